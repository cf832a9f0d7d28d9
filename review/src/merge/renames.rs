//! What one side renamed has its new name in what the other side wrote, too.

use super::Sides;
use crate::outline::Outline;
use crate::rename::{Rename, again, found};
use std::sync::Arc;

/// The three programs, with the new names in each.
pub(super) struct Carried {
    pub(super) base: Outline,
    pub(super) ours: Outline,
    pub(super) theirs: Outline,
    /// Why some have their old names.
    pub(super) refused: Vec<String>,
}

/// Renames the base, and the other side, as one side has.
pub(super) fn carried(sides: Sides<'_>) -> Carried {
    let (our, their) = (found(sides.base, sides.ours), found(sides.base, sides.theirs));
    let mut carried = Carried {
        base: sides.base.clone(),
        ours: sides.ours.clone(),
        theirs: sides.theirs.clone(),
        refused: Vec::new(),
    };
    for rename in &our {
        match their.iter().find(|other| other.is_of_same(rename)) {
            // The base alone has the old name.
            Some(other) if other.is == rename.is => drop(renamed(&mut carried.base, rename)),
            Some(other) => carried.refused.push(format!(
                "ours renamed the {} {} to {}, and theirs to {}",
                rename.kind, rename.was, rename.is, other.is
            )),
            None => carried.carry(rename, "ours", |carried| &mut carried.theirs),
        }
    }
    let only_their = their
        .iter()
        .filter(|rename| !our.iter().any(|other| other.is_of_same(rename)));
    for rename in only_their {
        carried.carry(rename, "theirs", |carried| &mut carried.ours);
    }
    carried
}

impl Carried {
    fn carry(&mut self, rename: &Rename, side: &str, other: fn(&mut Carried) -> &mut Outline) {
        let done = renamed(other(self), rename).and_then(|()| renamed(&mut self.base, rename));
        if let Err(why) = done {
            let Rename { kind, was, is, .. } = rename;
            self.refused.push(format!(
                "{side} renamed the {kind} {was} to {is}; in what the other side wrote, {why}"
            ));
        }
    }
}

/// Renames something, if it is in a program.
fn renamed(outline: &mut Outline, rename: &Rename) -> Result<(), String> {
    let text = outline.context.parse.to_string();
    let changed = rename
        .in_text(&outline.context, &text)
        .map_err(|refused| refused.0)?;
    if let Some(text) = changed {
        *outline = Outline::new(Arc::new(again(&outline.context, &text)));
    }
    Ok(())
}
