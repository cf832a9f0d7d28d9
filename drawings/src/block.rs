//! Blocks: what is written in a box, or between the brackets of one, as a block of ladder text.

use crate::operand::{Operands, duration};
use ladder_format::program::{self, Block, Expression, Path};
use ladder_instructions::{Accepts, Direction, Instruction, Operand, Presence, Shape, lookup};

/// What is given to a block, by what it is called there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Given {
    /// The operand, as the drawing calls it; empty if only its place says which.
    pub(crate) name: String,
    pub(crate) value: String,
}

/// The instruction that a word is.
pub(crate) fn row(word: &str) -> Option<&'static Instruction> {
    let word = word.trim();
    if word.is_empty() || word == "/" {
        return None;
    }
    lookup(Shape::Logical, word).next()
}

/// What other systems call operands: of timers and counters, and of what calculates.
const CALLED: [(&str, &[&str]); 8] = [
    ("PT", &["PRE", "PRESET", "TIME", "DELAY"]),
    ("PV", &["PRE", "PRESET", "COUNT"]),
    ("R", &["RESET", "RST", "CLR"]),
    ("LD", &["LOAD"]),
    ("y", &["OUT", "DEST", "DESTINATION"]),
    ("a", &["IN1", "SOURCE A", "IN", "SOURCE"]),
    ("b", &["IN2", "SOURCE B"]),
    ("t", &["TIMER", "COUNTER", "INSTANCE"]),
];

/// What is only shown: how far the block is, and where its power comes and goes.
const SHOWN: [&str; 16] = [
    "IN", "EN", "CU", "CD", "Q", "Q1", "QU", "QD", "ENO", "DN", "ET", "CV", "ACC", "ACCUM", "S", "S1",
];

/// What may be after the name of an operand in a box.
const NAMES_END: [char; 4] = [':', '=', '←', ' '];

/// Whether an operand may be called so.
fn is_called(operand: &str, written: &str) -> bool {
    let operand = if operand == "c" { "t" } else { operand };
    operand.eq_ignore_ascii_case(written)
        || CALLED.iter().any(|(own, others)| {
            *own == operand && others.iter().any(|other| other.eq_ignore_ascii_case(written))
        })
}

/// A block with the operands that were found. `name` is what is written above it.
///
/// # Errors
///
/// If an operand is missing, or is none of the block's.
pub(crate) fn written(
    row: &'static Instruction,
    name: Option<&str>,
    mut given: Vec<Given>,
    operands: &mut Operands,
) -> Result<Block, String> {
    // Nothing is next to a pin without a value.
    given.retain(|it| !it.value.is_empty());
    let time_base = given
        .iter()
        .position(|it| it.name.eq_ignore_ascii_case("TIME BASE"));
    let time_base = time_base.map(|at| given.remove(at).value);
    let mut list: Vec<program::Operand> = Vec::new();
    for (number, operand) in row.operands.iter().enumerate() {
        let is_state = matches!(operand.accepts, Accepts::State(_));
        let found = given.iter().position(|it| is_called(operand.name, &it.name));
        let by_place = || {
            (operand.presence != Presence::Named).then(|| given.iter().position(|it| it.name.is_empty()))?
        };
        let value = match name {
            Some(name) if is_state => {
                if let Some(at) = found {
                    given.remove(at);
                }
                Some(name.to_owned())
            }
            // What is above a comparison or calculation is its first operand, if that is not inside.
            _ => found
                .or_else(by_place)
                .map(|at| given.remove(at).value)
                .or_else(|| {
                    let first = number == 0 && operand.presence != Presence::Named;
                    name.filter(|_| first).map(str::to_owned)
                }),
        };
        let Some(value) = value else {
            match operand.presence {
                Presence::Named | Presence::Trailing => continue,
                _ if is_state => {
                    let name = operands.fresh(&format!("{}_1", row.mnemonic.to_ascii_lowercase()));
                    list.push(Path::tag(name).into());
                    continue;
                }
                _ => return Err(format!("its operand {} is not in the drawing", operand.name)),
            }
        };
        let value = held(operand, &value, time_base.as_deref(), operands)?;
        list.push(match (operand.presence, operand.direction) {
            (Presence::Named, Direction::Out) => program::Operand::Taken(operand.name.to_owned(), value),
            (Presence::Named, _) => program::Operand::Given(operand.name.to_owned(), value),
            _ => value.into(),
        });
        let Presence::Repeated { group, .. } = operand.presence else {
            continue;
        };
        let is_last = row.operands.get(number + 1).map(|next| next.presence) != Some(operand.presence);
        let group = &row.operands[(number + 1).saturating_sub(usize::from(group))..=number];
        // They come again as often as they are given.
        for operand in group.iter().cycle().take_while(|_| is_last) {
            let is_it = |it: &Given| it.name.is_empty() || is_called(operand.name, &it.name);
            let Some(at) = given.iter().position(is_it) else {
                break;
            };
            let value = given.remove(at).value;
            list.push(held(operand, &value, None, operands)?.into());
        }
    }
    given.retain(|it| !is_shown(it));
    if let Some(more) = given.first() {
        let what = if more.name.is_empty() {
            &more.value
        } else {
            &more.name
        };
        return Err(format!("[{}] has no operand `{what}`", row.mnemonic));
    }
    Ok(Block::of(row.op, list)?)
}

