//! What a notation makes of a file, and of a program.

use super::{Companion, Finding, LineColumn, ProjectTask, Report};
use ladder_format::program::ProgramSketch;

/// What was read.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Reading {
    /// The program, ready to be written.
    pub program: ProgramSketch,
    /// Where in the foreign file things are: the origins in the sketch are indices into this.
    pub places: Vec<LineColumn>,
    /// What the other system calls the parts of the file, each with where it begins: `routine Main of program Pump, rung 3`.
    pub names: Vec<(LineColumn, String)>,
    /// What became of each element.
    pub report: Report,
    /// What the other system itself would complain about.
    pub findings: Vec<Finding>,
    /// The same as the files of a workspace, where the source is a whole project: what is written into a folder. Empty:
    /// the program is one file.
    pub files: Vec<ProjectFile>,
    /// What is approximated in one program, and as it was in the files: elements of the report.
    pub exact_in_files: Vec<(LineColumn, String)>,
}

/// A file of a project.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ProjectFile {
    /// Its whole name: `Main.clad`, `ladder.toml`. It has no folder.
    pub name: String,
    /// What is in it.
    pub content: Content,
}

/// What is in a file of a project.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Content {
    /// A program, or types and blocks that programs share.
    Program(ProgramSketch),
    /// A program in another language of workspaces, as it is.
    Text(String),
    /// Settings: what comes first, as it is written, and the tasks.
    Settings(String, Vec<ProjectTask>),
}

impl Reading {
    /// Notes a place of the foreign file; what is made from it gets the number that comes back.
    pub fn origin(&mut self, place: LineColumn) -> u32 {
        self.places.push(place);
        self.places.len() as u32 - 1
    }
}

/// What was written.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Writing {
    /// The foreign file.
    pub bytes: Vec<u8>,
    /// What belongs next to it, each under its own name.
    pub companions: Vec<Companion>,
    /// What became of each element; places are those of the ladder text.
    pub report: Report,
}
