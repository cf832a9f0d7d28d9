//! Rungs as text, as Logix Designer and RSLogix 500 put them on the clipboard: `XIC(start)[XIC(a) ,XIO(b) ]OTE(run);`.
//!
//! A block there hands on the power that it gets. What hands on something else here, as a timer its output, is drawn on a branch of
//! its own before what follows it; in the middle of a branch, where that is another rung, it is not read.

use crate::neutral::{Instruction, Part, parse};
use crate::operand::Operands;
use ladder_format::Circuit;
use ladder_format::program::{self, Block, Drawing, Element, Expression, Item, Network, ProgramSketch};
use ladder_instructions::{Op, Shape, by_op, known_elsewhere, lookup};

/// The block of an instruction, and how its operands become those of the block.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Order {
    /// A tag.
    Tag(Op),
    /// A tag that keeps an edge: the one-shot keeps it by itself.
    Storage,
    /// Values that are compared.
    Compared(Op),
    /// Timer, preset, what has run so far; the older spelling has a time base before the preset.
    Timer(Op),
    /// Counter, preset, what was counted so far.
    Counter(Op),
    /// Values, then the tag for the result.
    ResultLast(Op),
    /// The tag that becomes 0.
    Cleared,
    /// None: it is a wire.
    Nothing,
}

/// The instructions that are read: their name, the block with its operands, and whether both hand on the same power.
const KNOWN: [(&str, Order, bool); 40] = [
    ("XIC", Order::Tag(Op::Contact), true),
    ("XIO", Order::Tag(Op::NegatedContact), true),
    ("OTE", Order::Tag(Op::Coil), true),
    ("OTL", Order::Tag(Op::SetCoil), false),
    ("OTU", Order::Tag(Op::ResetCoil), false),
    ("RES", Order::Tag(Op::Res), true),
    ("ONS", Order::Storage, true),
    ("TON", Order::Timer(Op::Ton), false),
    ("TOF", Order::Timer(Op::Tof), false),
    ("RTO", Order::Timer(Op::Rto), false),
    ("CTU", Order::Counter(Op::Ctu), false),
    ("CTD", Order::Counter(Op::Ctd), false),
    ("EQU", Order::Compared(Op::Eq), true),
    ("EQ", Order::Compared(Op::Eq), true),
    ("NEQ", Order::Compared(Op::Ne), true),
    ("NE", Order::Compared(Op::Ne), true),
    ("GRT", Order::Compared(Op::Gt), true),
    ("GT", Order::Compared(Op::Gt), true),
    ("GEQ", Order::Compared(Op::Ge), true),
    ("GE", Order::Compared(Op::Ge), true),
    ("LES", Order::Compared(Op::Lt), true),
    ("LT", Order::Compared(Op::Lt), true),
    ("LEQ", Order::Compared(Op::Le), true),
    ("LE", Order::Compared(Op::Le), true),
    ("MOV", Order::ResultLast(Op::Mov), true),
    ("MOVE", Order::ResultLast(Op::Mov), true),
    ("ADD", Order::ResultLast(Op::Add), true),
    ("SUB", Order::ResultLast(Op::Sub), true),
    ("MUL", Order::ResultLast(Op::Mul), true),
    ("DIV", Order::ResultLast(Op::Div), true),
    ("MOD", Order::ResultLast(Op::Mod), true),
    ("AND", Order::ResultLast(Op::And), true),
    ("OR", Order::ResultLast(Op::Or), true),
    ("XOR", Order::ResultLast(Op::Xor), true),
    ("NOT", Order::ResultLast(Op::Not), true),
    ("ABS", Order::ResultLast(Op::Abs), true),
    ("SQR", Order::ResultLast(Op::Sqrt), true),
    ("SQRT", Order::ResultLast(Op::Sqrt), true),
    ("CLR", Order::Cleared, true),
    ("NOP", Order::Nothing, true),
];

/// Rungs with more text than this are not pasted.
const LONGEST: usize = 64 << 10;

/// What was read.
#[derive(Debug)]
pub struct RungText {
    /// A network for each rung.
    pub program: ProgramSketch,
    /// What of it cannot be read, and why.
    pub problems: Vec<String>,
}

