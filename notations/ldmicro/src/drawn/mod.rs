//! What LDmicro 2.2 writes as "Export As Text": the diagram drawn with characters, and a list of its names.
//!
//! ```text
//!    ||       X0               X1               Y0        ||
//!  1 ||-------] [------+-------]/[--------------( )-------||
//!    ||                |                                  ||
//!    ||       Y0       |                                  ||
//!    ||-------] [------+                                  ||
//! ```
//!
//! An element has a cell of 17 columns and three lines: its name, itself between wires, a blank one. The text holds no
//! tables, no baud rate, and delays as they are shown. Both ways go by the model of an LDmicro file:
//!
//! ```text
//! File --canvas, listing--> text --read--> File
//! ```

mod canvas;
mod chips;
mod listing;
mod read;
mod row;
mod symbol;

use super::model::{Encoding, File, leaves};
use super::{export, rules, sketch};
use ladder_analysis::Analysis;
use ladder_notation::{Notation, Outcome, ReadError, Reading, Source, WriteError, Writing};

/// See the module.
#[derive(Debug)]
pub struct LdmicroText;

/// The columns of a cell.
const CELL: usize = 17;
/// Its lines.
const CELL_LINES: usize = 3;
/// What is in place of an element that does not fit its cell.
const TOO_LONG: &str = "!!!too long!!!";
/// How such a text begins.
const FIRST_LINE: &str = "LDmicro export text";

impl Notation for LdmicroText {
    fn name(&self) -> &'static str {
        "ldmicro-text"
    }

    fn title(&self) -> &'static str {
        "text that LDmicro exports"
    }

    fn extensions(&self) -> &'static [&'static str] {
        // `.txt`, like so much else: only the content shows it.
        &[]
    }

    fn recognises(&self, bytes: &[u8]) -> bool {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let first = bytes.split(|byte| matches!(byte, b'\r' | b'\n')).next();
        first.is_some_and(|line| line.trim_ascii() == FIRST_LINE.as_bytes())
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        source.bounded()?;
        let file = read::read(source.bytes)?;
        let mut reading = sketch::sketch(&file);
        for entry in &mut reading.report.entries {
            let Outcome::Refused(why) = &mut entry.outcome else {
                continue;
            };
            if is_table(&entry.element) {
                "the exported text does not hold its table".clone_into(why);
            } else if entry.element == TOO_LONG {
                "LDmicro left the element out, since it was too long for the drawing".clone_into(why);
            }
        }
        // Of a table that is not there nothing can be wrong.
        let checks = rules::findings(&file).into_iter();
        let checks = checks.filter(|found| found.check != "ldmicro-curve");
        reading.findings.extend(checks);
        reading.findings.sort_by_key(|finding| finding.place);
        Ok(reading)
    }

    fn write(&self, analysis: &Analysis) -> Result<Writing, WriteError> {
        let (file, mut report) = export::file(analysis)?;
        for entry in &mut report.entries {
            if entry.outcome == Outcome::Translated
                && let Some(why) = symbol::loss(&entry.element)
            {
                entry.outcome = Outcome::Approximated(why);
            }
        }
        let bytes = encoded(text(&file), file.encoding);
        Ok(Writing {
            bytes,
            companions: Vec::new(),
            report,
        })
    }
}

fn is_table(element: &str) -> bool {
    ["LOOK_UP_TABLE ", "PIECEWISE_LINEAR "]
        .iter()
        .any(|word| element.starts_with(word))
}

/// The whole text of a program.
fn text(file: &File) -> String {
    let used: Vec<&str> = file
        .rungs
        .iter()
        .flat_map(|rung| leaves(&rung.parts))
        .map(|leaf| leaf.text.as_str())
        .collect();
    format!(
        "{FIRST_LINE}\n{}\n\n\nLADDER DIAGRAM:\n\n{}\n\nI/O ASSIGNMENT:\n\n{}",
        listing::settings(file),
        canvas::draw(file),
        listing::names(file, &used)
    )
}

/// The bytes, with the line ends and characters that the file has.
fn encoded(text: String, encoding: Encoding) -> Vec<u8> {
    let text = if encoding.crlf {
        text.replace('\n', "\r\n")
    } else {
        text
    };
    let latin1: Option<Vec<u8>> = text.chars().map(|c| u8::try_from(c).ok()).collect();
    latin1
        .filter(|_| encoding.latin1)
        .unwrap_or_else(|| text.into_bytes())
}
