//! PLCopen XML (TC6 2.0 and 2.01): projects of Beremiz, OpenPLC, CODESYS and others.
//!
//! ```text
//! XML --read--> Project: types, variables, units, tasks; bodies as graphs of elements and wires
//!                  |
//!               sketch: scope (what names mean), expression, standard (functions and blocks)
//!                  |
//!               body: what is done, in its order --prepare--> what must stand above
//!                  |
//!               draw: each network as series and branches --> one program, and the files of a workspace
//!
//! ladder text --write--> Project --emit--> XML, which is read as the same text again
//! ```
//!
//! Other files that hold such graphs are read into the same [`model`] and go the same way through [`reading`].
#![forbid(unsafe_code)]

mod along;
mod arrays;
mod brought;
pub mod chart;
pub mod declarations;
mod emit;
mod expression;
pub mod graph;
mod keep;
mod loops;
mod loose;
pub mod model;
pub mod neighbours;
mod order;
mod own;
mod read;
mod scope;
mod shared;
mod sketch;
mod standard;
mod write;

#[cfg(test)]
mod counts;

pub use sketch::reading;
pub use write::{Compiler, project};

use ladder_analysis::Analysis;
use ladder_notation::{
    Kept, LineColumn, Notation, Project, ReadError, Reading, Source, WriteError, Writing, WrittenProject,
};

/// See the module.
#[derive(Debug)]
pub struct Plcopen;

impl Notation for Plcopen {
    fn name(&self) -> &'static str {
        "plcopen"
    }

    fn title(&self) -> &'static str {
        "PLCopen XML project"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["xml"]
    }

    fn recognises(&self, bytes: &[u8]) -> bool {
        read::recognises(bytes)
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        read::project(source.text_of_project()?).map(reading)
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

    fn texts(&self) -> Option<&'static dyn Notation> {
        Some(&ladder_notation_st::St)
    }

    fn has_projects(&self) -> bool {
        true
    }

    fn write_project(
        &self,
        project: &Project,
        kept: Option<&Kept<'_>>,
    ) -> Result<WrittenProject, WriteError> {
        if let Some(kept) = kept {
            return keep::write(project, kept);
        }
        let (made, mut reports) = write::files::project(project, |file| project.stem(file).to_owned())?;
        for unit in &made.units {
            if let Some(function) = write::texts::function_as_block(unit, &made) {
                let why = format!(
                    "it calls the function `{function}`, which is drawn as a block of an instance here: call it in Structured Text"
                );
                reports[0].refused(LineColumn::START, format!("unit {}", unit.name), why);
            }
        }
        Ok(WrittenProject {
            bytes: emit::project(made).into_bytes(),
            reports,
        })
    }
}
