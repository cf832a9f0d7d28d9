//! From the model to the sketch of a ladder program.

mod contacts;

use super::act::{self, Above};
use super::bank::{Bank, Writer};
use super::dsl::spell;
use super::model::{Action, CopyOptions, Instruction, Program, Routine, Rung};
use super::order::{self, Part};
use super::tags::Tags;
use super::uses::{Access, What, uses};
use ladder_format::Circuit;
use ladder_format::program::{Block, Drawing, Element, Item, Network};
use ladder_instructions::Op;
use ladder_notation::names::Names;
use ladder_notation::{LineColumn, Reading};
use std::collections::{HashMap, HashSet};

/// The whole program.
pub(super) fn sketch(program: &Program) -> Reading {
    let mut names = Names::default();
    for routine in program.routines() {
        names.spell(&routine.name);
    }
    let mut sketcher = Sketcher {
        tags: Tags::of(program),
        functions: names,
        blocks: HashMap::new(),
        items: Vec::new(),
        reading: Reading::default(),
        seen_first: 0,
    };
    sketcher.remarks(program);
    for routine in program.routines() {
        sketcher.routine(routine);
    }
    sketcher.finish(program)
}

struct Sketcher<'p> {
    tags: Tags<'p>,
    functions: Names,
    /// The timers and counters so far, and where: a tag belongs to one block.
    blocks: HashMap<String, LineColumn>,
    /// The networks: the declarations before them are known only when these are.
    items: Vec<Item>,
    reading: Reading,
    /// How many conditions were checked before their rung.
    seen_first: usize,
}

