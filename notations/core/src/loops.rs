//! Programs with loops (`<FOR>` .. `<NEXT>`), for systems that have jumps: two tags count the turns, and the networks of the loop
//! stand between two labels. The comment on the tag that holds how many turns there are says so, for people and for [`again`], which
//! makes a loop of it where such a program is read.

pub(crate) mod again;

use crate::edited::{Edited, Edits, first_line, own_networks, write_edited};
use crate::functions::head;
use crate::{WriteError, Writing};
use ladder_analysis::Analysis;
use ladder_analysis::context::{Body, Context};
use ladder_analysis::program::{Argument, Block, Expr, ExprKind, Network};
use ladder_analysis::values::types::{Scalar, passes};
use ladder_analysis::values::value::Value;
use ladder_syntax::{TextRange, TextSize};
use std::collections::HashMap;
use std::ops::RangeInclusive;

/// Writes a program whose loops are jumps. One that cannot be, because something outside jumps into it or an `<MCR>` rules it, stays
/// a loop for `write`, and so does one for which `are_jumps` says no, of what it is in and its number of turns as it is written.
///
/// # Errors
///
/// Those of `write`.
pub fn with_loops_as_jumps(
    analysis: &Analysis,
    are_jumps: impl Fn(Body, &str) -> bool,
    write: impl Fn(&Analysis) -> Result<Writing, WriteError>,
) -> Result<Writing, WriteError> {
    write_edited(analysis, as_jumps(analysis, &are_jumps), &write)
}

/// The comment on the tag with the turns.
const MARK: &str = "how often a loop runs, which is <FOR> in ladder text";
/// The comment on the tag that counts them.
const TURN: &str = "the turn that it is in";

/// A loop on its way to jumps.
struct Loop {
    /// `loop_1`, the first of its labels; what else it needs is called so, too.
    name: String,
    ty: Scalar,
    /// The networks: the one with the FOR, and the one with the NEXT.
    first: usize,
    last: usize,
    /// The FOR, and how many turns there are.
    place: TextRange,
    count: TextRange,
    /// The tag that has the number of the turn.
    turn: Option<TextRange>,
    next: TextRange,
}

/// The program with jumps. None: it has no loops that can be.
fn as_jumps(analysis: &Analysis, are_jumps: &dyn Fn(Body, &str) -> bool) -> Option<Edited> {
    let context = &analysis.context;
    let networks = own_networks(analysis)?;
    let text = context.parse.to_string();
    let mut loops = loops(context, &networks, &text.to_lowercase());
    loops.retain(|it| are_jumps(context.bodies[it.first], &text[it.count]));
    if loops.is_empty() {
        return None;
    }
    edits(context, &text, &loops).program(context)
}

/// The loops of a file that can be jumps.
fn loops(context: &Context, networks: &[(&Network, Body)], text: &str) -> Vec<Loop> {
    let blocks = networks.iter().flat_map(|(network, _)| &network.blocks);
    let by_start: HashMap<TextSize, &Block> = blocks
        .map(|block| (block.location.range.start(), block))
        .collect();
    let marks = marks(context);
    let mut loops = Vec::new();
    let mut number = 0;
    for network in &context.networks {
        let mut found = network.blocks().filter(|block| head(*block) == "<FOR>");
        let (Some(begin), None) = (found.next(), found.next()) else {
            continue;
        };
        let body = context.bodies[network.index];
        let has = |index: usize, op: &str| context.networks.at(index).blocks().any(|block| head(block) == op);
        let of_body = |index: &usize| context.bodies[*index] == body;
        let mut after = (network.index + 1..context.networks.len()).take_while(of_body);
        let Some(last) = after.find(|index| has(*index, "<NEXT>")) else {
            continue;
        };
        let of_body = marks.iter().filter(|mark| context.bodies[mark.network] == body);
        let own: Vec<&Mark> = of_body.collect();
        let is_ruled = own.iter().any(|mark| mark.head == "<MCR>");
        let nests = (network.index + 1..=last).any(|index| has(index, "<FOR>"));
        if is_ruled || nests || has(network.index, "<LBL>") || is_entered(&own, network.index + 1..=last) {
            continue;
        }
        let Some(block) = by_start.get(&begin.range().start()) else {
            continue;
        };
        let Some((ty, count, turn)) = counted(block) else {
            continue;
        };
        let next = context
            .networks
            .at(last)
            .blocks()
            .find(|block| head(*block) == "<NEXT>");
        let Some(next) = next else { continue };
        let name = loop {
            number += 1;
            let name = format!("loop_{number}");
            if !text.contains(&name) {
                break name;
            }
        };
        loops.push(Loop {
            name,
            ty,
            first: network.index,
            last,
            place: begin.range(),
            count,
            turn,
            next: next.range(),
        });
    }
    loops
}

