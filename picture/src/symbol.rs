//! Which symbol a block is drawn as, and how much room it takes.
//!
//! Contacts, coils, timers and counters are as IEC 61131-3 draws them: the tag above, the inputs in a box. A
//! comparison of two values is a contact with the comparison in it, which keeps a rung on one line.

use super::measure::{columns, shortened};
use super::style::{HALF, LINE, UNIT};
use super::{Options, Values, comment};
use ladder_analysis::context::Context;
use ladder_analysis::networks::BlockAt;
use ladder_analysis::networks::network::{Formal, Meaning};
use ladder_analysis::written::facts::{NodeKind, OperandFacts};
use ladder_instructions::{Direction, Group, Instruction, Op, Shape};
use ladder_syntax::TextRange;
use std::borrow::Cow;

/// A text and the value that it has while a program runs.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct Label {
    pub(super) text: String,
    pub(super) value: Option<String>,
    /// Which operand of its block it is.
    pub(super) operand: usize,
    /// There is room for the value that a user will write there.
    pub(super) room: bool,
}

/// The columns that a value has at the least where there is room for one.
const VALUE_COLUMNS: u32 = 9;
/// The height of a line of values in a live drawing.
pub(super) const VALUE: i32 = 14;

impl Label {
    fn width(&self) -> u32 {
        let value = self.value.as_deref().map_or(0, |value| columns(value) + 1);
        let room = if self.room { VALUE_COLUMNS } else { 0 };
        (columns(&self.text) + value).max(room)
    }

    /// What it takes next to its own line.
    pub(super) fn height(&self) -> i32 {
        if self.text.is_empty() {
            return 0;
        }
        LINE + if self.room { VALUE + 2 } else { 0 }
    }
}

/// A block as it is drawn.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Symbol {
    /// Two bars with a mark between them.
    Contact { mark: Mark, over: Label, under: Label },
    /// Two arcs with a mark between them.
    Coil { mark: Mark, over: Label },
    /// A box with its name, the pins that the wire goes through, and a row for each further operand.
    Box {
        over: Label,
        name: String,
        pins: Option<(&'static str, &'static str)>,
        rows: Vec<(String, Label)>,
        /// The columns that the names of the rows take.
        names: u32,
    },
    /// `>>name`: power that goes on at a label.
    Jump(String),
    /// A word in a box with pointed ends: `CALL pumps`, `RETURN`.
    Flow(String),
    /// A name that a jump or call comes to.
    Target(String),
}

/// What is between the bars of a contact or the arcs of a coil.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Mark {
    Nothing,
    /// The stroke of a negated contact or coil.
    Stroke,
    Word(String),
}

impl Mark {
    /// Columns between the bars.
    pub(super) fn width(&self) -> u32 {
        match self {
            Mark::Nothing | Mark::Stroke => 2,
            Mark::Word(word) => (columns(word) + 1).max(2),
        }
    }
}

/// The room that something takes: columns, and pixels over and under the wire.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Room {
    pub(super) columns: u32,
    pub(super) over: i32,
    pub(super) under: i32,
}

/// The rows of a box begin so far under the wire.
pub(super) const ROWS: i32 = 12;
/// The top of a box over the wire: room for its name.
pub(super) const NAME: i32 = LINE + 12;

impl Symbol {
    pub(super) fn room(&self) -> Room {
        match self {
            Symbol::Contact { mark, over, under } => Room {
                columns: (mark.width() + 3).max(over.width()).max(under.width()),
                over: HALF + over.height(),
                under: HALF + under.height(),
            },
            Symbol::Coil { mark, over } => Room {
                columns: (mark.width() + 3).max(over.width()),
                over: HALF + over.height(),
                under: HALF,
            },
            Symbol::Box {
                over,
                name,
                pins,
                rows,
                names,
            } => {
                let pins = pins.map_or(0, |(left, right)| left.len() + right.len() + 2) as u32;
                let widest = rows
                    .iter()
                    .map(|(name, label)| names + label.width() + u32::from(!name.is_empty()))
                    .max()
                    .unwrap_or(0);
                Room {
                    columns: (columns(name).max(pins).max(widest) + 2).max(over.width()),
                    over: NAME + over.height(),
                    under: ROWS
                        + rows
                            .iter()
                            .map(|(_, label)| label.height().max(LINE))
                            .sum::<i32>()
                        + if rows.is_empty() { 0 } else { 4 },
                }
            }
            Symbol::Jump(name) => Room {
                columns: columns(name) + 3,
                over: HALF,
                under: HALF,
            },
            Symbol::Flow(word) => Room {
                columns: columns(word) + 4,
                over: HALF + 2,
                under: HALF + 2,
            },
            Symbol::Target(name) => Room {
                columns: columns(name) + 3,
                over: HALF + 2,
                under: HALF + 2,
            },
        }
    }
}

