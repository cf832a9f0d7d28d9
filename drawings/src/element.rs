//! A contact or coil of a drawing as a block of ladder text.

use crate::block;
use crate::operand::Operands;
use ladder_format::program::{Block, Operand};
use ladder_instructions::{Op, Role, Shape, known_elsewhere, lookup};

/// What is written next to an element: above it, and below it.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Labels<'l> {
    pub(crate) above: Option<&'l str>,
    pub(crate) below: Option<&'l str>,
}

/// What a contact does with power, by what is between its bars.
fn contact_mark(inside: &str) -> Option<Op> {
    Some(match inside {
        "" | "─" | "━" => Op::Contact,
        "/" => Op::NegatedContact,
        "P" | "↑" | "^" => Op::RisingContact,
        "N" | "↓" => Op::FallingContact,
        _ => return None,
    })
}

/// What a coil does, by what is between its parentheses: as in ladder text, or by a name that it has elsewhere.
fn coil_mark(inside: &str) -> Option<Op> {
    let inside = match inside {
        "↑" => "P",
        "↓" => "N",
        // An inactive coil.
        "~" => "/",
        inside => inside,
    };
    // Between the parentheses of a drawing that is rather the name of an output.
    if inside.eq_ignore_ascii_case("OUT") {
        return None;
    }
    let own = lookup(Shape::Coil, inside).next();
    let row = own.or_else(|| known_elsewhere(inside).filter(|row| row.shape == Shape::Coil))?;
    Some(row.op)
}

/// A contact with what is between its bars.
///
/// # Errors
///
/// If no tag tells what it reads, or what is inside is not known.
pub(crate) fn contact(inside: &str, labels: Labels<'_>, operands: &mut Operands) -> Result<Block, String> {
    let says = inside.trim();
    if let Some(mark) = contact_mark(says) {
        let Some(name) = labels.above else {
            return Err(match says {
                "" => "no name is above this contact or inside it".to_owned(),
                _ => format!("no name is above this contact, and `{says}` inside tells only its kind"),
            });
        };
        return named(mark, name, operands);
    }
    if let Some(label) = says.strip_suffix(':') {
        return named(Op::Lbl, label, operands);
    }
    if let Some(name) = prefixed(says, &["/", "!", "NOT ", "XIO "]) {
        return named(Op::NegatedContact, name, operands);
    }
    if let Some(written) = block::in_brackets(&compared_below(says, labels), labels.above, operands) {
        return written;
    }
    no_flow(says)?;
    named(Op::Contact, prefixed(says, &["XIC "]).unwrap_or(says), operands)
}

/// A word of the program flow is not a name: what it does elsewhere is not what `<END>` or `<RET>` does here.
fn no_flow(says: &str) -> Result<(), String> {
    match lookup(Shape::Function, says).next() {
        Some(row) => Err(format!(
            "`{says}` is a word of the program flow: draw what is meant with {}, or leave it out",
            row.block()
        )),
        None => Ok(()),
    }
}

/// Whether what is between the bars is a comparison and nothing else: one operand is above then, and one below.
fn is_sign(says: &str) -> bool {
    let is_word = || {
        let row = block::row(says);
        row.is_some_and(|row| row.role == Role::Condition && row.required() == 2)
    };
    !says.is_empty() && (says.chars().all(|c| "<>=!≤≥≠".contains(c)) || is_word())
}

/// Whether the name of a contact, or an operand of the block in its place, is above it: what is inside does not say it.
pub(crate) fn contact_wants_name(inside: &str) -> bool {
    contact_mark(inside.trim()).is_some() || is_sign(inside.trim()) || block::wants_name(inside)
}

/// As [`contact_wants_name`], of a coil.
pub(crate) fn coil_wants_name(inside: &str) -> bool {
    coil_mark(inside.trim()).is_some() || block::wants_name(inside)
}

/// Whether one of a contact's operands may be below it.
pub(crate) fn wants_below(inside: &str, has_above: bool) -> bool {
    has_above && is_sign(inside.trim())
}

/// `>` with 300 below it is `> 300`.
fn compared_below(says: &str, labels: Labels<'_>) -> String {
    match (labels.above, labels.below) {
        (Some(above), Some(below)) if block::row(says).is_some() => format!("{says} {above} {below}"),
        (_, Some(below)) => format!("{says} {below}"),
        _ => says.to_owned(),
    }
}

/// A coil with what is between its parentheses.
///
/// # Errors
///
/// As [`contact`].
pub(crate) fn coil(inside: &str, labels: Labels<'_>, operands: &mut Operands) -> Result<Block, String> {
    let says = inside.trim();
    if let Some(mark) = coil_mark(says) {
        let Some(name) = labels.above else {
            return Err(match says {
                "" => "no name is above this coil or inside it".to_owned(),
                _ => format!("no name is above this coil, and `{says}` inside tells only its kind"),
            });
        };
        return named(mark, name, operands);
    }
    if let Some(label) = prefixed(says, &["JMP "]) {
        return named(Op::Jmp, label, operands);
    }
    if let Some((mark, name)) = says.split_once([' ', ':'])
        && let Some(mark) = coil_mark(mark.trim())
    {
        return named(mark, name, operands);
    }
    if let Some(written) = block::in_brackets(says, labels.above, operands) {
        return written;
    }
    no_flow(says)?;
    match prefixed(says, &["/", "!", "~", "NOT "]) {
        Some(name) => named(Op::NegatedCoil, name, operands),
        None => named(Op::Coil, says, operands),
    }
}

