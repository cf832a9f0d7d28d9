//! Properties of generated programs.

use super::case::Case;
use ladder_analysis::values::types::Scalar;
use ladder_generator::constants::literals;
use ladder_generator::generator::Dice;
use ladder_simulator::Point;

/// Properties of some of a program's tags. None: it has errors, or no tag to say anything of.
pub(crate) fn properties(case: &Case, dice: &mut Dice) -> Option<String> {
    let simulation = case.opened()?;
    let points = simulation.points().iter().filter(|point| !point.read_only);
    let (bools, others): (Vec<&Point>, Vec<&Point>) = points.partition(|point| point.ty == Scalar::Bool);
    let is_compared = |point: &&Point| !matches!(point.ty, Scalar::Enum(_)) && !point.ty.is_string();
    let others: Vec<&Point> = others.into_iter().filter(is_compared).collect();
    if bools.is_empty() && others.is_empty() {
        return None;
    }
    let holds = |dice: &mut Dice| {
        if others.is_empty() || !bools.is_empty() && dice.one_in(2) {
            dice.of(&bools).name.clone()
        } else {
            let point = dice.of(&others);
            let compare = dice.of(&["=", "<>", "<", ">="]);
            let compare = if point.ty.is_bits() { "=" } else { compare };
            format!(
                "({} {compare} {})",
                point.name,
                dice.of(literals(point.ty.name()))
            )
        }
    };
    let mut text = String::from("program program.clad\nno faults\n");
    for number in 0..6 {
        let (a, b) = (holds(dice), holds(dice));
        let form = match number {
            0 => format!("never {a}"),
            1 => format!("always {a} or not {b}"),
            2 => format!("when rises({a}): {b}"),
            3 => format!("after {a}: {b} or was({a})"),
            4 => format!("within 2 scans of {a}: {b}"),
            _ => format!("when {a}: not {b} until {b}"),
        };
        text.push_str(&format!("property \"{number}\"\n{form}\n"));
    }
    Some(text)
}
