//! The networks of a function take the place of its only call.

use super::extract_function::{lines_with_comments, starts_with_mark};
use super::flow::{has_mcr, is_flow};
use super::place::Selected;
use super::{Action, ActionKind};
use crate::drawing::item::{Item, ItemKind};
use crate::drawing::rows::{Drawing, lines_text};
use ladder_analysis::context::{Body, Context};
use ladder_analysis::networks::NetworkAt;
use ladder_analysis::written::facts::NodeKind;
use ladder_format::Edit;
use ladder_instructions::Op;
use ladder_syntax::{LineKind, Name, TextRange};
use std::ops::Range;

pub(super) fn offer(place: &Selected<'_>, out: &mut Vec<Action>) {
    let Some(on) = &place.on else { return };
    let Some(block) = on.block().filter(|block| block.op() == Some(Op::Call)) else {
        return;
    };
    let Some(NodeKind::Name(name)) = block.facts.operands.first().map(|operand| &operand.value.kind) else {
        return;
    };
    let title = format!("Inline the function `{name}` here");
    match inlined(place.context, on.network, &on.drawing, &Name::new(name)) {
        Ok(edits) => out.push(Action::new(ActionKind::Inline, title, edits)),
        Err(why) => out.push(Action::disabled(ActionKind::Inline, title, why)),
    }
}

fn inlined(context: &Context, caller: usize, drawing: &Drawing, name: &Name) -> Result<Vec<Edit>, String> {
    let function = context.function(name).ok_or("the function is in another file")?;
    if has_other_calls(context, caller, name) {
        return Err("the function is called elsewhere too".to_owned());
    }
    if context.others.have_files() {
        return Err("another file of the workspace may call the function".to_owned());
    }
    let body = context.bodies[caller];
    if matches!(body, Body::Block(_))
        || body == Body::Function(function)
        || context.networks.at(caller).scope != 0
    {
        return Err("the function runs with the tags of the file".to_owned());
    }
    let kinds: Vec<ItemKind> = drawing
        .rows
        .iter()
        .flat_map(|row| &row.items)
        .map(|item| item.kind)
        .filter(|kind| *kind != ItemKind::Comment)
        .collect();
    if !matches!(
        kinds.as_slice(),
        [ItemKind::LeftRail, ItemKind::Block(_)]
            | [ItemKind::LeftRail, ItemKind::Block(_), ItemKind::RightRail]
    ) {
        return Err("whether the function runs depends on this rung's power".to_owned());
    }
    let networks = networks_of(context, function);
    let facts = context.networks.range(networks.clone());
    let blocks = facts.clone().flat_map(NetworkAt::blocks);
    let mut control_flow =
        blocks.filter(|block| is_flow(block) && !matches!(block.op(), Some(Op::Call | Op::End)));
    let fun = control_flow.next().filter(|block| block.op() == Some(Op::Fun));
    let (Some(fun), None) = (fun, control_flow.next()) else {
        return Err("the function holds blocks of program flow: labels, jumps, returns, loops".to_owned());
    };
    if has_mcr(context, body) || has_mcr(context, Body::Function(function)) {
        return Err("an <MCR> switches rungs in one of them and not in the other".to_owned());
    }
    if facts.clone().any(|network| network.broken) {
        return Err("the function holds an error in its drawing".to_owned());
    }
    let mixed = || "declarations or blocks are between the rungs of the function".to_owned();
    let lines = lines_with_comments(context, &networks).ok_or_else(mixed)?;
    if starts_with_mark(context, &lines) {
        return Err("the function is first in a file with a byte order mark".to_owned());
    }
    if lines.contains(&context.networks.at(caller).first_line) {
        return Err("the function calls itself".to_owned());
    }
    let (first, rest) = without_fun(context, networks.start, fun.facts.rung)
        .ok_or("the rung of <FUN> cannot be drawn without it")?;
    let parse = &context.parse;
    let above = lines_text(parse, lines.start..context.networks.at(networks.start).first_line);
    let tail = lines_text(parse, rest..lines.end);
    let text = format!("{above}{first}{tail}");
    let text = text.trim_end_matches(['\n', '\r']);
    let place = drawing.range();
    Ok(vec![
        Edit {
            range: place,
            text: format!("{text}{}", comments(drawing)),
        },
        Edit {
            range: with_blanks_above(context, &lines),
            text: String::new(),
        },
    ])
}

/// The comments on the rung of the call.
fn comments(drawing: &Drawing) -> String {
    let items = drawing.rows.iter().flat_map(|row| &row.items);
    let comments = items.filter(|item| item.kind == ItemKind::Comment);
    comments.flat_map(|item| ["  ", &item.text]).collect()
}

/// Whether the function is called in any place but this.
fn has_other_calls(context: &Context, caller: usize, name: &Name) -> bool {
    let mut calls = 0;
    for (index, network) in context.networks.iter().enumerate() {
        for block in network.blocks().filter(|block| block.op() == Some(Op::Call)) {
            let operand = block.facts.operands.first().map(|operand| &operand.value.kind);
            if matches!(operand, Some(NodeKind::Name(other)) if Name::new(other) == *name) {
                calls += if index == caller { 1 } else { 2 };
            }
        }
    }
    calls != 1
}

/// The networks of a function.
fn networks_of(context: &Context, function: usize) -> Range<usize> {
    let start = context.functions[function].network;
    let rest = context.bodies[start..].iter();
    let count = rest.take_while(|body| **body == Body::Function(function)).count();
    start..start + count
}

/// The first network of a function without its `<FUN>`, and the line after it.
fn without_fun(context: &Context, network: usize, row: usize) -> Option<(String, usize)> {
    let mut drawing = Drawing::read(context, network)?;
    let facts = context.networks.at(network);
    let after = facts.first_line + facts.wiring.line_offsets.last()? + 1;
    let fun = drawing.rows[row].items.iter().position(|item| match item.kind {
        ItemKind::Block(Some(number)) => facts.blocks[number].op() == Some(Op::Fun),
        _ => false,
    })?;
    drawing.take(row, fun);
    let has_block = drawing.rows.iter().flat_map(|row| &row.items).any(Item::is_block);
    if has_block {
        // What `<FUN>` was before must still be one network of the same order.
        drawing.order()?;
        let ends = lines_text(&context.parse, after - 1..after);
        let line_end = if ends.ends_with(['\n', '\r']) {
            drawing.line_end()
        } else {
            ""
        };
        return Some((format!("{}{line_end}", drawing.text()), after));
    }
    Some((String::new(), after))
}

/// The lines, and the blank ones right above them.
fn with_blanks_above(context: &Context, lines: &Range<usize>) -> TextRange {
    let parse = &context.parse;
    let blank = (0..lines.start)
        .rev()
        .take_while(|&line| parse.lines()[line].kind == LineKind::Blank)
        .count();
    TextRange::new(
        parse.line_start(lines.start - blank),
        parse.line_range(lines.end - 1).end(),
    )
}
