//! The files of a program, and places in them as the client counts them.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use ladder_notations::Foreign;
use ladder_syntax::{LineIndex, TextRange, TextSize};
use ladder_workspace::{Disk, Member};
use serde_json::{Value as Json, json};

use crate::messages::Initialize;

/// A file with its text.
#[derive(Debug)]
pub(crate) struct Source {
    pub path: PathBuf,
    pub text: String,
    /// The text is not that of the file: the client asks for it.
    is_given: bool,
    index: LineIndex,
    /// What the file becomes, where it is of another notation: places of the program are in that.
    foreign: Option<Arc<Foreign>>,
}

/// What a client asks for the text of the only source that is not on disk by.
pub(crate) const GIVEN: i64 = 1;

impl Source {
    pub(crate) fn new(path: PathBuf, text: String) -> Source {
        Source {
            path,
            is_given: false,
            index: LineIndex::new(&text),
            text,
            foreign: None,
        }
    }

    /// A program of a workspace.
    pub(crate) fn of_member(path: PathBuf, member: &Member) -> Source {
        Source {
            foreign: member.foreign().cloned(),
            ..Source::new(path, member.text().to_owned())
        }
    }

    /// Whether places of the program are places of the file.
    pub(crate) fn is_ladder(&self) -> bool {
        self.foreign.is_none()
    }

    /// A place of the program as it is in the file.
    fn in_file(&self, range: TextRange) -> TextRange {
        self.foreign
            .as_ref()
            .map_or(range, |foreign| foreign.range(range))
    }

    /// A text that the client has given, which would be at this path.
    pub(crate) fn given(path: PathBuf, text: String) -> Source {
        Source {
            is_given: true,
            ..Source::new(path, text)
        }
    }

    /// The same once more.
    pub(crate) fn again(&self) -> Source {
        Source {
            is_given: self.is_given,
            foreign: self.foreign.clone(),
            ..Source::new(self.path.clone(), self.text.clone())
        }
    }

    /// The text that a client may ask for.
    pub(crate) fn given_text(&self) -> Option<&str> {
        self.is_given.then_some(&*self.text)
    }

    /// Whether a path of the client means this file.
    pub(crate) fn is(&self, disk: &dyn Disk, path: &Path) -> bool {
        if self.path == path {
            return true;
        }
        // A path of the network is not asked whether it is this one.
        if path.to_str().is_none_or(is_on_another_computer) {
            return false;
        }
        let same_name =
            self.path.file_name() == path.file_name() || disk.is_link(path) || disk.is_link(&self.path);
        same_name && resolved(disk, path).is_some_and(|path| resolved(disk, &self.path) == Some(path))
    }

    /// The line of a place of the program, from 0.
    pub(crate) fn line(&self, offset: TextSize) -> usize {
        self.index.line(self.in_file(TextRange::empty(offset)).start())
    }

    /// The line of an offset of the file, from 0.
    pub(crate) fn line_of(&self, offset: TextSize) -> usize {
        self.index.line(offset)
    }

    /// The range of a line, from 0, without its end.
    pub(crate) fn line_range(&self, line: usize) -> TextRange {
        self.index.content(&self.text, line)
    }

    pub(crate) fn line_count(&self) -> usize {
        self.index.line_count()
    }

    /// `motor.clad:3`
    pub(crate) fn place_name(&self, range: TextRange) -> String {
        let name = self.path.file_name().unwrap_or_default().to_string_lossy();
        format!("{name}:{}", self.line(range.start()) + 1)
    }

    /// The file and its name as the protocol has it.
    pub(crate) fn json(&self) -> Json {
        let name = self.path.file_name().map(|name| name.to_string_lossy());
        if self.is_given {
            let name = format!("run for {}", name.unwrap_or_default());
            return json!({"name": name, "sourceReference": GIVEN});
        }
        json!({"name": name, "path": self.path.to_string_lossy()})
    }

    /// Line and column in UTF-16 units, both from 0.
    fn place(&self, offset: TextSize) -> (usize, usize) {
        let offset = offset.min(TextSize::of(self.text.as_str()));
        let line = self.index.line(offset);
        let before = TextRange::new(self.index.range(line).start(), offset);
        let text = self
            .text
            .get(std::ops::Range::<usize>::from(before))
            .unwrap_or_default();
        (line, text.encode_utf16().count())
    }

    /// The offset of a column in UTF-16 units from 0, brought back into its line.
    fn offset(&self, line: usize, column: usize) -> TextSize {
        let range = self.line_range(line);
        let mut units = 0;
        for (at, letter) in self.text[range].char_indices() {
            if units >= column {
                return range.start() + TextSize::new(at as u32);
            }
            units += letter.len_utf16();
        }
        range.end()
    }
}

/// Whether a path is one of the network, as Windows writes it: refused everywhere, for a workspace is the same on each machine.
pub(crate) fn is_on_another_computer(path: &str) -> bool {
    path.starts_with(['/', '\\']) && path[1..].starts_with(['/', '\\'])
}

/// A path without links. None of those below the workspace that leads out of it is followed.
fn resolved(disk: &dyn Disk, path: &Path) -> Option<PathBuf> {
    let name = path.file_name()?.to_str()?;
    let located = disk.locate(&disk.named_in(path, name)).ok()?;
    disk.canonicalize(&located).ok()
}

/// How the client counts.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Counting {
    first_line: i64,
    first_column: i64,
}

impl Counting {
    pub(crate) fn of(client: &Initialize) -> Counting {
        Counting {
            first_line: i64::from(client.lines_start_at_1),
            first_column: i64::from(client.columns_start_at_1),
        }
    }

    /// A line of the client, from 0; lines before the first are the first.
    pub(crate) fn line(self, line: i64) -> usize {
        usize::try_from(line.saturating_sub(self.first_line)).unwrap_or(0)
    }

    /// A line for the client.
    pub(crate) fn line_out(self, line: usize) -> i64 {
        line as i64 + self.first_line
    }

    /// The offset of a place of the client.
    pub(crate) fn offset(self, source: &Source, line: usize, column: i64) -> TextSize {
        let column = usize::try_from(column.saturating_sub(self.first_column)).unwrap_or(0);
        source.offset(line, column)
    }

    /// A column of a text of one line, in bytes.
    pub(crate) fn bytes_before(self, text: &str, column: i64) -> usize {
        let column = usize::try_from(column.saturating_sub(self.first_column)).unwrap_or(0);
        let mut units = 0;
        for (at, letter) in text.char_indices() {
            if units >= column {
                return at;
            }
            units += letter.len_utf16();
        }
        text.len()
    }

    /// `line`, `column`, `endLine` and `endColumn` of a range; a range that reaches after its first line ends with that.
    pub(crate) fn range(self, source: &Source, range: TextRange) -> Json {
        let range = source.in_file(range);
        let (line, column) = source.place(range.start());
        let end = range.end().min(source.line_range(line).end().max(range.start()));
        let (_, end_column) = source.place(end);
        json!({
            "line": self.line_out(line),
            "column": column as i64 + self.first_column,
            "endLine": self.line_out(line),
            "endColumn": end_column as i64 + self.first_column,
        })
    }
}
