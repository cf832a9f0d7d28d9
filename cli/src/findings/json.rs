//! Findings for machines: one array of objects.

use super::place::{LineColumnRange, place};
use super::source::Source;
use ladder_analysis::{Diagnostic, Fix, Related};
use serde::Serialize;
use std::borrow::Cow;

/// One finding. The names of the members are documented; nothing may be renamed.
#[derive(Serialize)]
pub(crate) struct Finding<'a> {
    file: &'a str,
    rule: &'static str,
    severity: &'static str,
    message: &'a str,
    #[serde(flatten)]
    place: LineColumnRange,
    #[serde(skip_serializing_if = "Option::is_none")]
    part: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    help: Option<&'a str>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    related: Vec<RelatedPlace<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    fix: Option<Fixing<'a>>,
}

#[derive(Serialize)]
struct RelatedPlace<'a> {
    file: Cow<'a, str>,
    message: &'a str,
    #[serde(flatten)]
    place: LineColumnRange,
}

#[derive(Serialize)]
struct Fixing<'a> {
    title: &'a str,
    applicability: &'static str,
    edits: Vec<Change<'a>>,
}

#[derive(Serialize)]
struct Change<'a> {
    #[serde(flatten)]
    place: LineColumnRange,
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
            part: source.name_of(finding.range),
            help: finding.help.as_deref(),
            related: finding
                .related
                .iter()
                .map(|place| related(source, place))
                .collect(),
            fix: finding.fixes.first().map(|it| fix(source, it)),
        }
    }
}

fn related<'a>(source: &'a Source, other: &'a Related) -> RelatedPlace<'a> {
    let elsewhere = other.file.as_ref().and_then(|file| source.other(file));
    match elsewhere {
        Some(file) => RelatedPlace {
            place: place(&file, other.range),
            file: Cow::Owned(file.file),
            message: &other.message,
        },
        None => RelatedPlace {
            file: Cow::Borrowed(&source.file),
            message: &other.message,
            place: place(source, other.range),
        },
    }
}

fn fix<'a>(source: &Source, fix: &'a Fix) -> Fixing<'a> {
    Fixing {
        title: &fix.title,
        applicability: fix.applicability.name(),
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
