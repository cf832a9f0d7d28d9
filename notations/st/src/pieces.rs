//! The functions and blocks that are written along with a program that needs them.

use std::collections::BTreeSet;
use std::sync::LazyLock;

/// In the order in which they are written: each may use only what is above it.
const RUNTIME: [&str; 2] = [
    include_str!("../runtime/numbers.st"),
    include_str!("../runtime/blocks.st"),
];

/// What a line begins with that introduces a piece: its name and those of the pieces that it needs.
const MARK: &str = "//: ";

struct Piece {
    name: &'static str,
    needs: Vec<&'static str>,
    text: &'static str,
}

static ALL: LazyLock<Vec<Piece>> = LazyLock::new(|| {
    let texts = RUNTIME.iter().flat_map(|file| file.split(MARK).skip(1));
    texts
        .map(|piece| {
            let (head, text) = piece.split_once('\n').unwrap_or((piece, ""));
            let mut words = head.split_whitespace();
            Piece {
                name: words.next().unwrap_or_default(),
                needs: words.collect(),
                text: text.trim_end(),
            }
        })
        .collect()
});

/// The text of these pieces and of all that they need.
pub(crate) fn text(used: &BTreeSet<&'static str>) -> String {
    let mut wanted = used.clone();
    loop {
        let before = wanted.len();
        for piece in ALL.iter() {
            if wanted.contains(piece.name) {
                wanted.extend(piece.needs.iter().copied());
            }
        }
        if wanted.len() == before {
            break;
        }
    }
    let chosen = ALL.iter().filter(|piece| wanted.contains(piece.name));
    chosen.flat_map(|piece| [piece.text, "\n\n"]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_piece_needs_is_there_and_above_it() {
        let mut above = BTreeSet::new();
        for piece in ALL.iter() {
            above.insert(piece.name);
            for need in &piece.needs {
                assert!(above.contains(need), "{} needs {need}", piece.name);
            }
        }
    }
}
