//! Rungs as a person types them into a field, with the mnemonics of Logix: `XIC run BST XIO fault NXB XIC test BND TON warm T#5s OTE ready`.
//!
//! Unlike on a clipboard, what follows a block gets what that block hands on here: behind a timer its output. Instructions that
//! Logix does not have are called as they are here, with their operands in the order that they have here.

use crate::neutral::{Instruction, Part, Wrong, parse};
use crate::rung_text::{Order, Reader, known, program_of, rungs, unknown, without_number};
use ladder_format::Circuit;
use ladder_format::program::{self, Block, Element, Expression, ProgramSketch};
use ladder_instructions::{Op, Shape, by_op, lookup};

/// What a word stands for.
#[derive(Debug, Clone, Copy)]
enum Meant {
    Logix(Order),
    Own(Op),
}

fn meant(name: &str) -> Option<Meant> {
    let own = || {
        let mut rows = [Shape::Logical, Shape::Coil, Shape::Function].into_iter();
        rows.find_map(|shape| lookup(shape, name).next())
    };
    let logix = known(name).map(|(_, order, _)| Meant::Logix(*order));
    logix.or_else(|| own().map(|row| Meant::Own(row.op)))
}

/// How many operands a word has where no parentheses are around them.
fn operands(name: &str) -> Option<usize> {
    Some(match meant(name)? {
        Meant::Logix(Order::Nothing) => 0,
        Meant::Logix(Order::Tag(_) | Order::Storage | Order::Cleared) => 1,
        Meant::Logix(Order::Compared(_) | Order::Timer(_) | Order::Counter(_)) => 2,
        Meant::Logix(Order::ResultLast(op)) | Meant::Own(op) => by_op(op).required(),
    })
}

/// Reads rungs, each up to a `;` or the end of its line.
///
/// # Errors
///
/// The first word that cannot be read, and why.
pub fn read_entry(text: &str) -> Result<ProgramSketch, Wrong> {
    let mut reader = Reader::default();
    let mut circuits = Vec::new();
    for rung in rungs(text) {
        let rung = without_number(rung.trim());
        let start = rung.as_ptr().addr() - text.as_ptr().addr();
        let from_start = |wrong: Wrong| Wrong {
            at: wrong.at + start,
            ..wrong
        };
        let parts = parse(rung, &operands).map_err(from_start)?;
        if !parts.is_empty() {
            circuits.push(series(&mut reader, &parts).map_err(from_start)?);
        }
    }
    if circuits.is_empty() {
        let message = "there is nothing to draw".to_owned();
        return Err(Wrong { at: 0, message });
    }
    Ok(program_of(circuits))
}

fn series(reader: &mut Reader, parts: &[Part<'_>]) -> Result<Circuit<Element>, Wrong> {
    let mut made = Vec::with_capacity(parts.len());
    for part in parts {
        match part {
            Part::Branch(legs) => {
                let legs: Result<Vec<_>, Wrong> = legs.iter().map(|leg| series(reader, leg)).collect();
                made.push(Circuit::Parallel(legs?));
            }
            Part::Instruction(instruction) => {
                let block = block(reader, instruction).map_err(|message| Wrong {
                    at: instruction.at,
                    message,
                })?;
                made.extend(block.map(|block| {
                    let part = program::Part::Block(block);
                    Circuit::Element(Element { part, origin: None })
                }));
            }
        }
    }
    Ok(Circuit::Series(made))
}

/// The block of an instruction; none where it is a wire.
fn block(reader: &mut Reader, instruction: &Instruction<'_>) -> Result<Option<Block>, String> {
    let meant = meant(instruction.name).ok_or_else(|| unknown(instruction))?;
    let given = &instruction.operands[..];
    let cannot = || format!("the operands of `{}` cannot be read", instruction.text);
    let own = |reader: &mut Reader, op: Op| {
        let row = by_op(op);
        let values = given.iter().map(|written| reader.operands.time(written));
        let values: Option<Vec<Expression>> = values.collect();
        let values = values
            .filter(|values| row.takes(values.len()))
            .ok_or_else(cannot)?;
        Ok::<Block, String>(Block::of(op, values)?)
    };
    Ok(Some(match meant {
        Meant::Logix(Order::Nothing) => return Ok(None),
        Meant::Logix(Order::Storage) if given.len() == 1 => Block::one_shot(),
        Meant::Logix(Order::Timer(op) | Order::Counter(op)) | Meant::Own(op) => own(reader, op)?,
        Meant::Logix(order) => {
            let (op, list) = reader.list(order, given).ok_or_else(cannot)?;
            Block::of(op, list)?
        }
    }))
}

#[cfg(test)]
mod tests {
    use super::read_entry;
    use expect_test::{Expect, expect};
    use ladder_format::Options;

    #[track_caller]
    fn check(text: &str, expected: Expect) {
        expected.assert_eq(&match read_entry(text) {
            Ok(program) => program.write(&Options::default()).text,
            Err(wrong) => format!("{}: {}\n", wrong.at, wrong.message),
        });
    }

    #[test]
    fn what_follows_a_timer_gets_its_output() {
        check(
            "XIC run BST XIO fault NXB XIC test BND TON warm T#5s OTE ready",
            expect![[r#"
                +--[ ]( run )--\--[/]( fault )--\-----------[TON]( warm, T#5s )--( )( ready )--+
                |              /--[ ]( test )---/                                              |
            "#]],
        );
        check(
            "XIC a CTU c 5 OTE b",
            expect![[r#"
                +--[ ]( a )-------------------------------------------[CTU]( c, 5 )--( )( b )--+
            "#]],
        );
        check(
            "XIC a MOV 5 speed; XIO(a) TP(t, 2000) OTL(b)",
            expect![[r#"
                +--[ ]( a )-------------------------------------------------[MOV]( speed, 5 )--+

                +--[/]( a )-----------------------------------------[TP]( t, 2000 )--(S)( b )--+
            "#]],
        );
    }

    #[test]
    fn what_cannot_be_read_says_where() {
        check(
            "XIC a XYZ b OTE c",
            expect![[r#"
                6: `XYZ` is not read
            "#]],
        );
        check(
            "XIC a BST XIC b OTE c",
            expect![[r#"
                9: the branch that begins here has no end
            "#]],
        );
        check(
            "XIC a EQU b OTE c",
            expect![[r#"
                16: `c` is not read
            "#]],
        );
        check(
            " ",
            expect![[r#"
                0: there is nothing to draw
            "#]],
        );
    }
}
