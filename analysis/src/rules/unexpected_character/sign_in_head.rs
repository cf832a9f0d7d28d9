//! A sign where a block has its name: `[>=]( level, 50 )`.

use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::excerpt::in_sentence;
use ladder_instructions::{Op, by_op};

/// The signs of comparisons and of arithmetic.
const SIGNS: [(&[&str], Op); 10] = [
    (&["=", "=="], Op::Eq),
    (&["<>", "!=", "≠", "><"], Op::Ne),
    (&[">"], Op::Gt),
    (&[">=", "=>", "≥"], Op::Ge),
    (&["<"], Op::Lt),
    (&["<=", "=<", "≤"], Op::Le),
    (&["+"], Op::Add),
    (&["-", "−"], Op::Sub),
    (&["*", "×", "·"], Op::Mul),
    (&[":", "÷"], Op::Div),
];

/// Says so in the finding about the sign. `before` and `after` are what is around it on its line.
pub(crate) fn explain(found: Diagnostic, before: &str, sign: &str, after: &str) -> Diagnostic {
    let is_alone = before.trim_end_matches([' ', '\t']).ends_with('[')
        && after.trim_start_matches([' ', '\t']).starts_with(']');
    let row = SIGNS.iter().find(|(signs, _)| signs.contains(&sign));
    let Some((_, op)) = row.filter(|_| is_alone) else {
        return found;
    };
    let row = by_op(*op);
    let range = found.range;
    found
        .help(format!(
            "{} is written {}",
            in_sentence(row.title),
            row.signature()
        ))
        .fix(
            Applicability::Unsafe,
            format!("Write {}", row.block()),
            range,
            row.mnemonic,
        )
}
