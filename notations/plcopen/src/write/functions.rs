//! Instructions that make a value, each next to the function of the standard that says the same.

use ladder_instructions::Op;

/// A function and its inputs.
pub(super) struct Function {
    pub(super) name: &'static str,
    pub(super) pins: Pins,
}

/// The inputs of a function.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Pins {
    /// These.
    Fixed(&'static [&'static str]),
    /// `IN1`, `IN2`, as many as there are.
    Many,
    /// `K`, `IN0`, `IN1`, as many as there are.
    Chosen,
}

/// The function of an instruction. None: the standard has none.
pub(super) fn of(op: Op) -> Option<Function> {
    use Pins::{Chosen, Fixed, Many};
    const TWO: Pins = Fixed(&["IN1", "IN2"]);
    const ONE: Pins = Fixed(&["IN"]);
    const SHIFT: Pins = Fixed(&["IN", "N"]);
    let (name, pins) = match op {
        Op::Mov => ("MOVE", ONE),
        Op::Add => ("ADD", Many),
        Op::Mul => ("MUL", Many),
        Op::Sub => ("SUB", TWO),
        Op::Div => ("DIV", TWO),
        Op::Mod => ("MOD", TWO),
        Op::Exp => ("EXPT", TWO),
        Op::Not => ("NOT", ONE),
        Op::And => ("AND", Many),
        Op::Or => ("OR", Many),
        Op::Xor => ("XOR", Many),
        Op::Shl => ("SHL", SHIFT),
        Op::Shr => ("SHR", SHIFT),
        Op::Rol => ("ROL", SHIFT),
        Op::Ror => ("ROR", SHIFT),
        Op::Abs => ("ABS", ONE),
        Op::Sqrt => ("SQRT", ONE),
        Op::Ln => ("LN", ONE),
        Op::Log => ("LOG", ONE),
        Op::Expe => ("EXP", ONE),
        Op::Sin => ("SIN", ONE),
        Op::Cos => ("COS", ONE),
        Op::Tan => ("TAN", ONE),
        Op::Asin => ("ASIN", ONE),
        Op::Acos => ("ACOS", ONE),
        Op::Atan => ("ATAN", ONE),
        Op::Min => ("MIN", Many),
        Op::Max => ("MAX", Many),
        Op::Limit => ("LIMIT", Fixed(&["MN", "IN", "MX"])),
        Op::Sel => ("SEL", Fixed(&["G", "IN0", "IN1"])),
        Op::Mux => ("MUX", Chosen),
        Op::Len => ("LEN", ONE),
        Op::Left => ("LEFT", Fixed(&["IN", "L"])),
        Op::Right => ("RIGHT", Fixed(&["IN", "L"])),
        Op::Mid => ("MID", Fixed(&["IN", "L", "P"])),
        Op::Concat => ("CONCAT", Many),
        Op::Insert => ("INSERT", Fixed(&["IN1", "IN2", "P"])),
        Op::Delete => ("DELETE", Fixed(&["IN", "L", "P"])),
        Op::Replace => ("REPLACE", Fixed(&["IN1", "IN2", "L", "P"])),
        Op::Find => ("FIND", TWO),
        Op::Eq => ("EQ", Many),
        Op::Ne => ("NE", TWO),
        Op::Gt => ("GT", Many),
        Op::Ge => ("GE", Many),
        Op::Lt => ("LT", Many),
        Op::Le => ("LE", Many),
        _ => return None,
    };
    Some(Function { name, pins })
}

impl Pins {
    /// The names of so many inputs. None: it has another number of them.
    pub(super) fn names(self, count: usize) -> Option<Vec<String>> {
        match self {
            Pins::Fixed(names) => {
                (names.len() == count).then(|| names.iter().map(|name| (*name).to_owned()).collect())
            }
            Pins::Many => (count > 1).then(|| (1..=count).map(|n| format!("IN{n}")).collect()),
            Pins::Chosen => (count > 1).then(|| {
                let rest = (0..count - 1).map(|n| format!("IN{n}"));
                std::iter::once("K".to_owned()).chain(rest).collect()
            }),
        }
    }
}
