//! Which kinds of values turn into which in copies, and how much is packed into what.

use super::super::bank::{Bank, Kind};
use super::super::model::{Constant, Operand};
use super::super::operand::{fits, kind};
use super::Found;
use super::kinds::sort;
use ladder_notation::LineColumn;

/// The page's table of what turns into what in a copy.
pub(super) fn copied(place: LineColumn, source: &Operand, to: Kind, out: &mut Found) {
    let number = |kind: Kind| !matches!(kind, Kind::Bit | Kind::Text);
    if let Operand::Constant(constant) = source {
        let turns = match constant {
            Constant::Bit(_) => to == Kind::Bit,
            Constant::Text(_) => to == Kind::Text,
            Constant::Int(_) => number(to) || fits(constant, to),
            Constant::Hex(_) | Constant::Float(_) => number(to),
        };
        let shown = out.words.operand(source);
        if !turns {
            let message = format!("{shown} does not turn into {}", sort(to));
            out.error(place, "click-copy", message);
        } else if matches!(constant, Constant::Int(_) | Constant::Hex(_)) && !fits(constant, to) {
            let message =
                format!("{shown} does not fit its destination, which takes the nearest value that does");
            out.warning(place, "click-constant", message);
        }
        return;
    }
    let Some(from) = kind(source) else { return };
    if from != to && !(number(from) && number(to)) {
        let message = format!(
            "{} does not turn into {}: {}",
            sort(from),
            sort(to),
            out.words.operand(source)
        );
        out.error(place, "click-copy", message);
    }
}

/// What may be packed into what, and how much of it.
pub(super) fn packed(place: LineColumn, from: Bank, count: usize, to: Bank, out: &mut Found) {
    use Bank::{C, Ct, Ctd, Dd, Df, Dh, Ds, Sc, T, Td, Txt, X, Y};
    let most = match (from, to) {
        (X | Y | T | Ct | Sc, Dh) | (C, Ds | Dh) => 16,
        (C, Dd | Df) => 32,
        (Ds | Dh, Dd | Df) => 2,
        (Txt, Ds | Dd | Dh | Df | Td | Ctd) => 1_000,
        _ => 0,
    };
    no_more_than(most, count, place, (from, "packed", to), out);
}

pub(super) fn unpacked(place: LineColumn, from: Bank, to: Bank, count: usize, out: &mut Found) {
    use Bank::{C, Dd, Df, Dh, Ds, Y};
    let most = match (from, to) {
        (Ds | Dh, C | Y) => 16,
        (Dd | Df, C | Y) => 32,
        (Dd | Df, Ds | Dh) => 2,
        _ => 0,
    };
    no_more_than(most, count, place, (from, "unpacked", to), out);
}

/// What goes into what, and by which way: none of it may, or this many addresses.
fn no_more_than(
    most: usize,
    count: usize,
    place: LineColumn,
    (from, way, to): (Bank, &str, Bank),
    out: &mut Found,
) {
    if most == 0 {
        let (from, to) = (out.words.bank(from), out.words.bank(to));
        out.error(place, "click-pack", format!("{from} is not {way} into {to}"));
    } else if count > most {
        out.error(
            place,
            "click-pack",
            format!("no more than {most} addresses go into it, and these are {count}"),
        );
    }
}
