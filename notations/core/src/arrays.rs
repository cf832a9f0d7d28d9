//! Programs with instructions on arrays, for systems that have none: `[UNPACK]` and `[FILL]` become a `[MOV]` for each element, and
//! `SUM(a[1..9])` in a formula the sum of its elements.

use crate::edited::{Edited, Edits, own_networks, write_edited};
use crate::{WriteError, Writing};
use ladder_analysis::Analysis;
use ladder_analysis::program::{Argument, Block, BlockKind};
use ladder_analysis::values::types::Scalar;
use ladder_format::program::Expression;
use ladder_syntax::TextRange;

/// No instruction becomes more of them.
const MOST: i64 = 64;

/// Writes a program without these instructions, which are among `[UNPACK]` and `[FILL]`, and without sums of arrays. One that cannot
/// be said by elements stays for `write`.
///
/// # Errors
///
/// Those of `write`.
pub fn with_arrays_as_elements(
    analysis: &Analysis,
    instructions: &[&str],
    write: impl Fn(&Analysis) -> Result<Writing, WriteError>,
) -> Result<Writing, WriteError> {
    write_edited(analysis, by_elements(analysis, instructions), &write)
}

fn by_elements(analysis: &Analysis, instructions: &[&str]) -> Option<Edited> {
    let text = analysis.context.parse.to_string();
    let mut edits = Edits::default();
    let networks = own_networks(analysis)?;
    for block in networks.iter().flat_map(|(network, _)| &network.blocks) {
        edits.instead.extend(edit(block, &text, instructions));
    }
    if edits.is_empty() {
        return None;
    }
    edits.program(&analysis.context)
}

/// What stands in the place of a block, or of a sum in it.
fn edit(block: &Block, text: &str, instructions: &[&str]) -> Option<(TextRange, String)> {
    let BlockKind::Instruction(row) = block.kind else {
        return None;
    };
    let [to, from] = &block.arguments[..] else {
        return None;
    };
    let value = text[from.range].trim();
    if row.block() == "[CALC]" {
        let at = value.find("SUM(")?;
        let end = at + value[at..].find(')')? + 1;
        let range = Range::of(&value[at + "SUM(".len()..end - 1])?;
        let sum: Vec<String> = range.elements().collect();
        let formula = format!("{}({}){}", &value[..at], sum.join(" + "), &value[end..]);
        return Some((from.range, formula));
    }
    if !instructions.contains(&row.block().as_str()) {
        return None;
    }
    let range = Range::of(text[to.range].trim())?;
    let Argument::Range(array) = &to.argument else {
        return None;
    };
    // All operands are read before the first element is written.
    let mut reads = false;
    let operand = Expression::read(value).ok()?;
    operand.paths(&mut |path| reads |= path.root.eq_ignore_ascii_case(range.array));
    if reads {
        return None;
    }
    let values: Vec<String> = match row.block().as_str() {
        "[FILL]" => range.elements().map(|_| value.to_owned()).collect(),
        "[UNPACK]" if array.element == Scalar::Bool && is_name(value) => {
            let Argument::Value(bits) = &from.argument else {
                return None;
            };
            let width = i64::from(bits.ty.width());
            let count = range.last - range.first + 1;
            (count <= width).then(|| (0..count).map(|bit| format!("{value}.{bit}")).collect())?
        }
        _ => return None,
    };
    let moves: Vec<String> = range
        .elements()
        .zip(values)
        .map(|(element, value)| format!("[MOV]( {element}, {value} )"))
        .collect();
    Some((block.location.range, moves.join("--")))
}

/// `fit[0..7]`
struct Range<'t> {
    array: &'t str,
    first: i64,
    last: i64,
}

impl<'t> Range<'t> {
    fn of(text: &'t str) -> Option<Range<'t>> {
        let (array, bounds) = text.trim().strip_suffix(']')?.split_once('[')?;
        let (first, last) = bounds.split_once("..")?;
        let (first, last): (i64, i64) = (first.trim().parse().ok()?, last.trim().parse().ok()?);
        let is_small = first <= last && last.checked_sub(first)? < MOST;
        (is_small && is_name(array)).then_some(Range { array, first, last })
    }

    fn elements(&self) -> impl Iterator<Item = String> {
        (self.first..=self.last).map(|index| format!("{}[{index}]", self.array))
    }
}

fn is_name(text: &str) -> bool {
    text.starts_with(|c: char| c.is_alphabetic() || c == '_')
        && text.chars().all(|c| c.is_alphanumeric() || c == '_')
}
