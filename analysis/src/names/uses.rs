//! Which tags the operands of all blocks name, and how they use them. Tags that are nowhere declared come into
//! their scope here.

use super::cold::{Cold, ColdFacts};
use super::joined::Joined;
use super::scope::{Origin, Scope, SectionKind, TagFacts, type_by_form};
use super::unread_uses::UnreadUses;
use super::values_asked::Asking;
use crate::cancel::Cancel;
use crate::names::context::Context;
use crate::networks::named::spelling;
use crate::networks::reading::TOGETHER;
use crate::networks::use_place::{UseRef, Uses};
use crate::program::Access;
use crate::program::Role;
use crate::values::types::{Scalar, Type};
use ladder_instructions::{Semantics, Writers};
use ladder_syntax::TextRange;

/// Enters every use of every tag into its scope. None if that is cancelled.
pub(crate) fn collect(context: &mut Context, cancel: &Cancel) -> Option<()> {
    let semantics = context.profile.semantics();
    let mut types = std::mem::take(&mut context.types);
    let mut joined = Joined::with_networks(context.networks.len());
    let mut known = Vec::new();
    for first in (0..context.networks.len()).step_by(TOGETHER) {
        let together = first..(first + TOGETHER).min(context.networks.len());
        // Each name leads to another place in memory. The processor goes to several at once if nothing is done between.
        for network in context.networks.range(together.clone()) {
            let scope = &context.scopes[network.scope];
            known.extend(network.facts().named.iter().map(|named| scope.find(&named.key)));
        }
        let mut known = known.drain(..);
        for network in context.networks.range(together) {
            cancel.one_more()?;
            let known = known.by_ref().take(network.named.len());
            let scope = network.scope;
            for ((number, named), known) in (0..).zip(network.named.iter()).zip(known) {
                let found = known.or_else(|| context.scopes[scope].find(&named.key));
                let mut asking = Asking {
                    scopes: &context.scopes,
                    types: &mut types,
                    others: &context.others,
                    user_blocks: &context.user_blocks,
                    semantics,
                };
                if found.is_none() && asking.is_value(network, named) {
                    joined.push(None);
                    continue;
                }
                let tags = &mut context.scopes[scope];
                let index = found
                    .unwrap_or_else(|| tags.add(undeclared(spelling(network.facts(), named), semantics)));
                let place = UseRef::new(network.index as u32, number, named.kind);
                tags.tags[index].uses.0.push(place);
                joined.push(Some(index));
            }
            joined.end_network();
        }
    }
    context.types = types;
    context.joined = joined;
    roles(&mut context.scopes[0], &context.unread, semantics.writers);
    Some(())
}

/// A tag that is first met in an operand.
pub(crate) fn undeclared(name: &str, semantics: &Semantics) -> TagFacts {
    let form = type_by_form(name).map(|(scalar, role)| match scalar {
        Scalar::Lreal => (Scalar::real_of(semantics), role),
        other => (other, role),
    });
    let is_address = name.starts_with('%');
    TagFacts {
        name: name.into(),
        ty: form.map(|(scalar, _)| Type::Scalar(scalar)),
        role: form.map_or(Role::Internal, |(_, role)| role),
        // One that is not an address is reported where it is, and for nothing else.
        origin: if form.is_some() || is_address {
            Origin::Form
        } else {
            Origin::Undeclared
        },
        retain: false,
        constant: false,
        cold: Cold::from(ColdFacts {
            address: is_address.then(|| name.into()),
            ..ColdFacts::NONE
        }),
        declared_at: TextRange::default(),
        uses: Uses::default(),
        mistyped: false,
    }
}

/// An undeclared tag that is read and never written is an input; a BOOL that coils write and nothing reads is an
/// output (LANGUAGE §4). Types are not known yet: infer checks them.
/// A declared tag is an input, too, where other devices write tags.
fn roles(scope: &mut Scope, unread: &UnreadUses, writers: Writers) {
    for tag in &mut scope.tags[scope.declared..] {
        // What an unread part says that it writes is not an input.
        if tag.origin == Origin::Undeclared && !unread.names(0, tag) {
            tag.role = role(&tag.uses);
        }
    }
    if writers == Writers::Devices {
        for tag in &mut scope.tags[..scope.declared] {
            let may_be_given = tag.origin == Origin::Declared(SectionKind::Var)
                && matches!(tag.ty, Some(Type::Scalar(_)))
                && tag.cold.initial.is_empty()
                && !tag.constant;
            if may_be_given && tag.role == Role::Internal && role(&tag.uses) == Role::Input {
                tag.role = Role::Input;
            }
        }
    }
}

fn role(uses: &Uses) -> Role {
    let read = uses.accesses().any(Access::reads);
    let written = uses.accesses().any(Access::writes);
    let by_coils = || uses.writers().all(|place| place.effect().is_coil());
    match (read, written) {
        (true, false) => Role::Input,
        (false, true) if by_coils() => Role::Output,
        _ => Role::Internal,
    }
}
