//! Ladder diagrams drawn with characters, as people write them into forums, mails and manuals.
//!
//! ```text
//!   start      stop              run
//! |--| |---+----|/|--------------( )--|
//! |  run   |                          |
//! |--| |---+                          |
//! ```
//!
//! `ladder-drawings` reads them. What is written is what `ladder render --format text` shows, in plain characters.

use ladder_analysis::{Analysis, Severity, analyze};
use ladder_drawings::{Look, look, read};
use ladder_notation::{
    Finding, LineColumn, Notation, ReadError, Reading, Report, Source, WriteError, Writing, no_program,
};
use ladder_picture::letters::{self, Style};
use ladder_syntax::{TextRange, parse};

/// See the module.
#[derive(Debug)]
pub struct Ascii;

/// This many lines are checked for a drawing.
const LINES: usize = 200;

/// The column of the right rail.
const RAIL: u32 = 78;

impl Notation for Ascii {
    fn name(&self) -> &'static str {
        "ascii"
    }

    fn title(&self) -> &'static str {
        "ladder diagram drawn with characters"
    }

    fn extensions(&self) -> &'static [&'static str] {
        // `.txt`, like so much else: only the content shows it.
        &[]
    }

    fn recognises(&self, bytes: &[u8]) -> bool {
        let Ok(text) = std::str::from_utf8(bytes) else {
            return false;
        };
        let lines: Vec<&str> = text.trim_start_matches('\u{feff}').lines().take(LINES).collect();
        let parts = lines.split(|line| line.trim().is_empty());
        let is_drawn = |part: &[&str]| !part.is_empty() && look(part) == Look::Drawn;
        // Ladder text draws contacts on wires too.
        let has_errors = || analyze(&parse(&lines.join("\n")).into(), "").has_errors();
        parts.into_iter().any(is_drawn) && has_errors()
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        let read = read(source.text()?);
        if read.shown.is_empty() && read.problems.is_empty() {
            return Err(ReadError::whole(
                "there is no drawing in the file: no contact or coil is on a wire",
            ));
        }
        let mut reading = Reading {
            program: read.program,
            places: read.places,
            ..Reading::default()
        };
        let report = &mut reading.report;
        for shown in read.shown {
            report.translated(shown.place, shown.text);
        }
        for problem in read.problems {
            reading.findings.push(Finding {
                place: problem.place,
                severity: Severity::Error,
                check: "ascii-unread",
                message: format!("`{}` stays as a comment: {}", problem.text, problem.why),
            });
            report.refused(problem.place, problem.text, problem.why);
        }
        for (name, spelling) in read.renamed {
            let why = format!("this is not a name of its own in ladder text; it is `{spelling}` here");
            report.approximated(LineColumn::START, name, why);
        }
        for name in read.made {
            let why = "a timer or counter of the drawing has no name; it has this one here";
            report.approximated(LineColumn::START, name, why);
        }
        report.entries.sort_by_key(|entry| entry.place);
        Ok(reading)
    }

    fn write(&self, analysis: &Analysis) -> Result<Writing, WriteError> {
        if analysis.has_errors() {
            return Err(no_program(analysis, &analysis.context.parse.to_string()));
        }
        let networks = &analysis.context.networks;
        if (0..networks.len()).all(|network| networks.at(network).blocks().next().is_none()) {
            return Err(WriteError::new("nothing is drawn in the program"));
        }
        let all = TextRange::up_to(analysis.context.parse.text_len());
        let pieces = letters::pieces(&analysis.context, all, RAIL, None);
        Ok(Writing {
            bytes: letters::text(&pieces, Style::Ascii).into_bytes(),
            report: Report::default(),
            companions: Vec::new(),
        })
    }
}
