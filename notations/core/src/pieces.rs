//! Texts that are written along with a program in another language, each where a program needs it.

use std::collections::BTreeSet;

/// What a line begins with that introduces a piece: its name and those of the pieces that it needs.
const MARK: &str = "//: ";

/// The pieces of a language, in the order in which they are written.
#[derive(Debug)]
pub struct Pieces(Vec<Piece>);

#[derive(Debug)]
struct Piece {
    name: &'static str,
    needs: Vec<&'static str>,
    text: &'static str,
}

impl Pieces {
    /// The pieces of these files, each below a line such as `//: modulo wrap`: its name, and what it needs.
    pub fn of(files: &[&'static str]) -> Pieces {
        let texts = files.iter().flat_map(|file| file.split(MARK).skip(1));
        let pieces = texts.map(|piece| {
            let (head, text) = piece.split_once('\n').unwrap_or((piece, ""));
            let mut words = head.split_whitespace();
            Piece {
                name: words.next().unwrap_or_default(),
                needs: words.collect(),
                text: text.trim_end(),
            }
        });
        Pieces(pieces.collect())
    }

    /// What all pieces are called.
    pub fn names(&self) -> impl Iterator<Item = &'static str> {
        self.0.iter().map(|piece| piece.name)
    }

    /// The text of all pieces.
    pub fn all(&self) -> String {
        self.0.iter().flat_map(|piece| [piece.text, "\n\n"]).collect()
    }

    /// The name of a piece, if there is one that is called so.
    pub fn named(&self, name: &str) -> Option<&'static str> {
        self.0.iter().map(|piece| piece.name).find(|piece| *piece == name)
    }

    /// The text of these pieces and of all that they need.
    pub fn text(&self, used: &BTreeSet<&'static str>) -> String {
        let mut wanted = used.clone();
        loop {
            let before = wanted.len();
            for piece in &self.0 {
                if wanted.contains(piece.name) {
                    wanted.extend(piece.needs.iter().copied());
                }
            }
            if wanted.len() == before {
                break;
            }
        }
        let chosen = self.0.iter().filter(|piece| wanted.contains(piece.name));
        chosen.flat_map(|piece| [piece.text, "\n\n"]).collect()
    }

    /// A piece and what it needs that is not above it; none where the order is right.
    pub fn out_of_order(&self) -> Option<(&'static str, &'static str)> {
        let mut above = BTreeSet::new();
        self.0.iter().find_map(|piece| {
            above.insert(piece.name);
            let missing = piece.needs.iter().find(|need| !above.contains(*need))?;
            Some((piece.name, *missing))
        })
    }
}
