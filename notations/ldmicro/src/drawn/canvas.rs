//! The diagram itself: cells side by side, branches below each other.

use super::super::element;
use super::super::model::{File, Leaf, Node, Rung};
use super::symbol::{Symbol, symbol};
use super::{CELL, CELL_LINES};

/// Blank lines between two rungs.
const BETWEEN: usize = 3;
/// Where the cells begin.
const LEFT: usize = 5;

/// The diagram, with its rails.
pub(super) fn draw(file: &File) -> String {
    let width = file.rungs.iter().map(width_of_rung).max().unwrap_or(1).max(1);
    let mut canvas = Canvas {
        width,
        lines: Vec::new(),
    };
    // The first rung's name is on the second line.
    let mut top = 1;
    for (number, rung) in file.rungs.iter().enumerate() {
        let height = height(&rung.parts);
        canvas.text(0, top + 1, &format!("{:>2}", number + 1));
        match comment(rung) {
            Some(text) => canvas.comment(text, top),
            None => drop(canvas.series(&rung.parts, 0, top, true)),
        }
        top += height * CELL_LINES + BETWEEN;
    }
    let end = top - 1;
    canvas.text(LEFT, end, &"-".repeat(width * CELL));
    canvas.text(LEFT, end, "------[END]");
    canvas.finish(end + 2)
}

/// The text of a rung that is only a comment.
fn comment(rung: &Rung) -> Option<&str> {
    match &rung.parts[..] {
        [Node::Leaf(leaf)] => leaf.comment(),
        _ => None,
    }
}

/// The two lines of a comment. Where it has more, they are after the second one.
fn lines_of(comment: &str) -> Vec<String> {
    let mut lines = vec![String::new()];
    let mut chars = comment.chars();
    while let Some(c) = chars.next() {
        let line = lines.len() - 1;
        match (c, line) {
            ('\\', _) => match (chars.next(), line) {
                (Some('n'), 0) => lines.push(String::new()),
                (Some('n'), _) => lines[line].push(' '),
                (Some('r') | None, _) => {}
                (Some(c), _) => lines[line].push(c),
            },
            (c, _) => lines[line].push(c),
        }
    }
    lines
}

fn width_of_rung(rung: &Rung) -> usize {
    match comment(rung) {
        Some(text) => {
            let longest = lines_of(text).iter().map(|line| line.chars().count()).max();
            (longest.unwrap_or(0) + 3).div_ceil(CELL)
        }
        None => rung.parts.iter().map(width).sum(),
    }
}

/// How many cells a part has at least.
fn width(node: &Node) -> usize {
    match node {
        Node::Leaf(leaf) => symbol(&leaf.text).cells,
        Node::Series(parts) => parts.iter().map(width).sum(),
        Node::Parallel(branches) => branches.iter().map(width).max().unwrap_or(0),
    }
}

/// How many cells what is in series is high.
fn height(parts: &[Node]) -> usize {
    parts.iter().map(height_of).max().unwrap_or(0)
}

fn height_of(node: &Node) -> usize {
    match node {
        Node::Leaf(_) => 1,
        Node::Series(parts) => height(parts),
        Node::Parallel(branches) => branches.iter().map(height_of).sum(),
    }
}

struct Canvas {
    /// In cells.
    width: usize,
    lines: Vec<Vec<char>>,
}

impl Canvas {
    fn put(&mut self, column: usize, line: usize, c: char) {
        while self.lines.len() <= line {
            self.lines.push(Vec::new());
        }
        let line = &mut self.lines[line];
        if line.len() <= column {
            line.resize(column + 1, ' ');
        }
        line[column] = c;
    }

    fn text(&mut self, column: usize, line: usize, text: &str) {
        for (offset, c) in text.chars().enumerate() {
            self.put(column + offset, line, c);
        }
    }

    fn comment(&mut self, text: &str, top: usize) {
        for (index, line) in lines_of(text).iter().enumerate() {
            self.text(LEFT + 1, top + index, &format!("; {line}"));
        }
    }

