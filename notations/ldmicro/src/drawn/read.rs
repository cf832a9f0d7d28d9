//! From the text to the model.

use super::super::model::{Encoding, File, Leaf, Node, Rung};
use super::super::{element, head};
use super::listing::{NO_PIN, WITH_PIN};
use super::{CELL, CELL_LINES, FIRST_LINE, TOO_LONG, row};
use ladder_format::Circuit;
use ladder_notation::circuit::Wires;
use ladder_notation::{LineColumn, ReadError};

/// A wider drawing is not read.
const WIDEST: usize = 256;
/// A rung with more elements is not read.
const MOST_IN_RUNG: usize = 256;
/// Branches nest no deeper.
const DEEPEST: usize = 64;
/// Where the left rail is, and the cells begin.
const RAIL: usize = 3;
const LEFT: usize = RAIL + 2;

/// Reads a text.
pub(super) fn read(bytes: &[u8]) -> Result<File, ReadError> {
    let (text, latin1) = match std::str::from_utf8(bytes) {
        Ok(text) => (text.to_owned(), false),
        Err(_) => (bytes.iter().copied().map(char::from).collect(), true),
    };
    let crlf = text.find('\n').is_some_and(|at| text[..at].ends_with('\r'));
    let mut lines = (1..).zip(text.trim_start_matches('\u{feff}').lines());
    if lines.next().map(|(_, line)| line.trim()) != Some(FIRST_LINE) {
        let message = format!("the first line of the text is `{FIRST_LINE}`");
        return Err(ReadError::at(LineColumn::START, message));
    }
    let mut file = File {
        encoding: Encoding { crlf, latin1 },
        ..File::default()
    };
    file.header = settings(lines.next().map_or("", |(_, line)| line.trim()))?;
    let mut found = false;
    for (_, line) in lines.by_ref() {
        if line.trim() == "LADDER DIAGRAM:" {
            found = true;
            break;
        }
    }
    if !found {
        return Err(ReadError::whole("there is no `LADDER DIAGRAM:` in the text"));
    }
    let mut drawing = Vec::new();
    for (number, line) in lines.by_ref() {
        match line.trim() {
            "" => {}
            "I/O ASSIGNMENT:" => break,
            _ => drawing.push(drawn_line(number, line)?),
        }
    }
    file.rungs = rungs(&drawing)?;
    for (number, line) in lines {
        let columns: Vec<&str> = line.split('|').map(str::trim).collect();
        if let [name, kind, pin] = columns[..]
            && WITH_PIN.contains(&kind)
        {
            let pin = if pin == NO_PIN {
                0
            } else {
                pin.parse::<u32>().unwrap_or(0)
            };
            file.io.push((number, format!("{name} at {pin}")));
        }
    }
    Ok(file)
}

/// `for 'ANSI C Code', 4.000000 MHz crystal, 10.0 ms cycle time`
fn settings(line: &str) -> Result<Vec<String>, ReadError> {
    let mut lines = Vec::new();
    let mut rest = line;
    if let Some((name, after)) = line.strip_prefix("for '").and_then(|line| line.split_once('\'')) {
        lines.push(format!("MICRO={name}"));
        rest = after;
    }
    let parts: Vec<&str> = rest.split(',').map(str::trim).collect();
    let number = |unit: &str, factor: f64| {
        let text = parts.iter().find_map(|part| part.strip_suffix(unit))?;
        let value = text.trim().parse::<f64>().ok()? * factor;
        (1.0..1e15).contains(&value).then(|| value.round() as u64)
    };
    match (number("MHz crystal", 1e6), number("ms cycle time", 1e3)) {
        (Some(crystal), Some(cycle)) => {
            lines.extend([format!("CRYSTAL={crystal}"), format!("CYCLE={cycle}")]);
            Ok(head::header(super::super::model::Version::V01, &lines))
        }
        _ => {
            let message =
                "here are the crystal and the cycle time: `.., 4.000000 MHz crystal, 10.0 ms cycle time`";
            Err(ReadError::at(LineColumn::line(2), message))
        }
    }
}

