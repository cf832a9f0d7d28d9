//! The one trait of a notation.

use super::{Kept, Project, ReadError, Reading, Source, WriteError, Writing, WrittenProject};
use ladder_analysis::Analysis;
use std::fmt;

/// A way to write ladder programs that is not this project's own.
pub trait Notation: Sync {
    /// What a command line calls it: `ldmicro`.
    fn name(&self) -> &'static str;

    /// What a person calls it: `LDmicro program`.
    fn title(&self) -> &'static str;

    /// How its files' names end, without the dot, the usual one first. Other systems may use the same; none: the
    /// names show nothing.
    fn extensions(&self) -> &'static [&'static str];

    /// Whether nothing else has files of such names, so that the name alone shows what a file is in.
    fn owns_extension(&self) -> bool {
        false
    }

    /// Whether its files are programs of a workspace, next to those in ladder text: what one declares the others see.
    fn is_in_workspaces(&self) -> bool {
        false
    }

    /// Whether a file is in this notation, from its content alone. No more than the first lines are checked.
    fn recognises(&self, bytes: &[u8]) -> bool;

    /// Whether such a file is read, too. A language that programs are only translated to is not.
    fn is_read(&self) -> bool {
        true
    }

    /// Whether a program is written with the functions and blocks that it uses of other files and of the library. What
    /// [writes](Notation::write) is then handed an analysis whose program has them: places in it may be those of other files.
    fn writes_other_files(&self) -> bool {
        false
    }

    /// Whether [`write`](Notation::write) itself says which unread parts it does not write. Else it writes none, and that is reported for it.
    fn writes_unread(&self) -> bool {
        false
    }

    /// Whether programs are written in this notation, too. Else [`write`](Notation::write) says so.
    fn is_written(&self) -> bool {
        true
    }

    /// Whether a run of such a program is about its coils, and nothing else is shown of it unless asked for.
    fn shows_coils(&self) -> bool {
        false
    }

    /// What an editor calls the language of such a file, if it can be opened as it is: then it is checked and drawn
    /// while it is typed. Only a client that names this language has its files read so.
    fn editor_language(&self) -> Option<&'static str> {
        None
    }

    /// Whether a line of a file only introduces what is on the line below, and means nothing by itself.
    fn introduces(&self, _line: &str) -> bool {
        false
    }

    /// Whether a file in [reach](Notation::reach) of a program belongs to it: `program` is the stem of the program's name,
    /// `file` the name of the other as it is seen from the folder of the program: `subroutines/Rinse.csv`. The caller that
    /// reads the program from a folder hands such files in as [`Source::companions`].
    fn has_companion(&self, _program: &str, _file: &str) -> bool {
        false
    }

    /// Where the files lie that may belong to a program.
    fn reach(&self) -> Reach {
        Reach::Folder
    }

    /// Reads a program.
    ///
    /// # Errors
    ///
    /// If the file is not in this notation, is broken, or larger than what is read.
    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError>;

    /// Writes a program that has no errors.
    ///
    /// # Errors
    ///
    /// If nothing of it can be expressed in this notation. A part that cannot be is an entry of the report.
    fn write(&self, analysis: &Analysis) -> Result<Writing, WriteError>;

    /// Whether a whole project is one file: then the files of a folder are [written](Notation::write_project) as one.
    fn has_projects(&self) -> bool {
        false
    }

    /// What files of a folder are in that a [project](Notation::write_project) has as they are, besides those in ladder text.
    fn texts(&self) -> Option<&'static dyn Notation> {
        None
    }

    /// Writes the files of a folder as one file. What is as it was in the file that they come from stays as that has it.
    ///
    /// # Errors
    ///
    /// As for [`write`](Notation::write), and if that file is not in this notation.
    fn write_project(
        &self,
        _project: &Project,
        _kept: Option<&Kept<'_>>,
    ) -> Result<WrittenProject, WriteError> {
        Err(WriteError::new(
            "each of its files holds one program: convert them one by one, or into a folder",
        ))
    }
}

/// Where the files lie that belong to a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reach {
    /// In its folder.
    Folder,
    /// In its folder, and in the one of this name next to it.
    FolderAnd(&'static str),
    /// In its workspace: the programs of that.
    Workspace,
    /// Anywhere in its project. The folder of that has a file whose name ends so, if the system has such a file.
    Project(Option<&'static str>),
}

impl PartialEq for dyn Notation {
    fn eq(&self, other: &dyn Notation) -> bool {
        self.name() == other.name()
    }
}

impl Eq for dyn Notation {}

impl fmt::Debug for dyn Notation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Whether the names of a notation's files may end so.
pub fn has_extension(notation: &dyn Notation, extension: &str) -> bool {
    let mut own = notation.extensions().iter();
    own.any(|own| own.eq_ignore_ascii_case(extension))
}
