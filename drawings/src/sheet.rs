//! A drawing as a sheet of columns, and what its characters are.

use ladder_format::display_width;

/// A line is read up to this column.
pub(crate) const WIDEST: usize = 1_000;

/// Where a tab leads to: the next multiple of this.
const TAB: usize = 8;

/// Lines of a text, each with one character for each column.
#[derive(Debug, Default)]
pub(crate) struct Sheet {
    lines: Vec<Line>,
}

#[derive(Debug, Default)]
struct Line {
    cells: Vec<char>,
    /// For each column the character of the text, from 1.
    characters: Vec<u32>,
}

impl Sheet {
    pub(crate) fn of<'t>(lines: impl Iterator<Item = &'t str>) -> Sheet {
        let mut sheet = Sheet {
            lines: lines.map(Line::of).collect(),
        };
        sheet.use_other_bars();
        sheet.use_round_corners();
        sheet
    }

    /// `.` and `'` are corners where wire comes from the side, and a line leads down or up from them.
    fn use_round_corners(&mut self) {
        for line in 0..self.lines.len() {
            for column in 0..self.width(line) {
                let goes_on = match self.at(line, column) {
                    '.' if line + 1 < self.len() => self.at(line + 1, column),
                    '\'' if line > 0 => self.at(line - 1, column),
                    _ => continue,
                };
                let before = column.checked_sub(1).map_or(' ', |before| self.at(line, before));
                let is_wired = [before, self.at(line, column + 1)].contains(&'-');
                if is_wired && (is_bar(goes_on) || matches!(goes_on, '+' | '\'')) {
                    self.lines[line].cells[column] = '+';
                }
            }
        }
    }

    /// `!` is a vertical line where no `|` is anywhere.
    fn use_other_bars(&mut self) {
        let has_bars = self
            .lines
            .iter()
            .any(|line| line.cells.iter().any(|&c| is_bar(c)));
        if !has_bars {
            for cell in self.lines.iter_mut().flat_map(|line| &mut line.cells) {
                if *cell == '!' {
                    *cell = '|';
                }
            }
        }
    }

    pub(crate) fn len(&self) -> usize {
        self.lines.len()
    }

    /// The lines that were cut off.
    pub(crate) fn cut(&self) -> impl Iterator<Item = usize> {
        (0..self.len()).filter(|&line| self.width(line) == WIDEST)
    }

    /// How many columns a line has.
    pub(crate) fn width(&self, line: usize) -> usize {
        self.lines.get(line).map_or(0, |line| line.cells.len())
    }

    /// The character at a place; a blank where there is none.
    pub(crate) fn at(&self, line: usize, column: usize) -> char {
        let line = self.lines.get(line);
        line.and_then(|line| line.cells.get(column))
            .copied()
            .unwrap_or(' ')
    }

    /// What is between two columns.
    pub(crate) fn text(&self, line: usize, from: usize, to: usize) -> String {
        (from..to.min(self.width(line)))
            .map(|column| self.at(line, column))
            .filter(|c| *c != AFTER)
            .collect()
    }

    /// Which character of its line, from 1, is in a column.
    pub(crate) fn character(&self, line: usize, column: usize) -> u32 {
        let line = self.lines.get(line);
        let known = line.and_then(|line| line.characters.get(column)).copied();
        known.unwrap_or(column as u32 + 1)
    }
}

/// What is in the second column of a character that takes two.
const AFTER: char = '\u{0}';

impl Line {
    fn of(text: &str) -> Line {
        let mut line = Line::default();
        for (c, character) in text.trim_end().chars().zip(1..) {
            let column = line.cells.len();
            let wide = match c {
                '\t' => TAB - column % TAB,
                c => display_width(c.encode_utf8(&mut [0; 4])) as usize,
            };
            for after in 0..wide.min(WIDEST - column) {
                line.cells.push(match (c, after) {
                    ('\t', _) => ' ',
                    (c, 0) if c.is_whitespace() || c.is_control() => ' ',
                    (c, 0) => c,
                    _ => AFTER,
                });
                line.characters.push(character);
            }
            if line.cells.len() == WIDEST {
                break;
            }
        }
        line.one_rail_for_two();
        line
    }

    /// `||` is a rail that is drawn twice: the bar next to the wire is kept.
    fn one_rail_for_two(&mut self) {
        for at in 1..self.cells.len() {
            if is_bar(self.cells[at - 1]) && is_bar(self.cells[at]) {
                let comes =
                    at > 1 && (is_wire(self.cells[at - 2]) || matches!(self.cells[at - 2], ')' | ']'));
                self.cells[if comes { at } else { at - 1 }] = ' ';
            }
        }
    }
}

/// A piece of wire from left to right.
pub(crate) fn is_wire(c: char) -> bool {
    matches!(
        c,
        '-' | '\u{2010}'
            ..='\u{2015}'
                | '\u{2212}'
                | '─'
                | '━'
                | '═'
                | '╌'
                | '┄'
                | '╍'
                | '┅'
                | '╴'
                | '╶'
                | '╸'
                | '╺'
                | '╼'
                | '╾'
    )
}

/// A line from top to bottom.
pub(crate) fn is_bar(c: char) -> bool {
    matches!(c, '|' | '¦' | '│' | '┃' | '║' | '╎' | '┆' | '╏' | '╽' | '╿')
}

/// Where lines lead to from the middle of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Arms {
    pub(crate) up: bool,
    pub(crate) right: bool,
    pub(crate) down: bool,
    pub(crate) left: bool,
}

/// The joints among the box-drawing characters, by where they lead to: up, right, down, left.
const JOINTS: [(&str, [bool; 4]); 9] = [
    ("┌┍┎┏╒╓╔╭", [false, true, true, false]),
    ("┐┑┒┓╕╖╗╮", [false, false, true, true]),
    ("└┕┖┗╘╙╚╰", [true, true, false, false]),
    ("┘┙┚┛╛╜╝╯", [true, false, false, true]),
    ("├┝┞┟┠┡┢┣╞╟╠", [true, true, true, false]),
    ("┤┥┦┧┨┩┪┫╡╢╣", [true, false, true, true]),
    ("┬┭┮┯┰┱┲┳╤╥╦", [false, true, true, true]),
    ("┴┵┶┷┸┹┺┻╧╨╩", [true, true, false, true]),
    ("┼┽┾┿╀╁╂╃╄╅╆╇╈╉╊╋╪╫╬", [true, true, true, true]),
];

/// Where a joint or a bar may lead to; none for any other character. What is drawn without box characters leads wherever
/// something comes.
pub(crate) fn arms(c: char) -> Option<Arms> {
    if c == '+' || is_bar(c) {
        return Some(Arms {
            up: true,
            right: true,
            down: true,
            left: true,
        });
    }
    if c.is_ascii() {
        return None;
    }
    let (_, [up, right, down, left]) = JOINTS.iter().find(|(joints, _)| joints.contains(c))?;
    Some(Arms {
        up: *up,
        right: *right,
        down: *down,
        left: *left,
    })
}

/// Whether something is a bar as contacts are drawn with: `┤ ├`, `| |`.
pub(crate) fn opens_contact(c: char) -> bool {
    is_bar(c) || JOINTS[5].0.contains(c)
}

/// See [`opens_contact`].
pub(crate) fn closes_contact(c: char) -> bool {
    is_bar(c) || JOINTS[4].0.contains(c)
}
