//! `double-coil`: a tag is written by more than one plain coil, so that the last one alone decides.

use super::parts;
use super::tag_view::TagView;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::context::Context;
use crate::networks::control_flow::ControlFlow;
use crate::networks::use_place::Use;
use crate::written::facts::Node;
use ladder_instructions::Coil;
use ladder_syntax::Name;
use rustc_hash::FxHashMap;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Program, "double-coil", Severity::Warning).about_types());

pub(super) fn check(view: &TagView<'_>, out: &mut Vec<Diagnostic>) {
    let (context, tag, leaving) = (view.context, view.tag, &view.around.leaving);
    let mut others = context.others_at_address(tag).peekable();
    let shared_address = tag.cold.address.as_deref().filter(|_| others.peek().is_some());
    if tag.uses.writers().nth(1).is_none() && shared_address.is_none() {
        return;
    }
    if !context.is_first_at_address(tag) {
        return;
    }
    let names = std::iter::once(tag).chain(others);
    let coils = names.flat_map(|name| context.writers(name));
    let mut coils: Vec<Use> = coils.filter(|place| is_plain_coil(context, place)).collect();
    if coils.len() < 2 {
        return;
    }
    coils.sort_by_key(|coil| coil.range.start());
    // A tag as a whole, or its members, bits and elements one by one.
    let mut places: FxHashMap<Name, (String, Vec<Use>)> = FxHashMap::default();
    for coil in coils {
        let scope = context.networks.at(coil.network).scope;
        let Some(part) = parts::fixed(context, scope, operand(context, &coil)) else {
            continue;
        };
        let (written, coils) = places.entry(Name::new(&part)).or_default();
        if coils.is_empty() {
            *written = part;
        }
        coils.push(coil);
    }
    for (part, coils) in places.into_values() {
        let name = format!("{}{part}", shared_address.unwrap_or(&tag.name));
        for together in coils.chunk_by(|a, b| both_run(context, leaving, a, b)) {
            out.extend(double(context, &name, together));
        }
    }
}

fn double(context: &Context, name: &str, coils: &[Use]) -> Option<Diagnostic> {
    let [first, second, rest @ ..] = coils else {
        return None;
    };
    let place = |coil: &Use| {
        let bound = context.networks.at(coil.network).block(coil.block);
        bound.absolute(bound.facts.operands[coil.operand].value.range)
    };
    let mut found = Diagnostic::new(
        RULE,
        place(second),
        format!(
            "`{name}` is written by {} coils: the last one alone decides",
            coils.len()
        ),
    )
    .help("combine all conditions into one coil, joined with \\ and /; or use (S) and (R)");
    for other in std::iter::once(first).chain(rest) {
        found = found.related(place(other), format!("`{name}` is written here as well"));
    }
    Some(found)
}

fn is_plain_coil(context: &Context, place: &Use) -> bool {
    let network = context.networks.at(place.network);
    !network.broken
        && !network.blocks[place.block].faulty
        && matches!(
            network.blocks[place.block].coil(),
            Some(Coil::Follows | Coil::Negated)
        )
}

fn operand<'c>(context: &'c Context, place: &Use) -> &'c Node {
    &context.block_at(place).facts.operands[place.operand].value
}

/// The networks with a block that may leave the straight way down, from top to bottom: what is after such a block may be the
/// other case of what is before.
#[derive(Debug)]
pub(super) struct Leaving(Vec<usize>);

impl Leaving {
    /// The blocks that may leave it.
    pub(super) const WAYS: ControlFlow = ControlFlow::LEAVES.with(ControlFlow::FOR);

    /// Those of a file. `any` is what its networks have together of program flow.
    pub(super) fn of(context: &Context, any: ControlFlow) -> Leaving {
        let networks = any.has(Leaving::WAYS).then(|| context.networks.iter());
        let leaving = networks.into_iter().flatten();
        let leaving = leaving.filter(|network| network.control_flow.has(Leaving::WAYS));
        Leaving(leaving.map(|network| network.index).collect())
    }

    /// How many are above a network.
    fn above(&self, network: usize) -> usize {
        self.0.partition_point(|&leaving| leaving < network)
    }
}

/// Whether two coils, the first before the second in the text, both run in every scan, as far as a look at the
/// text can say.
fn both_run(context: &Context, leaving: &Leaving, a: &Use, b: &Use) -> bool {
    // Within one network the block that leaves it may be between them.
    let end = b.network.max(a.network + 1);
    context.bodies[a.network] == context.bodies[b.network] && leaving.above(end) == leaving.above(a.network)
}