pub(crate) fn known(name: &str) -> Option<&'static (&'static str, Order, bool)> {
    KNOWN.iter().find(|(known, ..)| known.eq_ignore_ascii_case(name))
}

/// How many operands there are where no parentheses are around them.
fn operands(name: &str) -> Option<usize> {
    let (_, order, _) = known(name)?;
    Some(match order {
        Order::Tag(_) | Order::Storage | Order::Cleared => 1,
        Order::Compared(_) => 2,
        Order::Timer(_) => 4,
        Order::Counter(_) => 3,
        Order::Nothing => 0,
        Order::ResultLast(op) => by_op(*op).required(),
    })
}

/// Whether a line may begin such a rung. Cheap: asked of each line with an error.
pub fn may_be_rung_text(line: &str) -> bool {
    let line = without_number(line.trim_start());
    let line = line.trim_start_matches(['[', ' ', ',']);
    let end = line.find(|c: char| !c.is_alphanumeric() && c != '_');
    let (word, rest) = line.split_at(end.unwrap_or(line.len()));
    let is_called = rest.trim_start().starts_with('(') || rest.starts_with(' ');
    is_called && (matches!(word, "SOR" | "BST") || known(word).is_some())
}

/// A rung of an export begins with `N:`.
pub(crate) fn without_number(rung: &str) -> &str {
    rung.strip_prefix("N:").map_or(rung, str::trim_start)
}

/// Reads rungs, if that is what a text is: nothing else is in it, and it says of at least one bit what no ladder text says so.
pub fn read_rung_text(text: &str) -> Option<RungText> {
    if text.len() > LONGEST {
        return None;
    }
    let mut reader = Reader::default();
    let mut circuits = Vec::new();
    let mut count = 0;
    for rung in rungs(text) {
        let parts = parse(without_number(rung.trim()), &operands).ok()?;
        if parts.is_empty() {
            continue;
        }
        count += count_known(&parts)?;
        circuits.push(reader.series(&parts, true));
    }
    let problems = reader.problems;
    let program = program_of(circuits);
    (count > 0).then_some(RungText { program, problems })
}

