//! From the rungs of a grid to those of the model.

use super::super::model::{Action, Condition, Instruction, Rung};
use super::cell::{GridRung, Text};
use super::file;
use super::netlist::{Fed, Netlist};
use super::reduce::{Budget, Directions, NoCircuit, circuit};
use super::subcircuit::{Kind, Subcircuit};
use super::{action, contact};
use ladder_analysis::Severity;
use ladder_notation::{Finding, Report};

/// The comment above a rung of the model that a rung of the grid goes on with.
pub(in super::super) const CONTINUES: &str = "click: goes on in the same rung of the grid";

/// What a line of the grid begins with that is kept as a comment.
pub(super) const KEPT: &str = "click: grid ";

/// Contacts nest no deeper than this.
const MOST_DEPTH: usize = 32;

/// What is read of the rungs of a file. The report has only what the model does not show: pins, and what is not quite
/// what the grid says.
pub(super) struct Reader {
    pub(super) rungs: Vec<Rung>,
    pub(super) report: Report,
    pub(super) findings: Vec<Finding>,
    budget: Budget,
    /// The comments above the next rung.
    above: Vec<String>,
}

/// An output, and how power gets to it.
struct Powered<'r> {
    output: &'r Text,
    part: Subcircuit,
}

/// Why a rung is kept as it is.
struct Refusal<'r> {
    at: &'r Text,
    /// What Click itself would say.
    check: &'static str,
    why: String,
}

/// What is where the name of Click's check would, if it has none for it.
const KEPT_RUNG: &str = "click-grid";

impl<'r> Refusal<'r> {
    fn new(at: &'r Text, why: impl Into<String>) -> Refusal<'r> {
        Refusal {
            at,
            check: KEPT_RUNG,
            why: why.into(),
        }
    }

    /// There is no circuit to an output.
    fn unwired(at: &'r Text, why: NoCircuit) -> Refusal<'r> {
        let check = match why {
            NoCircuit::Unfed => "click-c0202",
            NoCircuit::ManyPaths | NoCircuit::Deep | NoCircuit::TooLarge => "click-c0005",
        };
        Refusal {
            at,
            check,
            why: reason(why),
        }
    }
}

impl Default for Reader {
    fn default() -> Reader {
        Reader {
            rungs: Vec::new(),
            report: Report::default(),
            findings: Vec::new(),
            budget: Budget::FILE,
            above: Vec::new(),
        }
    }
}

impl Reader {
    /// The comments after the last rung.
    pub(super) fn finish(&mut self, end: &[Text]) -> Vec<String> {
        let mut after = std::mem::take(&mut self.above);
        after.extend(end.iter().map(|comment| comment.text.clone()));
        after
    }

    /// Reads one rung of the grid, which may be several of the model.
    pub(super) fn rung(&mut self, rung: &GridRung) {
        self.above
            .extend(rung.comments.iter().map(|comment| comment.text.clone()));
        let entries = self.report.entries.len();
        if let Err(Refusal { at, check, why }) = self.wired(rung) {
            self.report.entries.truncate(entries);
            self.report.refused(at.place, at.text.as_str(), why.as_str());
            let shown: String = at.text.chars().take(60).collect();
            self.findings.push(Finding {
                place: at.place,
                severity: Severity::Error,
                check,
                message: format!("the rung stays as a comment, for `{shown}`: {why}"),
            });
            let kept = file::kept(&rung.rows)
                .into_iter()
                .map(|line| format!("{KEPT}{line}"));
            self.above.extend(kept);
        }
    }

    fn wired<'r>(&mut self, rung: &'r GridRung) -> Result<(), Refusal<'r>> {
        let netlist = Netlist::of(&rung.rows);
        let mut read = Vec::with_capacity(netlist.contacts.len());
        for wired in &netlist.contacts {
            let text = wired.contact;
            let cell = contact::read(&text.text, text.place).map_err(|why| Refusal::new(text, why))?;
            read.push(cell);
        }
        let mut directions = Directions::default();
        let mut powered: Vec<Powered<'r>> = Vec::with_capacity(netlist.outputs.len());
        let mut last: Option<(usize, Subcircuit)> = None;
        for Fed { output, net } in &netlist.outputs {
            let part = match &last {
                Some((same, part)) if same == net => part.clone(),
                _ => circuit(&netlist, *net, &mut self.budget)
                    .and_then(shallow)
                    .map_err(|why| Refusal::unwired(output, why))?,
            };
            self.budget
                .spend(part.contacts() * 8)
                .map_err(|why| Refusal::unwired(output, why))?;
            directions.note(&part);
            last = Some((*net, part.clone()));
            powered.push(Powered { output, part });
        }
        let conditions: Vec<Condition> = read.iter().map(|cell| cell.condition.clone()).collect();
        let rungs = grouped(powered, &conditions, &mut self.report)?;
        for (number, wired) in netlist.contacts.iter().enumerate() {
            let Text { text, place } = wired.contact;
            if !directions.pass(number) {
                let why =
                    "no output depends on it: what it lets through leads nowhere, or a wire leads round it";
                self.report.refused(*place, text.as_str(), why);
                self.findings.push(Finding {
                    place: *place,
                    severity: Severity::Error,
                    check: "click-c0202",
                    message: format!("a line is missing at `{text}`: {why}"),
                });
                self.above
                    .push(format!("click: without effect in the grid: {text}"));
                continue;
            }
            match (directions.both().contains(&number), read[number].remark) {
                (true, _) => {
                    let why =
                        "power goes through it both ways; the rung is written as the paths that this makes";
                    self.report.approximated(*place, text.as_str(), why);
                }
                (false, Some(why)) => self.report.approximated(*place, text.as_str(), why),
                (false, None) => {}
            }
        }
        let mut comments = std::mem::take(&mut self.above);
        for mut rung in rungs {
            rung.comments.splice(0..0, comments.drain(..));
            self.rungs.push(rung);
        }
        self.above = comments;
        Ok(())
    }
}

