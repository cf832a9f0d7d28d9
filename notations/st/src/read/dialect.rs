//! Which system's Structured Text a text is in.

/// The dialects differ in their tokens, in a few statements, and in how wide an expression is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dialect {
    /// IEC 61131-3, as in plain files, PLCopen XML and OpenPLC.
    Iec,
    /// Routines and Add-On Instructions of Studio 5000.
    Logix,
    /// SCL of TIA Portal: `#local`, `"global"`.
    Scl,
    /// CODESYS and TwinCAT: `x S= e;`
    Codesys,
}

impl Dialect {
    /// Whether `(* (* *) *)` is one comment.
    pub(super) fn nests_comments(self) -> bool {
        self != Dialect::Logix
    }

    /// Whether `".."` is a name, and `#` is before a local one.
    pub(super) fn quotes_names(self) -> bool {
        self == Dialect::Scl
    }

    /// Whether integers are exact within an expression, and cut to the width of what they are assigned to. Else each
    /// operator computes in the type of its operands.
    pub(super) fn is_exact(self) -> bool {
        self != Dialect::Scl
    }

    /// Whether an F_TRIG that first runs with a low CLK reports a fall.
    pub(super) fn falls_at_first(self) -> bool {
        self != Dialect::Scl
    }

    /// Whether a FOR that has ended leaves its variable one step past the end. The standard leaves it open.
    pub(super) fn steps_past_the_end(self) -> bool {
        self != Dialect::Iec
    }
}
