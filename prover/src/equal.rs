//! Whether two networks do the same: from any state in which all tags that they read are equal, all that they leave is equal.
//!
//! Each is followed alone (`encode/alone.rs`), over one graph in which values of one name are one variable, so that equal logic is
//! one node. That some state comes to be in a run is not asked: values that show a difference may be ones that never come together.

use crate::body;
use crate::clock::Clock;
use crate::decide::reach;
use crate::encode::{Cells, InputTag, Left, World, follow_alone};
use crate::graph::Lit;
use crate::limits::End;
use crate::model::Model;
use crate::number::Number;
pub use crate::shown::Difference;
use crate::shown::{Effect, shown};
use crate::unrolled::{Found, From, Unrolled};
use ladder_analysis::Cancel;
use ladder_analysis::program::{Block, BlockKind, Program, Tag};
use ladder_simulator::compiled::{Compiled, Instr, UnreadPlace, compile};
use rustc_hash::FxHashMap;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;
use std::sync::Arc;
use std::time::Duration;

/// Conflicts that the question about two networks may have.
const CONFLICTS: u64 = 50_000;

const OWN_MEMORY: &str = "a block in it has a memory of its own";

/// What an edited network does, next to what it did.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Meaning {
    /// The same, from any state.
    Same,
    /// Something else: values that show it.
    Other(Difference),
    /// These tags are declared differently.
    Declared(Vec<String>),
    /// It is not known: why.
    NotDecided(String),
}

/// Two programs whose networks are compared.
#[derive(Debug)]
pub struct Compared {
    old: Form,
    new: Form,
    /// The bodies of blocks, each compiled when the first of its networks is asked about.
    bodies: RefCell<Bodies>,
}

/// By a block of the old program and one of the new.
type Bodies = FxHashMap<(usize, usize), Result<Rc<Compared>, String>>;

/// A program, compiled.
#[derive(Debug)]
struct Form {
    program: Arc<Program>,
    compiled: Compiled,
    cells: Cells,
    /// The tags by their names in lower case.
    tags: FxHashMap<String, usize>,
}

impl Form {
    fn new(program: &Arc<Program>) -> Result<Form, String> {
        // What depends on the time between scans does so in both programs.
        let interval = program.cycle.unwrap_or(10_000_000);
        let compiled = compile(program, interval).map_err(|error| error.message)?;
        Ok(Form {
            cells: Cells::alone(program, &compiled),
            tags: program
                .tags
                .iter()
                .enumerate()
                .filter(|(_, tag)| tag.block.is_none())
                .map(|(number, tag)| (tag.name.to_ascii_lowercase(), number))
                .collect(),
            program: Arc::clone(program),
            compiled,
        })
    }

    fn tag(&self, name: &str) -> Option<&Tag> {
        Some(&self.program.tags[*self.tags.get(name)?])
    }

    /// The declared tag that a value belongs to: `t1` of `t1.Q`.
    fn tag_of(&self, value: &str) -> Option<&Tag> {
        let mut name = value;
        loop {
            if let Some(tag) = self.tag(name) {
                return Some(tag);
            }
            name = &name[..name.rfind(['.', '[', ' '])?];
        }
    }

    /// The block in whose body a network is.
    fn block_of(&self, network: usize) -> Option<usize> {
        let mut blocks = self.program.blocks.iter();
        blocks.position(|block| block.networks.contains(&network))
    }

    fn follow(&self, world: &mut World, network: usize) -> Result<Left, String> {
        if self.block_of(network).is_some() && !self.program.main.contains(&network) {
            return Err("it is in the body of a block".into());
        }
        let Some(stretch) = self.compiled.stretch_of(network) else {
            return Ok(follow_alone(world, &self.compiled, &self.cells, 0..0));
        };
        let cells = self.cells.with_network(&self.compiled, network, stretch.clone());
        let left = follow_alone(world, &self.compiled, &cells, stretch);
        match &world.blocked {
            Some(gap) => Err(gap.what.clone()),
            None => Ok(left),
        }
    }