    /// Draws parts after each other from a cell on; `last` where the right rail follows. Returns the cells it took.
    fn series(&mut self, parts: &[Node], cell: usize, top: usize, last: bool) -> usize {
        let mut at = cell;
        for (index, part) in parts.iter().enumerate() {
            at += self.part(part, at, top, last && index + 1 == parts.len());
        }
        at - cell
    }

    fn part(&mut self, node: &Node, cell: usize, top: usize, last: bool) -> usize {
        match node {
            Node::Leaf(leaf) => self.leaf(leaf, cell, top, last),
            Node::Series(parts) => self.series(parts, cell, top, last),
            Node::Parallel(branches) => self.parallel(branches, cell, top, last),
        }
    }

    fn leaf(&mut self, leaf: &Leaf, cell: usize, top: usize, last: bool) -> usize {
        let symbol = symbol(&leaf.text);
        let ends_rung = element::row_of(&leaf.text).is_some_and(|row| row.ends_rung);
        let before = if ends_rung && last {
            self.width.saturating_sub(cell + symbol.cells)
        } else {
            0
        };
        self.wire(cell, before, top);
        self.symbol(&symbol, cell + before, top);
        before + symbol.cells
    }

    fn wire(&mut self, cell: usize, cells: usize, top: usize) {
        self.text(LEFT + cell * CELL, top + 1, &"-".repeat(cells * CELL));
    }

    fn symbol(&mut self, symbol: &Symbol, cell: usize, top: usize) {
        let room = symbol.cells * CELL;
        let start = LEFT + cell * CELL;
        let centred = |text: &str| start + room.saturating_sub(text.chars().count()) / 2;
        self.text(centred(&symbol.above), top, &symbol.above);
        self.wire(cell, symbol.cells, top);
        self.text(centred(&symbol.body), top + 1, &symbol.body);
    }

    fn parallel(&mut self, branches: &[Node], cell: usize, top: usize, last: bool) -> usize {
        let takes = |node: &Node| {
            if last && fills(node) {
                self.width.saturating_sub(cell)
            } else {
                width(node)
            }
        };
        let wide = branches.iter().map(takes).max().unwrap_or(0);
        let mut tops = Vec::with_capacity(branches.len());
        let mut at = top;
        for branch in branches {
            let taken = self.part(branch, cell, at, last);
            self.wire(cell + taken, wide.saturating_sub(taken), at);
            tops.push(at);
            at += height_of(branch) * CELL_LINES;
        }
        // The rails join the branches that begin or end there.
        if cell > 0 {
            self.join(LEFT + cell * CELL - 1, &tops);
        }
        if cell + wide < self.width {
            self.join(LEFT + (cell + wide) * CELL - 1, &tops);
        }
        wide
    }

    /// The vertical wire at one end of branches.
    fn join(&mut self, column: usize, tops: &[usize]) {
        let (Some(&first), Some(&last)) = (tops.first(), tops.last()) else {
            return;
        };
        for line in first + 1..=last + 1 {
            let there = self.lines.get(line).and_then(|line| line.get(column)).copied();
            if tops.contains(&(line - 1)) || matches!(there, Some('+' | '-')) {
                self.put(column, line, '+');
            } else {
                self.put(column, line, '|');
            }
        }
    }

    /// The lines between the rails.
    fn finish(mut self, last: usize) -> String {
        let right = LEFT + self.width * CELL;
        for line in 0..=last {
            for column in [LEFT - 2, LEFT - 1, right, right + 1] {
                self.put(column, line, '|');
            }
        }
        let lines = self.lines.iter().take(last + 1);
        lines.map(|line| line.iter().collect::<String>() + "\n").collect()
    }
}

/// Whether a part that is last goes on to the right rail.
fn fills(node: &Node) -> bool {
    match node {
        Node::Leaf(leaf) => element::row_of(&leaf.text).is_some_and(|row| row.ends_rung),
        Node::Series(parts) => parts.last().is_some_and(fills),
        Node::Parallel(branches) => branches.iter().any(fills),
    }
}
