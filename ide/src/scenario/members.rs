//! What is after a point in a row's name: `cell[2].`, `m1.`

use super::named_by_rows::Proposed;
use super::row::{Files, Named, named};
use crate::completion::{CompletionKind, Topic};
use ladder_analysis::program::Role;
use ladder_analysis::values::compound::Compound;
use ladder_analysis::values::types::Type;
use ladder_simulator::scenario::Direction;
use ladder_syntax::Name;

/// The members of the structure or block that a name leads to which is written up to its last point. None: it leads to
/// something else.
pub(super) fn after_point(files: Files<'_>, written: &str) -> Option<Vec<Proposed>> {
    let (base, _) = written.rsplit_once('.')?;
    let named = named(files, base)?;
    let Type::Compound(id) = named.whole? else {
        return None;
    };
    let direction = match named.file.shared(named.tag()).role {
        Role::Input => Direction::Given,
        _ => Direction::Expected,
    };
    let member = |name: &str, ty: Type| Proposed {
        order: 0,
        name: format!("{base}.{name}"),
        direction: ty.scalar().map(|_| direction),
        kind: CompletionKind::Member,
        detail: ty.to_string(),
        topic: Topic::Nothing,
    };
    match id.get() {
        Compound::Structure(structure) => {
            let members = structure.members.iter();
            Some(members.map(|it| member(&it.name, it.ty)).collect())
        }
        Compound::Block(block) => of_block(files, &named, &block, member),
        Compound::Array(_) => None,
    }
}

/// The tags of a block's body, which scenarios see all.
fn of_block(
    files: Files<'_>,
    named: &Named<'_>,
    block: &str,
    member: impl Fn(&str, Type) -> Proposed,
) -> Option<Vec<Proposed>> {
    let (home, scope) = files.body(&named.type_file, &Name::new(block))?;
    let tags = home
        .scopes
        .get(scope)?
        .tags
        .iter()
        .filter(|tag| tag.is_declared());
    Some(
        tags.filter_map(|tag| Some(member(&tag.name, home.shared(tag).ty?)))
            .collect(),
    )
}
