//! What has another name now: tags, members, types, blocks, functions and labels.
//!
//! A name that only the old program has became one that only the new program has, if they have the same place wherever the rest of
//! an entry is the same. Whether that is so is only a guess about what was meant: what is compared is the old program with the new
//! names, which is the same program, as [`ladder_ide::rename`] refuses a name that would make another one of it.

mod found;
mod words;

use crate::outline::Outline;
pub(crate) use found::found;
use ladder_analysis::context;
use ladder_analysis::context::Context;
use ladder_format::{Options, apply};
use ladder_ide::{Alone, RenameRefused, rename};
use ladder_syntax::Name;
use std::fmt;
use std::sync::Arc;
use words::{flat, words};

/// So many things are renamed.
const MOST: usize = 64;
/// All texts that are read again for it are no longer than this.
const MOST_BYTES: usize = 16 << 20;

/// Something that has another name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Rename {
    /// What it is: `tag`, `member`, `type`, `block`, `function` or `label`.
    pub kind: &'static str,
    /// Its old name.
    pub was: String,
    /// Its new name.
    pub is: String,
    /// At how many places it is named.
    pub places: usize,
    /// What others know it as, by its name: `input`, `output`, `global tag` or `retentive tag`.
    pub shown_as: Option<&'static str>,
    /// The block in whose body it is.
    scope: Arc<str>,
}

impl Rename {
    /// Whether it is of the block in whose body things were, and now are.
    fn is_from(&self, was: &str, is: &str) -> bool {
        let of = |place: &str| Name::new(place.split(' ').next_back().unwrap_or_default());
        self.kind == "block" && of(was) == Name::new(&self.was) && of(is) == Name::new(&self.is)
    }

    /// Whether another rename is of the same thing.
    pub(crate) fn is_of_same(&self, other: &Rename) -> bool {
        self.scope == other.scope && self.kind == other.kind && Name::new(&self.was) == Name::new(&other.was)
    }
}

impl fmt::Display for Rename {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Rename {
            kind,
            was,
            is,
            places,
            ..
        } = self;
        let kind = self.shown_as.unwrap_or(kind);
        let word = if *places == 1 { "place" } else { "places" };
        write!(f, "{kind} {was} -> {is} ({places} {word})")
    }
}

/// The old program with the names of the new one.
#[derive(Debug)]
pub struct Renamed {
    /// Its text.
    pub text: String,
    /// What was renamed in it.
    pub renames: Vec<Rename>,
}

/// Finds what was renamed, and renames it in the old program. None: nothing was.
pub fn renamed(old: &Outline, new: &Outline) -> Option<Renamed> {
    let found = found(old, new);
    if found.is_empty() {
        return None;
    }
    let mut text = old.context.parse.to_string();
    let mut read = Arc::clone(&old.context);
    let mut renames = Vec::new();
    let most = (MOST_BYTES / text.len().max(1)).clamp(1, MOST);
    for found in found.into_iter().take(most) {
        let Ok(Some(changed)) = found.in_text(&read, &text) else {
            continue;
        };
        text = changed;
        read = Arc::new(again(&read, &text));
        renames.push(found);
    }
    (!renames.is_empty()).then_some(Renamed { text, renames })
}

/// What is known of a text in the place of another one.
pub(crate) fn again(read: &Context, text: &str) -> Context {
    context(&Arc::new(ladder_syntax::parse(text)), &read.name)
}

impl Rename {
    /// A text in which it has its new name. None: it is not there.
    ///
    /// # Errors
    /// It would be another program: why.
    pub(crate) fn in_text(&self, read: &Context, text: &str) -> Result<Option<String>, RenameRefused> {
        let is_member = self.kind == "member";
        let outline = Outline::new(Arc::new(read.clone()));
        let entries = flat(&outline.entries);
        let mut words = entries.iter().flat_map(|entry| words(&outline, entry));
        let was = Name::new(&self.was);
        let at = words.find_map(|word| {
            let ((scope, member, name), at) = word.named?;
            (name == was && member == is_member && scope == self.scope).then_some(at.start())
        });
        let Some(at) = at else { return Ok(None) };
        let files = rename(read, at, &self.is, &Alone, &Options::default())?;
        let own = files.iter().find(|file| file.file == read.name);
        Ok(own.map(|file| apply(text, &file.edits)))
    }
}