    /// The unread parts of a network.
    fn unread_parts(&self, network: usize) -> Vec<&UnreadPlace> {
        let code = &self.compiled.code;
        let stretch = self.compiled.stretch_of(network).unwrap_or_default();
        let instrs = &code.instrs[stretch.start as usize..stretch.end as usize];
        let parts = instrs.iter().filter_map(|instr| match *instr {
            Instr::Unread { at } => Some(&code.unread[at as usize]),
            _ => None,
        });
        parts.collect()
    }

    /// Whether what a block of a network remembers has no name, and another network may find it: the state of the block is a tag.
    fn has_hidden(&self, model: &Model, network: usize) -> bool {
        let mut blocks = self.program.networks[network].blocks.iter();
        let has_state = |block: &Block| {
            let mut arguments = block.arguments.iter();
            matches!(block.kind, BlockKind::User(_)) && arguments.any(|bound| bound.parameter.is_none())
        };
        !model.world.states.is_empty() && blocks.any(has_state)
    }

    /// The label at a place in the code.
    fn label(&self, to: u32) -> Option<String> {
        let networks: Vec<usize> = self.compiled.code.networks_at(to).collect();
        let mut labels = self.program.labels.iter();
        let (label, _) = labels.find(|(_, network)| networks.contains(network))?;
        Some(label.as_str().to_owned())
    }
}

/// Two networks over one graph.
struct Both {
    /// Each value that one of them may change, with what each leaves of it.
    values: Vec<(Effect, Number, Number)>,
}

impl Compared {
    /// Compiles both programs.
    ///
    /// # Errors
    /// One takes more memory than there is: why.
    pub fn new(old: &Arc<Program>, new: &Arc<Program>) -> Result<Compared, String> {
        let (mut old, mut new) = (Form::new(old)?, Form::new(new)?);
        old.cells.keep_idle(&new.cells);
        new.cells.keep_idle(&old.cells);
        Ok(Compared {
            old,
            new,
            bodies: RefCell::default(),
        })
    }

    /// Compares a network of the old program with one of the new, by their numbers, for no longer than `time`, unless it is cancelled.
    pub fn networks(&self, old: usize, new: usize, time: Duration, cancel: &Cancel) -> Meaning {
        let end = &End::after(time, &Clock::default(), cancel);
        let asked = match (self.old.block_of(old), self.new.block_of(new)) {
            (None, None) => self.asked(old, new, end),
            (Some(was), Some(is)) => self
                .bodies(was, is)
                .and_then(|bodies| bodies.asked(old, new, end)),
            _ => Err("it is in the body of a block in one of the programs only".into()),
        };
        asked.unwrap_or_else(Meaning::NotDecided)
    }

    /// The bodies of two blocks.
    fn bodies(&self, was: usize, is: usize) -> Result<Rc<Compared>, String> {
        let body = |form: &Form, block| body::program(&form.program, block).map(Arc::new);
        let compiled = || Compared::new(&body(&self.old, was)?, &body(&self.new, is)?).map(Rc::new);
        let mut bodies = self.bodies.borrow_mut();
        bodies.entry((was, is)).or_insert_with(compiled).clone()
    }

