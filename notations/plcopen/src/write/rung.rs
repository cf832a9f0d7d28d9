//! A network as elements and wires. The generators of Beremiz and OpenPLC read all contacts that feed a coil when they come
//! to that coil, and again for the next; here each contact is read once, where it stands. Where that would make a difference
//! power goes into a tag, and on from a contact on it.

use super::added::Added;
use super::declare::named;
use super::names::Names;
use super::touched::Touched;
use crate::graph::{Edge, End, Kind, Modifier, Node, Output, Pin, Storage};
use crate::model::Type;
use ladder_analysis::program::{Network, Step};
use ladder_notation::LineColumn;
use std::collections::{BTreeSet, HashSet};
use std::rc::Rc;

/// What else is known of an element than its node in the drawing.
#[derive(Debug)]
pub(super) struct Note {
    /// The step that it was made for.
    pub(super) step: usize,
    pub(super) touched: Touched,
    /// It is done, once; else it only passes power on.
    pub(super) acts: bool,
}

/// A network on its way.
pub(super) struct Rung<'r> {
    pub(super) place: LineColumn,
    /// How many elements the drawing had before.
    base: usize,
    pub(super) nodes: Vec<Node>,
    pub(super) notes: Vec<Note>,
    pub(super) made: Added,
    step: usize,
    plan: &'r Plan,
}

/// What is known of a network before it is drawn. What a drawing shows to be missing here is there in the next one.
struct Plan {
    /// The steps whose power goes on.
    needed: Vec<bool>,
    /// The steps whose power goes into a tag.
    held: BTreeSet<usize>,
    /// The blocks, by their steps, that something must ask for at once.
    asked: BTreeSet<usize>,
}

/// Writes a block of a network, with the power that enters it; comes back the power that leaves it.
type Element<'e> = dyn Fn(&mut Rung<'_>, usize, Vec<End>) -> Result<Vec<End>, String> + 'e;

/// Networks with more elements are not written.
const MOST_NODES: usize = 2_000;

/// The elements of a network, with what a unit gets beside them: `element` writes one block of it, with the power that enters it,
/// and comes back with the power that leaves it.
///
/// # Errors
///
/// Why it has no counterpart.
pub(super) fn drawn(
    place: LineColumn,
    base: usize,
    names: &Rc<Names>,
    network: &Network,
    element: &Element<'_>,
) -> Result<(Vec<Node>, Added), String> {
    let mut plan = Plan {
        needed: needed(network),
        held: BTreeSet::new(),
        asked: BTreeSet::new(),
    };
    loop {
        let mut rung = Rung {
            place,
            base,
            nodes: Vec::new(),
            notes: Vec::new(),
            made: Added::of(Names::added_to(names)),
            step: 0,
            plan: &plan,
        };
        rung.draw(network, element)?;
        let (more, late) = (rung.read_too_late(), rung.asked_too_late());
        if !more.is_subset(&plan.held) || !late.is_subset(&plan.asked) {
            plan.held.extend(more);
            plan.asked.extend(late);
            continue;
        }
        if !more.is_empty() {
            return Err("its order of evaluation cannot be kept there".to_owned());
        }
        if rung.goes_on_after_jump() {
            return Err("something is done after a jump in it, whose order is not settled there".to_owned());
        }
        return Ok((rung.nodes, rung.made));
    }
}

