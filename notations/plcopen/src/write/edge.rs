//! Edges and inverted power as elements of a drawing.

use super::declare::named;
use super::rung::{Rung, pin};
use super::touched::Touched;
use crate::graph::{End, Modifier, Storage};

/// The power that is not there.
pub(super) fn invert(rung: &mut Rung<'_>, power: Vec<End>) -> End {
    rung.block(
        ("NOT", None),
        vec![pin("IN", power)],
        &["OUT"],
        Touched::default(),
        false,
    )
}

/// A tag that is high in the scan in which power fell. The function block of the standard reports a fall in the first scan,
/// the instruction does not.
pub(super) fn fell_power(rung: &mut Rung<'_>, power: Vec<End>) -> String {
    let again = power.clone();
    fell(
        rung,
        move |rung, from| {
            let not = invert(rung, power.clone());
            let inputs = vec![pin("IN1", from), pin("IN2", vec![not])];
            vec![rung.block(("AND", None), inputs, &["OUT"], Touched::default(), false)]
        },
        move |_| again.clone(),
    )
}

/// A tag that is high in the scan in which something fell: `low` passes power on while it is low, `high` is it.
pub(super) fn fell(
    rung: &mut Rung<'_>,
    low: impl FnOnce(&mut Rung<'_>, Vec<End>) -> Vec<End>,
    high: impl FnOnce(&mut Rung<'_>) -> Vec<End>,
) -> String {
    let none = Modifier::default();
    let was = rung.made("was", named("BOOL"), "what it was at the last evaluation");
    let fell = rung.made("fell", named("BOOL"), "it fell");
    let rail = vec![rung.rail()];
    let from = vec![rung.contact(&was, none, rail, Touched::default())];
    let from = low(rung, from);
    rung.coil(&fell, none, Storage::None, from, Touched::default());
    let from = high(rung);
    rung.coil(&was, none, Storage::None, from, Touched::default());
    fell
}
