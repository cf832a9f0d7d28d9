//! Networks become a function, and a call takes their place.

use super::flow::{has_mcr, is_flow};
use super::names::new_function;
use super::place::Selected;
use super::{Action, ActionKind};
use crate::drawing::item::{Item, ItemKind};
use crate::drawing::rows::{Drawing, lines_text};
use ladder_analysis::context::{Body, Context};
use ladder_analysis::names::declaring::line_end;
use ladder_analysis::networks::NetworkAt;
use ladder_format::Edit;
use ladder_instructions::Op;
use ladder_syntax::{LineKind, TextRange, TextSize};
use std::ops::Range;

pub(super) fn offer(place: &Selected<'_>, out: &mut Vec<Action>) {
    let networks = place.networks.clone();
    if networks.is_empty() {
        return;
    }
    let name = new_function(place.context);
    let title = match networks.len() {
        1 => format!("Extract the network into the function `{name}`"),
        count => format!("Extract {count} networks into the function `{name}`"),
    };
    match extracted(place.context, networks, &name) {
        Ok(edits) => out.push(Action::new(ActionKind::Extract, title, edits).making_up(name)),
        Err(Some(why)) => out.push(Action::disabled(ActionKind::Extract, title, why)),
        Err(None) => {}
    }
}

/// The edits, or why there are none; without a reason where nobody would ask for it.
fn extracted(context: &Context, networks: Range<usize>, name: &str) -> Result<Vec<Edit>, Option<String>> {
    let body = context.bodies[networks.start];
    if context.bodies[networks.clone()]
        .iter()
        .any(|other| *other != body)
    {
        return Err(Some("the selected networks are not of one body".to_owned()));
    }
    if matches!(body, Body::Block(_)) {
        return Err(Some(
            "a user-defined block has no functions of its own".to_owned(),
        ));
    }
    let facts = context.networks.range(networks.clone());
    if facts.clone().any(|network| network.broken || network.scope != 0) {
        return Err(Some("there is an error in the network".to_owned()));
    }
    let blocks = || facts.clone().flat_map(NetworkAt::blocks);
    if blocks().any(|block| block.op() == Some(Op::Fun)) || is_call_alone(context, &networks) {
        return Err(None);
    }
    if let Some(block) =
        blocks().find(|block| is_flow(block) && !matches!(block.op(), Some(Op::Call | Op::End)))
    {
        let block = block.head_text();
        return Err(Some(format!(
            "{block} works only where it is: a function has labels, returns and loops of its own"
        )));
    }
    if has_mcr(context, body) {
        return Err(Some(
            "an <MCR> switches these rungs, and would not switch those of a function".to_owned(),
        ));
    }
    let parse = &context.parse;
    let structure = parse.structure();
    if structure.blocks.iter().any(|block| !block.closed)
        || structure.sections.iter().any(|section| !section.closed)
    {
        return Err(None);
    }
    let lines = lines_with_comments(context, &networks).ok_or(None)?;
    let line_end = line_end(parse);
    let call = format!("+--<CALL>( {name} )--+");
    let mut moved = lines_text(parse, lines.clone());
    let mut start = parse.line_start(lines.start);
    if starts_with_mark(context, &lines) {
        start += TextSize::of(MARK);
        moved.remove(0);
    }
    let ends_line = moved.ends_with(['\n', '\r']);
    if !ends_line {
        moved.push_str(line_end);
    }
    let function = begin_function(context, networks.start, start, &moved, name).ok_or(None)?;
    let place = TextRange::new(start, parse.line_range(lines.end - 1).end());
    if place.end() == parse.text_len() {
        // Nothing is after them: call and function come one after the other.
        return Ok(vec![Edit {
            range: place,
            text: format!("{call}{line_end}{line_end}{function}"),
        }]);
    }
    let last = lines_text(parse, parse.lines().len() - 1..parse.lines().len());
    let before = if last.ends_with(['\n', '\r']) {
        ""
    } else {
        line_end
    };
    Ok(vec![
        Edit {
            range: place,
            text: format!("{call}{line_end}"),
        },
        Edit {
            range: TextRange::empty(parse.text_len()),
            text: format!("{before}{line_end}{function}"),
        },
    ])
}

/// The byte order mark.
const MARK: char = '\u{feff}';

/// Whether some lines begin with the file's byte order mark.
pub(super) fn starts_with_mark(context: &Context, lines: &Range<usize>) -> bool {
    lines.start == 0 && lines_text(&context.parse, 0..1).starts_with(MARK)
}

/// A call takes the place of a function: there is nothing to extract.
fn is_call_alone(context: &Context, networks: &Range<usize>) -> bool {
    let facts = context.networks.range(networks.clone());
    let mut blocks = facts.clone().flat_map(NetworkAt::blocks);
    blocks.all(|block| block.op() == Some(Op::Call))
}

/// The lines of the networks and of the comments right above the first, if nothing but networks, comments and blank
/// lines is among them.
pub(super) fn lines_with_comments(context: &Context, networks: &Range<usize>) -> Option<Range<usize>> {
    let parse = &context.parse;
    let structure = parse.structure();
    let first = structure.networks.get(networks.start)?.lines.start;
    let last = structure.networks.get(networks.end - 1)?.lines.end;
    let lines = parse.lines();
    let plain = |line: usize| {
        (lines[line].kind == LineKind::Rung || lines[line].kind.is_decoration())
            && !lines[line].is_in_conflict()
    };
    if !(first..last).all(plain) {
        return None;
    }
    let above = (0..first)
        .rev()
        .take_while(|&line| lines[line].kind == LineKind::Comment);
    // A directive for the file belongs to its head; one for the next rung goes with it.
    let above = above.take_while(|&line| {
        let text = lines_text(parse, line..line + 1);
        line > 0 && !text.contains("allow-file") && !text.contains("profile") && !text.contains("ladder: fmt")
    });
    let start = first - above.count();
    let begins_line = start == 0 || lines_text(parse, start - 1..start).ends_with(['\n', '\r']);
    begins_line.then_some(start..last)
}

/// The text of the networks with `<FUN>` on the first rung, or on one of its own before them.
fn begin_function(
    context: &Context,
    first: usize,
    start: TextSize,
    text: &str,
    name: &str,
) -> Option<String> {
    let drawing = Drawing::read(context, first)?;
    let items = &drawing.rows[0].items;
    let at_rail = items.first().filter(|item| item.kind == ItemKind::LeftRail);
    let fun = Item::block(format!("<FUN>( {name} )"));
    let Some(rail) = at_rail.filter(|_| items.len() > 1) else {
        return Some(format!("+--{}--+{}{text}", fun.text, drawing.line_end()));
    };
    let after = usize::from(rail.at.end() - start);
    let (before, rest) = text.split_at_checked(after)?;
    Some(format!("{before}--{}--{rest}", fun.text))
}
