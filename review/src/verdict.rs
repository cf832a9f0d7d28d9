//! What became of an entry of a program.

/// What became of an entry from the old text to the new one.
///
/// Whether an edited network does the same as before is reported by the [`Meaning`](ladder_prover::Meaning) of its change.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Verdict {
    /// The same, to the letter but for blanks at its ends.
    Same,
    /// The same wiring and operands, drawn or spelled differently.
    Redrawn,
    /// The same wiring and operands, with other comments.
    Commented,
    /// Of a controller's tag only the value that it had is another one.
    Value,
    /// It says something else.
    Edited,
    /// Only the new text has it.
    New,
    /// Only the old text has it.
    Gone,
}

impl Verdict {
    /// As it is called in reports.
    pub const fn text(self) -> &'static str {
        match self {
            Verdict::Same => "same",
            Verdict::Redrawn => "drawn differently",
            Verdict::Commented => "other comments",
            Verdict::Value => "other value",
            Verdict::Edited => "edited",
            Verdict::New => "new",
            Verdict::Gone => "gone",
        }
    }

    /// As it is called in JSON: one word.
    pub const fn word(self) -> &'static str {
        match self {
            Verdict::Same => "same",
            Verdict::Redrawn => "redrawn",
            Verdict::Commented => "commented",
            Verdict::Value => "value",
            Verdict::Edited => "edited",
            Verdict::New => "new",
            Verdict::Gone => "gone",
        }
    }
}
