//! `recursive-call`: a function that calls itself, directly or through others.

use super::circles::{Use, circles, way};
use super::survey::Survey;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::context::{Body, Context};
use crate::networks::BlockAt;
use crate::networks::control_flow::ControlFlow;
use crate::networks::network::Meaning;
use ladder_instructions::Op;
use ladder_syntax::Name;

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Names,
    "recursive-call",
    Severity::Warning,
));

pub(super) fn check(survey: &Survey<'_>, out: &mut Vec<Diagnostic>) {
    let context = survey.context;
    if context.functions.is_empty() || !survey.any.has(ControlFlow::CALL) {
        return;
    }
    // Functions first, then blocks: a function may call itself through a block that it uses.
    let functions = context.functions.len();
    let mut uses: Vec<Vec<Use>> = vec![Vec::new(); functions + context.own_blocks];
    for (network, body) in context.bodies.iter().enumerate() {
        let user = match *body {
            Body::Main => continue,
            Body::Function(function) => function,
            Body::Block(block) => functions + block,
        };
        // Most call nothing: their blocks need not be read.
        let calls = ControlFlow::CALL.with(ControlFlow::USER_BLOCK);
        if !survey.control_flow(network).has(calls) {
            continue;
        }
        for bound in context.networks.at(network).blocks() {
            match bound.meaning {
                // Blocks of other files call functions of theirs.
                Meaning::User(block) if block >= context.own_blocks => {}
                Meaning::User(block) => uses[user].push((functions + block, bound.head_range())),
                _ => uses[user].extend(called(context, bound)),
            }
        }
    }
    for (first, around) in circles(&uses, uses.len()) {
        // A circle of blocks alone is the error recursive-block.
        if first < functions || around.iter().any(|&(used, _)| used < functions) {
            out.push(recursive(context, first, &around));
        }
    }
}

fn called(context: &Context, bound: BlockAt<'_>) -> Option<Use> {
    let name = bound.facts.first_name();
    let (name, range) = name.filter(|_| bound.op() == Some(Op::Call))?;
    let function = context.function(&Name::new(name))?;
    Some((function, bound.absolute(range)))
}

fn recursive(context: &Context, first: usize, around: &[Use]) -> Diagnostic {
    let functions = context.functions.len();
    let name = |node: usize| match node.checked_sub(functions) {
        None => format!("`{}`", context.functions[node].name),
        Some(block) => format!("`{}`", context.user_blocks[block].name),
    };
    let message = match around {
        [_] => format!("the function {} calls itself", name(first)),
        _ => {
            let way = way(around.iter().map(|&(used, _)| name(used)), ", then ");
            format!("{} calls itself: by way of {way}", name(first))
        }
    };
    let at = around.first().map_or_else(Default::default, |&(_, at)| at);
    let mut found = Diagnostic::new(RULE, at, message)
        .help("calls nest to a depth of 64, then the simulation stops with a fault: use <FOR> to repeat, or break the circle");
    for &(used, at) in &around[1..] {
        found = found.related(at, format!("{} is used here", name(used)));
    }
    found
}