impl Sketcher<'_> {
    fn finish(mut self, program: &Program) -> Reading {
        let mut items: Vec<Item> = Vec::new();
        items.extend(program.main.comments.iter().cloned().map(Item::Comment));
        items.push(Item::Directive("profile click".to_owned()));
        let (read, written) = self.traffic(program);
        // A panel or another controller may read and write every address of Click.
        let others = "other devices reach the addresses of Click too";
        let is_inside = |bank: &Bank| !matches!(bank.row().writer, Writer::World | Writer::System(_));
        let mut allow =
            |rule: &str, why: &str| items.push(Item::Directive(format!("allow-file({rule}): {why}")));
        if read
            .iter()
            .any(|(name, bank)| is_inside(bank) && !written.contains_key(name))
        {
            allow("never-written", others);
        }
        // What is kept over a restart and what leaves the controller counts as read.
        let is_read = |bank: &Bank| matches!(bank, Bank::Y | Bank::Yd) || bank.row().retentive;
        if written
            .iter()
            .any(|(name, bank)| !is_read(bank) && !read.contains_key(name))
        {
            allow("never-read", others);
        }
        let mut main = program.main.rungs.iter().flat_map(|rung| &rung.actions);
        if main.any(|action| action.what == Instruction::End) {
            allow("return-outside-function", "it is Click's END");
        }
        items.push(Item::Blank);
        for section in self.tags.sections() {
            items.push(Item::Section(section));
        }
        for definition in self.tags.drum_blocks.into_values() {
            items.extend([Item::Blank, definition]);
        }
        items.append(&mut self.items);
        self.reading.program.items = items;
        self.reading
    }

    /// The tags that are read and those that are written, without timers and counters.
    fn traffic(&self, program: &Program) -> (HashMap<String, Bank>, HashMap<String, Bank>) {
        let mut read = HashMap::new();
        let mut written = HashMap::new();
        for one in uses(program) {
            let (bank, name) = match one.what {
                What::One(tag) | What::From(tag, _) => (tag.bank, self.tags.declared(tag)),
                What::Many(span) => (span.bank, Some(span.bank.row().name.to_owned())),
                What::Somewhere(pointer) => (pointer.bank, Some(pointer.bank.row().name.to_owned())),
            };
            let Some(name) = name else { continue };
            if matches!(one.access, Access::Read | Access::Contact) {
                read.insert(name.clone(), bank);
            }
            if one.access == Access::Write {
                written.insert(name, bank);
            }
        }
        // The first bit of a register without a clock is what enters it.
        let rungs = program.routines().flat_map(|routine| &routine.rungs);
        for action in rungs.flat_map(|rung| &rung.actions) {
            if let Instruction::Shift(shift) = &action.what
                && shift.clock.is_none()
            {
                read.insert(shift.bits.bank.row().name.to_owned(), shift.bits.bank);
            }
        }
        (read, written)
    }

    /// What there is to say of the program as a whole.
    fn remarks(&mut self, program: &Program) {
        let report = &mut self.reading.report;
        for (tag, name) in self.tags.renamed() {
            report.approximated(LineColumn::START, tag, format!("it is spelled `{name}` here"));
        }
        for (nickname, why) in self.tags.unsaid() {
            report.approximated(LineColumn::START, nickname.address.to_string(), why);
        }
        let mut told = HashSet::new();
        for one in uses(program) {
            let (bank, number) = match one.what {
                What::One(tag) => (tag.bank, self.tags.address(tag).map(|address| address.number)),
                What::Many(span) => (span.bank, Some(span.first)),
                _ => continue,
            };
            let why = match bank {
                Bank::Xd | Bank::Yd => {
                    "it holds the bits of a module in Click, and is a word of its own here"
                }
                Bank::Sc | Bank::Sd if number.is_some_and(|number| super::tags::is_known(bank, number)) => {
                    continue;
                }
                Bank::Sc | Bank::Sd => "Click's controller sets it, and nothing does here",
                _ => continue,
            };
            let what = match one.what {
                What::One(tag) => tag.dsl(),
                What::Many(span) => span.dsl(),
                _ => continue,
            };
            if told.insert(what.clone()) {
                report.approximated(one.place, what, why);
            }
        }
    }

    fn routine(&mut self, routine: &Routine) {
        if routine.name != "main" {
            self.items.push(Item::Blank);
            let name = self.functions.spell(&routine.name).to_owned();
            if name != routine.name {
                let why = format!("it is spelled `{name}` here");
                self.reading
                    .report
                    .approximated(routine.place, &routine.name, why);
            }
            let origin = self.reading.origin(routine.place);
            let block = Element::of(Block::function(&name), Some(origin));
            self.items.push(Item::Network(Network {
                comments: routine.comments.clone(),
                drawing: Drawing::Circuit(Circuit::Element(block)),
            }));
        }
        for rungs in routine.rungs.chunk_by(|_, next| order::goes_on(next)) {
            self.rungs(rungs);
        }
        if !routine.after.is_empty() {
            self.items.push(Item::Blank);
            self.items
                .extend(routine.after.iter().cloned().map(Item::Comment));
        }
    }

    /// A rung of Click, which may be several networks: all of its contacts are checked before it acts.
    fn rungs(&mut self, rungs: &[Rung]) {
        let mut above = Vec::new();
        for (condition, part) in order::late(&self.tags, rungs) {
            self.seen_first += 1;
            let part = match part {
                Part::Branch => "a branch",
                Part::Pin => "a pin",
            };
            let what = format!("what {part} sees before its rung acts, {}", self.seen_first);
            let helper = self.tags.helper("seen", "BOOL", what);
            above.push(Above {
                condition: condition.clone(),
                blocks: vec![Block::coil(helper.clone())],
            });
            self.tags.late.push((condition.clone(), helper));
        }
        for rung in rungs {
            self.rung(rung, std::mem::take(&mut above));
        }
        self.tags.late.clear();
    }

    fn rung(&mut self, rung: &Rung, mut above: Vec<Above>) {
        let mut comments = rung.comments.clone();
        let mut branches = Vec::with_capacity(rung.actions.len());
        let mut after = Vec::new();
        let condition = self.seen(&rung.condition, rung.place);
        // Actions that follow each other after the same condition share it.
        let same =
            |one: &Action, other: &Action| !one.condition.is_always() && one.condition == other.condition;
        for actions in rung.actions.chunk_by(same) {
            let before = self.seen(&actions[0].condition, actions[0].place);
            let mut parts = if before_is_bare(&before) {
                Vec::new()
            } else {
                vec![before]
            };
            let mut acts: Vec<Circuit<Element>> = Vec::with_capacity(actions.len());
            for action in actions {
                acts.push(Circuit::Series(self.action(action, &mut above, &mut after)));
            }
            match acts.len() {
                1 => parts.append(&mut acts),
                _ => parts.push(Circuit::Parallel(acts)),
            }
            branches.push(Circuit::Series(parts));
        }
        let only_nops = rung.actions.iter().all(|action| action.what == Instruction::Nop);
        let mut parts = vec![condition];
        match branches.len() {
            0 | 1 => parts.extend(branches),
            _ => parts.push(Circuit::Parallel(branches)),
        }
        for Above { condition, blocks } in above {
            let condition = self.condition(&condition);
            self.own_network(std::mem::take(&mut comments), condition, blocks, rung.place);
        }
        self.items.push(Item::Blank);
        if only_nops {
            let comments = std::mem::take(&mut comments);
            self.items.extend(comments.into_iter().map(Item::Comment));
            self.items.push(Item::Directive(
                "allow(no-output): a rung of Click that does nothing".to_owned(),
            ));
        }
        self.items.push(Item::Network(Network {
            comments,
            drawing: Drawing::Circuit(Circuit::Series(parts)),
        }));
        for network in after {
            let resets = network
                .blocks
                .iter()
                .filter(|block| block.op() == Some(Op::ResetCoil));
            let told = resets.filter_map(|reset| Some(format!("reset of {}", reset.only()?)));
            let told: Vec<String> = told.collect();
            let condition = self.seen(&network.condition, rung.place);
            self.own_network(told, condition, network.blocks, rung.place);
        }
    }

    /// A rung that the importer makes.
    fn own_network(
        &mut self,
        comments: Vec<String>,
        condition: Circuit<Element>,
        blocks: Vec<Block>,
        place: LineColumn,
    ) {
        let parts = vec![condition, self.series(place, blocks)];
        self.items.push(Item::Blank);
        self.items.push(Item::Network(Network {
            comments,
            drawing: Drawing::Circuit(Circuit::Series(parts)),
        }));
    }

    /// What is after the condition of an action.
    fn action(
        &mut self,
        action: &Action,
        above: &mut Vec<Above>,
        after: &mut Vec<Above>,
    ) -> Vec<Circuit<Element>> {
        let place = action.place;
        let shown = spell::action(action);
        let origin = Some(self.reading.origin(place));
        let mut out = Vec::new();
        match self.acts(action) {
            Ok(acts) => {
                let blocks = acts.chain.blocks.into_iter();
                out.extend(blocks.map(|block| Circuit::Element(Element::of(block, origin))));
                above.extend(acts.above);
                after.extend(acts.after);
                match acts.chain.remark {
                    Some(why) => self.reading.report.approximated(place, shown, why),
                    None => self.reading.report.translated(place, shown),
                }
            }
            Err(why) => {
                let kept = match &action.what {
                    Instruction::Kept { text, .. } => text.clone(),
                    _ => shown,
                };
                out.push(Circuit::Element(self.refused(place, kept, why)));
            }
        }
        if let Some(comment) = &action.comment {
            out.push(Circuit::Element(Element::comment(comment, origin)));
        }
        out
    }

    /// A comment in the place of what has no counterpart.
    fn refused(&mut self, place: LineColumn, shown: String, why: String) -> Element {
        let origin = Some(self.reading.origin(place));
        let comment = Element::comment(&format!("click: {shown}"), origin);
        self.reading.report.refused(place, shown, why);
        comment
    }

    fn acts(&mut self, action: &Action) -> Result<act::Acts, String> {
        let tag = match &action.what {
            Instruction::Timer(timer) => Some(&timer.tag),
            Instruction::Counter(counter) => Some(&counter.tag),
            _ => None,
        };
        if let Some(state) = tag.and_then(|tag| self.tags.state(tag)) {
            if let Some(first) = self.blocks.get(&state.name) {
                let name = &state.name;
                return Err(format!(
                    "a timer or counter belongs to one block, and `{name}` has one at {first}"
                ));
            }
            self.blocks.insert(state.name.clone(), action.place);
        }
        if has_options(&action.what) {
            return Err("its options have no counterpart here".to_owned());
        }
        if let Instruction::Call(name) = &action.what {
            let spelled = Instruction::Call(self.functions.spell(name).to_owned());
            return act::acts(&mut self.tags, &spelled, action.oneshot);
        }
        act::acts(&mut self.tags, &action.what, action.oneshot)
    }
}

fn before_is_bare(circuit: &Circuit<Element>) -> bool {
    matches!(circuit, Circuit::Series(parts) if parts.is_empty())
}

fn has_options(what: &Instruction) -> bool {
    match what {
        Instruction::Copy { options, .. } | Instruction::BlockCopy { options, .. } => {
            !options.named.is_empty() || options.allow_whitespace
        }
        Instruction::Pack { options, .. } => !options.named.is_empty() || options.convert.is_some(),
        Instruction::Fill { options, .. } | Instruction::Unpack { options, .. } => {
            *options != CopyOptions::default()
        }
        _ => false,
    }
}