/// A line of the diagram.
struct Drawn {
    number: u32,
    /// The number of a rung is before the rail.
    begins: bool,
    /// What is between the rails.
    inside: Vec<char>,
}

fn drawn_line(number: u32, line: &str) -> Result<Drawn, ReadError> {
    let chars: Vec<char> = line.trim_end().chars().take(LEFT + WIDEST * CELL + 3).collect();
    let is_rail = |at: usize| chars.get(at) == Some(&'|') && chars.get(at + 1) == Some(&'|');
    let wrong = |message: &str| Err(ReadError::at(LineColumn::line(number), message));
    if !is_rail(RAIL) {
        return wrong(if is_rail(RAIL + 1) {
            "this is a text of LDmicro's fork; only those of LDmicro 2.2 are read"
        } else {
            "a line of the diagram begins with the left rail, in its fourth column"
        });
    }
    let width = chars.len().saturating_sub(LEFT + 2);
    if !width.is_multiple_of(CELL) || !is_rail(LEFT + width) || width == 0 {
        return wrong("between the rails are cells of 17 columns, at most 256 of them");
    }
    let before: String = chars[..RAIL].iter().collect();
    Ok(Drawn {
        number,
        begins: before.trim().parse::<u32>().is_ok(),
        inside: chars[LEFT..LEFT + width].to_vec(),
    })
}

fn rungs(drawing: &[Drawn]) -> Result<Vec<Rung>, ReadError> {
    let Some(first) = drawing.first() else {
        return Err(ReadError::whole("there is no diagram after `LADDER DIAGRAM:`"));
    };
    if let Some(other) = drawing
        .iter()
        .find(|line| line.inside.len() != first.inside.len())
    {
        let message = "this line is not as wide as those above it";
        return Err(ReadError::at(LineColumn::line(other.number), message));
    }
    let end = drawing.iter().rposition(|line| {
        let text: String = line.inside.iter().collect();
        text.trim_matches('-') == "[END]"
    });
    let Some(end) = end else {
        return Err(ReadError::whole("there is no `[END]` in the diagram"));
    };
    let starts: Vec<usize> = (1..end)
        .filter(|line| drawing[*line].begins)
        .map(|line| line - 1)
        .collect();
    let mut rungs = Vec::new();
    for (index, start) in starts.iter().enumerate() {
        let after = starts.get(index + 1).copied().unwrap_or(end);
        rungs.push(rung(&drawing[*start..after])?);
    }
    Ok(rungs)
}

/// A rung, from the line with its first name on.
fn rung(lines: &[Drawn]) -> Result<Rung, ReadError> {
    let line = lines.get(1).map_or(1, |line| line.number);
    if let Some(comment) = comment(lines) {
        let text = format!("COMMENT {comment}");
        return Ok(Rung {
            line,
            parts: vec![Node::Leaf(Leaf { line, text })],
        });
    }
    let mut reader = Reader {
        lines,
        leaves: Vec::new(),
        wires: Wires::new((lines.len() / CELL_LINES + 1) * (lines[0].inside.len() / CELL + 1)),
    };
    for branch in 0..lines.len() / CELL_LINES {
        reader.branch(branch)?;
    }
    if reader.leaves.is_empty() {
        return Ok(Rung {
            line,
            parts: Vec::new(),
        });
    }
    let circuit = reader.wires.into_circuit();
    let whole = circuit.filter(|circuit| depth(circuit) <= DEEPEST);
    let Some(circuit) = whole else {
        let message = "the rung is not made of series and branches, or branches are nested too deep";
        return Err(ReadError::at(LineColumn::line(line), message));
    };
    Ok(Rung {
        line,
        parts: parts(circuit, &reader.leaves),
    })
}

/// The text of a rung that is only a comment, as a program file has it.
fn comment(lines: &[Drawn]) -> Option<String> {
    let told = |index: usize| {
        let text: String = lines.get(index)?.inside.iter().collect();
        let text = text.strip_prefix(" ; ")?.trim_end().replace('\\', "\\\\");
        Some(text)
    };
    let first = told(0)?;
    Some(match told(1) {
        Some(second) => format!("{first}\\r\\n{second}"),
        None => first,
    })
}

