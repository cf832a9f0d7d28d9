//! `input-written`: a block writes a tag that is fed from outside.

use super::parts;
use super::tag_view::TagView;
use crate::findings::article::with_article;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::context::Context;
use crate::networks::NetworkAt;
use crate::networks::network::{Formal, Meaning};
use crate::networks::use_kind::Extent;
use crate::networks::use_place::Use;
use crate::program::{ParameterKind, Role};
use crate::values::types::Type;
use ladder_syntax::Name;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Names, "input-written", Severity::Warning).about_types());

pub(super) fn check(view: &TagView<'_>, out: &mut Vec<Diagnostic>) {
    let tag = view.tag;
    if matches!(tag.ty, Some(Type::Compound(_))) {
        of_instances(view, out);
    }
    // In a body a name says nothing: `I1` there is undeclared.
    let in_body = view.scope > 0 && !tag.is_declared();
    if tag.mistyped || tag.role != Role::Input || view.places.writes == 0 || tag.constant || in_body {
        return;
    }
    let mut writers = view.context.writers(tag).filter(|place| {
        let bound = view.context.networks.at(place.network).block(place.block);
        // Of an unknown block nobody knows what it writes.
        !bound.faulty && bound.instruction().is_some()
    });
    let Some(first) = writers.next() else { return };
    if view.scope > 0 && is_kept(view) {
        return;
    }
    let (what, why) = if view.scope == 0 {
        ("input", "the next reading of the inputs overwrites it")
    } else {
        (
            "input of the block",
            "its caller gives it again each time the block runs",
        )
    };
    let mut found = Diagnostic::new(
        RULE,
        first.range,
        format!(
            "`{}` is {}, and is written here: {why}",
            tag.name,
            with_article(what)
        ),
    )
    .help("write a tag of its own, and read that instead of the input where it is needed");
    for other in writers {
        found = found.related(other.range, format!("`{}` is written here as well", tag.name));
    }
    if tag.is_declared() {
        found = found.related(
            tag.declared_at,
            format!("`{}` is declared as an input here", tag.name),
        );
    }
    out.push(found);
}

/// Whether no use of the block hands over its input: then the state of each keeps what is written into it.
fn is_kept(view: &TagView<'_>) -> bool {
    let context = view.context;
    let block = view.scope - 1;
    let facts = &context.user_blocks[block];
    let key = Name::new(&view.tag.name);
    let Some(number) = facts.parameters.iter().position(|it| it.key == key) else {
        return false;
    };
    let own = context.networks.iter().flat_map(NetworkAt::blocks);
    let own = own.filter(|bound| matches!(bound.meaning, Meaning::User(used) if used == block));
    let own = own.map(|bound| {
        let has = |formal: &dyn Fn(&Formal) -> bool| bound.formals.iter().any(formal);
        has(&|it| matches!(it, Formal::Instance))
            && !has(&|it| matches!(it, Formal::Parameter(given) if *given == number))
    });
    let others = context
        .others
        .files()
        .filter_map(|file| file.outward.blocks.get(&facts.key));
    let others = others.flatten().map(|handed| handed.may_keep(number, &key));
    let mut all = own.chain(others).peekable();
    all.peek().is_some() && all.all(|keeps| keeps)
}

/// Inputs of the blocks whose states the tag holds, that are written from outside and handed over by the block as well.
fn of_instances(view: &TagView<'_>, out: &mut Vec<Diagnostic>) {
    let context = view.context;
    let uses = || view.tag.uses.0.iter();
    for place in uses().filter(|it| it.access().writes() && it.extent() == Extent::Member) {
        let place = context.networks.use_of(*place);
        let scope = context.networks.at(place.network).scope;
        let into = parts::path_of(context, &place)
            .and_then(|path| Context::into_instance(path, |base| context.path_type(scope, base)));
        let Some((state, block, word)) = into else {
            continue;
        };
        let Some(part) = parts::fixed(context, scope, state) else {
            continue;
        };
        let key = Name::new(&word.text);
        let calls = uses().filter(|it| matches!(context.networks.formal_of(**it), Formal::Instance));
        let calls = calls.map(|it| context.networks.use_of(*it));
        let mut calls = calls.filter(|it| parts::fixed_at(context, it).as_deref() == Some(&*part));
        let hands_over = |call: &Use| {
            let bound = context.networks.at(call.network).block(call.block);
            let Meaning::User(user) = bound.meaning else {
                return false;
            };
            let parameters = &context.user_blocks[user].parameters;
            let is_input = |it: &Formal| {
                matches!(it, Formal::Parameter(n)
                    if parameters[*n].key == key && parameters[*n].kind == ParameterKind::Input)
            };
            bound.formals.iter().any(is_input)
        };
        let Some(first) = calls.next() else { continue };
        if !hands_over(&first) || !calls.all(|call| hands_over(&call)) {
            continue;
        }
        let (tag, input) = (&view.tag.name, &word.text);
        let message = format!(
            "`{tag}{part}.{input}` is an input of {block}, and is written here: the block is given it again each time it runs"
        );
        let found = Diagnostic::new(RULE, place.range, message)
            .help(format!(
                "leave `{input}` out where the block is, or give it the value there"
            ))
            .related(first.range, format!("the block is given `{input}` here"));
        out.push(found);
    }
}