/// What an operand holds.
fn held(
    operand: &Operand,
    value: &str,
    time_base: Option<&str>,
    operands: &mut Operands,
) -> Result<Expression, String> {
    let held = match operand.accepts {
        Accepts::State(_) => operands.tag(value).map(Expression::from),
        Accepts::Duration => with_base(value, time_base).or_else(|| operands.time(value)),
        Accepts::Expression => operands.expression(value),
        _ => operands.value(value),
    };
    held.ok_or_else(|| format!("`{value}` is not a name or a value"))
}

/// What a box only shows: names of its power, and how far it has come, which begins with 0.
fn is_shown(given: &Given) -> bool {
    let known = |name: &str| SHOWN.iter().any(|shown| shown.eq_ignore_ascii_case(name));
    match given.value.as_str() {
        "0" | "0.0" => known(&given.name),
        _ => false,
    }
}

/// A number of time bases, as older controllers have it: a base of 1.0 or 0.01 seconds.
fn with_base(preset: &str, base: Option<&str>) -> Option<Expression> {
    let preset: f64 = preset.trim().parse().ok()?;
    let base: f64 = base?.trim().trim_end_matches(['s', ' ']).parse().ok()?;
    let milliseconds = (preset * base * 1000.0).round();
    (0.0..1e15)
        .contains(&milliseconds)
        .then(|| Expression::literal(format!("T#{milliseconds}ms")).ok())?
}

/// Whether what is between the brackets is a block without one of its operands, which is above it then.
pub(crate) fn wants_name(inside: &str) -> bool {
    let (word, rest) = inside
        .trim()
        .split_once([' ', ',', ':'])
        .unwrap_or((inside.trim(), ""));
    let is_comparison = SIGNS
        .iter()
        .any(|(sign, _)| inside.trim_start().starts_with(sign));
    is_comparison || row(word).is_some_and(|row| values(rest).len() < row.required())
}

