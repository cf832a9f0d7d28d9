//! The blocks that the draft has, besides timers and counters.

use ladder_instructions::Op;

/// An instruction of ladder text, its head in the draft, what a name is like that the draft wants before its operands (none: its
/// only operand is a tag), and how many operands it has here. Of three the first is the result, which comes last in the draft.
type Row = (Op, &'static str, Option<&'static str>, usize);

const ROWS: [Row; 17] = [
    (Op::Contact, "[ ]", None, 1),
    (Op::NegatedContact, "[/]", None, 1),
    (Op::Coil, "( )", None, 1),
    (Op::SetCoil, "(S)", None, 1),
    (Op::ResetCoil, "(R)", None, 1),
    (Op::OneShotRising, "[OSR]", Some("pulse"), 0),
    (Op::OneShotFalling, "[OSF]", Some("pulse"), 0),
    (Op::Eq, "[EQU]", Some("equal"), 2),
    (Op::Ne, "[NEQ]", Some("unequal"), 2),
    (Op::Gt, "[GRT]", Some("greater"), 2),
    (Op::Ge, "[GEQ]", Some("at_least"), 2),
    (Op::Lt, "[LES]", Some("less"), 2),
    (Op::Le, "[LEQ]", Some("at_most"), 2),
    (Op::Add, "[ADD]", Some("sum"), 3),
    (Op::Sub, "[SUB]", Some("difference"), 3),
    (Op::Mul, "[MUL]", Some("product"), 3),
    (Op::Div, "[DIV]", Some("quotient"), 3),
];

/// The row of an instruction.
pub(super) fn row_of(op: Op) -> Option<Row> {
    ROWS.into_iter().find(|row| row.0 == op)
}

/// The row of a block by its first bracket and what is in its brackets.
pub(super) fn row_named(bracket: char, inside: &str) -> Option<Row> {
    let is_it = |row: &Row| {
        let own = row.1.strip_prefix(bracket);
        own.is_some_and(|own| own[..own.len() - 1].trim() == inside)
    };
    ROWS.into_iter().find(is_it)
}