impl Rung<'_> {
    fn draw(&mut self, network: &Network, element: &Element<'_>) -> Result<(), String> {
        let rail = self.push(Kind::LeftRail, Vec::new(), Touched::default(), false);
        let mut powers: Vec<Vec<End>> = Vec::with_capacity(network.steps.len());
        for (step, it) in network.steps.iter().enumerate() {
            self.step = step;
            let mut power = match it {
                Step::Start { rail: true } => vec![rail],
                Step::Start { rail: false } => Vec::new(),
                Step::Join { upper, lower } => self.either(&powers[*upper], &powers[*lower]),
                Step::Block { en, .. } if powers[*en].is_empty() => {
                    return Err("no power can reach a block of it".to_owned());
                }
                Step::Block { block, en } => element(self, *block, powers[*en].clone())?,
            };
            if self.nodes.len() > MOST_NODES {
                return Err(format!("it has more than {MOST_NODES} elements"));
            }
            if self.plan.held.contains(&step) && power != [rail] {
                let tag = self.made("power", named("BOOL"), "power at a point of the drawing");
                let touched = Touched::default();
                let coil = Kind::Coil(tag.clone(), Modifier::default(), Storage::None);
                self.push(coil, vec![pin("", power)], touched.clone(), true);
                power = vec![self.contact(&tag, Modifier::default(), vec![rail], touched)];
            }
            powers.push(power);
        }
        Ok(())
    }

    /// The left rail.
    pub(super) fn rail(&self) -> End {
        End {
            node: self.base,
            output: 0,
        }
    }

    /// Whether power is that of the left rail.
    pub(super) fn is_rail(&self, power: &[End]) -> bool {
        power == [self.rail()]
    }

    fn either(&self, one: &[End], other: &[End]) -> Vec<End> {
        if one.contains(&self.rail()) || other.contains(&self.rail()) {
            return vec![self.rail()];
        }
        let mut all = one.to_vec();
        all.extend(other.iter().filter(|end| !one.contains(end)));
        all
    }

    /// Whether anything takes the power that leaves the block.
    pub(super) fn is_needed(&self) -> bool {
        self.plan.needed[self.step]
    }

    /// Whether something must ask for the block at once.
    pub(super) fn is_asked(&self) -> bool {
        self.plan.asked.contains(&self.step)
    }

    /// An element; comes back its first output.
    pub(super) fn push(&mut self, kind: Kind, inputs: Vec<Pin>, touched: Touched, acts: bool) -> End {
        let node = self.base + self.nodes.len();
        self.nodes.push(Node::new(self.place, kind, inputs));
        self.notes.push(Note {
            step: self.step,
            touched,
            acts,
        });
        End { node, output: 0 }
    }

    /// A block with these outputs.
    pub(super) fn block(
        &mut self,
        (name, instance): (&str, Option<String>),
        inputs: Vec<Pin>,
        outputs: &[&str],
        touched: Touched,
        acts: bool,
    ) -> End {
        let kind = Kind::Block {
            name: name.to_owned(),
            instance,
            code: None,
        };
        let end = self.push(kind, inputs, touched, acts);
        self.nodes[end.node - self.base].outputs = outputs
            .iter()
            .map(|name| Output {
                name: (*name).to_owned(),
                negated: false,
            })
            .collect();
        end
    }

    pub(super) fn contact(
        &mut self,
        tag: &str,
        modifier: Modifier,
        power: Vec<End>,
        touched: Touched,
    ) -> End {
        self.push(
            Kind::Contact(tag.to_owned(), modifier),
            vec![pin("", power)],
            touched,
            false,
        )
    }

    pub(super) fn coil(
        &mut self,
        tag: &str,
        modifier: Modifier,
        storage: Storage,
        power: Vec<End>,
        touched: Touched,
    ) -> End {
        let kind = Kind::Coil(tag.to_owned(), modifier, storage);
        self.push(kind, vec![pin("", power)], touched, true)
    }

    /// A value at a pin.
    pub(super) fn value(&mut self, text: String) -> Vec<End> {
        vec![self.push(Kind::Value(text, false), Vec::new(), Touched::default(), false)]
    }

    /// A variable that takes a value.
    pub(super) fn variable(&mut self, text: String, from: End, touched: Touched) {
        self.push(
            Kind::Variable(text, false),
            vec![pin("", vec![from])],
            touched,
            true,
        );
    }

    /// A variable that the ladder text does not have; comes back its name.
    pub(super) fn made(&mut self, like: &str, ty: Type, comment: &str) -> String {
        self.made.variable(self.place, like, ty, comment)
    }

    /// Lets something take the power that leaves a block.
    pub(super) fn ask(&mut self, from: End) {
        let tag = self.made.sink(self.place);
        let none = Modifier::default();
        self.coil(&tag, none, Storage::None, vec![from], Touched::default());
    }

    /// What feeds an element. Coils pass on what comes to them.
    fn sources(&self, node: usize) -> Vec<usize> {
        let mut all = Vec::new();
        let mut waiting = vec![node];
        while let Some(node) = waiting.pop() {
            for end in self.nodes[node].inputs.iter().flat_map(|pin| &pin.from) {
                let source = end.node - self.base;
                match self.nodes[source].kind {
                    Kind::Coil(..) => waiting.push(source),
                    _ => all.push(source),
                }
            }
        }
        all
    }

    /// All that is read again for an element: what feeds it, up to blocks and coils, which were done already.
    fn cone(&self, node: usize) -> Vec<usize> {
        let mut seen = HashSet::new();
        let mut waiting = vec![node];
        while let Some(at) = waiting.pop() {
            for source in self.sources(at) {
                if !self.notes[source].acts && seen.insert(source) {
                    waiting.push(source);
                }
            }
        }
        let mut all: Vec<usize> = seen.into_iter().collect();
        all.sort_unstable();
        all
    }

    /// The steps whose power is read again after something that it was made from has changed.
    fn read_too_late(&self) -> BTreeSet<usize> {
        let mut late = BTreeSet::new();
        let writers: Vec<usize> = (0..self.nodes.len())
            .filter(|node| {
                let touched = &self.notes[*node].touched;
                self.notes[*node].acts && (touched.writes_any || !touched.writes.is_empty())
            })
            .collect();
        for (node, note) in self.notes.iter().enumerate() {
            if !note.acts || writers.first().is_none_or(|first| *first >= node) {
                continue;
            }
            let cone = self.cone(node);
            // Of each element the first that changes what it reads.
            let changed_by = |element: usize| {
                let from = writers.partition_point(|writer| *writer < element);
                let between = writers[from..].iter().take_while(|writer| **writer < node);
                let touched = &self.notes[element].touched;
                between
                    .copied()
                    .find(|writer| self.notes[*writer].touched.changes(touched))
            };
            let changed: Vec<(usize, usize)> = cone
                .iter()
                .filter_map(|element| Some((*element, changed_by(*element)?)))
                .collect();
            let Some(writer) = changed.iter().map(|(_, writer)| *writer).min() else {
                continue;
            };
            late.extend(self.cut(node, &cone, writer, &changed));
        }
        late
    }

    /// The steps where what feeds an element is cut before a writer, so that nothing which that changes is read after it.
    fn cut(&self, node: usize, cone: &[usize], writer: usize, changed: &[(usize, usize)]) -> BTreeSet<usize> {
        // Which elements have changed ones before them, or are some.
        let mut stale: HashSet<usize> = changed
            .iter()
            .filter(|(_, by)| *by == writer)
            .map(|(it, _)| *it)
            .collect();
        for element in cone.iter().filter(|element| **element < writer) {
            if self.sources(*element).iter().any(|source| stale.contains(source)) {
                stale.insert(*element);
            }
        }
        let after = cone
            .iter()
            .copied()
            .filter(|element| *element > writer)
            .chain([node]);
        let mut steps = BTreeSet::new();
        for element in after {
            for source in self.sources(element) {
                if source < writer && stale.contains(&source) {
                    steps.insert(self.notes[source].step);
                }
            }
        }
        steps
    }

    /// The steps of function blocks that the next thing which is done does not ask for: a generator would run them later.
    fn asked_too_late(&self) -> BTreeSet<usize> {
        let mut late = BTreeSet::new();
        for (node, note) in self.notes.iter().enumerate() {
            if !matches!(
                &self.nodes[node].kind,
                Kind::Block {
                    instance: Some(_),
                    ..
                }
            ) {
                continue;
            }
            let is_root = |kind: &Kind| matches!(kind, Kind::Coil(..) | Kind::Variable(..));
            let next = (node + 1..self.nodes.len()).find(|next| is_root(&self.nodes[*next].kind));
            if next.is_none_or(|next| !self.reaches(node, next)) {
                late.insert(note.step);
            }
        }
        late
    }

    /// Whether anything that leaves an element arrives at a later one.
    fn reaches(&self, from: usize, to: usize) -> bool {
        let mut reached = vec![false; to + 1];
        reached[from] = true;
        for node in from + 1..=to {
            let mut sources = self.nodes[node].inputs.iter().flat_map(|pin| &pin.from);
            reached[node] = sources.any(|end| reached[end.node - self.base]);
        }
        reached[to]
    }

    /// Whether a jump is followed by something that is done.
    fn goes_on_after_jump(&self) -> bool {
        let is_jump = |node: &Node| matches!(node.kind, Kind::Jump(..) | Kind::Return(_));
        match self.nodes.iter().position(is_jump) {
            Some(jump) => self.notes[jump + 1..].iter().any(|note| note.acts),
            None => false,
        }
    }
}

/// The pin of a block, or the only one of an element.
pub(super) fn pin(name: &str, from: Vec<End>) -> Pin {
    Pin {
        name: name.to_owned(),
        from,
        ..Pin::default()
    }
}

/// What is done to power at a contact or coil.
pub(super) fn modifier(negated: bool, edge: Edge) -> Modifier {
    Modifier { negated, edge }
}

/// For each step whether a block after it has its power.
fn needed(network: &Network) -> Vec<bool> {
    let mut needed = vec![false; network.steps.len()];
    for (step, it) in network.steps.iter().enumerate().rev() {
        match it {
            Step::Block { en, .. } => needed[*en] = true,
            Step::Join { upper, lower } if needed[step] => {
                needed[*upper] = true;
                needed[*lower] = true;
            }
            _ => {}
        }
    }
    needed
}
