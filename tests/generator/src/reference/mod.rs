//! The order of evaluation, written down a second time.
//!
//! This is the language's definition of a network's evaluation as directly as it can be written: a recursive
//! `run(line, up to which /)`. It shares no code with the parser, the analysis or the simulator, which are
//! compared with it.

mod boolean;
mod reader;

pub use boolean::{Boolean, Contact};
pub use reader::{networks, rung};

/// A thing on a line of a network.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DrawnPart {
    /// A `+`. First on its line it is the left rail's.
    Rail,
    /// A piece of wire.
    Wire,
    /// A block, with its number.
    Block(usize),
    /// `\`
    Down,
    /// `/`
    Up,
    /// White space: a new segment begins after it.
    Gap,
}

/// Evaluates a network once. Each block gets its EN and returns its ENO; what is given back is the power of every
/// part, of a connector that of its point.
pub fn evaluate(network: &[Vec<DrawnPart>], block: &mut dyn FnMut(usize, bool) -> bool) -> Vec<Vec<bool>> {
    let mut run = Run {
        network,
        block,
        lines: network.iter().map(|_| Line::default()).collect(),
        power: network.iter().map(|line| vec![false; line.len()]).collect(),
    };
    for line in 0..network.len() {
        run.run(line, None);
    }
    run.power
}

/// How far a line has come.
#[derive(Default)]
struct Line {
    next: usize,
    power: bool,
    ups: usize,
    downs: usize,
}

struct Run<'n> {
    network: &'n [Vec<DrawnPart>],
    block: &'n mut dyn FnMut(usize, bool) -> bool,
    lines: Vec<Line>,
    power: Vec<Vec<bool>>,
}

impl Run<'_> {
    /// Evaluates a line from where it is, up to but not including its k-th `/`, else to its end.
    fn run(&mut self, line: usize, up_to: Option<usize>) {
        while let Some(&part) = self.network[line].get(self.lines[line].next) {
            if part == DrawnPart::Up && Some(self.lines[line].ups) == up_to {
                return;
            }
            let at = self.lines[line].next;
            match part {
                DrawnPart::Rail if at == 0 => self.lines[line].power = true,
                DrawnPart::Rail | DrawnPart::Wire => {}
                DrawnPart::Gap => self.lines[line].power = false,
                DrawnPart::Block(number) => {
                    let enabled = self.lines[line].power;
                    self.lines[line].power = (self.block)(number, enabled);
                }
                // Reached by itself, its point was made before.
                DrawnPart::Up => unreachable!("the line above comes first"),
                DrawnPart::Down => {
                    self.join(line);
                    continue;
                }
            }
            self.power[line][at] = self.lines[line].power;
            self.lines[line].next += 1;
        }
    }

    /// At a `\`: the line below is brought to its partner, and both go on with the power of the point.
    fn join(&mut self, upper: usize) {
        let lower = upper + 1;
        let number = self.lines[upper].downs;
        self.run(lower, Some(number));
        let point = self.lines[upper].power || self.lines[lower].power;
        for line in [upper, lower] {
            let at = self.lines[line].next;
            self.power[line][at] = point;
            self.lines[line].power = point;
            self.lines[line].next += 1;
        }
        self.lines[upper].downs += 1;
        self.lines[lower].ups += 1;
    }
}
