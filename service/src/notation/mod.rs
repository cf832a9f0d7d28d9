//! Programs of other systems, for the editor: a program in, the same program in another notation out. Nothing is written.

pub mod messages;

use ladder_analysis::{Analysis, Linked};
use ladder_notations::{
    Finding, Foreign, Form, NOTATIONS, Remark, Report, Source, Tally, remarks, write_checked,
};
use messages::{Converted, Element, Known, NextTo, Notations};
use std::sync::Arc;

/// What a program is to become, and what it is.
#[derive(Debug)]
pub(crate) struct Task<'t> {
    pub(crate) source: &'t Source<'t>,
    /// The notation that it is in.
    pub(crate) from: Form,
    /// The notation that it is to be in.
    pub(crate) to: Form,
}

/// The notations, apart from ladder text, that programs are written in.
pub(crate) fn known() -> Notations {
    let written = NOTATIONS.iter().filter(|notation| notation.is_written());
    let known = written.map(|notation| Known {
        name: notation.name().to_owned(),
        title: notation.title().to_owned(),
        extensions: notation.extensions().iter().map(ToString::to_string).collect(),
    });
    Notations {
        notations: known.collect(),
    }
}

/// Writes a program in another notation. `analysis` is that of ladder text that the editor shows, if it is one, and `linked` what it
/// makes with the files that it uses.
///
/// # Errors
///
/// It is broken, or cannot be expressed in the other notation: a sentence, with the place in front of it.
pub(crate) fn translate(
    task: &Task<'_>,
    analysis: Option<Arc<Analysis>>,
    linked: Option<Linked>,
) -> Result<Converted, String> {
    let mut account = Account::default();
    let mut companions = Vec::new();
    let analyze = |ladder: &str| {
        let parse = ladder_syntax::parse(ladder).into();
        Arc::new(ladder_analysis::analyze(&parse, &task.source.name))
    };
    let (ladder, own) = match task.from {
        Form::Ladder => {
            let bytes = task.source.bytes.to_vec();
            let ladder = String::from_utf8(bytes).map_err(|_| "the file is not UTF-8".to_owned())?;
            (ladder, None)
        }
        Form::Foreign(notation) => {
            let foreign = Foreign::read(notation, task.source).map_err(|error| error.to_string())?;
            let ladder = foreign.ladder().to_owned();
            let own = analyze(&ladder);
            let report = foreign.report(own.errors());
            account.add(&report, &foreign.converted().findings, true);
            (ladder, Some(own))
        }
    };
    let text = match task.to {
        Form::Ladder => ladder,
        Form::Foreign(notation) => {
            let own = analysis.or(own).unwrap_or_else(|| analyze(&ladder));
            let linked = linked.or_else(|| ladder_analysis::link_files(&own, &|_| None).ok());
            let own = match linked {
                Some(linked) if notation.writes_other_files() => Arc::new(own.with_others(linked)),
                _ => own,
            };
            let writing = write_checked(notation, &own, &task.source.name);
            let writing = writing.map_err(|error| error.to_string())?;
            account.add(&writing.report, &[], matches!(task.from, Form::Ladder));
            let next_to = writing.companions.iter().map(|companion| {
                let name = &companion.name;
                format!("{name} belongs next to this program; `ladder convert -o` writes both")
            });
            account.notes.extend(next_to);
            companions.extend(writing.companions.into_iter().map(|companion| NextTo {
                name: companion.name,
                text: String::from_utf8(companion.bytes.to_vec()).ok(),
            }));
            String::from_utf8(writing.bytes).map_err(|_| {
                "this program is not a text in UTF-8; `ladder convert -o` writes it".to_owned()
            })?
        }
    };
    Ok(Converted {
        from: task.from.name().to_owned(),
        to: task.to.name().to_owned(),
        extension: task.to.extension().to_owned(),
        text,
        companions,
        translated: account.tally.translated,
        approximated: account.tally.approximated,
        refused: account.tally.refused,
        remarks: account.remarks,
        notes: account.notes,
    })
}

/// What became of the elements on the way.
#[derive(Default)]
struct Account {
    tally: Tally,
    remarks: Vec<Element>,
    notes: Vec<String>,
}

impl Account {
    /// `is_shown`: whether the places are those of the file that the editor shows.
    fn add(&mut self, report: &Report, findings: &[Finding], is_shown: bool) {
        let tally = report.tally();
        self.tally.translated += tally.translated;
        self.tally.approximated += tally.approximated;
        self.tally.refused += tally.refused;
        let remarks = remarks(report, findings);
        self.remarks
            .extend(remarks.iter().map(|remark| element(remark, is_shown)));
    }
}

fn element(remark: &Remark<'_>, is_shown: bool) -> Element {
    Element {
        line: is_shown.then_some(remark.place.line),
        column: is_shown.then_some(remark.place.column),
        outcome: remark.outcome.to_owned(),
        element: remark.element.to_owned(),
        reason: remark.reason.to_owned(),
    }
}
