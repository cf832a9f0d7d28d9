//! A sheet of characters, on which lines that meet are joined.

use super::{Ink, Line, Mark};
use ladder_syntax::TextSize;

/// The weight of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, PartialOrd, Ord)]
pub(super) enum Weight {
    /// There is none.
    #[default]
    None,
    Light,
    Heavy,
}

/// Where a line leads from the middle of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Arm {
    Up,
    Right,
    Down,
    Left,
}

/// The characters of lines, by the weights of their arms: up, right, down, left, the last one counts up first.
const JOINTS: &str = concat!(
    " ╴╸╷┐┑╻┒┓",
    "╶─╾┌┬┭┎┰┱",
    "╺╼━┍┮┯┏┲┳",
    "╵┘┙│┤┥╽┧┪",
    "└┴┵├┼┽┟╁╅",
    "┕┶┷┝┾┿┢╆╈",
    "╹┚┛╿┦┩┃┨┫",
    "┖┸┹┞╀╃┠╂╉",
    "┗┺┻┡╄╇┣╊╋",
);

/// What is in one column of one line.
#[derive(Debug, Clone, Default)]
enum Content {
    #[default]
    Blank,
    /// Lines that meet here.
    Lines([Weight; 4]),
    /// A character, with what takes no column of its own.
    Letter(String),
    /// The rest of a character that takes two columns.
    After,
}

#[derive(Debug, Clone, Default)]
struct Cell {
    content: Content,
    ink: Option<Ink>,
}

/// A sheet that grows with what is drawn.
#[derive(Debug, Default)]
pub(super) struct Canvas {
    rows: Vec<Vec<Cell>>,
}

impl Canvas {
    fn cell(&mut self, row: usize, column: usize) -> &mut Cell {
        if self.rows.len() <= row {
            self.rows.resize_with(row + 1, Vec::new);
        }
        let cells = &mut self.rows[row];
        if cells.len() <= column {
            cells.resize_with(column + 1, Cell::default);
        }
        &mut cells[column]
    }

    /// Leads a line out of a cell; where one leads there already, the heavier one is drawn.
    pub(super) fn arm(&mut self, row: usize, column: usize, arm: Arm, weight: Weight, ink: Ink) {
        let cell = self.cell(row, column);
        let mut arms = match cell.content {
            Content::Lines(arms) => arms,
            _ => [Weight::None; 4],
        };
        let before = arms.iter().max().copied().unwrap_or_default();
        arms[arm as usize] = arms[arm as usize].max(weight);
        cell.content = Content::Lines(arms);
        // Where lines meet the heavier one is seen.
        if cell.ink.is_none() || weight > before {
            cell.ink = Some(ink);
        }
    }

    /// A line from left to right through these columns.
    pub(super) fn across(&mut self, row: usize, from: usize, to: usize, weight: Weight, ink: Ink) {
        for column in from..to {
            self.arm(row, column, Arm::Left, weight, ink);
            self.arm(row, column, Arm::Right, weight, ink);
        }
    }

    /// A line down, from the middle of one row to the middle of another.
    pub(super) fn down(&mut self, column: usize, from: usize, to: usize, weight: Weight, ink: Ink) {
        for row in from..=to {
            if row > from {
                self.arm(row, column, Arm::Up, weight, ink);
            }
            if row < to {
                self.arm(row, column, Arm::Down, weight, ink);
            }
        }
    }

    /// Writes a text over what is there.
    pub(super) fn text(&mut self, row: usize, column: usize, text: &str, ink: Ink) {
        let mut at = column;
        for letter in text.chars() {
            let wide = ladder_format::display_width(letter.encode_utf8(&mut [0; 4])) as usize;
            if wide == 0 {
                if let Some(before) = at.checked_sub(1)
                    && let Content::Letter(text) = &mut self.cell(row, before).content
                {
                    text.push(letter);
                }
                continue;
            }
            *self.cell(row, at) = Cell {
                content: Content::Letter(letter.to_string()),
                ink: Some(ink),
            };
            for after in 1..wide {
                *self.cell(row, at + after) = Cell {
                    content: Content::After,
                    ink: Some(ink),
                };
            }
            at += wide;
        }
    }

    /// The lines; `places` has for each of them the place that it shows, or one for all that follow, and `wires` those that
    /// have the wire of a rung, in their order.
    pub(super) fn finish(self, places: &[TextSize], wires: &[usize]) -> Vec<Line> {
        let rows = self.rows.into_iter().enumerate();
        let lines = rows.map(|(row, cells)| {
            let (mut text, mut marks) = (String::new(), Vec::<Mark>::new());
            let mut at = 0;
            for cell in cells {
                let before = at;
                match &cell.content {
                    Content::Blank => {
                        text.push(' ');
                        at += 1;
                    }
                    Content::Lines(arms) => {
                        text.push(joint(*arms));
                        at += 1;
                    }
                    Content::Letter(letter) => {
                        text.push_str(letter);
                        at += letter.chars().count();
                    }
                    Content::After => {}
                }
                match (cell.ink, marks.last_mut()) {
                    (None, _) => {}
                    (Some(ink), Some(last)) if last.ink == ink && last.characters.end == before => {
                        last.characters.end = at;
                    }
                    (Some(ink), _) => marks.push(Mark {
                        characters: before..at,
                        ink,
                    }),
                }
            }
            text.truncate(text.trim_end().len());
            let place = places.get(row).or(places.last());
            Line {
                text,
                marks,
                place: place.copied().unwrap_or_default(),
                is_wire: wires.binary_search(&row).is_ok(),
            }
        });
        lines.collect()
    }
}

fn joint(arms: [Weight; 4]) -> char {
    let index = arms
        .into_iter()
        .fold(0, |index, weight| index * 3 + weight as usize);
    JOINTS.chars().nth(index).unwrap_or(' ')
}