fn reason(why: NoCircuit) -> String {
    match why {
        NoCircuit::Unfed => "nothing joins it to the left rail".to_owned(),
        NoCircuit::ManyPaths => {
            "bridges on its way make too many paths: draw the rung as contacts in series and in parallel"
                .to_owned()
        }
        NoCircuit::Deep => {
            format!("branches on its way nest deeper than {MOST_DEPTH}: make several rungs of it")
        }
        NoCircuit::TooLarge => {
            "the rungs of this file are larger than what is read: make several files of it".to_owned()
        }
    }
}

/// A circuit that does not nest deeper than what is read.
fn shallow(part: Subcircuit) -> Result<Subcircuit, NoCircuit> {
    fn is_shallow(part: &Subcircuit, depth: usize) -> bool {
        match &part.kind {
            Kind::Contact { .. } => true,
            Kind::Series(parts) | Kind::Parallel(parts) => {
                depth > 0 && parts.iter().all(|part| is_shallow(part, depth - 1))
            }
        }
    }
    if is_shallow(&part, MOST_DEPTH) {
        Ok(part)
    } else {
        Err(NoCircuit::Deep)
    }
}

/// A rung of the model that is being made: what all of its outputs have in common, and each with its whole way.
struct Group<'r> {
    common: Vec<Subcircuit>,
    outputs: Vec<Acting<'r>>,
    has_pins: bool,
}

struct Acting<'r> {
    output: &'r Text,
    way: Vec<Subcircuit>,
    what: Instruction,
    oneshot: bool,
}

/// The outputs of a grid's rung as rungs of the model: those that follow each other and have a way in common are one.
/// An output with pins is the last of its rung, for its pins are at the left rail.
fn grouped<'r>(
    powered: Vec<Powered<'r>>,
    conditions: &[Condition],
    report: &mut Report,
) -> Result<Vec<Rung>, Refusal<'r>> {
    let mut groups: Vec<Group<'r>> = Vec::new();
    for Powered { output, part } in powered {
        let refusal = |why: String| Refusal::new(output, why);
        if output.text.starts_with('.') {
            let group = groups.last_mut();
            let Some((acting, has_pins)) =
                group.and_then(|group| Some((group.outputs.last_mut()?, &mut group.has_pins)))
            else {
                return Err(refusal("there is no output above this pin".to_owned()));
            };
            if let Instruction::Kept { why, .. } = &acting.what {
                return Err(Refusal::new(acting.output, why.as_str()));
            }
            action::pin(&mut acting.what, &output.text, condition(&part, conditions)).map_err(refusal)?;
            *has_pins = true;
            report.translated(output.place, output.text.as_str());
            continue;
        }
        let (what, oneshot) = match action::read(&output.text) {
            Ok(read) => (read.what, read.oneshot),
            Err(why) => {
                let text = output.text.clone();
                (Instruction::Kept { text, why }, false)
            }
        };
        let way = part.into_series();
        let acting = Acting {
            output,
            way,
            what,
            oneshot,
        };
        match groups
            .last_mut()
            .filter(|group| !group.has_pins)
            .and_then(|group| group.shared(&acting.way).map(|common| (group, common)))
        {
            Some((group, common)) => {
                group.common.truncate(common);
                group.outputs.push(acting);
            }
            None => groups.push(Group {
                common: acting.way.clone(),
                outputs: vec![acting],
                has_pins: false,
            }),
        }
    }
    let made = groups
        .into_iter()
        .enumerate()
        .map(|(number, group)| group.into_rung(number > 0, conditions));
    Ok(made.collect())
}

impl Group<'_> {
    /// How much of the common way a further output has too. None: it has a way of its own from the left rail.
    fn shared(&self, way: &[Subcircuit]) -> Option<usize> {
        let shared = self
            .common
            .iter()
            .zip(way)
            .take_while(|(one, other)| one == other)
            .count();
        (shared > 0 || self.common.is_empty()).then_some(shared)
    }

    fn into_rung(self, continues: bool, conditions: &[Condition]) -> Rung {
        let common = self.common.len();
        let actions = self.outputs.iter().map(|acting| Action {
            place: acting.output.place,
            condition: all(&acting.way[common..], conditions),
            what: acting.what.clone(),
            oneshot: acting.oneshot,
            comment: None,
        });
        Rung {
            place: self.outputs[0].output.place,
            comments: continues.then(|| CONTINUES.to_owned()).into_iter().collect(),
            condition: all(&self.common, conditions),
            actions: actions.collect(),
        }
    }
}

/// Parts of a circuit in series as a condition.
fn all(parts: &[Subcircuit], conditions: &[Condition]) -> Condition {
    match parts {
        [one] => condition(one, conditions),
        parts => Condition::All(parts.iter().map(|part| condition(part, conditions)).collect()),
    }
}

fn condition(part: &Subcircuit, conditions: &[Condition]) -> Condition {
    match &part.kind {
        Kind::Contact { contact, .. } => conditions[*contact].clone(),
        Kind::Series(parts) => all(parts, conditions),
        Kind::Parallel(parts) => {
            Condition::Any(parts.iter().map(|part| condition(part, conditions)).collect())
        }
    }
}
