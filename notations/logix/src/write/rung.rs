//! Rungs as neutral text: `XIC(a)[XIC(b) ,XIO(c) ]OTE(d);`

/// What is in series on a rung.
pub(super) type Series = Vec<Piece>;

/// A part of a rung.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Piece {
    /// An instruction with its operands.
    It(String),
    /// Legs from top to bottom.
    Branch(Vec<Series>),
}

/// An instruction.
pub(super) fn it(name: &str, operands: &[&str]) -> Piece {
    Piece::It(format!("{name}({})", operands.join(",")))
}

/// Legs as one part. No leg more than one is none.
pub(super) fn branch(legs: Vec<Series>) -> Series {
    match <[Series; 1]>::try_from(legs) {
        Ok([only]) => only,
        Err(legs) => vec![Piece::Branch(legs)],
    }
}

/// The text of a rung.
pub(super) fn text(series: &[Piece]) -> String {
    let mut out = String::new();
    write(series, "", &mut out);
    out.push(';');
    out
}

fn write(series: &[Piece], after: &str, out: &mut String) {
    for piece in series {
        match piece {
            Piece::It(text) => out.push_str(text),
            Piece::Branch(legs) => {
                out.push('[');
                for (number, leg) in legs.iter().enumerate() {
                    if number > 0 {
                        out.push(',');
                    }
                    write(leg, " ", out);
                }
                out.push(']');
            }
        }
        out.push_str(after);
    }
}