/// How many contacts and coils there are by the names that only such text has. None if something is not an instruction.
fn count_known(parts: &[Part<'_>]) -> Option<usize> {
    let counts = parts.iter().map(|part| match part {
        Part::Instruction(it)
            if !it
                .name
                .chars()
                .all(|c| c.is_ascii_uppercase() || c.is_ascii_digit()) =>
        {
            None
        }
        Part::Instruction(it) => Some(usize::from(matches!(
            it.name,
            "XIC" | "XIO" | "OTE" | "OTL" | "OTU"
        ))),
        Part::Branch(legs) => legs.iter().map(|leg| count_known(leg)).sum(),
    });
    counts.sum()
}

/// The networks of some circuits, with a blank line between two of them.
pub(crate) fn program_of(circuits: impl IntoIterator<Item = Circuit<Element>>) -> ProgramSketch {
    let mut program = ProgramSketch::default();
    for circuit in circuits {
        if !program.items.is_empty() {
            program.items.push(Item::Blank);
        }
        program.items.push(Item::Network(Network {
            comments: Vec::new(),
            drawing: Drawing::Circuit(circuit),
        }));
    }
    program
}

/// The rungs of a text: up to a `;`, or without one each on a line of its own.
pub(crate) fn rungs(text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    let mut start = 0;
    let mut is_quoted = false;
    let by_line = !text.contains(';');
    for (at, letter) in text.char_indices() {
        is_quoted ^= letter == '\'';
        if letter == '\n' && by_line || letter == ';' && !is_quoted {
            found.push(&text[start..at]);
            start = at + 1;
        }
    }
    found.push(&text[start..]);
    found
}

#[derive(Default)]
pub(crate) struct Reader {
    pub(crate) operands: Operands,
    problems: Vec<String>,
}

impl Reader {
    /// Parts one after the other. `is_last`: nothing follows them but the rail.
    fn series(&mut self, parts: &[Part<'_>], is_last: bool) -> Circuit<Element> {
        let mut made = Vec::new();
        for (index, part) in parts.iter().enumerate() {
            let after = &parts[index + 1..];
            let ends = is_last && after.is_empty();
            let instruction = match part {
                Part::Branch(legs) => {
                    let legs = legs.iter().map(|leg| self.series(leg, ends));
                    made.push(Circuit::Parallel(legs.collect()));
                    continue;
                }
                Part::Instruction(instruction) => instruction,
            };
            let (part, passes) = match self.part(instruction) {
                Ok(Some(read)) => read,
                Ok(None) => continue,
                Err(why) => {
                    self.problems.push(why);
                    continue;
                }
            };
            let element = Circuit::Element(Element { part, origin: None });
            match (passes || ends, is_last) {
                (true, _) => made.push(element),
                (false, true) => {
                    let rest = self.series(after, true);
                    made.push(Circuit::Parallel(vec![element, rest]));
                    break;
                }
                (false, false) => self.problems.push(format!(
                    "`{}` hands on its power there, and something else here: draw it at the end of its rung",
                    instruction.text
                )),
            }
        }
        Circuit::Series(made)
    }

    /// An instruction as a block, and whether that hands on the same power. None: it does nothing.
    fn part(&mut self, instruction: &Instruction<'_>) -> Result<Option<(program::Part, bool)>, String> {
        let Some((_, order, passes)) = known(instruction.name) else {
            return Err(unknown(instruction));
        };
        let given = &instruction.operands[..];
        let cannot = || format!("the operands of `{}` cannot be read", instruction.text);
        let block = match (*order, given) {
            (Order::Nothing, _) => return Ok(None),
            (Order::Storage, _) => Block::one_shot(),
            (Order::Timer(op) | Order::Counter(op), [state] | [state, UNKNOWN, ..])
            | (Order::Timer(op), [state, _, UNKNOWN, _]) => {
                let state = self.operands.tag(state).ok_or_else(cannot)?;
                let open = format!("{}( {state}, {UNKNOWN} )", by_op(op).block());
                return Ok(Some((program::Part::Text(open), *passes)));
            }
            (order, given) => {
                let (op, list) = self.list(order, given).ok_or_else(cannot)?;
                Block::of(op, list)?
            }
        };
        Ok(Some((program::Part::Block(block), *passes)))
    }

    /// The block of an instruction, with its operands. None: it has no such operands.
    pub(crate) fn list(&mut self, order: Order, given: &[&str]) -> Option<(Op, Vec<Expression>)> {
        let mut tag = |written: &str| self.operands.tag(written).map(Expression::from);
        Some(match (order, given) {
            (Order::Tag(op), [only]) => (op, vec![tag(only)?]),
            (Order::Cleared, [only]) => (Op::Mov, vec![tag(only)?, 0.into()]),
            (Order::Compared(op), [a, b]) => (op, vec![self.operands.value(a)?, self.operands.value(b)?]),
            (Order::Timer(op), [timer, preset, ..]) if given.len() < 4 => {
                (op, vec![tag(timer)?, preset_time(preset, "0.001")?])
            }
            (Order::Timer(op), [timer, base, preset, _]) => {
                (op, vec![tag(timer)?, preset_time(preset, base)?])
            }
            (Order::Counter(op), [counter, preset, ..]) if given.len() < 4 => {
                (op, vec![tag(counter)?, self.operands.value(preset)?])
            }
            (Order::ResultLast(op), [values @ .., result]) if by_op(op).takes(given.len()) => {
                let result = tag(result)?;
                let values = values.iter().map(|value| self.operands.value(value));
                let list: Option<Vec<Expression>> = std::iter::once(Some(result)).chain(values).collect();
                (op, list?)
            }
            _ => return None,
        })
    }
}

/// What is not on the clipboard. It is written in the block: what is missing there is an error that says what to write.
const UNKNOWN: &str = "?";

/// A preset that counts in units of so many seconds.
fn preset_time(preset: &str, base: &str) -> Option<Expression> {
    let count: u64 = preset.parse().ok()?;
    let unit = match base {
        "0.001" | ".001" => 1,
        "0.01" | ".01" => 10,
        "0.1" | ".1" => 100,
        "1.0" | "1" => 1000,
        _ => return None,
    };
    let milliseconds = count.checked_mul(unit)?;
    let time = match milliseconds % 1000 {
        0 => format!("T#{}s", milliseconds / 1000),
        _ => format!("T#{milliseconds}ms"),
    };
    Expression::literal(time).ok()
}

pub(crate) fn unknown(instruction: &Instruction<'_>) -> String {
    let name = instruction.name;
    let row = lookup(Shape::Logical, name)
        .next()
        .or_else(|| known_elsewhere(name));
    match row {
        Some(row) => format!("`{}` is not read: draw it with {}", instruction.text, row.block()),
        None => format!("`{}` is not read", instruction.text),
    }
}

#[cfg(test)]
mod tests {
    use super::{may_be_rung_text, read_rung_text};
    use expect_test::{Expect, expect};
    use ladder_format::Options;

    #[track_caller]
    fn check(text: &str, expected: Expect) {
        let shown = match read_rung_text(text) {
            None => "no rung\n".to_owned(),
            Some(read) => {
                assert!(may_be_rung_text(text));
                let problems = read.problems.iter().map(|problem| format!("{problem}\n"));
                let problems: String = problems.collect();
                format!("{}{problems}", read.program.write(&Options::default()).text)
            }
        };
        expected.assert_eq(&shown);
    }

    #[test]
    fn what_follows_a_timer_gets_the_power_that_the_timer_gets() {
        check(
            "XIC(a)XIO(b)TON(t1,5000,0)OTE(b);",
            expect![[r#"
            +--[ ]( a )--[/]( b )--\---------------------------------[TON]( t1, T#5s )--\--+
            |                      /------------------------------------------( )( b )--/  |
        "#]],
        );
        check(
            "XIC(a)[XIC(b) ,XIO(c) ]OTL(d);",
            expect![[r#"
            +--[ ]( a )--\--[ ]( b )--\------------------------------------------(S)( d )--+
            |            /--[/]( c )--/                                                    |
        "#]],
        );
        check(
            "XIC(a)[TON(t,?,?) ,XIC(t.DN) OTE(b) ];\nXIC(t.DN)CTU(n,10,0);",
            expect![[r#"
            +--[ ]( a )--\--[TON]( t, ? )--\--+
              /--[ ]( t.DN )--( )( b )--/

            +--[ ]( t.DN )-------------------------------------------------[CTU]( n, 10 )--+
        "#]],
        );
    }

    #[test]
    fn results_come_first() {
        check(
            "XIC(go)GEQ(level,50)ADD(level,5,total)MOV(total,shown)CLR(n);",
            expect![[r#"
            +--[ ]( go )--[GE]( level, 50 )----[ADD]( total, level, 5 )--[MOV]( shown, total )--[MOV]( n, 0 )--+
        "#]],
        );
    }

    #[test]
    fn the_older_spelling() {
        check(
            "SOR XIC I:1/0 BST XIC a NXB XIC b BND TON T4:0 0.01 50 0 EOR",
            expect![[r#"
            +--[ ]( I_1_0 )--\--[ ]( a )--\------------------------[TON]( T4_0, T#500ms )--+
            |                /--[ ]( b )--/                                                |
        "#]],
        );
    }

    #[test]
    fn what_is_not_read_is_named() {
        check(
            "XIC(a)JSR(Fill,0);",
            expect![[r#"
            +--[ ]( a )--------------------------------------------------------------------+
            `JSR(Fill,0)` is not read: draw it with <CALL>
        "#]],
        );
    }

    #[test]
    fn a_timer_in_the_middle_of_a_rung_is_not_read() {
        let read = read_rung_text("XIC(a)[TON(t,5,0),XIC(b)]OTE(c);").map(|read| read.problems);
        expect![
            "`TON(t,5,0)` hands on its power there, and something else here: draw it at the end of its rung"
        ]
        .assert_eq(&read.unwrap_or_default().join(" "));
    }

    #[test]
    fn other_texts() {
        for text in [
            "",
            "start(a);",
            "TON(t, T#5s)",
            "ADD(a, b, c);",
            "XIC a note",
            "XIC(a)--OTE(b)",
        ] {
            check(text, expect![["no rung\n"]]);
        }
    }
}
