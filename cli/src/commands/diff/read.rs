//! The files of both sides, read as what is compared.

use super::Arguments;
use super::around::Around;
use super::pairs::Pair;
use super::settings::SettingsDiff;
use super::side::{File, Text};
use crate::git::Git;
use crate::outcome::Failure;
use ladder_review::Outline;
use ladder_review::rename::{Rename, renamed};

/// A program that is compared, by the name of its file.
pub(super) struct Program {
    pub(super) name: String,
    pub(super) outline: Outline,
}

/// A program on both sides. None: there is no such file on that side.
pub(super) struct Programs {
    pub(super) old: Option<Program>,
    pub(super) new: Option<Program>,
    /// It is one file under another name.
    pub(super) renamed: bool,
    pub(super) renames: Vec<Rename>,
}

/// What is read of both sides, and what their programs see of others.
pub(super) struct Read<'g> {
    git: &'g Git,
    old: Around<'g>,
    new: Around<'g>,
    pub(super) programs: Vec<Programs>,
    pub(super) settings: Vec<SettingsDiff>,
}

impl<'g> Read<'g> {
    pub(super) fn new(arguments: &Arguments, git: &'g Git) -> Read<'g> {
        let among = arguments.among.as_deref();
        Read {
            git,
            old: Around::new(&arguments.new, among, git),
            new: Around::new(&arguments.old, among, git),
            programs: Vec::new(),
            settings: Vec::new(),
        }
    }

    /// Reads the files of a pair, unless nothing about them can be different.
    pub(super) fn add(&mut self, pair: &Pair) -> Result<(), Failure> {
        let (old, new) = (pair.old.as_ref(), pair.new.as_ref());
        let bytes = |file: Option<&File>| file.map(|file| file.bytes(self.git)).transpose();
        let (old_bytes, new_bytes) = (bytes(old)?, bytes(new)?);
        if old_bytes == new_bytes && !pair.renamed && !self.others_differ(pair)? {
            return Ok(());
        }
        let text = |file: Option<&File>, bytes: Option<Vec<u8>>| -> Result<Option<Text>, Failure> {
            let both = file.zip(bytes);
            both.map(|(file, bytes)| file.text(bytes, self.git)).transpose()
        };
        let (old_text, new_text) = (text(old, old_bytes)?, text(new, new_bytes)?);
        if pair.is_settings() {
            let named = |file: Option<&File>, text: Option<Text>| Some((file?.name.clone(), text?.ladder));
            self.settings
                .extend(SettingsDiff::new(named(old, old_text), named(new, new_text)));
            return Ok(());
        }
        let was = old.zip(old_text.as_ref());
        let mut old = program(&mut self.old, was)?;
        let new = program(&mut self.new, new.zip(new_text.as_ref()))?;
        let renames = match (was, &mut old, &new) {
            (Some((file, _)), Some(old), Some(new)) => give_new_names(&mut self.old, file, old, new)?,
            _ => Vec::new(),
        };
        self.programs.push(Programs {
            old,
            new,
            renamed: pair.renamed,
            renames,
        });
        Ok(())
    }

    /// Whether the programs around a file are not the same on both sides.
    fn others_differ(&mut self, pair: &Pair) -> Result<bool, Failure> {
        let (Some(old), Some(new), true) = (&pair.old, &pair.new, pair.is_program()) else {
            return Ok(false);
        };
        Ok(self.old.content(old)? != self.new.content(new)?)
    }
}

fn program(around: &mut Around<'_>, read: Option<(&File, &Text)>) -> Result<Option<Program>, Failure> {
    let Some((file, text)) = read else {
        return Ok(None);
    };
    let mut outline = around.outline(file, &text.ladder)?;
    if let Some(foreign) = &text.foreign {
        outline.name_parts(|range| foreign.name_of(range).map(str::to_owned));
    }
    Ok(Some(Program {
        name: file.name.clone(),
        outline,
    }))
}

/// Renames in the old program what has a new name, and says what that is.
fn give_new_names(
    around: &mut Around<'_>,
    file: &File,
    old: &mut Program,
    new: &Program,
) -> Result<Vec<Rename>, Failure> {
    let Some(renamed) = renamed(&old.outline, &new.outline) else {
        return Ok(Vec::new());
    };
    let mut outline = around.outline(file, &renamed.text)?;
    outline.take_parts(&old.outline);
    // Another file may use the old name.
    if old.outline.runs() && !outline.runs() {
        return Ok(Vec::new());
    }
    old.outline = outline;
    Ok(renamed.renames)
}
