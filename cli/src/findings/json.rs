//! Findings for machines: one array of objects.

use super::source::Source;
use ladder_analysis::{Diagnostic, Fix, Related};
use ladder_syntax::TextRange;
use serde::Serialize;

/// One finding. The names of the members are documented; nothing may be renamed.
#[derive(Serialize)]
pub(crate) struct Finding<'a> {
    file: &'a str,
    rule: &'static str,
    severity: &'static str,
    message: &'a str,
    #[serde(flatten)]
    place: Place,
    #[serde(skip_serializing_if = "Option::is_none")]
    help: Option<&'a str>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    related: Vec<RelatedPlace<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    fix: Option<Mend<'a>>,
}

/// Lines and columns from 1, columns in characters; the end is behind the last character.
#[derive(Serialize)]
struct Place {
    line: u32,
    column: u32,
    end_line: u32,
    end_column: u32,
}

#[derive(Serialize)]
struct RelatedPlace<'a> {
    file: &'a str,
    message: &'a str,
    #[serde(flatten)]
    place: Place,
}

#[derive(Serialize)]
struct Mend<'a> {
    title: &'a str,
    edits: Vec<Change<'a>>,
}

#[derive(Serialize)]
struct Change<'a> {
    #[serde(flatten)]
    place: Place,
    text: &'a str,
}

impl<'a> Finding<'a> {
    pub(crate) fn new(source: &'a Source, finding: &'a Diagnostic) -> Finding<'a> {
        Finding {
            file: &source.file,
            rule: finding.rule.name(),
            severity: finding.severity.name(),
            message: &finding.message,
            place: place(source, finding.range),
            help: finding.help.as_deref(),
            related: finding
                .related
                .iter()
                .map(|place| related(source, place))
                .collect(),
            fix: finding.fixes.first().map(|fix| mend(source, fix)),
        }
    }
}

fn place(source: &Source, range: TextRange) -> Place {
    let (start, end) = (source.place(range.start()), source.place(range.end()));
    Place {
        line: start.line,
        column: start.column,
        end_line: end.line,
        end_column: end.column,
    }
}

fn related<'a>(source: &'a Source, other: &'a Related) -> RelatedPlace<'a> {
    RelatedPlace {
        file: &source.file,
        message: &other.message,
        place: place(source, other.range),
    }
}

fn mend<'a>(source: &Source, fix: &'a Fix) -> Mend<'a> {
    Mend {
        title: &fix.title,
        edits: fix
            .edits
            .iter()
            .map(|edit| Change {
                place: place(source, edit.range),
                text: &edit.text,
            })
            .collect(),
    }
}
