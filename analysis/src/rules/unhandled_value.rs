//! `unhandled-value`: a chain of networks compares an enumeration with some of its values and not with others.

use crate::boolean::written::written;
use crate::context::{Body, Context};
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::networks::NetworkAt;
use crate::networks::facts::Node;
use crate::values::compound::EnumId;
use crate::values::types::{Scalar, Type};
use ladder_instructions::Op;
use ladder_syntax::{Name, TextRange};
use smol_str::SmolStr;

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Program,
    "unhandled-value",
    Severity::Info,
));

/// A shorter chain is one question, not a choice among all values.
const SHORTEST: usize = 2;

/// Networks one after the other that compare one tag.
struct Chain {
    path: Name,
    shown: String,
    body: Body,
    id: EnumId,
    first: TextRange,
    networks: usize,
    values: Vec<SmolStr>,
}

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    if !context.types.have_values() {
        return;
    }
    let mut open: Option<Chain> = None;
    for network in &context.networks {
        let body = context.bodies[network.index];
        let compared = compared(context, network);
        let goes_on = |chain: &Chain, path: &Name| chain.body == body && chain.path == *path;
        match (&mut open, compared) {
            (Some(chain), Some(found)) if goes_on(chain, &found.path) => {
                chain.networks += 1;
                chain.values.extend(found.values);
            }
            (_, found) => {
                out.extend(open.take().and_then(unhandled));
                open = found;
            }
        }
    }
    out.extend(open.and_then(unhandled));
}

/// What a network compares with values of an enumeration.
fn compared(context: &Context, network: NetworkAt<'_>) -> Option<Chain> {
    let mut found: Option<Chain> = None;
    for block in network
        .blocks()
        .filter(|block| block.op() == Some(Op::Eq) && !block.faulty)
    {
        let [left, right] = &*block.facts.operands else {
            continue;
        };
        let value = |node: &Node| context.value_of(network.scope, block, node);
        let (path, (id, value)) = match (value(&left.value), value(&right.value)) {
            (None, Some(value)) => (&left.value, value),
            (Some(value), None) => (&right.value, value),
            _ => continue,
        };
        if context.path_type(network.scope, path) != Some(Type::Scalar(Scalar::Enum(id))) {
            continue;
        }
        let shown = written(context, network.scope, path);
        let key = Name::new(&shown);
        match &mut found {
            Some(chain) if chain.path == key => chain.values.push(value),
            Some(_) => {}
            None => {
                found = Some(Chain {
                    path: key,
                    shown,
                    body: context.bodies[network.index],
                    id,
                    first: block.range(),
                    networks: 1,
                    values: vec![value],
                });
            }
        }
    }
    found
}

fn unhandled(chain: Chain) -> Option<Diagnostic> {
    if chain.networks < SHORTEST {
        return None;
    }
    let enumeration = chain.id.get();
    let is_missing = |name: &&SmolStr| {
        let key = Name::new(name);
        !chain.values.iter().any(|value| Name::new(value) == key)
    };
    let missing: Vec<&str> = enumeration
        .values
        .iter()
        .map(|(name, _)| name)
        .filter(is_missing)
        .map(SmolStr::as_str)
        .collect();
    let (shown, count) = (&chain.shown, chain.networks);
    (!missing.is_empty()).then(|| {
        let message = format!(
            "these {count} networks ask for values of `{shown}`, and none for {}",
            missing.join(", ")
        );
        Diagnostic::new(RULE, chain.first, message)
            .help("add a network for each, if something is to happen then")
    })
}
