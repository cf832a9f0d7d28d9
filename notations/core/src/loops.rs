//! Programs with loops (`<FOR>` .. `<NEXT>`), for systems that have jumps: two tags count the turns, and the networks of the loop
//! are between two labels. The comment on the tag that holds how many turns there are says so, for people and for [`again`], which
//! makes a loop of it where such a program is read.

pub(crate) mod again;

use crate::elements::{Around, Declared, Replaced, by_origin, put_around, replace, rung};
use crate::fresh::Fresh;
use crate::functions::head;
use crate::rewritten::own_networks;
use crate::target::Stays;
use ladder_analysis::Analysis;
use ladder_analysis::context::{Body, Context};
use ladder_analysis::program::{Argument, Block, Expr, ExprKind, Network};
use ladder_analysis::values::types::{Scalar, passes};
use ladder_analysis::values::value::Value;
use ladder_format::program::{self, Declaration, Expression, Item, Operand, Path, ProgramSketch};
use ladder_instructions::Op;
use ladder_syntax::{Name, TextSize};
use std::collections::HashMap;
use std::ops::RangeInclusive;

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
    /// Where the FOR is, and the NEXT.
    begin: TextSize,
    end: TextSize,
}

/// A program whose loops are jumps. One that cannot be, because something outside jumps into it or an `<MCR>` rules it, stays a loop,
/// and so does one that is an instruction of the system. None: none is to be.
pub(crate) fn as_jumps(analysis: &Analysis, stays: fn(&Context) -> Stays) -> Option<ProgramSketch> {
    let context = &analysis.context;
    let networks = own_networks(analysis)?;
    let loops = loops(context, &networks);
    if loops.is_empty() {
        return None;
    }
    let stays = stays(context);
    let mut sketch = ProgramSketch::of_text(&context.parse);
    let drawn = by_origin(&sketch.items);
    let (mut around, mut instead, mut declared) = (HashMap::new(), Replaced::new(), Declared::default());
    for it in loops {
        let operands = drawn
            .get(&it.begin.into())
            .map_or(&[][..], |block| block.operands());
        let Some(Operand::Value(count)) = operands.first() else {
            continue;
        };
        let body = context.bodies[it.first];
        let is_instruction = match body {
            Body::Block(block) => stays.blocks.contains(&block),
            _ => false,
        };
        if is_instruction || stays.turns.contains(&Name::new(&count.to_string())) {
            continue;
        }
        let turn = operands.iter().find_map(|operand| match operand {
            Operand::Taken(_, tag) => Some(tag.clone()),
            _ => None,
        });
        draw(&it, context, (count.clone(), turn), &mut around, &mut instead)?;
        let tags = [("count", MARK), ("turn", TURN)].map(|(what, comment)| Declaration {
            comment: Some(comment.to_owned()),
            ..Declaration::new(format!("{}_{what}", it.name), it.ty.name())
        });
        declared.add(body, tags);
    }
    if instead.is_empty() {
        return None;
    }
    replace(&mut sketch.items, &instead);
    put_around(&mut sketch.items, &mut around);
    declared.put(&mut sketch.items);
    Some(sketch)
}

/// The jumps of a loop.
fn draw(
    it: &Loop,
    context: &Context,
    (count, turn): (Expression, Option<Expression>),
    around: &mut HashMap<usize, Around>,
    instead: &mut Replaced,
) -> Option<()> {
    let name = &it.name;
    let tag = |what: &str| Expression::from(Path::tag(format!("{name}_{what}")));
    let end = format!("{name}_end");
    let from = Some(it.begin.into());
    let block = |op: Op, operands: Vec<Expression>| program::Block::of(op, operands).ok();
    let own = |blocks: Vec<program::Block>, from| [rung(blocks, from), Item::Blank];
    instead.insert(it.begin.into(), vec![block(Op::Mov, vec![tag("count"), count])?]);
    let begins = around.entry(it.first).or_default();
    for what in ["count", "turn"] {
        begins
            .above
            .extend(own(vec![block(Op::Mov, vec![tag(what), 0.into()])?], from));
    }
    let ends = vec![
        block(Op::Ge, vec![tag("turn"), tag("count")])?,
        program::Block::jump(&end),
    ];
    begins.below.push(Item::Blank);
    begins.below.extend(own(vec![program::Block::label(name)], from));
    begins.below.extend(own(ends, from));
    let next = block(Op::Add, vec![tag("turn"), tag("turn"), 1.into()])?;
    begins.below.extend(own(vec![next], from));
    if let Some(turn) = turn {
        begins
            .below
            .extend(own(vec![block(Op::Mov, vec![turn, tag("turn")])?], from));
    }
    let last = around.entry(it.last).or_default();
    let from = Some(it.end.into());
    last.is_gone = context.networks.at(it.last).blocks().count() == 1;
    last.below.push(Item::Blank);
    last.below.extend(own(vec![program::Block::jump(name)], from));
    last.below.extend(own(vec![program::Block::label(&end)], from));
    instead.insert(it.end.into(), Vec::new());
    Some(())
}

/// The loops of a file that can be jumps.
fn loops(context: &Context, networks: &[(&Network, usize)]) -> Vec<Loop> {
    let begins: Vec<_> = (context.networks.iter())
        .flat_map(|network| network.blocks().map(move |block| (network.index, block)))
        .filter(|(_, block)| head(*block) == "<FOR>")
        .collect();
    if begins.is_empty() {
        return Vec::new();
    }
    let blocks = networks.iter().flat_map(|(network, _)| &network.blocks);
    let by_start: HashMap<TextSize, &Block> = blocks
        .map(|block| (block.location.range.start(), block))
        .collect();
    let marks = marks(context);
    let pairs = context.loops();
    let mut names = Fresh::of(context, "loop_");
    let mut loops = Vec::new();
    for (at, (first, begin)) in begins.iter().enumerate() {
        let (first, body) = (*first, context.bodies[*first]);
        let is_next_to = |other: Option<&(usize, _)>| other.is_some_and(|(other, _)| *other == first);
        if is_next_to(begins.get(at + 1)) || at.checked_sub(1).is_some_and(|at| is_next_to(begins.get(at))) {
            continue;
        }
        let has = |index: usize, op: &str| {
            context
                .networks
                .at(index)
                .blocks()
                .find(|block| head(*block) == op)
        };
        let pair = pairs.iter().find(|(of, _)| *of == first);
        let Some((last, next)) = pair.and_then(|(_, last)| Some((*last, has(*last, "<NEXT>")?))) else {
            continue;
        };
        let own: Vec<&Mark> = (marks.iter().filter(|mark| context.bodies[mark.network] == body)).collect();
        let is_ruled = own.iter().any(|mark| mark.head == "<MCR>");
        if is_ruled || has(first, "<LBL>").is_some() || is_entered(&own, first + 1..=last) {
            continue;
        }
        let Some(ty) = by_start
            .get(&begin.range().start())
            .and_then(|block| counted(block))
        else {
            continue;
        };
        loops.push(Loop {
            name: names.next(),
            ty,
            first,
            last,
            begin: begin.range().start(),
            end: next.range().start(),
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

/// The type that counts.
fn counted(head: &Block) -> Option<Scalar> {
    let Argument::Value(number) = &head.arguments.first()?.argument else {
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
    fits(number, ty).then_some(ty)
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
