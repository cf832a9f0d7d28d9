//! Instructions on arrays, for systems that have none: `[UNPACK]` and `[FILL]` become a `[MOV]` for each element, and `SUM(a[1..9])`
//! in a formula the sum of its elements.

use crate::elements::{Replaced, replace};
use crate::rewritten::own_networks;
use ladder_analysis::Analysis;
use ladder_analysis::program::{Argument, Block, BlockKind};
use ladder_analysis::values::types::Scalar;
use ladder_format::program::{self, Expression, Operand, Operator, Path, ProgramSketch, Step};
use ladder_instructions::Op;

/// No instruction becomes more of them.
const MOST: i64 = 64;

/// A program without these instructions, which are among `[UNPACK]` and `[FILL]`, and without sums of arrays. What cannot be expressed by
/// elements stays. None: it has nothing of it.
pub(crate) fn by_elements(analysis: &Analysis, instructions: &[Op]) -> Option<ProgramSketch> {
    let is_concerned = |block: &&Block| match block.kind {
        BlockKind::Instruction(row) => row.op == Op::Calc || instructions.contains(&row.op),
        BlockKind::User(..) => false,
    };
    let networks = own_networks(analysis)?;
    let blocks = networks.iter().flat_map(|(network, _)| &network.blocks);
    let mut blocks = blocks.filter(is_concerned).peekable();
    blocks.peek()?;
    let mut sketch = ProgramSketch::of_text(&analysis.context.parse);
    let drawn = crate::elements::by_origin(&sketch.items);
    let instead: Replaced = blocks
        .filter_map(|block| {
            let at = block.location.range.start().into();
            Some((at, elements(block, drawn.get(&at)?)?))
        })
        .collect();
    if instead.is_empty() {
        return None;
    }
    replace(&mut sketch.items, &instead);
    Some(sketch)
}

/// What is in the place of a block.
fn elements(block: &Block, drawn: &program::Block) -> Option<Vec<program::Block>> {
    let [Operand::Value(to), Operand::Value(from)] = drawn.operands() else {
        return None;
    };
    let op = drawn.op()?;
    if op == Op::Calc {
        let sum = with_sums(from)?;
        return Some(vec![program::Block::of(op, [to.clone(), sum]).ok()?]);
    }
    let (array, elements) = range(to)?;
    let [Argument::Range(of), Argument::Value(bits)] = [
        &block.arguments.first()?.argument,
        &block.arguments.get(1)?.argument,
    ] else {
        return None;
    };
    // All operands are read before the first element is written.
    let mut reads = false;
    from.paths(&mut |path| reads |= path.root.eq_ignore_ascii_case(&array.root));
    if reads {
        return None;
    }
    let values: Vec<Expression> = match (op, from) {
        (Op::Fill, _) => elements.iter().map(|_| from.clone()).collect(),
        (Op::Unpack, Expression::Path(path)) if of.element == Scalar::Bool && path.steps.is_empty() => {
            let fits = elements.len() <= bits.ty.width() as usize;
            let bit = |number: usize| path.clone().bit(number as u32).into();
            fits.then(|| (0..elements.len()).map(bit).collect())?
        }
        _ => return None,
    };
    let moves = elements.into_iter().zip(values);
    moves
        .map(|(to, value)| program::Block::of(Op::Mov, [to, value]).ok())
        .collect()
}

/// A formula with sums of elements in the place of `SUM`. None: it has none.
fn with_sums(formula: &Expression) -> Option<Expression> {
    if let Expression::Call(name, arguments) = formula
        && name.eq_ignore_ascii_case("SUM")
        && let [array] = &arguments[..]
    {
        let (_, elements) = range(array)?;
        let sum = elements
            .into_iter()
            .reduce(|sum, element| sum.with(Operator::Plus, element))?;
        return Some(Expression::Group(Box::new(sum)));
    }
    let mut changed = false;
    let formula = formula.clone().map_inner(&mut |inner| match with_sums(&inner) {
        Some(sum) => {
            changed = true;
            sum
        }
        None => inner,
    });
    changed.then_some(formula)
}

/// The array and the elements of `fit[0..7]`, which are few.
fn range(of: &Expression) -> Option<(&Path, Vec<Expression>)> {
    let path = of.path()?;
    let (Step::Range(before, bounds), to_array) = path.steps.split_last()? else {
        return None;
    };
    let number = |bound: &Expression| bound.to_string().parse::<i64>().ok();
    let (first, last) = (number(&bounds.0)?, number(&bounds.1)?);
    let is_small = first <= last && last.checked_sub(first)? < MOST;
    let element = |index: i64| {
        let indices = before.iter().cloned().chain([index.into()]).collect();
        let steps = to_array.iter().cloned().chain([Step::Index(indices)]).collect();
        Expression::Path(Path {
            root: path.root.clone(),
            steps,
        })
    };
    is_small.then(|| (path, (first..=last).map(element).collect()))
}
