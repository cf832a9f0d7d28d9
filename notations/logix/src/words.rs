//! What is done with the bytes and digits of words, as formulas of `[CALC]`: there these are instructions.

use ladder_format::program::{Expression, Operator, Path, Sign};

/// The ways to swap the bytes of a word.
pub(crate) const MODES: &[&str] = &["REVERSE", "WORD", "HIGH/LOW"];

/// The bits of a value that are moved up by so many places, or down, and kept by a mask. What is moved to the end of the word needs
/// none.
fn moved(source: &Expression, up: i64, mask: Option<i64>) -> Expression {
    let source = source.clone();
    let moved = match up {
        0 => source,
        up if up > 0 => source.with(Operator::Shl, up),
        down => source.with(Operator::Shr, -down),
    };
    match mask {
        Some(mask) => moved.with(Operator::And, mask),
        None => moved,
    }
}

/// Parts of a number, one after the other with an operator between them.
fn joined(parts: impl IntoIterator<Item = Expression>, operator: Operator) -> Expression {
    let joined = parts.into_iter().reduce(|all, part| all.with(operator, part));
    joined.unwrap_or_else(|| 0.into())
}

/// `SWPB`: the bytes of a word of 16 or 32 bits in another order. None: there is no such mode.
pub(crate) fn swapped(source: &Expression, bits: u32, mode: &str) -> Option<Expression> {
    let parts: &[(i64, Option<i64>)] = match (bits, mode.to_ascii_uppercase().as_str()) {
        (16, "REVERSE" | "WORD" | "HIGH/LOW") => &[(8, None), (-8, Some(255))],
        (32, "REVERSE") => &[
            (24, None),
            (8, Some(16_711_680)),
            (-8, Some(65_280)),
            (-24, Some(255)),
        ],
        (32, "WORD") => &[(16, None), (-16, Some(65_535))],
        (32, "HIGH/LOW") => &[(8, Some(-16_711_936)), (-8, Some(16_711_935))],
        _ => return None,
    };
    let parts = parts.iter().map(|(up, mask)| moved(source, *up, *mask));
    Some(joined(parts, Operator::Or))
}

/// How many decimal digits a word of so many bits has.
const fn digits(bits: u32) -> u32 {
    bits / 4
}

/// `TOD`: a number as decimal digits, four bits each.
pub(crate) fn to_bcd(source: &Expression, bits: u32) -> Expression {
    let digit = |digit: u32| match digit {
        0 => source.clone().with(Operator::Mod, 10),
        _ => source
            .clone()
            .with(Operator::Divide, 10i64.pow(digit))
            .with(Operator::Mod, 10)
            .with(Operator::Times, 16i64.pow(digit)),
    };
    joined((0..digits(bits)).map(digit), Operator::Plus)
}

/// `FRD`: the number that decimal digits say.
pub(crate) fn from_bcd(source: &Expression, bits: u32) -> Expression {
    let digit = |digit: u32| match (moved(source, -4 * i64::from(digit), Some(15)), digit) {
        (lowest, 0) => lowest,
        (own, _) => own.with(Operator::Times, 10i64.pow(digit)),
    };
    joined((0..digits(bits)).map(digit), Operator::Plus)
}

/// `ATAN2`: the angle of the point whose height is `y`, from -PI to PI. Nothing is divided by 0, which is a fault.
pub(crate) fn angle(y: &Expression, x: &Expression) -> Expression {
    let select = |of: &Expression, relation: Operator, no: Expression, yes: Expression| {
        Expression::call("SEL", [of.clone().with(relation, 0), no, yes])
    };
    let pi = || Expression::from(Path::tag("PI"));
    let negative = || Expression::Unary(Sign::Minus, Box::new(pi()));
    let half = |of: Expression| of.with(Operator::Divide, 2);
    let below = select(y, Operator::Less, 0.into(), half(negative()));
    let upright = select(y, Operator::Greater, below, half(pi()));
    let behind = select(y, Operator::Less, pi(), negative());
    let turned = select(x, Operator::Less, 0.into(), behind);
    let divisor = select(x, Operator::Equal, x.clone(), 1.into());
    let slope = Expression::call("ATAN", [y.clone().with(Operator::Divide, divisor)]);
    select(x, Operator::Equal, slope.with(Operator::Plus, turned), upright)
}

/// An element of a copy between arrays of words of other widths: the low bytes come first. `number` is which one it is,
/// `from` the array with the index where it begins, each with its width in bits.
pub(crate) fn element(number: u32, width: u32, from: (&Path, i64), own: u32) -> Expression {
    let (array, first) = from;
    let word = |number: u32| Expression::from(array.clone().index([first + i64::from(number)]));
    if own >= width {
        let each = own / width;
        return moved(&word(number / each), -i64::from(number % each * width), None);
    }
    let each = width / own;
    let mask = (1i64 << own) - 1;
    let part = |part: u32| {
        let kept = word(number * each + part).with(Operator::And, mask);
        moved(&kept, i64::from(part * own), None)
    };
    joined((0..each).map(part), Operator::Or)
}
