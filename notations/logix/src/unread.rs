//! What is not read: instructions, routines, and programs that run at other times than the scan. Each is an unread part.

use crate::blocks::Blocks;
use crate::mnemonic::{Op, instruction, is_written};
use crate::model::{Family, Foreign, Language, Protected};
use crate::operand::{Expr, Path, Step};
use crate::plan::Later;
use crate::sketch::{Sketcher, alone, network};
use crate::translate::Translator;
use crate::unit::{Owner, Unit, operand};
use ladder_drawings::neutral::{Instruction, instructions};
use ladder_format::program::{Block, Item};
use ladder_notation::{Power, Turn, Unread};
use std::collections::{BTreeSet, HashSet};

/// What an instruction without a counterpart writes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Writes {
    /// No tag.
    Nothing,
    /// This operand.
    Only(usize),
    /// Each tag among its operands.
    Operands,
    /// Nobody knows: it acts on what is not among them.
    Anything,
}

/// What instructions without a counterpart write.
fn writes_of(name: &str) -> Writes {
    match name.to_ascii_uppercase().as_str() {
        "SSV" | "IOT" | "UID" | "UIE" | "EVENT" | "REF" | "IOM" => Writes::Nothing,
        "GSV" => Writes::Only(3),
        "RTOS" | "UPPER" | "LOWER" => Writes::Only(1),
        "DTR" => Writes::Only(2),
        "ISNAN" | "ISINF" => Writes::Nothing,
        // Charts and phases, other routines, what a communication brings.
        "SFR" | "SFP" | "PSC" | "PFL" | "PCMD" | "PCLF" | "PXRQ" | "POVR" | "PATT" | "PDET" | "PRNP"
        | "PPD" | "JXR" | "SVC" | "SUS" => Writes::Anything,
        _ => Writes::Operands,
    }
}

/// The instructions without a counterpart that decide about the power of their rung.
const CONDITIONS: [&str; 3] = ["DTR", "IsNAN", "IsINF"];

/// What is reported about a routine that is unread for one of its instructions.
pub(crate) const LEFT: &str = "in it is not read";

/// An instruction that is not read, as it is on a rung.
pub(crate) struct Unreadable {
    pub(crate) block: Block,
    /// What there is to say of it.
    pub(crate) why: String,
    /// Its routine may not go on after it, or goes on elsewhere.
    pub(crate) may_leave: bool,
}

impl<'p> Translator<'p> {
    /// The block in the place of an instruction that is not read.
    pub(crate) fn unread(&mut self, it: &Instruction<'_>, why: &str) -> Unreadable {
        let op = instruction(it.name, it.operands.len());
        let is_condition = match op {
            Some(op) => op.is_condition(it.operands.len()),
            None => CONDITIONS.iter().any(|own| it.name.eq_ignore_ascii_case(own)),
        };
        let (power, says) = if is_condition {
            (Power::Ends, "no power passes")
        } else {
            (Power::Passes, "power passes")
        };
        let writes = match op {
            // What the routine does.
            Some(Op::Jsr) => self.writes_of_routine(it),
            Some(Op::For) => None,
            _ => self.writes(self.scope(), it),
        };
        let mut text = match self.project.family {
            Family::Logix => {
                let inside = it.text.split_once('(').map_or("", |(_, inside)| inside);
                inside.strip_suffix(')').unwrap_or(inside).trim().to_owned()
            }
            Family::Slc => it.operands.join(","),
        };
        if let Some(protected) = self.protected(it.name) {
            text = format!("{text}\n{}", protected.text);
        }
        // Blocks of such a name mean something else.
        let name = if Blocks::has(it.name) || op == Some(Op::Pid) {
            format!("unread {}", it.name)
        } else {
            it.name.to_owned()
        };
        let part = Unread {
            name: &name,
            about: &format!("{}: {why}; it is not run here, and {says}.", it.name),
            text: &text,
            writes: writes.as_deref(),
            power,
            turn: Turn::Here,
        };
        let names = &self.aoi_names;
        let is_taken = |name: &str| names.iter().any(|own| own.eq_ignore_ascii_case(name));
        Unreadable {
            block: self.unread.block(part, is_taken),
            why: format!("{why}: it is not run, and {says}"),
            may_leave: op.is_some_and(Op::may_leave) || it.name == "SUS",
        }
    }

