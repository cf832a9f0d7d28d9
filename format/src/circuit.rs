//! A network as what is in series and in parallel, drawn as a [`Sketch`]: for importers and refactorings.

use crate::width::display_width;
use crate::{ElementKind, Options, Sketch};

/// A part of a network with one wire in and one wire out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Circuit<T> {
    /// One block, or a comment in the wire.
    Element(T),
    /// One after the other; none is a bare wire.
    Series(Vec<Circuit<T>>),
    /// Branches between the same two points, from the upper one to the lowest.
    Parallel(Vec<Circuit<T>>),
}

impl<T> Circuit<T> {
    /// The same circuit with something else in the place of each element.
    #[must_use]
    pub fn replaced<U>(self, by: &dyn Fn(T) -> Circuit<U>) -> Circuit<U> {
        let all = |parts: Vec<Circuit<T>>| parts.into_iter().map(|part| part.replaced(by)).collect();
        match self {
            Circuit::Element(element) => by(element),
            Circuit::Series(parts) => Circuit::Series(all(parts)),
            Circuit::Parallel(branches) => Circuit::Parallel(all(branches)),
        }
    }
}

impl<T> Circuit<T> {
    /// Changes each element.
    pub fn for_each_mut(&mut self, with: &mut impl FnMut(&mut T)) {
        match self {
            Circuit::Element(element) => with(element),
            Circuit::Series(parts) | Circuit::Parallel(parts) => {
                for part in parts {
                    part.for_each_mut(with);
                }
            }
        }
    }
}

/// One thing on a rung of a drawn circuit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Piece<'c, T> {
    /// What it is.
    pub kind: PieceKind<'c, T>,
    /// Whether wire joins it to what is before it on its rung.
    pub joined: bool,
}

/// What a piece is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PieceKind<'c, T> {
    /// `\`
    Down,
    /// `/`
    Up,
    /// An element of the circuit.
    Element(&'c T),
}

type Rungs<'c, T> = Vec<Vec<Piece<'c, T>>>;

const fn down<'c, T>(joined: bool) -> Piece<'c, T> {
    let kind = PieceKind::Down;
    Piece { kind, joined }
}

const fn up<'c, T>(joined: bool) -> Piece<'c, T> {
    let kind = PieceKind::Up;
    Piece { kind, joined }
}

impl<T> Circuit<T> {
    /// Its rungs from top to bottom. Wire comes in at the left end of the first and goes out at its right end; the
    /// other rungs are joined to it from below. What is in series is evaluated from left to right, what is in parallel from
    /// top to bottom.
    pub fn rungs(&self) -> Vec<Vec<Piece<'_, T>>> {
        match self {
            Circuit::Element(element) => vec![vec![Piece {
                kind: PieceKind::Element(element),
                joined: true,
            }]],
            Circuit::Series(parts) => {
                let mut rungs: Rungs<'_, T> = vec![Vec::new()];
                for part in parts {
                    for (number, rung) in part.rungs().into_iter().enumerate() {
                        if rungs.len() <= number {
                            rungs.push(Vec::new());
                        }
                        rungs[number].extend(rung);
                    }
                }
                rungs
            }
            Circuit::Parallel(branches) => parallel(branches),
        }
    }

    /// The text of a network that leads from the left rail to the right one through the circuit, each rung with
    /// `line_end` after it. `element` says what an element is, and its text.
    pub fn draw<'c>(
        &'c self,
        options: &Options,
        line_end: &str,
        element: impl Fn(&'c T) -> (ElementKind, &'c str),
    ) -> String {
        let mut sketch = Sketch::new();
        let mut texts = Vec::new();
        for (number, rung) in self.rungs().into_iter().enumerate() {
            sketch.begin_rung();
            let mut push = |kind, joined, text: &'c str| {
                sketch.push(kind, joined, display_width(text).max(1));
                texts.push(text);
            };
            if number == 0 {
                push(ElementKind::LeftRail, false, "");
            }
            for piece in rung {
                let (kind, text) = match piece.kind {
                    PieceKind::Down => (ElementKind::Down, ""),
                    PieceKind::Up => (ElementKind::Up, ""),
                    PieceKind::Element(it) => element(it),
                };
                push(kind, piece.joined, text);
            }
            if number == 0 {
                push(ElementKind::RightRail, true, "");
            }
        }
        let mut out = String::new();
        sketch.lay_out(options).draw(|n| texts[n], line_end, &mut out);
        out
    }
}

/// The first branch is between two `\`, the others in the same way between the `/` below them. On the rungs
/// below the first branch the wires to the others pass on both sides.
fn parallel<T>(branches: &[Circuit<T>]) -> Rungs<'_, T> {
    let [first, rest @ ..] = branches else {
        return vec![Vec::new()];
    };
    let mut above = first.rungs();
    if rest.is_empty() {
        return above;
    }
    for (number, rung) in above.iter_mut().enumerate() {
        if number == 0 {
            rung.insert(0, down(true));
            rung.push(down(true));
        } else {
            rung.splice(0..0, [up(false), down(true)]);
            rung.extend([down(false), up(true)]);
        }
    }
    let mut below = parallel(rest);
    if let Some(rung) = below.first_mut() {
        rung.insert(0, up(false));
        rung.push(up(true));
    }
    above.extend(below);
    above
}