/// What a text takes, in pixels.
pub(super) fn width(text: &str) -> i32 {
    columns(text) as i32 * UNIT
}

/// What a block's texts are made of.
#[derive(Clone, Copy)]
pub(super) struct Words<'c> {
    pub(super) context: &'c Context,
    pub(super) value: Option<&'c Values<'c>>,
    /// There is room for values that a user will write.
    pub(super) room: bool,
}

impl<'c> Words<'c> {
    pub(super) fn of(context: &'c Context, options: &Options<'c>) -> Words<'c> {
        Words {
            context,
            value: options.value,
            room: options.live,
        }
    }

    /// A place's text.
    pub(super) fn text_of(&self, range: TextRange) -> Cow<'c, str> {
        self.context.parse.text_in(range)
    }

    /// The lines of the comments on a line that is not a rung, but for directives to the tools.
    pub(super) fn comments_of(&self, line: usize) -> Vec<String> {
        let text = self.text_of(self.context.parse.line_range(line));
        // A comment reaches to the very next `#`, so every second piece is one.
        let comments = text.split('#').skip(1).step_by(2);
        comments
            .filter(|comment| !comment.trim_start().starts_with("ladder:"))
            .flat_map(comment::lines)
            .map(str::to_owned)
            .collect()
    }

    fn operand(&self, bound: BlockAt<'_>, operand: &OperandFacts) -> String {
        let text = self.text_of(bound.absolute(operand.value.range));
        shortened(text.split_whitespace().collect::<Vec<_>>().join(" "))
    }

    /// An operand with its value, if it has one.
    fn label(&self, bound: BlockAt<'_>, index: usize) -> Label {
        let Some(operand) = bound.facts.operands.get(index) else {
            return Label::default();
        };
        let text = self.operand(bound, operand);
        let value = self.value.and_then(|value| value(&text));
        let value = value.map(|value| shortened(format!("= {value}")));
        Label {
            text,
            value,
            operand: index,
            room: self.room && has_value(operand) && !is_drawn(bound),
        }
    }

    /// The name of a label or function.
    fn target(&self, bound: BlockAt<'_>) -> String {
        let operand = bound.facts.operands.first();
        operand.map_or_else(String::new, |operand| self.operand(bound, operand))
    }

    /// The symbol of a block of a scope: 0 the file's, else that of the body of a user-defined block. The tags of a
    /// body have as many values as the block has places, so none is shown there.
    pub(super) fn symbol(&self, bound: BlockAt<'_>, scope: usize) -> Symbol {
        let words = Words {
            value: self.value.filter(|_| scope == 0),
            room: self.room && scope == 0,
            ..*self
        };
        words.symbol_of(bound)
    }

    fn symbol_of(&self, bound: BlockAt<'_>) -> Symbol {
        match bound.meaning {
            Meaning::Instruction(row) => self.instruction(bound, row),
            Meaning::User(_) | Meaning::UnknownUser | Meaning::Unknown => {
                let pins = match bound.facts.shape {
                    Shape::Logical | Shape::Coil => Some(("EN", "ENO")),
                    Shape::Function => None,
                };
                self.box_of(bound, bound.facts.head.text(), pins, 0)
            }
        }
    }

    fn instruction(&self, bound: BlockAt<'_>, row: &Instruction) -> Symbol {
        let operands = bound.facts.operands.len();
        let contact = |mark| Symbol::Contact {
            mark,
            over: self.label(bound, 0),
            under: Label::default(),
        };
        let coil = |mark| Symbol::Coil {
            mark,
            over: self.label(bound, 0),
        };
        let word = |word: &str| Mark::Word(word.to_owned());
        match row.op {
            Op::Contact => contact(Mark::Nothing),
            Op::NegatedContact => contact(Mark::Stroke),
            Op::RisingContact
            | Op::FallingContact
            | Op::Inverter
            | Op::OneShotRising
            | Op::OneShotFalling => contact(word(row.mnemonic)),
            Op::Eq | Op::Ne | Op::Gt | Op::Ge | Op::Lt | Op::Le if operands == 2 => Symbol::Contact {
                mark: word(sign(row.op)),
                over: self.label(bound, 0),
                under: self.label(bound, 1),
            },
            Op::Coil => coil(Mark::Nothing),
            Op::NegatedCoil => coil(Mark::Stroke),
            _ if row.group == Group::Coil => coil(word(row.mnemonic)),
            Op::Jmp => Symbol::Jump(self.target(bound)),
            Op::Lbl => Symbol::Target(format!("{}:", self.target(bound))),
            Op::Ret => Symbol::Flow("RETURN".to_owned()),
            _ if row.group == Group::Flow => {
                let mut words = format!("{} {}", row.mnemonic, self.target(bound));
                // What a loop says of itself: the tag that has the number of the turn.
                for (operand, formal) in bound.facts.operands.iter().zip(&bound.formals).skip(1) {
                    if let Formal::Operand(formal) = formal {
                        words.push_str(&format!(", {} => {}", formal.name, self.operand(bound, operand)));
                    }
                }
                Symbol::Flow(words.trim_end().to_owned())
            }
            _ if row.group == Group::State => {
                let (left, right) = pins_of(row.op);
                self.box_of(bound, row.mnemonic, Some((left, right)), 1)
            }
            _ if row.group == Group::Condition => self.box_of(bound, row.mnemonic, Some(("", "")), 0),
            _ => self.box_of(bound, row.mnemonic, Some(("EN", "ENO")), 0),
        }
    }

    /// A box; its first `over` operands are above it.
    fn box_of(
        &self,
        bound: BlockAt<'_>,
        name: &str,
        pins: Option<(&'static str, &'static str)>,
        over: usize,
    ) -> Symbol {
        let rows: Vec<_> = (over..bound.facts.operands.len())
            .map(|index| (self.row_name(bound, index), self.label(bound, index)))
            .collect();
        let names = rows.iter().map(|(name, _)| columns(name)).max();
        Symbol::Box {
            over: if over > 0 {
                self.label(bound, 0)
            } else {
                Label::default()
            },
            name: shortened(name.to_owned()),
            pins,
            rows,
            names: names.unwrap_or(0),
        }
    }

    /// What an operand is called inside the box. Results have an arrow.
    fn row_name(&self, bound: BlockAt<'_>, index: usize) -> String {
        match bound.formals.get(index) {
            Some(Formal::Operand(operand)) => match operand.direction {
                Direction::In | Direction::InOut => operand.name.to_owned(),
                Direction::Out => format!("{} ←", operand.name),
            },
            Some(Formal::Parameter(parameter)) => {
                let Meaning::User(block) = bound.meaning else {
                    return String::new();
                };
                shortened(
                    self.context.user_blocks[block].parameters[*parameter]
                        .name
                        .clone(),
                )
            }
            _ => String::new(),
        }
    }
}