    /// The Add-On Instruction of this name whose source is protected.
    pub(crate) fn protected(&self, name: &str) -> Option<&'p Protected> {
        let mut all = self.project.protected.iter();
        all.find(|protected| protected.name.eq_ignore_ascii_case(name))
    }

    /// The tags that an instruction may write. None: it is not known.
    fn writes(&mut self, scope: usize, it: &Instruction<'_>) -> Option<Vec<String>> {
        let count = it.operands.len();
        let op = instruction(it.name, count);
        let others = match self.aoi(it.name) {
            Some(_) => Writes::Operands,
            None => writes_of(it.name),
        };
        let is_written = |index: usize| match (op, others) {
            // What it hands over is written by the routine.
            (Some(Op::Jsr | Op::Sbr), _) => true,
            (Some(_), _) => is_written(it.name, count, index),
            (None, Writes::Only(only)) => only == index,
            (None, writes) => writes == Writes::Operands,
        };
        if op.is_none() && others == Writes::Anything {
            return None;
        }
        let operands = it.operands.iter().copied().enumerate();
        let written = operands.filter(|(index, _)| is_written(*index));
        let mut texts: Vec<&str> = written.map(|(_, text)| text).collect();
        if it.name.eq_ignore_ascii_case("MSG") {
            let message = it.operands.first()?.to_ascii_uppercase();
            let fetched = self.project.messages.get(&message)?;
            texts.extend(fetched.iter().map(String::as_str));
        }
        let mut names = BTreeSet::new();
        for text in texts {
            let mut paths = Vec::new();
            match operand(self.project.family, text) {
                Ok(expr) => paths_of(&expr, &mut paths),
                Err(_) if text.contains(|c: char| c.is_alphabetic()) => return None,
                Err(_) => {}
            }
            for path in paths {
                names.extend(self.tags.written(scope, &path)?);
            }
        }
        Some(names.into_iter().collect())
    }

    /// What a routine may write that is unread: each tag that its text names, unless it acts on what it does not name.
    fn writes_of_text(&mut self, scope: usize, text: &str) -> Option<Vec<String>> {
        if text.contains('\\') {
            return None;
        }
        let is_in_word = |c: char| c.is_alphanumeric() || matches!(c, '_' | ':');
        let words: HashSet<&str> = text.split(|c| !is_in_word(c)).collect();
        let calls = |word: &&str| {
            let word = word.to_ascii_uppercase();
            matches!(word.as_str(), "JSR" | "MSG") || writes_of(&word) == Writes::Anything
        };
        if words.iter().any(calls) {
            return None;
        }
        let mut names = BTreeSet::new();
        // `Local:1:O` is a module, `X:y` in a CASE two words.
        for root in words.into_iter().flat_map(|word| word.split(':').chain([word])) {
            names.extend(self.tags.written(scope, &Path::tag(root))?);
        }
        Some(names.into_iter().collect())
    }

    /// What a call of a routine may write that is not read.
    fn writes_of_routine(&mut self, it: &Instruction<'_>) -> Option<Vec<String>> {
        let scope = self.scope();
        let program = self.project.programs.get(scope.checked_sub(1)?)?;
        let called = it.operands.first()?;
        let mut routines = program.routines.iter();
        let routine = routines.find(|routine| routine.name.eq_ignore_ascii_case(called))?;
        let foreign = routine.foreign.as_ref()?;
        if foreign.language == Language::Protected {
            return None;
        }
        let inside = self.writes_of_text(scope, &foreign.text)?;
        let names: BTreeSet<String> = inside.into_iter().chain(self.writes(scope, it)?).collect();
        Some(names.into_iter().collect())
    }

    /// What the routines of a program may write.
    fn writes_of_all<'u>(&mut self, units: impl Iterator<Item = &'u Unit<'u>>) -> Option<Vec<String>> {
        let mut names = BTreeSet::new();
        for unit in units {
            if unit.routine.foreign.is_some() {
                return None;
            }
            for parts in unit.rungs.iter().filter_map(|rung| rung.as_ref().ok()) {
                let mut all = Vec::new();
                instructions(parts, &mut |it| all.push(it));
                for it in all {
                    names.extend(self.writes(unit.scope, it)?);
                }
            }
        }
        Some(names.into_iter().collect())
    }
}

/// The tags in an operand, but those in indices.
fn paths_of(expr: &Expr, out: &mut Vec<Path>) {
    match expr {
        Expr::Path(path) => {
            let own = |step: &&Step| matches!(step, Step::Member(_));
            out.push(Path {
                root: path.root.clone(),
                steps: path.steps.iter().take_while(own).cloned().collect(),
            });
        }
        _ => expr.parts().for_each(|part| paths_of(part, out)),
    }
}

