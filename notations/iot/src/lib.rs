//! Programs of iot-ladder-editor in a small notation: one line a rung.
//!
//! ```text
//! file     = { line }
//! line     = rung | "#" comment | "=" title | ">" stimulus
//! rung     = parallel { ";" parallel }          (in series, from the left rail)
//! parallel = one { "|" one }                    (branches, from top to bottom)
//! one      = element | "(" [ rung ] ")"
//! element  = word { operand }                   NO I1, TON T1 3 100, ADD MI01 MI01 1, EQ T1:AC 3
//! ```
//!
//! A second form, with the editor's symbols in the columns of its grid, is read too: see `prose`.
//!
//! The editor itself has no text: its projects (`.ld`) are Java objects, which are recognised and refused. The
//! words are those of `word::ROWS`; parentheses are for branches of several elements, which nobody else writes yet.
//!
//! A variable of the editor is a number of some width: inputs and outputs have eight bits, `MI` 32, `MF` is a float. An input or
//! output that never holds anything but 0 and 1 is BOOL here.

mod kinds;
mod model;
mod names;
mod parse;
mod prose;
mod rules;
mod sketch;
mod word;
mod write;

use ladder_analysis::Analysis;
use ladder_notation::{Notation, ReadError, Reading, Source, Target, WriteError, Writing};

/// See the module.
#[derive(Debug)]
pub struct Iot;

/// How every file begins that Java has stored objects in.
const JAVA_OBJECTS: &[u8] = &[0xAC, 0xED, 0x00, 0x05];

impl Notation for Iot {
    fn name(&self) -> &'static str {
        "iot"
    }

    fn title(&self) -> &'static str {
        "program of the IoT ladder language"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["iot"]
    }

    fn owns_extension(&self) -> bool {
        true
    }

    fn recognises(&self, bytes: &[u8]) -> bool {
        bytes.starts_with(JAVA_OBJECTS) || parse::begins(bytes)
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        if source.bytes.starts_with(JAVA_OBJECTS) {
            return Err(ReadError::whole(
                "this is a project of iot-ladder-editor, which Java stored as objects that only the editor can read; open it \
                 there, and write its rungs into a text file, one a line: `NO I1 ; TON T1 3 100 ; OUT Q1`",
            ));
        }
        let file = parse::parse(source)?;
        let mut reading = sketch::sketch(&file);
        reading.findings.extend(rules::findings(&file));
        reading.findings.sort_by_key(|finding| finding.place);
        Ok(reading)
    }

    fn write(&self, analysis: &Analysis) -> Result<Writing, WriteError> {
        Target::SERIES_AND_BRANCHES.write(analysis, |analysis, _| write::write(analysis))
    }
}