    fn asked(&self, old: usize, new: usize, end: &End) -> Result<Meaning, String> {
        let parts = [(&self.old, old), (&self.new, new)].map(|(form, network)| form.unread_parts(network));
        if let Some(name) = another_part(parts) {
            return Err(is_another(name));
        }
        let mut world = World::until(end);
        world.compares = true;
        let before = self.old.follow(&mut world, old)?;
        let after = self.new.follow(&mut world, new)?;
        let declared = self.declared(&world);
        if !declared.is_empty() {
            return Ok(Meaning::Declared(declared));
        }
        let both = self.both(&mut world, &before, &after)?;
        let graph = &mut world.graph;
        let differs: Vec<Lit> = both
            .values
            .iter()
            .map(|(_, old, new)| !graph.equal(old, new))
            .collect();
        let any = world.graph.any(differs.iter().copied());
        let edges_agree = edges_of_a_tag_agree(&mut world);
        let assumed = std::mem::take(&mut world.valid);
        let model = Model {
            world,
            properties: Vec::new(),
            assumed,
            lemmas: Vec::new(),
        };
        let mut solver = Unrolled::new(&model, From::Anywhere, end);
        solver.add_scan();
        let any = solver.lit(0, any);
        match solver.ask(&[any], CONFLICTS) {
            Found::No if self.old.has_hidden(&model, old) || self.new.has_hidden(&model, new) => {
                return Err(OWN_MEMORY.into());
            }
            Found::No => return Ok(Meaning::Same),
            Found::Unknown => return Err(String::from("it takes too long")),
            Found::Yes => {}
        }
        // Edges of one tag in a network hold the same as a rule: which is whose does not matter then.
        let edges_agree = solver.lit(0, edges_agree);
        solver.require(edges_agree);
        match solver.ask(&[any], CONFLICTS) {
            Found::No => return Err(String::from("edges of one tag in it have changed places")),
            Found::Unknown => return Err(String::from("it takes too long")),
            Found::Yes => {}
        }
        // What was left open may be what differs: something that does not depend on it shows a difference for sure.
        let mut cause = None;
        let mut values: Vec<_> = both.values.iter().zip(&differs).collect();
        values.sort_by_key(|((effect, _, _), _)| effect.rank());
        for ((effect, old, new), differs) in values {
            if let Some(open) = open(&model, *differs) {
                cause.get_or_insert(open);
                continue;
            }
            let lit = solver.lit(0, *differs);
            // The difference may be simpler than what differs.
            for bit in [old, new].into_iter().flat_map(|number| number.low(64)) {
                solver.make_known(0, bit);
            }
            match solver.ask(&[lit], CONFLICTS) {
                Found::Yes => {
                    let shown = shown(&model, &mut solver, *differs, (effect, old, new));
                    return Ok(Meaning::Other(shown));
                }
                Found::No => {}
                Found::Unknown => return Err(String::from("it takes too long")),
            }
        }
        Err(cause.unwrap_or_else(|| String::from("it takes too long")))
    }

    /// The tags that were read or written and are declared differently.
    fn declared(&self, world: &World) -> Vec<String> {
        let mut names: Vec<String> = Vec::new();
        for (name, _) in world.shared.keys() {
            let (Some(old), Some(new)) = (self.old.tag_of(name), self.new.tag_of(name)) else {
                continue;
            };
            if is_other(old, new) && !names.contains(&old.name) {
                names.push(old.name.clone());
            }
        }
        names.sort();
        names
    }

    /// What both leave, value by value.
    fn both(&self, world: &mut World, before: &Left, after: &Left) -> Result<Both, String> {
        let mut left: BTreeMap<String, (&InputTag, Option<&Number>, Option<&Number>)> = BTreeMap::new();
        let key = |tag: &InputTag| format!("{} {:?}", tag.name.to_ascii_lowercase(), tag.ty);
        for (tag, value) in &before.values {
            left.entry(key(tag)).or_insert((tag, None, None)).1 = Some(value);
        }
        for (tag, value) in &after.values {
            left.entry(key(tag)).or_insert((tag, None, None)).2 = Some(value);
        }
        let mut values = Vec::new();
        for (tag, old, new) in left.into_values() {
            let effect = Effect::Value(tag.clone());
            // A memory that only one of them has matters by what it does to the tags.
            if effect.is_of_place() && (old.is_none() || new.is_none()) {
                continue;
            }
            let at_first = world.shared(tag);
            let value = |value: Option<&Number>| value.unwrap_or(&at_first).clone();
            values.push((effect, value(old), value(new)));
        }
        let mut add = |effect: Effect, old: Lit, new: Lit| {
            values.push((effect, Number::of_bit(old), Number::of_bit(new)));
        };
        add(Effect::Fault, before.faulted, after.faulted);
        add(Effect::End, before.ended, after.ended);
        add(Effect::Rail, before.rail, after.rail);
        let mut jumps: BTreeMap<String, [Lit; 2]> = BTreeMap::new();
        for (side, (form, left)) in [(&self.old, before), (&self.new, after)].into_iter().enumerate() {
            for (to, who) in &left.jumps {
                let label = form.label(*to).ok_or("it jumps to a place without a name")?;
                let both = jumps.entry(label).or_insert([Lit::FALSE; 2]);
                both[side] = world.graph.or(both[side], *who);
            }
        }
        for (label, [old, new]) in jumps {
            add(Effect::Jump(label), old, new);
        }
        add(Effect::GoesOn, before.goes_on, after.goes_on);
        Ok(Both { values })
    }
}

