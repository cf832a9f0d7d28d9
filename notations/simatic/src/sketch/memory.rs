//! The variables that only remember edges: here the place in the text does.

use crate::model::{Body, Part, Unit, Value};
use crate::standard::{Form, of_document};
use std::collections::HashSet;

/// Their names in small letters: those that stand at such a pin, and nowhere else.
pub(super) fn of(unit: &Unit) -> HashSet<String> {
    let mut memory = HashSet::new();
    let mut others = HashSet::new();
    for network in &unit.networks {
        match &network.body {
            Body::Text(..) => words(&network.text, &mut others),
            Body::Ladder(net) => {
                for part in net.wires.iter().flat_map(|wire| &wire.parts) {
                    of_part(part, &mut memory, &mut others);
                }
            }
        }
    }
    memory.retain(|name| !others.contains(name));
    memory
}

fn of_part(part: &Part, memory: &mut HashSet<String>, others: &mut HashSet<String>) {
    words(part.instance.as_deref().unwrap_or_default(), others);
    let form = of_document(&part.name).map(|row| row.form);
    if form.is_none() {
        words(&part.name, others);
    }
    for argument in &part.arguments {
        let Value::Operand(text) = &argument.value else {
            continue;
        };
        let is_bit = argument
            .pin
            .as_deref()
            .is_some_and(|pin| pin.eq_ignore_ascii_case("bit"));
        let remembers = match form {
            Some(Form::Edge(_)) => true,
            Some(Form::EdgeContact(_) | Form::EdgeCoil(_)) => is_bit,
            _ => false,
        };
        words(text, if remembers { memory } else { others });
    }
}

/// The names in a text.
fn words(text: &str, out: &mut HashSet<String>) {
    let words = text.split(|c: char| !c.is_alphanumeric() && c != '_');
    out.extend(words.filter(|word| !word.is_empty()).map(str::to_lowercase));
}
