//! The parts of the C runtime that a program needs.

use ladder_notation::pieces::Pieces;
use std::sync::LazyLock;

/// In the order in which they are written: each may use only what is above it, but for the texts, which ranges move.
pub(crate) static PIECES: LazyLock<Pieces> = LazyLock::new(|| {
    Pieces::of(&[
        include_str!("../runtime/numbers.c"),
        include_str!("../runtime/noted.c"),
        include_str!("../runtime/blocks.c"),
        include_str!("../runtime/texts.c"),
        include_str!("../runtime/ranges.c"),
        include_str!("../runtime/ports.c"),
        include_str!("../runtime/profiles.c"),
    ])
});

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_piece_needs_is_there_and_above_it() {
        assert_eq!(PIECES.out_of_order(), None);
    }
}
