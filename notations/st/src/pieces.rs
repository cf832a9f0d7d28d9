//! The functions and blocks that are written along with a program that needs them.

use ladder_notation::pieces::Pieces;
use std::sync::LazyLock;

/// In the order in which they are written: each may use only what is above it.
pub(crate) static PIECES: LazyLock<Pieces> = LazyLock::new(|| {
    Pieces::of(&[
        include_str!("../runtime/numbers.st"),
        include_str!("../runtime/blocks.st"),
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
