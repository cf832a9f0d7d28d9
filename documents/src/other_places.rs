//! Places in the other files of a document's workspace, by the names that findings and programs know the files by.

use std::collections::HashMap;

use ladder_syntax::TextRange;
use ladder_workspace::Member;
use ropey::Rope;

use crate::position::{self, Range};
use crate::revision::Revision;

/// The files next to a document whose places were asked for: each is read once.
pub struct OtherPlaces<'r> {
    revision: &'r Revision,
    /// Address and text.
    files: HashMap<String, Option<(String, Rope, Member)>>,
}

impl<'r> OtherPlaces<'r> {
    /// Those next to this one. None was asked for yet.
    pub fn new(revision: &'r Revision) -> Self {
        OtherPlaces {
            revision,
            files: HashMap::new(),
        }
    }

    /// A range in one of them: the file's address, and the range.
    pub fn range(&mut self, file: &str, range: TextRange) -> Option<(String, Range)> {
        if !self.files.contains_key(file) {
            let found = self.revision.text_next_to(file);
            let found = found.map(|(address, member)| (address, Rope::from_str(member.text()), member));
            self.files.insert(file.to_owned(), found);
        }
        let (address, text, member) = self.files.get(file)?.as_ref()?;
        let range = member.range(range);
        let end = usize::from(range.end()).min(text.len_bytes());
        let bytes = usize::from(range.start()).min(end)..end;
        Some((
            address.clone(),
            position::range(text, self.revision.encoding(), bytes),
        ))
    }
}