/// What is between the brackets of one line, if it is a block: `TON T1 5s`, `GEQ count 5`, `count >= 5`, `>= 5`.
pub(crate) fn in_brackets(
    inside: &str,
    name: Option<&str>,
    operands: &mut Operands,
) -> Option<Result<Block, String>> {
    if let Some(compared) = comparison(inside, name) {
        let (row, given) = compared;
        return Some(written(row, None, given, operands));
    }
    let (word, rest) = inside
        .trim()
        .split_once([' ', ',', ':'])
        .unwrap_or((inside.trim(), ""));
    let row = row(word).filter(|row| row.mnemonic.len() > 1)?;
    let mut given: Vec<Given> = values(rest);
    // `TON T1 5s` has the timer, `TON 5s` has it above.
    let wanted = row.required();
    let name = name.filter(|_| given.len() < wanted);
    let is_number = |it: &Given| it.name.is_empty() && it.value.starts_with(|c: char| c.is_ascii_digit());
    if let [preset] = &mut given[..]
        && row.state().is_some()
        && is_number(preset)
    {
        "PRE".clone_into(&mut preset.name);
    }
    if row.state().is_none() && row.role == ladder_instructions::Role::Acting && !given.is_empty() {
        let why = "where its result goes is not the same in all systems";
        return Some(Err(format!(
            "{why}: write [{}]( result, operands )",
            row.mnemonic
        )));
    }
    Some(written(row, name, given, operands))
}

/// Values after each other, parted by blanks or commas, with or without their names: `T1, PT:=5 s`.
fn values(text: &str) -> Vec<Given> {
    let mut given: Vec<Given> = Vec::new();
    let text = text.replace(":=", "=");
    for word in text.split([' ', ',', ';']).filter(|word| !word.is_empty()) {
        let (name, value) = word.split_once('=').unwrap_or(("", word));
        let unit = |last: &Given| duration(&format!("{}{value}", last.value)).is_some();
        let is_unit = name.is_empty() && value.chars().all(char::is_alphabetic);
        match given.last_mut() {
            Some(last) if is_unit && unit(last) => last.value.push_str(value),
            Some(last) if last.value.is_empty() && name.is_empty() => value.clone_into(&mut last.value),
            _ => given.push(Given {
                name: name.to_owned(),
                value: value.to_owned(),
            }),
        }
    }
    given
}

/// The signs of comparisons, longest first.
const SIGNS: [(&str, &str); 12] = [
    ("≥", "GE"),
    ("≤", "LE"),
    ("≠", "NE"),
    (">=", "GE"),
    ("<=", "LE"),
    ("<>", "NE"),
    ("!=", "NE"),
    ("/=", "NE"),
    ("==", "EQ"),
    (">", "GT"),
    ("<", "LT"),
    ("=", "EQ"),
];

fn comparison(inside: &str, name: Option<&str>) -> Option<(&'static Instruction, Vec<Given>)> {
    let (at, sign, mnemonic) = SIGNS
        .iter()
        .find_map(|(sign, mnemonic)| Some((inside.find(sign)?, *sign, *mnemonic)))?;
    let (left, right) = (inside[..at].trim(), inside[at + sign.len()..].trim());
    let left = left.strip_prefix("CMP").unwrap_or(left).trim();
    let left = if left.is_empty() { name? } else { left };
    // `TON PT=5s` has names of operands.
    if right.is_empty() || left.contains(' ') || right.contains(' ') {
        return None;
    }
    let value = |value: &str| Given {
        name: String::new(),
        value: value.to_owned(),
    };
    Some((row(mnemonic)?, vec![value(left), value(right)]))
}

/// What boxes say of themselves next to their short names.
const TITLES: [&str; 20] = [
    "TIMER ON DELAY",
    "TIMER OFF DELAY",
    "TIMER ON",
    "TIMER OFF",
    "RETENTIVE TIMER ON",
    "RETENTIVE TIMER",
    "COUNT UP",
    "COUNT DOWN",
    "COUNTER UP",
    "ADD",
    "SUBTRACT",
    "MULTIPLY",
    "DIVIDE",
    "MOVE",
    "EQUAL",
    "NOT EQUAL",
    "GREATER THAN",
    "LESS THAN",
    "GREATER OR EQUAL",
    "LESS OR EQUAL",
];

