//! Units of TwinCAT 3 (`.TcPOU`) whose body is a list of networks: declarations as IEC 61131-3 writes them, and the networks as
//! the editor's own objects, which are trees of boxes.
//!
//! ```text
//! XML --unit----> a unit with its variables, and what else the file has --project--> what it uses of the files next to it
//!     --archive-> objects, their fields by name
//!     --network-> boxes as a graph --> the model of `ladder-notation-plcopen`, and its way to ladder text
//!
//! ladder text --that model--> write: declarations, and drawings as trees of boxes --> files
//! ```
#![forbid(unsafe_code)]

mod archive;
mod flag;
mod network;
mod project;
mod system;
mod unit;
mod write;

use ladder_analysis::Analysis;
use ladder_notation::{Notation, Reach, ReadError, Reading, Source, WriteError, Writing};

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

    fn has_companion(&self, _program: &str, file: &str) -> bool {
        project::is_file(file)
    }

    fn reach(&self) -> Reach {
        Reach::Project(Some(".plcproj"))
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        project::project(source).map(ladder_notation_plcopen::reading)
    }

    fn writes_other_files(&self) -> bool {
        true
    }

    fn writes_unread(&self) -> bool {
        true
    }

    fn write(&self, analysis: &Analysis) -> Result<Writing, WriteError> {
        write::write(analysis)
    }
}