/// Whether an operand can have another value than it says itself.
fn has_value(operand: &OperandFacts) -> bool {
    !matches!(operand.value.kind, NodeKind::Literal(_) | NodeKind::Missing)
}

/// Whether the drawing of a block shows the value of its operand: a contact that is closed, a coil that has power.
fn is_drawn(bound: BlockAt<'_>) -> bool {
    let row = bound.instruction();
    row.is_some_and(|row| {
        matches!(
            row.op,
            Op::Contact | Op::NegatedContact | Op::Coil | Op::NegatedCoil
        )
    })
}

fn sign(op: Op) -> &'static str {
    match op {
        Op::Eq => "=",
        Op::Ne => "≠",
        Op::Gt => ">",
        Op::Ge => "≥",
        Op::Lt => "<",
        _ => "≤",
    }
}

/// The pins of a box that the wire goes through, as IEC 61131-3 names them.
fn pins_of(op: Op) -> (&'static str, &'static str) {
    match op {
        Op::Ctu | Op::Ctc => ("CU", "Q"),
        Op::Ctd => ("CD", "Q"),
        Op::Ctud => ("CU", "QU"),
        Op::Sr => ("S1", "Q1"),
        Op::Rs => ("S", "Q1"),
        _ => ("IN", "Q"),
    }
}
