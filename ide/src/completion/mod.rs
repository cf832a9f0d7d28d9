//! Completion: what can be written at a place. One file for each kind of place.
//!
//! What is accepted leaves a text that reads: a block comes with its operands, its bracket and the wire to what is
//! drawn after it, and nothing twice that is there already. Only the cursor's line is changed: the drawing
//! around it is put straight by the formatter, which knows how wide it all became.

mod blocks;
mod drawings;
mod expression;
mod initial;
mod item;
mod keywords;
mod likeness;
mod members;
mod names;
mod operands;
mod proposals;
mod tags;

pub(crate) use blocks::{operands_of, operands_of_user};
pub use item::{Completion, CompletionKind, Completions, Snippet, Topic};

use crate::hover;
use crate::path::tag_of;
use crate::typing::{CursorContext, Declaration, Operand, Typing, typing};
use crate::wanted::{Called, Kind, called, wanted};
use ladder_analysis::context::Context;
use ladder_instructions::by_op;
use ladder_syntax::{Name, TextSize};
use proposals::Proposals;

/// What can be written at an offset. `trigger` is the character that was just typed, if that is why it is asked.
pub fn completions(context: &Context, offset: TextSize, trigger: Option<char>) -> Completions {
    let Some(typing) = typing(context, offset).filter(|typing| !typing.literal) else {
        return Completions::default();
    };
    if trigger.is_some_and(|trigger| !is_welcome(&typing, trigger)) {
        return Completions::default();
    }
    let mut out = Proposals::new(&typing);
    let mut after = Snippet::default();
    match &typing.place {
        CursorContext::LineStart => keywords::at_line_start(&typing, &mut out),
        CursorContext::Wire => blocks::on_wire(&typing, &mut out),
        CursorContext::Head(head) => blocks::in_head(&typing, head, &mut out),
        CursorContext::Declaration(place) => keywords::in_declaration(&typing, *place, &mut out),
        CursorContext::Operand(operand) => after = in_operand(&typing, operand, &mut out),
    }
    // `[TON]($0` gets the blanks that its layout has.
    let crowded = matches!(&typing.place, CursorContext::Operand(operand) if operand.first_word)
        && typing.text[..typing.word.start].ends_with(['(', ',']);
    let mut found = out.finish(if crowded { " " } else { "" }, &after);
    // More letters may say what an instruction is for, and bring others into view.
    found.cut |= matches!(typing.place, CursorContext::Wire | CursorContext::Head(_));
    found
}

/// Whether a character that was typed is worth a list: a comma between names, or a bracket around a type's bounds,
/// is not.
fn is_welcome(typing: &Typing<'_>, trigger: char) -> bool {
    match &typing.place {
        CursorContext::Head(_) => matches!(trigger, '[' | '(' | '<' | '$'),
        CursorContext::Operand(operand) => match trigger {
            '.' => operand.member_of.is_some(),
            '%' | '(' | ',' | '[' => true,
            ':' | '$' => false,
            _ => operand.open.is_empty() && operand.first_word,
        },
        CursorContext::Declaration(place) => match trigger {
            ':' => *place == Declaration::Type,
            '%' => *place == Declaration::Address,
            '$' => *place == Declaration::Type,
            '(' | '[' => *place == Declaration::Initial,
            _ => false,
        },
        CursorContext::LineStart | CursorContext::Wire => false,
    }
}

/// What can be in an operand's place. Returns what each proposal gets after it.
fn in_operand(typing: &Typing<'_>, operand: &Operand, out: &mut Proposals<'_>) -> Snippet {
    if operand.before_value && !operand.after_value {
        return Snippet::default();
    }
    let called = operand
        .shape
        .map(|shape| called(typing.context, shape, &operand.head))
        .unwrap_or_default();
    let after = blocks::rest_of_list(typing, operand, &called);
    if operand.member_of.is_some() {
        members::propose(typing, operand, out);
        return after;
    }
    let is_first = operand.before.is_empty() && operand.state.is_none() && operand.name.is_none();
    if is_first && !operand.after_value && operand.open.is_empty() && operand.head.starts_with('$') {
        let wanted = wanted(typing, operand);
        tags::states(typing, &operand.head, wanted.as_ref(), out);
    }
    let Some(wanted) = wanted(typing, operand) else {
        if operand.after_value {
            return Snippet::default();
        }
        operands::propose(typing, operand, &called, out);
        return after;
    };
    if operand.after_value {
        if wanted.expression {
            expression::operators(if operand.before_value { "" } else { "b" }, out);
        }
        return after;
    }
    match wanted.kind {
        Kind::Label => names::labels(typing, operand, out),
        Kind::Function => names::functions(typing, operand, out),
        Kind::SearchOperator => names::search_operators(out),
        _ if typing.prefix().starts_with('%') => {
            tags::propose(typing, operand, &wanted, out);
            keywords::addresses(out);
        }
        _ => {
            tags::propose(typing, operand, &wanted, out);
            if wanted.expression {
                expression::values(typing, out);
                return after;
            }
            let may_be_named = operand.first_word && operand.name.is_none();
            let of_user = matches!(called.first(), Some(Called::User(_)));
            if may_be_named && (of_user || operand.before.len() >= required(&called)) {
                operands::propose(typing, operand, &called, out);
            }
        }
    }
    after
}

fn required(called: &[Called<'_>]) -> usize {
    match called.first() {
        Some(Called::Row(row)) => row.required(),
        _ => 0,
    }
}

/// What a proposal is, in Markdown, for the one that the user has selected.
pub fn documentation(context: &Context, topic: &Topic) -> Option<String> {
    match topic {
        Topic::UserBlock(name) => {
            let block = hover::block_named(context, &Name::new(name))?;
            Some(hover::user_block_card(context, &block))
        }
        Topic::Tag(scope, name) => Some(hover::tag_card(context, tag_of(context, *scope, name)?, None)),
        other => card(other),
    }
}

/// The same, for what is known without a program: instructions, keywords.
pub fn card(topic: &Topic) -> Option<String> {
    match topic {
        Topic::Instruction(op, profile) => Some(hover::instruction_card(by_op(*op), *profile)),
        Topic::Keyword(word) => hover::keyword_card(word),
        Topic::Words(words) => Some((*words).to_owned()),
        Topic::Nothing | Topic::UserBlock(_) | Topic::Tag(..) => None,
    }
}

#[cfg(test)]
mod tests;
