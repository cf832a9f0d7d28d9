//! `[project]`: what the project is.

use super::reader::{Reader, Table};
use super::table::{NAME, VERSION};

/// What the project is, for the title block of printed pages.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Project {
    /// What it is called.
    pub name: Option<String>,
    /// The version of its programs.
    pub version: Option<String>,
}

pub(super) fn read(mut table: Table, reader: &mut Reader) -> Project {
    let mut text = |setting| {
        let given = reader.take(&mut table, setting)?;
        reader.text(&given, setting.example)
    };
    let project = Project {
        name: text(&NAME),
        version: text(&VERSION),
    };
    table.finish(reader);
    project
}
