//! What a plant is connected with by name: a tag that gets another name stays connected, and is connected with nothing else.

use super::row::Files;
use crate::symbol::Symbol;
use ladder_analysis::context::Context;
use ladder_analysis::program::Role;
use ladder_analysis::values::types::Type;
use ladder_syntax::Name;

/// A tag that can be connected.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pin {
    pub(super) role: Role,
    pub(super) ty: Type,
}

impl Pin {
    /// The tag of a name in a file.
    pub(super) fn of(file: &Context, name: &Name) -> Option<Pin> {
        let scope = file.scopes.first()?;
        let tag = file.shared(&scope.tags[scope.find(name)?]);
        Some(Pin {
            role: tag.role,
            ty: tag.ty?,
        })
    }

    /// Whether the one would drive the other if they had one name.
    fn meets(self, other: Pin) -> bool {
        matches!(
            (self.role, other.role),
            (Role::Input, Role::Output) | (Role::Output, Role::Input)
        )
    }
}

/// The lines that keep a tag connected with plants once it is called `new`.
///
/// # Errors
/// It would be connected with another tag, which is named so.
pub(crate) fn lines(files: Files<'_>, symbol: &Symbol, new: &str) -> Result<Vec<String>, String> {
    let Some(old) = symbol.name() else {
        return Ok(Vec::new());
    };
    let is_of = |file: &Context| match symbol {
        Symbol::Tag {
            file: of, scope: 0, ..
        } => file.is_called(of),
        Symbol::Global(_) => file.scopes.first().is_some_and(|scope| scope.find(old).is_some()),
        _ => false,
    };
    let program = files.program();
    let mut lines = Vec::new();
    for (plant, file) in files.plants() {
        let (home, other) = match (is_of(program), is_of(&file)) {
            (true, _) => (program, &*file),
            (_, true) => (&*file, program),
            _ => continue,
        };
        let Some(own) = Pin::of(home, old) else { continue };
        let drives_plant = (own.role == Role::Output) == is_of(program);
        // What a line connects is not connected by name.
        let by_name = |theirs: &str, ours: &str| {
            let driven = if drives_plant {
                format!("{}.{theirs}", plant.name)
            } else {
                ours.to_owned()
            };
            let mut sides = files.suite.connects.iter().flat_map(|connect| &connect.sides);
            sides.all(|side| Name::new(&side.text) != Name::new(&driven))
        };
        let (theirs, ours) = if is_of(program) {
            (old.as_str(), new)
        } else {
            (new, old.as_str())
        };
        if let Some(before) = Pin::of(other, old)
            && before.meets(own)
            && before.ty == own.ty
            && by_name(old.as_str(), old.as_str())
        {
            lines.push(format!("connect {}.{theirs} = {ours}", plant.name));
        }
        if let Some(after) = Pin::of(other, &Name::new(new))
            && after.meets(own)
            && by_name(new, new)
        {
            return Err(format!(
                "{} has a tag `{new}`, too, with which it would be connected as a plant",
                other.name
            ));
        }
    }
    Ok(lines)
}