/// A block that jumps, is jumped to, or rules the networks below it.
struct Mark {
    network: usize,
    head: String,
    label: String,
}

/// All of them, each found once: many loops ask for them.
fn marks(context: &Context) -> Vec<Mark> {
    let mut marks = Vec::new();
    for network in &context.networks {
        for block in network.blocks() {
            let head = head(block);
            if !["<LBL>", "<JMP>", "<MCR>"].contains(&head.as_str()) {
                continue;
            }
            let label = block.facts.operands.first().map(|operand| {
                let range = block.absolute(operand.value.range);
                context.parse.text_in(range).to_lowercase()
            });
            marks.push(Mark {
                network: network.index,
                head,
                label: label.unwrap_or_default(),
            });
        }
    }
    marks
}

/// Whether something outside of a loop jumps into it.
fn is_entered(marks: &[&Mark], inside: RangeInclusive<usize>) -> bool {
    let names = |is_inside: bool, head: &'static str| {
        let marks = marks.iter().filter(|mark| mark.head == head);
        let marks = marks.filter(|mark| inside.contains(&mark.network) == is_inside);
        marks.map(|mark| &mark.label).collect::<Vec<_>>()
    };
    let labels = names(true, "<LBL>");
    names(false, "<JMP>").iter().any(|label| labels.contains(label))
}

/// The type that counts, how many turns there are, and the tag that has their number.
fn counted(head: &Block) -> Option<(Scalar, TextRange, Option<TextRange>)> {
    let count = head.arguments.first()?;
    let Argument::Value(number) = &count.argument else {
        return None;
    };
    let turn = head
        .arguments
        .iter()
        .find(|bound| bound.operand.is_some_and(|operand| operand.name == "I"));
    let ty = match turn.map(|turn| &turn.argument) {
        Some(Argument::Place(_, ty)) => *ty,
        Some(_) => return None,
        None if fits(number, Scalar::Dint) => Scalar::Dint,
        None => Scalar::Lint,
    };
    fits(number, ty).then_some((ty, count.range, turn.map(|turn| turn.range)))
}

/// Whether a number of turns is one of this type.
fn fits(number: &Expr, ty: Scalar) -> bool {
    match (&number.kind, ty.bounds()) {
        (ExprKind::Constant(Value::Int(number)), Some((low, high))) => {
            (low..=high).contains(&i128::from(*number))
        }
        (ExprKind::Pass(inner), _) => fits(inner, ty),
        _ => passes(number.ty, ty) && ty.is_integer(),
    }
}

/// What makes jumps of loops.
fn edits(context: &Context, text: &str, loops: &[Loop]) -> Edits {
    let parse = &context.parse;
    let structure = parse.structure();
    let mut edits = Edits::default();
    for it in loops {
        let Loop { name, ty, .. } = it;
        let (body, ty) = (context.bodies[it.first], ty.name());
        edits.declare(body, &format!("{name}_count : {ty};  # {MARK} #"));
        edits.declare(body, &format!("{name}_turn : {ty};  # {TURN} #"));
        edits
            .instead
            .push((it.place, format!("[MOV]( {name}_count, {} )", &text[it.count])));
        let own = &structure.networks[it.first].lines;
        edits
            .before
            .entry(first_line(context, it.first))
            .or_default()
            .push_str(&format!(
                "+--[MOV]( {name}_count, 0 )--+\n\n+--[MOV]( {name}_turn, 0 )--+\n\n"
            ));
        let turn = it.turn.map(|turn| {
            // `I => k`
            let turn = text[turn].rsplit(['>', '=']).next().unwrap_or_default().trim();
            format!("+--[MOV]( {turn}, {name}_turn )--+\n\n")
        });
        edits.after.entry(own.end - 1).or_default().push_str(&format!(
            "\n+--<LBL>( {name} )--+\n\n+--[GE]( {name}_turn, {name}_count )--<JMP>( {name}_end )--+\n\n\
             +--[ADD]( {name}_turn, {name}_turn, 1 )--+\n\n{}",
            turn.unwrap_or_default()
        ));
        let last = &structure.networks[it.last].lines;
        let ends = format!("\n+--<JMP>( {name} )--+\n\n+--<LBL>( {name}_end )--+\n\n");
        edits.after.entry(last.end - 1).or_default().push_str(&ends);
        if context.networks.at(it.last).blocks().count() == 1 {
            edits.gone.extend(last.clone());
        } else {
            edits.instead.push((it.next, "-".repeat(it.next.len().into())));
        }
    }
    edits
}
