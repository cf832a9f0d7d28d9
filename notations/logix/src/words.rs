//! What is done with the bytes and digits of words, as formulas of `[CALC]`: there these are instructions.

/// The ways to swap the bytes of a word.
pub(crate) const MODES: &[&str] = &["REVERSE", "WORD", "HIGH/LOW"];

/// `SWPB`: the bytes of a word of 16 or 32 bits in another order. None: there is no such mode.
pub(crate) fn swapped(source: &str, bits: u32, mode: &str) -> Option<String> {
    Some(match (bits, mode.to_ascii_uppercase().as_str()) {
        (16, "REVERSE" | "WORD" | "HIGH/LOW") => format!("{source} SHL 8 OR {source} SHR 8 AND 255"),
        (32, "REVERSE") => format!(
            "{source} SHL 24 OR {source} SHL 8 AND 16711680 OR {source} SHR 8 AND 65280 OR {source} SHR 24 AND 255"
        ),
        (32, "WORD") => format!("{source} SHL 16 OR {source} SHR 16 AND 65535"),
        (32, "HIGH/LOW") => format!("{source} SHL 8 AND -16711936 OR {source} SHR 8 AND 16711935"),
        _ => return None,
    })
}

/// How many decimal digits a word of so many bits has.
const fn digits(bits: u32) -> u32 {
    bits / 4
}

/// `TOD`: a number as decimal digits, four bits each.
pub(crate) fn to_bcd(source: &str, bits: u32) -> String {
    let digit = |digit: u32| match digit {
        0 => format!("{source} MOD 10"),
        _ => format!("{source} / {} MOD 10 * {}", 10u64.pow(digit), 16u64.pow(digit)),
    };
    let all: Vec<String> = (0..digits(bits)).map(digit).collect();
    all.join(" + ")
}

/// `FRD`: the number that decimal digits say.
pub(crate) fn from_bcd(source: &str, bits: u32) -> String {
    let digit = |digit: u32| match digit {
        0 => format!("({source} AND 15)"),
        _ => format!("({source} SHR {} AND 15) * {}", 4 * digit, 10u64.pow(digit)),
    };
    let all: Vec<String> = (0..digits(bits)).map(digit).collect();
    all.join(" + ")
}

/// `ATAN2`: the angle of the point whose height is `y`, from -PI to PI. Nothing is divided by 0, which is a fault.
pub(crate) fn angle(y: &str, x: &str) -> String {
    let upright = format!("SEL({y} > 0, SEL({y} < 0, 0, -PI / 2), PI / 2)");
    let turned = format!("SEL({x} < 0, 0, SEL({y} < 0, PI, -PI))");
    format!("SEL({x} = 0, ATAN({y} / SEL({x} = 0, {x}, 1)) + {turned}, {upright})")
}

/// An element of a copy between arrays of words of other widths: the low bytes come first. `number` is which one it is,
/// `from` the array with the index where it begins, each with its width in bits.
pub(crate) fn element(number: u32, width: u32, from: (&str, i64), own: u32) -> String {
    let (array, first) = from;
    if own >= width {
        let each = own / width;
        let index = first + i64::from(number / each);
        return match number % each * width {
            0 => format!("{array}[{index}]"),
            shift => format!("{array}[{index}] SHR {shift}"),
        };
    }
    let each = width / own;
    let mask = (1u64 << own) - 1;
    let part = |part: u32| {
        let index = first + i64::from(number * each + part);
        match part * own {
            0 => format!("{array}[{index}] AND {mask}"),
            shift => format!("({array}[{index}] AND {mask}) SHL {shift}"),
        }
    };
    (0..each).map(part).collect::<Vec<_>>().join(" OR ")
}
