//! The grammar of M. Petici, E. Cotelnic, D. Ciorba and D. Rusu, "Context-free grammar defined for ladder logic"
//! (2020): a rung as one line of text.
//!
//! ```text
//! file      = { program }
//! program   = [ "|" ] "start" any "end" [ "|" ]
//! any       = all { "V" all }                      (branches in parallel)
//! all       = one { "&" one }                      (in series)
//! one       = "(" any ")" | contact | coil
//! contact   = ( "open contact" | "closed contact" ) name
//! coil      = ( "active coil" | "inactive coil" ) name
//! name      = ( "I" | "M" | "Q" ) digit { digit } [ "." ( "0" | "1" ) ]
//! ```
//!
//! The paper writes the words together too (`openContact`). It gives no precedence; `&` binds more tightly here, and a
//! mixture without parentheses is remarked on. Its checks: a program begins with a contact, ends with a coil, and has an
//! operation; an input carries its value (`I0.1` is I0 with the value 1), nothing else does; contacts are better called `I`
//! or `M`, coils `Q` or `M`. A line that begins with `#` is a comment; that is not in the paper.

mod read;
mod word;
mod write;

use ladder_analysis::Analysis;
use ladder_notation::{Notation, ReadError, Reading, Source, WriteError, Writing};

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
        let Ok(text) = std::str::from_utf8(bytes) else {
            return false;
        };
        let first = text
            .lines()
            .map(str::trim)
            .find(|line| !line.is_empty() && !line.starts_with('#'));
        first.is_some_and(|line| {
            let line = line.trim_start_matches(['|', ' ', '\t']);
            line.get(..5)
                .is_some_and(|word| word.eq_ignore_ascii_case("start"))
                && line[5..].starts_with([' ', '\t', '('])
        })
    }

    fn shows_coils(&self) -> bool {
        true
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        read::read(source.text()?)
    }

    fn write(&self, analysis: &Analysis) -> Result<Writing, WriteError> {
        write::write(analysis)
    }
}
