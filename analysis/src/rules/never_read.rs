//! `never-read`: a tag of the program that no block reads.

use super::parts::Part;
use super::tag_view::TagView;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity, When};
use crate::names::scope::{Origin, SectionKind};
use crate::program::Role;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Program, "never-read", Severity::Info).when(When::WholeAndNames));

pub(super) fn check(view: &TagView<'_>, out: &mut Vec<Diagnostic>) {
    let tag = view.tag;
    if !view.reports_use() {
        return;
    }
    if view.is_written() && !view.has_outputs() {
        return;
    }
    if view.is_read() {
        let is_plain = !tag.retain && tag.cold.address.is_none() && !view.unread.read;
        if is_plain && tag.origin == Origin::Declared(SectionKind::Var) {
            let elements = view
                .parts()
                .filter(|part| part.is_element && part.touched.reads == 0);
            out.extend(elements.filter_map(|element| unread(view, &element)));
        }
        return;
    }
    let name = &tag.name;
    let (message, help) = match tag.origin {
        Origin::Declared(SectionKind::Input) => (
            format!("the input `{name}` is declared, and nothing reads it"),
            "read it where it is meant to act, or remove its declaration",
        ),
        // What is retained, or lies at an address, may be read by a panel.
        Origin::Declared(SectionKind::Var | SectionKind::Global)
            if tag.retain || tag.cold.address.is_some() =>
        {
            return;
        }
        Origin::Declared(SectionKind::Global) if !view.is_written() => (
            format!("the global `{name}` is declared, and no file of the workspace uses it"),
            "use it, or remove its declaration",
        ),
        Origin::Declared(SectionKind::Global) => (
            format!("the global `{name}` is written, and no file of the workspace reads it"),
            "read it where it is meant to act, or remove it",
        ),
        Origin::Declared(SectionKind::Var) if view.places.writes == 0 => (
            format!("`{name}` is declared and never used"),
            "use it, or remove its declaration",
        ),
        Origin::Declared(SectionKind::Var) => (
            format!("`{name}` is written, and nothing reads it"),
            "read it where it is meant to act; declare it in VAR_OUTPUT if it is for the outside; or remove it",
        ),
        Origin::Form if tag.role == Role::Internal && tag.cold.address.is_none() => (
            format!("`{name}` is an internal tag: it is written, and nothing reads it"),
            "read it where it is meant to act, or use an output (Q and a number) if it is for the outside",
        ),
        _ => return,
    };
    out.push(Diagnostic::new(RULE, view.context.place_of(tag), message).help(help));
}

/// An element that is written, of an array of which others are read.
fn unread(view: &TagView<'_>, element: &Part<'_>) -> Option<Diagnostic> {
    let at = view.context.networks.use_of(*element.own.first()?).range;
    let message = format!("`{}` is written, and nothing reads this element", element.name);
    let help = "read it where it is meant to act, or remove what writes it";
    Some(Diagnostic::new(RULE, at, message).help(help))
}