fn depth(circuit: &Circuit<usize>) -> usize {
    match circuit {
        Circuit::Element(_) => 0,
        Circuit::Series(parts) | Circuit::Parallel(parts) => 1 + parts.iter().map(depth).max().unwrap_or(0),
    }
}

/// What is in series.
fn parts(circuit: Circuit<usize>, leaves: &[Leaf]) -> Vec<Node> {
    match circuit {
        Circuit::Element(leaf) => vec![Node::Leaf(leaves[leaf].clone())],
        Circuit::Series(inside) => inside.into_iter().flat_map(|part| parts(part, leaves)).collect(),
        Circuit::Parallel(branches) => {
            let branch = |branch| {
                let mut parts = parts(branch, leaves);
                match (parts.pop(), parts.is_empty()) {
                    (Some(leaf @ Node::Leaf(_)), true) => leaf,
                    (last, _) => {
                        parts.extend(last);
                        Node::Series(parts)
                    }
                }
            };
            vec![Node::Parallel(branches.into_iter().map(branch).collect())]
        }
    }
}

struct Reader<'l> {
    lines: &'l [Drawn],
    leaves: Vec<Leaf>,
    wires: Wires,
}

impl Reader<'_> {
    /// The point at the end of a cell, before which vertical wires are.
    fn point(&self, branch: usize, cell: usize) -> usize {
        Wires::point(branch * (self.lines[0].inside.len() / CELL + 1) + cell)
    }

    /// Reads the wire of a branch, and what joins it to the branch below.
    fn branch(&mut self, branch: usize) -> Result<(), ReadError> {
        let lines = self.lines;
        let line = branch * CELL_LINES;
        let (above, wire) = (&lines[line].inside, &lines[line + 1].inside);
        let number = lines[line + 1].number;
        let wrong = |column: usize, message: String| {
            let place = LineColumn {
                line: number,
                column: (LEFT + column) as u32 + 1,
            };
            ReadError::at(place, message)
        };
        // Where the wire comes from, and its elements since.
        let mut from = (wire[0] != ' ').then_some((Wires::SOURCE, Vec::new()));
        let mut column = 0;
        while column < wire.len() {
            let at_border = column % CELL == CELL - 1;
            match wire[column] {
                ' ' => {
                    if let Some((from, elements)) = from.take() {
                        self.wires.add(from, Wires::SINK, elements);
                    }
                }
                '-' if from.is_some() => {}
                '|' if at_border && from.is_none() => {}
                '+' if at_border => {
                    let here = self.point(branch, column / CELL);
                    if let Some((from, elements)) = from.take() {
                        self.wires.add(from, here, elements);
                    }
                    if wire.get(column + 1).is_some_and(|next| *next != ' ') {
                        from = Some((here, Vec::new()));
                    }
                }
                _ => {
                    let found = row::element(above, wire, column).map_err(|why| wrong(column, why))?;
                    let Some((_, elements)) = &mut from else {
                        return Err(wrong(column, "no wire leads here".to_owned()));
                    };
                    if found.text != TOO_LONG {
                        element::check(&found.text).map_err(|why| wrong(column, why))?;
                    }
                    if self.leaves.len() == MOST_IN_RUNG {
                        let message = format!("the rung has more than {MOST_IN_RUNG} elements");
                        return Err(wrong(column, message));
                    }
                    elements.push(self.leaves.len());
                    self.leaves.push(Leaf {
                        line: number,
                        text: found.text,
                    });
                    column += found.length;
                    continue;
                }
            }
            column += 1;
        }
        if let Some((from, elements)) = from {
            self.wires.add(from, Wires::SINK, elements);
        }
        for cell in 0..wire.len() / CELL {
            let column = cell * CELL + CELL - 1;
            let below = (line + 2..=line + 3).map(|line| lines.get(line).map(|line| line.inside[column]));
            if below.into_iter().all(|c| c == Some('|')) {
                let (here, there) = (self.point(branch, cell), self.point(branch + 1, cell));
                self.wires.join(here, there);
            }
        }
        Ok(())
    }
}