/// A change of the program flow: `CALL mix`, `RETURN`.
///
/// # Errors
///
/// If it is not known.
pub(crate) fn flow(inside: &str, operands: &mut Operands) -> Result<Block, String> {
    let says = inside.trim();
    let (word, rest) = says.split_once(' ').unwrap_or((says, ""));
    let word = if word.eq_ignore_ascii_case("RETURN") {
        "RET"
    } else {
        word
    };
    let row = lookup(Shape::Function, word).next();
    let row = row.ok_or_else(|| format!("`<{says}>` is not known"))?;
    if rest.trim().is_empty() {
        return Ok(Block::of(row.op, Operand::NONE)?);
    }
    let operand = operands.value(rest);
    let operand = operand.ok_or_else(|| format!("`{}` is not a name or a value", rest.trim()))?;
    Ok(Block::of(row.op, [operand])?)
}

fn prefixed<'t>(text: &'t str, prefixes: &[&str]) -> Option<&'t str> {
    prefixes.iter().find_map(|prefix| {
        let head = text.get(..prefix.len())?;
        head.eq_ignore_ascii_case(prefix)
            .then(|| text[prefix.len()..].trim())
    })
}

/// A name has no more words: `Stop button`. Three are an instruction that is not known, with its operands.
const WORDS: usize = 2;

fn named(op: Op, name: &str, operands: &mut Operands) -> Result<Block, String> {
    let is_short = name.split_whitespace().count() <= WORDS;
    let tag = is_short.then(|| operands.tag(name)).flatten();
    let tag = tag.ok_or_else(|| format!("`{}` is no name of a tag", name.trim()))?;
    Ok(Block::of(op, [tag])?)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(above: &str) -> Labels<'_> {
        Labels {
            above: Some(above).filter(|above| !above.is_empty()),
            below: None,
        }
    }

    #[test]
    fn contacts() {
        let mut operands = Operands::default();
        for (inside, above, expected) in [
            (" ", "a", "[ ]( a )"),
            ("/", "a", "[/]( a )"),
            (" P ", "a", "[P]( a )"),
            ("start", "", "[ ]( start )"),
            ("/stop", "", "[/]( stop )"),
            ("NOT stop", "", "[/]( stop )"),
            ("XIO stop", "", "[/]( stop )"),
            ("XIC I:0/1", "", "[ ]( I_0_1 )"),
            ("TON T1 5s", "", "[TON]( T1, T#5s )"),
            ("TON T1, PT:=5 s", "", "[TON]( T1, T#5s )"),
            ("TON 5s", "T1", "[TON]( T1, T#5s )"),
            ("CTU C1 10", "", "[CTU]( C1, 10 )"),
            ("GEQ C1.ACC 5", "", "[GE]( C1.ACC, 5 )"),
            ("count >= 5", "", "[GE]( count, 5 )"),
            ("== 20", "level", "[EQ]( level, 20 )"),
            ("OSR", "", "[OSR]"),
            (" ", "", "no name is above this contact or inside it"),
            (
                "P",
                "",
                "no name is above this contact, and `P` inside tells only its kind",
            ),
            (
                "MOV 5 n",
                "",
                "where its result goes is not the same in all systems: write [MOV]( result, operands )",
            ),
            ("TON", "", "its operand PT is not in the drawing"),
            ("???", "", "`???` is no name of a tag"),
            ("PID x y", "", "`PID x y` is no name of a tag"),
            ("TON T1", "", "its operand PT is not in the drawing"),
        ] {
            let found = contact(inside, labels(above), &mut operands);
            let found = found.map(|block| block.to_string());
            assert_eq!(found.unwrap_or_else(|why| why), expected, "[{inside}] {above}");
        }
    }

    #[test]
    fn coils() {
        let mut operands = Operands::default();
        for (inside, above, expected) in [
            (" ", "y", "( )( y )"),
            ("/", "y", "(/)( y )"),
            ("~", "y", "(/)( y )"),
            ("L", "y", "(S)( y )"),
            ("U", "y", "(R)( y )"),
            ("run", "", "( )( run )"),
            ("S run", "", "(S)( run )"),
            ("OTL run", "", "(S)( run )"),
            ("/run", "", "(/)( run )"),
            ("~run", "", "(/)( run )"),
            ("~ run", "", "(/)( run )"),
            ("RES", "T4:0", "(RES)( T4_0 )"),
            ("JMP end", "", "<JMP>( end )"),
            ("TON T1 2s", "", "[TON]( T1, T#2s )"),
            (
                "S",
                "",
                "no name is above this coil, and `S` inside tells only its kind",
            ),
        ] {
            let found = coil(inside, labels(above), &mut operands);
            let found = found.map(|block| block.to_string());
            assert_eq!(found.unwrap_or_else(|why| why), expected, "({inside}) {above}");
        }
    }

    #[test]
    fn comparisons_with_their_operands_around_them() {
        let mut operands = Operands::default();
        for (inside, expected) in [
            (" > ", "[GT]( level, 300 )"),
            ("≥", "[GE]( level, 300 )"),
            ("EQU", "[EQ]( level, 300 )"),
        ] {
            let labels = Labels {
                above: Some("level"),
                below: Some("300"),
            };
            let found = contact(inside, labels, &mut operands).map(|block| block.to_string());
            assert_eq!(found.as_deref(), Ok(expected));
        }
    }
}
