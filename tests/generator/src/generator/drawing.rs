//! A network as a list of things on rungs, and the writer that draws it.
//!
//! The writer knows no columns and is not the formatter's: wires are as long as the dice say, verticals are
//! anywhere, so that what is tested is the wiring and not the look.

use super::dice::Dice;
use crate::reference::DrawnPart;

/// A thing on a rung. Things that follow each other are joined by a wire.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Item {
    /// A `+`: the left rail's if it is first, the right rail's if it is last.
    Rail,
    /// A block.
    Block(String),
    /// `\`
    Down,
    /// `/`
    Up,
    /// A comment in a wire.
    Comment(String),
    /// White space: the segment ends, the next one begins.
    Gap,
    /// A wire that ends at nothing, first or last in its segment.
    Stub,
}

/// The rungs of a network.
pub type Network = Vec<Vec<Item>>;

/// The network as the reference evaluation reads it; blocks are numbered from left to right, top to bottom.
pub(super) fn parts(network: &Network) -> Vec<Vec<DrawnPart>> {
    let mut blocks = 0;
    network
        .iter()
        .map(|rung| {
            rung.iter()
                .map(|item| match item {
                    Item::Rail => DrawnPart::Rail,
                    Item::Down => DrawnPart::Down,
                    Item::Up => DrawnPart::Up,
                    Item::Gap => DrawnPart::Gap,
                    Item::Comment(_) | Item::Stub => DrawnPart::Wire,
                    Item::Block(_) => {
                        blocks += 1;
                        DrawnPart::Block(blocks - 1)
                    }
                })
                .collect()
        })
        .collect()
}

/// How the writer draws.
#[derive(Debug, Clone, Copy)]
pub struct Pen {
    /// The longest wire, where nothing holds back what follows it.
    pub longest: usize,
    /// What ends a line.
    pub line_end: &'static str,
    /// Draw comments, rail lines and blank lines that mean nothing.
    pub decorated: bool,
    /// Paired connectors are below each other.
    pub aligned: bool,
}

impl Pen {
    /// Draws a network.
    pub fn draw(self, dice: &mut Dice, network: &Network, text: &mut String) {
        let columns = self.columns(dice, network);
        for (number, (rung, columns)) in network.iter().zip(&columns).enumerate() {
            if number > 0 && self.decorated && dice.one_in(5) {
                let between = ["", "|", "|   |    |", "  # between #", "|  # between #  |", "\t"];
                text.push_str(dice.of(&between));
                text.push_str(self.line_end);
            }
            self.rung(dice, rung, columns, text);
            text.push_str(self.line_end);
        }
    }

    /// Where each thing begins. A rung that does not begin at the rail leaves room for a `|`.
    fn columns(self, dice: &mut Dice, network: &Network) -> Vec<Vec<usize>> {
        let wires: Vec<Vec<usize>> = network
            .iter()
            .map(|rung| rung.iter().map(|_| 1 + dice.below(self.longest)).collect())
            .collect();
        let mut columns: Vec<Vec<usize>> = network.iter().map(|rung| vec![0; rung.len()]).collect();
        loop {
            let mut moved = false;
            for (rung, items) in network.iter().enumerate() {
                let mut end = if items.first() == Some(&Item::Rail) { 0 } else { 3 };
                for (at, item) in items.iter().enumerate() {
                    let wire = if at == 0 { 0 } else { wires[rung][at] };
                    let column = columns[rung][at].max(end + wire);
                    columns[rung][at] = column;
                    end = column + width(item);
                }
            }
            for upper in 0..network.len().saturating_sub(1) {
                let (above, below) = (
                    places(&network[upper], &Item::Down),
                    places(&network[upper + 1], &Item::Up),
                );
                for (down, up) in above.into_iter().zip(below) {
                    let (one, other) = (columns[upper][down], columns[upper + 1][up]);
                    moved |= self.aligned && one != other;
                    if self.aligned {
                        columns[upper][down] = one.max(other);
                        columns[upper + 1][up] = one.max(other);
                    }
                }
            }
            if !moved {
                return columns;
            }
        }
    }

    fn rung(self, dice: &mut Dice, rung: &[Item], columns: &[usize], text: &mut String) {
        let railed = rung.first() == Some(&Item::Rail);
        let before = match columns.first() {
            Some(_) if !self.aligned && self.decorated && dice.one_in(3) => dice
                .of(&["  ", " ", "# lead # ", "\t", "  # lead #  "])
                .to_owned(),
            Some(&column) if !railed && dice.one_in(2) => format!("|{}", " ".repeat(column - 1)),
            Some(&column) => " ".repeat(column),
            None => String::new(),
        };
        text.push_str(&before);
        let mut end = columns.first().copied().unwrap_or_default();
        for (number, (item, &column)) in rung.iter().zip(columns).enumerate() {
            let before = number.checked_sub(1).map(|before| &rung[before]);
            let blank = before == Some(&Item::Gap) || *item == Item::Gap;
            let wire = column - end;
            let bar = *item == Item::Gap && wire > 1 && !self.aligned && dice.one_in(3);
            match (blank, bar) {
                (false, _) => text.push_str(&"-".repeat(wire)),
                (true, false) => text.push_str(&" ".repeat(wire)),
                (true, true) => text.push_str(&format!("{}| ", " ".repeat(wire - 1))),
            }
            match item {
                Item::Rail => text.push('+'),
                Item::Down => text.push('\\'),
                Item::Up => text.push('/'),
                Item::Block(words) | Item::Comment(words) => text.push_str(words),
                Item::Gap | Item::Stub => {}
            }
            end = column + width(item);
        }
        let ends_railed = rung.len() > 1 && rung.last() == Some(&Item::Rail);
        if self.decorated && dice.one_in(4) {
            text.push_str(dice.of(&["  # after #", "  # after #  # more #", " "]));
        } else if !ends_railed && dice.one_in(3) {
            text.push_str("   |");
        }
    }
}

/// How many columns a thing takes; of a gap it is the blank that is always there.
fn width(item: &Item) -> usize {
    match item {
        Item::Rail | Item::Down | Item::Up => 1,
        Item::Block(words) | Item::Comment(words) => words.chars().count(),
        Item::Gap | Item::Stub => 0,
    }
}

/// The places of a connector on a rung.
fn places(rung: &[Item], connector: &Item) -> Vec<usize> {
    (0..rung.len()).filter(|&at| rung[at] == *connector).collect()
}