/// The instruction of a box, and for each line inside what is given there.
pub(crate) struct Boxed {
    pub(crate) row: &'static Instruction,
    pub(crate) given: Vec<Vec<Given>>,
}

/// What a box says inside. Each line may have a pin at its left and one at its right edge, or a name and a value.
///
/// # Errors
///
/// If it does not say which block it is.
pub(crate) fn boxed(edge: &str, inside: &[String]) -> Result<Boxed, String> {
    let titles = std::iter::once(edge).chain(inside.iter().map(String::as_str));
    let found = titles.zip(0..).find_map(|(title, number)| {
        // A word alone, one before others that say the same (`TON Timer on delay`), or one between pins (`IN TON Q`).
        let is_shown = |word: &&str| SHOWN.iter().any(|shown| shown.eq_ignore_ascii_case(word));
        let mut words = title.split_whitespace().filter(|word| !is_shown(word));
        let word = words.next()?;
        let row = row(word).filter(|row| row.mnemonic.len() > 1)?;
        (number == 0 || words.next().is_none() || row.state().is_some()).then_some((row, number))
    });
    let Some((row, title)) = found else {
        let pins = inside.iter().flat_map(|line| line.split_whitespace());
        let is_timer = pins.clone().any(|pin| pin.eq_ignore_ascii_case("PT"));
        let is_counter = pins.clone().any(|pin| pin.eq_ignore_ascii_case("PV"));
        return Err(match (is_timer, is_counter) {
            (true, _) => "the box does not say which block it is: TON, TOF and TP have these pins".to_owned(),
            (_, true) => "the box does not say which block it is: CTU and CTD have these pins".to_owned(),
            _ => "the box does not say which block it is".to_owned(),
        });
    };
    let lines = inside.iter().zip(1..);
    let says_more = |line: &str| TITLES.iter().any(|title| title.eq_ignore_ascii_case(line.trim()));
    let is_title = |line: &str, number: usize| number == title || says_more(line);
    let given = lines.map(|(line, number)| {
        if is_title(line, number) {
            Vec::new()
        } else {
            labelled(line, row)
        }
    });
    Ok(Boxed {
        row,
        given: given.collect(),
    })
}

/// `PT   ET`, `PT T#5s`, `Source A  count`, `Preset 5`: a name with its value, or pins, whose values are next to the box.
fn labelled(line: &str, row: &Instruction) -> Vec<Given> {
    let given = |name: &str, value: &str| Given {
        name: name.trim().trim_end_matches(NAMES_END).trim().to_owned(),
        value: value.trim().to_owned(),
    };
    let line = line.trim();
    if line.is_empty() {
        return Vec::new();
    }
    let known = |text: &str| {
        let text = text.trim().trim_end_matches(NAMES_END).trim();
        let called = CALLED.iter().any(|(own, others)| {
            own.eq_ignore_ascii_case(text) || others.iter().any(|other| other.eq_ignore_ascii_case(text))
        });
        called
            || row
                .operands
                .iter()
                .any(|operand| operand.name.eq_ignore_ascii_case(text))
            || text.eq_ignore_ascii_case("TIME BASE")
            || SHOWN.iter().any(|shown| shown.eq_ignore_ascii_case(text))
    };
    if known(line) {
        return vec![given(line, "")];
    }
    let cuts = line
        .char_indices()
        .filter(|(_, c)| c.is_whitespace() || NAMES_END.contains(c));
    let cuts: Vec<usize> = cuts.map(|(at, c)| at + c.len_utf8()).collect();
    let cut = cuts.into_iter().rev().find(|&at| known(&line[..at]));
    match cut {
        Some(at) if SHOWN.contains(&line[at..].trim()) || line[at..].trim() == "OUT" => {
            vec![given(&line[..at], ""), given(&line[at..], "")]
        }
        Some(at) => vec![given(&line[..at], &line[at..])],
        None => vec![given("", line)],
    }
}
