//! From a program of the model to its grids.

use super::super::dsl::spell;
use super::super::model::{Action, Condition, Instruction, Program, Routine, Rung, Timer, TimerKind};
use super::super::nicknames;
use super::addresses::Addresses;
use super::cell::{Cell, Grid, GridRung, Row, Text};
use super::draw::{self, Drawn, Undrawable};
use super::file::{self, MOST_ROWS};
use super::output::{self, Written};
use super::read::SUBROUTINES;
use super::rungs::{CONTINUES, KEPT};
use ladder_notation::{Companion, LineColumn, Report};

/// The grids of a program: that of its main program, and next to it its subroutines and its nicknames. A program that is
/// only a subroutine is its grid.
pub(in super::super) fn write(program: &Program, report: &mut Report) -> (String, Vec<Companion>) {
    let addresses = Addresses::of(program, report);
    let mut grids = |routine: &Routine| file::write(&grid(routine, &addresses, report));
    let only = match &program.subroutines[..] {
        [only] if program.has_no_main() => Some(only),
        _ => None,
    };
    let text = grids(only.unwrap_or(&program.main));
    let subroutines = program.subroutines.iter().filter(|_| only.is_none());
    let mut companions: Vec<Companion> = subroutines
        .map(|routine| Companion {
            name: format!("{SUBROUTINES}/{}.csv", routine.name),
            bytes: grids(routine).into(),
        })
        .collect();
    let mut nicknames = program.nicknames.clone();
    nicknames.extend(addresses.into_given());
    companions.extend(nicknames::companion(&nicknames));
    (text, companions)
}

/// The grid of a routine. What it cannot say is a comment.
fn grid(routine: &Routine, addresses: &Addresses, report: &mut Report) -> Grid {
    let mut writer = Writer {
        grid: Grid::default(),
        addresses,
        report,
        kept: Vec::new(),
    };
    writer.comments(&routine.comments);
    for rung in &routine.rungs {
        let continues = writer.comments(&rung.comments);
        writer.rung(rung, continues);
    }
    writer.comments(&routine.after);
    writer.keep();
    writer.finish()
}

struct Writer<'r> {
    grid: Grid,
    addresses: &'r Addresses,
    report: &'r mut Report,
    /// The lines of a rung that was kept as comments, so far.
    kept: Vec<String>,
}

impl Writer<'_> {
    /// Comments above the next rung. Among them are rungs that were kept as they are; comes back whether the next rung
    /// goes on with the one before it.
    fn comments(&mut self, comments: &[String]) -> bool {
        let mut continues = false;
        for comment in comments {
            if let Some(line) = comment.strip_prefix(KEPT) {
                if line.starts_with('R') {
                    self.keep();
                }
                self.kept.push(line.to_owned());
                continue;
            }
            self.keep();
            if comment == CONTINUES {
                continues = true;
            } else {
                self.grid.end.push(text(comment));
            }
        }
        self.keep();
        continues && self.grid.end.is_empty() && !self.grid.rungs.is_empty()
    }

    /// Puts a kept rung back, where its lines still are a rung.
    fn keep(&mut self) {
        if self.kept.is_empty() {
            return;
        }
        let lines = std::mem::take(&mut self.kept);
        match file::read_kept(&lines) {
            Some(rows) => {
                let comments = std::mem::take(&mut self.grid.end);
                self.grid.rungs.push(GridRung { comments, rows });
            }
            None => self
                .grid
                .end
                .extend(lines.iter().map(|line| text(&format!("{KEPT}{line}")))),
        }
    }

    fn rung(&mut self, rung: &Rung, mut continues: bool) {
        // The pins of an output are at the left rail, so nothing of its rung can follow them.
        let has_pins = |action: &Action| {
            output::write(&action.what, false, self.addresses).is_some_and(|written| !written.pins.is_empty())
        };
        let parts: Vec<&[Action]> = rung.actions.split_inclusive(has_pins).collect();
        for actions in parts {
            match drawn(&rung.condition, actions, self.addresses) {
                Ok(rows) => {
                    for action in actions {
                        self.tell(action);
                    }
                    self.add(rows, continues);
                }
                Err(why) => self.refuse(rung, actions, &why),
            }
            continues = true;
        }
    }

    /// Other readers want a rung below each comment: the last ones go above the last rung.
    fn finish(mut self) -> Grid {
        let end = std::mem::take(&mut self.grid.end);
        match self.grid.rungs.last_mut() {
            Some(last) => last.comments.extend(end),
            None if end.is_empty() => {}
            None => {
                let mut row = Row::empty();
                row.cells.fill(Cell::read("-", LineColumn::START));
                row.output = Some(text("NOP"));
                self.grid.rungs.push(GridRung {
                    comments: end,
                    rows: vec![row],
                });
            }
        }
        self.grid
    }

    fn tell(&mut self, action: &Action) {
        match &action.what {
            Instruction::Kept { text, why } => self.report.refused(action.place, text, why.clone()),
            Instruction::Timer(Timer {
                kind: TimerKind::RetentiveOff,
                ..
            }) => {
                let why = "Click itself has no retentive off-delay: it is an off-delay with a reset";
                self.report.approximated(action.place, spell::action(action), why);
            }
            _ => self.report.translated(action.place, spell::action(action)),
        }
    }

    fn add(&mut self, mut rows: Vec<Row>, continues: bool) {
        let comments = std::mem::take(&mut self.grid.end);
        match self.grid.rungs.last_mut() {
            Some(rung) if continues && comments.is_empty() && rung.rows.len() + rows.len() <= MOST_ROWS => {
                rung.rows.append(&mut rows);
            }
            _ => self.grid.rungs.push(GridRung { comments, rows }),
        }
    }

    fn refuse(&mut self, rung: &Rung, actions: &[Action], why: &str) {
        for action in actions {
            let name = spell::action(action);
            self.report.refused(action.place, name.as_str(), why);
            self.grid
                .end
                .push(text(&format!("click: not in the grid: {name}: {why}")));
        }
        if actions.is_empty() {
            self.report.refused(rung.place, "rung", why);
        }
    }
}

fn text(text: &str) -> Text {
    Text {
        text: text.to_owned(),
        place: LineColumn::START,
    }
}

fn drawn(condition: &Condition, actions: &[Action], addresses: &Addresses) -> Result<Vec<Row>, String> {
    let mut outputs = Vec::with_capacity(actions.len());
    for action in actions {
        let Written { output, pins } = output::write(&action.what, action.oneshot, addresses)
            .ok_or("the grid cannot say this instruction")?;
        outputs.push(Drawn {
            output,
            condition: &action.condition,
            pins,
        });
    }
    draw::rung(condition, &outputs, addresses).map_err(|why| match why {
        Undrawable::Wide => {
            "the rung is wider than the 31 columns of the grid: make several rungs of it".to_owned()
        }
        Undrawable::Tall => format!("the rung has more than {MOST_ROWS} rows: make several rungs of it"),
        Undrawable::Unsaid(what) => format!("the grid cannot say {what}"),
    })
}