impl Sketcher<'_> {
    /// What there is to say of Add-On Instructions whose source is protected.
    pub(crate) fn protected(&mut self) {
        for protected in &self.translator.project.protected {
            let place = self.place(protected.at);
            let what = format!("Add-On Instruction {}", protected.name);
            let why = format!("{}: its calls are not run", Language::Protected.is());
            self.reading.report.approximated(place, what, why);
        }
    }

    /// A routine in another language: a block with its text.
    pub(crate) fn foreign(&mut self, number: usize, foreign: &Foreign) -> Vec<Item> {
        if foreign.language == Language::StructuredText {
            return match self.structured(number, &foreign.text) {
                Ok(items) => items,
                Err(why) => {
                    let why = format!("{}, and not read: {why}", foreign.language.is());
                    self.unread_routine(number, &why, &foreign.text)
                }
            };
        }
        self.unread_routine(number, foreign.language.is(), &foreign.text)
    }

    /// A routine that is unread as a whole.
    pub(crate) fn unread_routine(&mut self, number: usize, why: &str, text: &str) -> Vec<Item> {
        let unit = &self.units[number];
        let writes = match &unit.routine.foreign {
            Some(foreign) if foreign.language == Language::Protected => None,
            _ => self.translator.writes_of_text(unit.scope, text),
        };
        let left = self.translator.left_by(unit.scope, &unit.routine.name);
        let writes = writes.map(|writes| [writes, left].concat());
        let project = self.translator.project;
        let name = &unit.routine.name;
        let what = match unit.owner {
            Owner::Program(_) => format!("routine {name}"),
            Owner::Aoi(aoi) => format!("routine {name} of {}", project.aois[aoi].name),
        };
        let place = self.place(unit.routine.at);
        let report = &mut self.reading.report;
        report.approximated(place, what.as_str(), format!("{why}: it is not run"));
        let part = Unread {
            name: &format!("routine {name}"),
            about: &format!("{what}: {why}; it is not run here."),
            text,
            writes: writes.as_deref(),
            power: Power::Passes,
            turn: Turn::Here,
        };
        let block = self.unread_body(part);
        let origin = self.origin(unit.routine.at);
        vec![Item::Blank, network(Vec::new(), alone(block, Some(origin)))]
    }

    /// What is in the function of a program that runs at other times than the scan.
    pub(crate) fn later(&mut self, later: &Later) -> Vec<Item> {
        let units = self.units;
        let project = self.translator.project;
        let program = &project.programs[later.program];
        let own = |unit: &&Unit<'_>| unit.owner == Owner::Program(later.program);
        let writes = self.translator.writes_of_all(units.iter().filter(own));
        // Another program does other things, and so does one with other instructions.
        let in_aoi = |unit: &&Unit<'_>| matches!(unit.owner, Owner::Aoi(_));
        let texts = units.iter().filter(|unit| own(unit) || in_aoi(unit));
        let sum = checksum(texts.flat_map(|unit| unit.routine.rungs.iter().map(|rung| rung.text.as_str())));
        let task = &later.why;
        let why = if later.is_run {
            format!("{task}, whatever else runs; here it runs in each scan")
        } else {
            format!("{task}; it is not run here")
        };
        let place = self.place(program.at);
        let what = format!("program {}", program.name);
        self.reading
            .report
            .approximated(place, what.as_str(), why.as_str());
        let part = Unread {
            name: &what,
            about: &format!("{what}: {why}."),
            text: &format!("the checksum of its rungs is {sum:016x}"),
            writes: writes.as_deref(),
            power: Power::Passes,
            turn: Turn::AnyTime,
        };
        let block = self.unread_body(part);
        let origin = self.origin(program.at);
        vec![Item::Blank, network(Vec::new(), alone(block, Some(origin)))]
    }

    fn unread_body(&mut self, part: Unread<'_>) -> Block {
        let names = &self.translator.aoi_names;
        let is_taken = |name: &str| names.iter().any(|own| own.eq_ignore_ascii_case(name));
        self.translator.unread.body(part, is_taken)
    }
}

/// A number that is another one for other texts.
fn checksum<'t>(texts: impl Iterator<Item = &'t str>) -> u64 {
    let bytes = texts.flat_map(|text| text.bytes().chain([0]));
    bytes.fold(0xcbf2_9ce4_8422_2325, |sum, byte| {
        (sum ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}
