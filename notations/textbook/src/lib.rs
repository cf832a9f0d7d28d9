//! The grammar of M. Petici, E. Cotelnic, D. Ciorba and D. Rusu, "Context-free grammar defined for ladder logic"
//! (2020): a rung as one line of text.
//!
//! ```text
//! file      = { program }
//! program   = { "|" } "start" any "end" { "|" }
//! any       = some { "&" coil .. }                 (a coil takes all that is before it)
//! some      = all { "V" all }                      (branches in parallel)
//! all       = one { "&" one }                      (in series)
//! one       = "(" any ")" | contact | coil
//! contact   = ( "open contact" | "closed contact" ) name
//! coil      = ( "active coil" | "inactive coil" ) name
//! name      = ( "I" | "M" | "Q" ) digit { digit } [ "." ( "0" | "1" ) ]
//! ```
//!
//! The paper writes the words together too (`openContact`). It gives no precedence: `&` before a coil takes all that is
//! before it up to a parenthesis; between contacts `&` binds more tightly than `V`, and such a mixture without parentheses
//! is remarked on. Its checks: a program begins with a contact, ends with a coil, and has an
//! operation; an input carries its value (`I0.1` is I0 with the value 1), nothing else does; contacts are better called `I`
//! or `M`, coils `Q` or `M`. A line that begins with `#` is a comment; that is not in the paper.

mod read;
mod word;
mod write;

use ladder_analysis::Analysis;
use ladder_notation::{Notation, ReadError, Reading, Source, Target, WriteError, Writing};

/// See the module.
#[derive(Debug)]
pub struct Textbook;

impl Notation for Textbook {
    fn name(&self) -> &'static str {
        "textbook"
    }

    fn title(&self) -> &'static str {
        "rung in the textbook grammar"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["rung"]
    }

    fn recognises(&self, bytes: &[u8]) -> bool {
        std::str::from_utf8(bytes).is_ok_and(begins_program)
    }

    fn owns_extension(&self) -> bool {
        true
    }

    fn shows_coils(&self) -> bool {
        true
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        read::read(source.text()?)
    }

    fn write(&self, analysis: &Analysis) -> Result<Writing, WriteError> {
        Target::SERIES_AND_BRANCHES.write(analysis, |analysis, _| write::write(analysis))
    }
}

/// Whether a text begins with `start` and what may follow it; comments, blanks and `|` may be above and between.
fn begins_program(text: &str) -> bool {
    let lines = text
        .lines()
        .map(str::trim_start)
        .filter(|line| !line.starts_with('#'));
    let ends = |c: char| c.is_whitespace() || matches!(c, '|' | '\u{feff}' | '(');
    let mut words = lines
        .flat_map(|line| line.split(ends))
        .filter(|word| !word.is_empty());
    let is = |word: Option<&str>, any: &[&str]| {
        word.is_some_and(|word| {
            any.iter().any(|any| {
                word.get(..any.len())
                    .is_some_and(|begin| begin.eq_ignore_ascii_case(any))
            })
        })
    };
    words
        .next()
        .is_some_and(|word| word.eq_ignore_ascii_case("start"))
        && is(words.next(), &["open", "closed", "active", "inactive", "end"])
}
