//! Completion of `connect`: a tag of a plant on one side, one of the program that fits it on the other.

use super::completion::Proposals;
use super::connected::Pin;
use super::file::Scenarios;
use super::row::{Files, named};
use crate::completion::{CompletionKind, Snippet, Topic};
use ladder_analysis::context::Context;
use ladder_analysis::program::Role;
use ladder_analysis::values::types::Type;
use ladder_simulator::scenario::Word;
use ladder_syntax::Name;

/// What can follow these words of a connection.
pub(super) fn in_connection(scenarios: &Scenarios<'_>, words: &[Word<'_>], out: &mut Proposals) {
    let Some(files) = Files::of(scenarios) else { return };
    match words {
        [] => {
            for (plant, file) in files.plants() {
                pins(&file, &format!("{}.", plant.name), " = ", out, |_| true);
            }
        }
        [_] => out.value("=", "connected with"),
        [one, equals] if equals.text == "=" => {
            let Some(side) = named(files, one.text) else {
                return;
            };
            let Some(own) = Pin::of(&side.file, &Name::new(&side.tag().name)) else {
                return;
            };
            if side.file.is_called(&files.program().name) {
                for (plant, file) in files.plants() {
                    let fits = |pin: Pin| fits(own, pin);
                    pins(&file, &format!("{}.", plant.name), "", out, fits);
                }
            } else {
                pins(files.program(), "", "", out, |pin| fits(pin, own));
            }
        }
        _ => {}
    }
}

/// Whether a tag of the program can be connected with one of a plant.
fn fits(ours: Pin, theirs: Pin) -> bool {
    ours.ty == theirs.ty && (theirs.role == Role::Input) != (ours.role == Role::Input)
}

/// Proposes the inputs and outputs of a file that are wanted.
fn pins(file: &Context, before: &str, after: &str, out: &mut Proposals, wanted: impl Fn(Pin) -> bool) {
    let Some(scope) = file.scopes.first() else { return };
    for tag in scope.tags.iter().filter(|tag| !tag.constant) {
        let Some(pin) = Pin::of(file, &Name::new(&tag.name)) else {
            continue;
        };
        let role = match pin.role {
            Role::Input => "input",
            Role::Output => "output",
            Role::Internal => continue,
        };
        if !wanted(pin) || !matches!(pin.ty, Type::Scalar(_) | Type::Array { .. }) {
            continue;
        }
        let name = format!("{before}{}", tag.name);
        let detail = format!("{}, {role} of {}", pin.ty, file.name);
        let text = Snippet::plain_text(format!("{name}{after}"));
        out.add(CompletionKind::Tag, &name, &detail, text, Topic::Nothing);
    }
}
