//! `never-written`: a tag that is read, or an output, that nothing writes.

use super::parts::Part;
use super::tag_view::TagView;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity, When};
use crate::names::scope::{Origin, SectionKind};
use crate::program::Role;
use crate::values::types::{Scalar, Type};

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Program, "never-written", Severity::Info).when(When::WholeAndNames));

pub(super) fn check(view: &TagView<'_>, out: &mut Vec<Diagnostic>) {
    let tag = view.tag;
    if !view.reports_use() {
        return;
    }
    // One that is an input only because other devices may write it is told: that is for the reader to know.
    let is_input = tag.role == Role::Input && tag.origin != Origin::Declared(SectionKind::Var);
    if tag.constant || is_input || !tag.cold.initial.is_empty() {
        return;
    }
    if view.is_written() {
        if tag.origin == Origin::Declared(SectionKind::Var)
            && tag.cold.address.is_none()
            && !view.unread.written
        {
            let elements = view
                .parts()
                .filter(|part| part.is_element && part.touched.writes == 0);
            out.extend(elements.filter_map(|element| unwritten(view, &element)));
        }
        return;
    }
    let name = &tag.name;
    let stays = stays(tag.ty);
    let (message, help) = match (tag.origin, tag.ty) {
        (Origin::Declared(SectionKind::Output), _) => (
            format!("the output `{name}` is never written: it stays {stays}"),
            "write it with a coil or another block, or remove its declaration",
        ),
        // never-read says that it is not used at all.
        _ if !view.is_read() => return,
        (Origin::Declared(SectionKind::Var | SectionKind::Global), Some(Type::State(state))) => (
            format!(
                "no [{}] block works on `{name}`: it stays as it is at the start",
                state.name()
            ),
            "put the block with this tag onto a rung",
        ),
        // A panel may write what lies at an address.
        (Origin::Declared(SectionKind::Var), _) if tag.cold.address.is_none() => (
            format!("`{name}` is read, and nothing writes it: it stays {stays}"),
            "write it; declare it in VAR_INPUT if it comes from outside; or give it a value and declare it CONSTANT",
        ),
        (Origin::Declared(SectionKind::Global), _) if tag.cold.address.is_none() => (
            format!("the global `{name}` is read, and no file of the workspace writes it: it stays {stays}"),
            "write it; or give it a value and declare it CONSTANT",
        ),
        (Origin::Form, _) if tag.cold.address.is_none() => (
            format!("`{name}` is read, and nothing writes it: it is {stays} unless it is given from outside"),
            "write it, or use an input (I and a number) if it comes from outside",
        ),
        _ => return,
    };
    let at = view
        .context
        .uses(tag)
        .next()
        .map_or(tag.declared_at, |first| first.range);
    let mut found = Diagnostic::new(RULE, at, message).help(help);
    if at != view.context.place_of(tag) {
        found = found.related(tag.declared_at, format!("`{name}` is declared here"));
    }
    out.push(found);
}

/// An element that is read, of an array of which others are written.
fn unwritten(view: &TagView<'_>, element: &Part<'_>) -> Option<Diagnostic> {
    let at = view.context.networks.use_of(*element.own.first()?).range;
    let stays = stays(view.tag.ty);
    let message = format!(
        "`{}` is read, and nothing writes this element: it stays {stays}",
        element.name
    );
    let help = "write it, or read another element";
    Some(Diagnostic::new(RULE, at, message).help(help))
}

fn stays(ty: Option<Type>) -> &'static str {
    match ty {
        Some(
            Type::Scalar(Scalar::Bool)
            | Type::Array {
                element: Scalar::Bool,
                ..
            },
        ) => "off",
        Some(Type::Scalar(Scalar::String(_))) => "empty",
        Some(Type::State(_)) => "as it is",
        _ => "0",
    }
}
