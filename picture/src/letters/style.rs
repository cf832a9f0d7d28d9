//! Which characters a drawing is made of.

use super::{Ink, Line, Piece};
use ladder_format::display_width;

/// A set of characters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Style {
    /// Box-drawing characters.
    #[default]
    Unicode,
    /// Those of ASCII: `-`, `|`, `+`, and `=` for a wire with power.
    Ascii,
}

/// Drawings below each other, with a blank line between two.
pub fn text(pieces: &[Piece], style: Style) -> String {
    let drawn = pieces.iter().map(|piece| {
        let lines: Vec<String> = match style {
            Style::Unicode => piece.lines.iter().map(|line| line.text.clone()).collect(),
            Style::Ascii => plain(&piece.lines),
        };
        let mut text = String::new();
        for line in &lines {
            text.push_str(line.trim_end());
            text.push('\n');
        }
        text
    });
    drawn.collect::<Vec<String>>().join("\n")
}

/// A character of a drawing, in its column.
struct Cell {
    letter: char,
    column: usize,
    /// It is written, not drawn: it stays.
    is_text: bool,
}

/// Lines in the characters of ASCII. Each stands for one, so columns stay, and so does what is written.
fn plain(lines: &[Line]) -> Vec<String> {
    let rows: Vec<Vec<Cell>> = lines.iter().map(cells).collect();
    let drawn = |row: Option<usize>, column: usize| {
        let row = row.and_then(|row| rows.get(row))?;
        let at = row.binary_search_by_key(&column, |cell| cell.column).ok()?;
        (!row[at].is_text).then_some(row[at].letter)
    };
    let line = |(number, row): (usize, &Vec<Cell>)| {
        let mut out = String::new();
        let mut cells = row.iter().peekable();
        while let Some(cell) = cells.next() {
            let goes_on = || {
                let above = drawn(number.checked_sub(1), cell.column);
                let below = drawn(Some(number + 1), cell.column);
                above.is_some_and(leads_down) || below.is_some_and(leads_up)
            };
            match cell.letter {
                letter if cell.is_text && letter != '←' => out.push(letter),
                '─' => out.push('-'),
                '━' => out.push('='),
                '│' | '┃' | '╽' | '╿' => out.push('|'),
                '←' => out.push('='),
                // The bars of contacts lead nowhere up or down.
                '┤' | '├' | '┥' | '┝' | '┨' | '┠' | '┫' | '┣' if !goes_on() => out.push('|'),
                '≥' | '≤' | '≠' => {
                    out.push_str(match cell.letter {
                        '≥' => ">=",
                        '≤' => "<=",
                        _ => "<>",
                    });
                    // There is room after the sign.
                    cells.next_if(|next| !next.is_text);
                }
                letter if is_line(letter) => out.push('+'),
                letter => out.push(letter),
            }
        }
        out
    };
    rows.iter().enumerate().map(line).collect()
}

fn cells(line: &Line) -> Vec<Cell> {
    let mut column = 0;
    let mut marks = line.marks.iter().peekable();
    let cells = line.text.chars().enumerate().map(|(at, letter)| {
        while marks.next_if(|mark| mark.characters.end <= at).is_some() {}
        let ink = marks
            .peek()
            .filter(|mark| mark.characters.contains(&at))
            .map(|mark| mark.ink);
        let cell = Cell {
            letter,
            column,
            is_text: ink.is_some_and(is_written),
        };
        column += display_width(letter.encode_utf8(&mut [0; 4])) as usize;
        cell
    });
    cells.collect()
}

/// Whether something is a text and no line.
fn is_written(ink: Ink) -> bool {
    match ink {
        Ink::Tag | Ink::Name | Ink::Pin | Ink::Value | Ink::Forced | Ink::Comment | Ink::Text => true,
        Ink::Line | Ink::On | Ink::Off | Ink::Closed | Ink::Blocks | Ink::Rail => false,
    }
}

/// Whether a character is one of those that lines are drawn with.
fn is_line(letter: char) -> bool {
    ('\u{2500}'..='\u{257f}').contains(&letter)
}

fn leads_down(letter: char) -> bool {
    is_line(letter) && !"─━└┕┖┗┘┙┚┛┴┵┶┷┸┹┺┻╴╶╸╺╵╹".contains(letter)
}

fn leads_up(letter: char) -> bool {
    is_line(letter) && !"─━┌┍┎┏┐┑┒┓┬┭┮┯┰┱┲┳╴╶╸╺╷╻".contains(letter)
}
