//! Hover on an operand: the tag with its type and who uses it, or the value; and what the block does with it.

use super::uses::{self, line_link};
use super::{Hover, types};
use crate::locate::{OnRung, node_at};
use crate::markdown;
use ladder_analysis::context::{Callee, Context};
use ladder_analysis::names::scope::{Origin, TagFacts};
use ladder_analysis::networks::BlockAt;
use ladder_analysis::networks::network::Formal;
use ladder_analysis::program::{Role, SystemTag};
use ladder_analysis::values::types::Type;
use ladder_analysis::written::constant::natural_literal;
use ladder_analysis::written::facts::{Node, NodeKind};
use ladder_instructions::Accepts;
use ladder_syntax::{Name, TextSize};
use std::fmt::Write;

pub(super) fn hover(
    context: &Context,
    place: &OnRung<'_>,
    block: BlockAt<'_>,
    offset: TextSize,
) -> Option<Hover> {
    let within = offset - block.base;
    let (index, operand) = block
        .facts
        .operands
        .iter()
        .enumerate()
        .find(|(_, operand)| operand.range.contains_inclusive(within))?;
    let formal = block.formals.get(index).copied();
    let node = node_at(&operand.value, within).unwrap_or(&operand.value);
    let what = describe(context, place, node, formal, offset);
    let used_for = match formal {
        Some(Formal::Operand(row)) => format!("`{}` of `{}`: {}", row.name, block.head_text(), row.doc),
        Some(Formal::Parameter(parameter)) => match block.meaning {
            ladder_analysis::networks::network::Meaning::User(user) => {
                let name = &context.user_blocks[user].parameters[parameter].name;
                format!("`{name}` of `{}`", block.head_text())
            }
            _ => String::new(),
        },
        _ => String::new(),
    };
    let markdown = [what.unwrap_or_default(), used_for]
        .into_iter()
        .filter(|s| !s.is_empty())
        .collect::<Vec<_>>();
    if markdown.is_empty() {
        return None;
    }
    Some(Hover {
        range: block.absolute(node.range),
        markdown: markdown.join("\n\n---\n\n"),
    })
}

/// What a node is by itself.
fn describe(
    context: &Context,
    place: &OnRung<'_>,
    node: &Node,
    formal: Option<Formal>,
    here: TextSize,
) -> Option<String> {
    if let (NodeKind::Name(name), Some(Formal::Operand(operand))) = (&node.kind, formal) {
        let key = Name::new(name);
        match operand.accepts {
            Accepts::Label => {
                let label = context.labels.iter().find(|label| label.key == key)?;
                return Some(format!(
                    "```clad\n<LBL>( {} )\n```\nLabel on line {}",
                    label.name,
                    line_link(context.line_number(label.at.start()))
                ));
            }
            Accepts::Function => {
                let own = match context.callee(&key)? {
                    Callee::Own(own) => own,
                    Callee::Other(import) => {
                        return Some(format!(
                            "```clad\n<FUN>( {name} )\n```\nFunction in {}",
                            markdown::code(&import.file)
                        ));
                    }
                };
                let function = &context.functions[own];
                let line = line_link(context.line_number(function.at.start()));
                return Some(format!(
                    "```clad\n<FUN>( {} )\n```\nFunction on line {line}",
                    function.name
                ));
            }
            _ => {}
        }
    }
    let number = context.networks.at(place.network).scope;
    let scope = &context.scopes[number];
    if let NodeKind::Member(base, word) = &node.kind
        && let Some(Type::Compound(ty)) = context.path_type(number, base)
        && let Some(block) = ty.block()
    {
        return types::of_instance(context, &block, &word.text);
    }
    match &node.kind {
        NodeKind::Name(name) | NodeKind::Address(name) => scope
            .find(&Name::new(name))
            .map(|tag| tag_card(context, &scope.tags[tag], Some(here))),
        NodeKind::Member(base, word) => {
            let (NodeKind::Name(name) | NodeKind::Address(name)) = &base.kind else {
                let ty = context.path_type(number, node)?;
                return Some(format!("```clad\n.{} : {ty}\n```", word.text));
            };
            if name.eq_ignore_ascii_case("SYS") {
                let tag = SystemTag::from_name(&word.text)?;
                return Some(format!(
                    "```clad\nSYS.{}\n```\n{}. {}",
                    tag.name(),
                    tag.ty(),
                    tag.about()
                ));
            }
            let tag = &scope.tags[scope.find(&Name::new(name))?];
            Some(format!(
                "Member `{}` of\n\n{}",
                word.text,
                tag_card(context, tag, Some(here))
            ))
        }
        _ => node.literal().map(natural_literal),
    }
}

/// A tag: its declaration in one line, where it comes from, and who writes and reads it. `here` is where the user
/// sees it already.
pub(crate) fn tag_card(context: &Context, tag: &TagFacts, here: Option<TextSize>) -> String {
    // What several scopes share is shown where it is declared.
    let tag = context.shared(tag);
    let ty = tag.ty.map(|ty| ty.to_string()).unwrap_or_default();
    let address = tag
        .cold
        .address
        .as_ref()
        .filter(|a| ***a != *tag.name)
        .map(|a| format!(" AT {a}"))
        .unwrap_or_default();
    let mut card = format!("```clad\n{}{address} : {ty}\n```\n", tag.name);
    let role = match tag.role {
        Role::Input => "input",
        Role::Output => "output",
        Role::Internal => "internal tag",
    };
    let origin = match (tag.origin, &tag.cold.foreign) {
        (_, Some(file)) => format!("declared in VAR_GLOBAL in {}", markdown::code(file)),
        (Origin::Declared(section), None) => format!(
            "declared in {} on line {}",
            section.keyword(),
            line_link(context.line_number(context.place_of(tag).start()))
        ),
        (Origin::Form, None) => "its name gives its type".to_owned(),
        (Origin::Implicit, None) => "every block has it".to_owned(),
        (Origin::Shared, None) => "shared by the whole file".to_owned(),
        (Origin::Undeclared, None) => "not declared; its type follows from its use".to_owned(),
    };
    let _ = write!(card, "{} ({origin})", capitalised(role));
    card.push_str(&uses::card(context, tag, here));
    card
}

fn capitalised(text: &str) -> String {
    let mut chars = text.chars();
    chars
        .next()
        .map(|c| c.to_ascii_uppercase().to_string() + chars.as_str())
        .unwrap_or_default()
}