/// The name of the first unread part of two programs, or networks, that has no counterpart with the same text.
pub(crate) fn another_part([mut old, mut new]: [Vec<&UnreadPlace>; 2]) -> Option<&str> {
    old.retain(
        |part| match new.iter().position(|other| other.text == part.text) {
            Some(same) => {
                new.remove(same);
                false
            }
            None => true,
        },
    );
    let first = new.first().or(old.first())?;
    Some(&first.name)
}

/// Why there is no verdict on two programs with different unread parts.
pub(crate) fn is_another(name: &str) -> String {
    format!("the unread part `{name}` is another one")
}

/// High where the memories of all edges of one tag hold the same.
fn edges_of_a_tag_agree(world: &mut World) -> Lit {
    let mut first: BTreeMap<String, Lit> = BTreeMap::new();
    let mut edges: Vec<(String, Lit)> = Vec::new();
    for ((name, _), value) in &world.shared {
        if let Some((tag, _)) = name.split_once(" before ").filter(|(tag, _)| !tag.is_empty()) {
            edges.push((tag.to_owned(), value.bit(0)));
        }
    }
    let mut agree = Lit::TRUE;
    for (tag, edge) in edges {
        let other = *first.entry(tag).or_insert(edge);
        let same = world.graph.same(edge, other);
        agree = world.graph.and(agree, same);
    }
    agree
}

/// The tags of two programs that are declared differently, or have another type by what is done with them.
pub fn other_tags(old: &Program, new: &Program) -> Vec<String> {
    let is_own = |tag: &&Tag| tag.block.is_none();
    let now: FxHashMap<String, &Tag> = new
        .tags
        .iter()
        .filter(is_own)
        .map(|tag| (tag.name.to_ascii_lowercase(), tag))
        .collect();
    let is_different = |tag: &&Tag| {
        now.get(&tag.name.to_ascii_lowercase()).is_some_and(|now| {
            is_other(tag, now)
                || tag.initial != now.initial
                || tag.role != now.role
                || tag.retain != now.retain
        })
    };
    let different = old.tags.iter().filter(is_own).filter(is_different);
    different.map(|tag| tag.name.clone()).collect()
}

/// Whether two tags of one name are not declared in the same way, as far as a network can tell.
fn is_other(old: &Tag, new: &Tag) -> bool {
    old.ty != new.ty
        || old.address != new.address
        || old.constant != new.constant
        || (old.constant && old.initial != new.initial)
}

/// What was left open that a literal depends on.
fn open(model: &Model, lit: Lit) -> Option<String> {
    let nodes = reach(model, std::iter::once(lit));
    let world = &model.world;
    let mut gaps: Vec<usize> = world
        .open
        .iter()
        .filter(|(node, _)| nodes.contains(node))
        .map(|(_, gap)| *gap)
        .collect();
    gaps.sort_unstable();
    if let Some(gap) = gaps.first() {
        return Some(world.gaps[*gap].what.clone());
    }
    let mut states = world.states.iter();
    let remembers = states.any(|state| nodes.contains(&state.leaf.node()));
    remembers.then(|| OWN_MEMORY.into())
}
