//! Units of TwinCAT 3 (`.TcPOU`) whose body is a list of networks: declarations as IEC 61131-3 writes them, and the networks as
//! the editor's own objects, which are trees of boxes.
//!
//! ```text
//! XML --unit----> a unit with its variables, and what else the file has
//!     --archive-> objects, their fields by name
//!     --network-> boxes as a graph --> the model of `ladder-notation-plcopen`, and its way to ladder text
//! ```
#![forbid(unsafe_code)]

mod archive;
mod network;
mod unit;

use ladder_analysis::Analysis;
use ladder_notation::{Notation, ReadError, Reading, Source, WriteError, Writing};

/// See the module.
#[derive(Debug)]
pub struct TwinCat;

/// How many bytes are checked for the element of a unit.
const HEAD: usize = 4_096;

impl Notation for TwinCat {
    fn name(&self) -> &'static str {
        "twincat"
    }

    fn title(&self) -> &'static str {
        "TwinCAT unit"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["tcpou"]
    }

    fn owns_extension(&self) -> bool {
        true
    }

    fn recognises(&self, bytes: &[u8]) -> bool {
        let head = String::from_utf8_lossy(&bytes[..bytes.len().min(HEAD)]);
        head.contains("<TcPlcObject")
    }

    fn is_written(&self) -> bool {
        false
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        unit::project(source.text()?).map(ladder_notation_plcopen::reading)
    }

    fn write(&self, _: &Analysis) -> Result<Writing, WriteError> {
        Err(WriteError::new(
            "units of TwinCAT are read only: write PLCopen XML, which TwinCAT imports",
        ))
    }
}
