//! Whose turn it is. A generator runs the blocks and the edge detectors that feed an element one after the other, each before
//! what it feeds, and reads contacts only then; in a network they run where they stand. Where that is not the same, because
//! something reads by name what a block in the same network writes, each is in a network of its own, in their order.

use super::blocks::{Class, power_output, power_pins};
use super::body::Body;
use super::draw::Target;
use crate::expression::reads;
use crate::graph::{Edge, End, Kind, Pin};
use crate::standard::Gate;
use ladder_format::program::Path;
use std::collections::HashSet;

/// What feeds an element, by whatever pins.
#[derive(Default)]
struct Before {
    /// The blocks that act, the comparisons and the contacts that see edges, in the order in which a generator runs them.
    turns: Vec<usize>,
    /// The tags that are read by name, in small letters.
    reads: HashSet<String>,
    seen: HashSet<usize>,
}

/// Whether a generator runs a block before what it feeds.
fn has_turn(class: Class) -> bool {
    class.acts() || matches!(class, Class::Compare(_))
}

impl Body<'_> {
    /// What there is to look out for in the drawing.
    pub(super) fn look_over(&mut self) {
        let nodes = 0..self.graph.nodes.len();
        for node in nodes.clone() {
            for tag in self.reads(node) {
                self.facts.readers.entry(tag).or_default().push(node);
            }
            for tag in self.writes(node) {
                self.facts.writers.entry(tag).or_default().push(node);
            }
        }
        for (place, node) in self.facts.order.iter().enumerate() {
            self.facts.places[*node] = place;
        }
        self.facts.has_falls = nodes.clone().any(|node| self.falls(node));
        let is_block = |node: &usize| matches!(self.graph.nodes[*node].kind, Kind::Block { .. });
        let states = nodes.filter(is_block).flat_map(|node| self.writes(node));
        self.facts.has_turns = states
            .into_iter()
            .any(|tag| self.facts.readers.contains_key(&tag));
    }

    /// The tags that an element reads by name, in small letters.
    pub(super) fn reads(&self, node: usize) -> Vec<String> {
        let mut all = match &self.graph.nodes[node].kind {
            Kind::Contact(text, _) | Kind::Value(text, _) => self.tags(text),
            Kind::Block { code: Some(_), .. } => self.in_text(node, |(reads, _)| reads),
            _ => Vec::new(),
        };
        if !self.graph.feedback.is_empty() {
            let ends = self.graph.nodes[node].inputs.iter().flat_map(|pin| &pin.from);
            let back = ends.filter(|end| self.graph.feedback.contains(&(node, **end)));
            all.extend(back.flat_map(|end| self.writes(end.node)));
        }
        all
    }

    /// The tags that an element writes, and those that say which of them.
    pub(super) fn writes(&self, node: usize) -> Vec<String> {
        match &self.graph.nodes[node].kind {
            Kind::Coil(text, ..) | Kind::Variable(text, _) => self.tags(text),
            Kind::Block { code: Some(_), .. } => self.in_text(node, |(_, writes)| writes),
            Kind::Block { .. } => {
                let instance = self.tags.instances.get(&node).into_iter();
                let held = self.tags.fed_back.iter().filter(|(end, _)| end.node == node);
                let tags = instance.chain(held.map(|(_, tag)| tag));
                tags.map(|tag| tag.root.to_lowercase()).collect()
            }
            _ => Vec::new(),
        }
    }

    /// The tags of a text in ST.
    fn in_text<'b>(
        &'b self,
        node: usize,
        which: impl Fn((&'b HashSet<String>, &'b HashSet<String>)) -> &'b HashSet<String>,
    ) -> Vec<String> {
        let tags = self.tags_of_text(node).map(which);
        tags.into_iter().flatten().cloned().collect()
    }

    fn tags(&self, text: &str) -> Vec<String> {
        let operand = self.operand(text);
        operand.map_or_else(|_| Vec::new(), |operand| reads(&operand.value))
    }

    /// What feeds an element and does not stand in a network above.
    fn before(&self, root: usize) -> Before {
        let mut before = Before::default();
        // Each element is met when power is asked for there, and again when all that feeds it was met.
        let mut waiting = vec![(root, false)];
        while let Some((node, is_left)) = waiting.pop() {
            if is_left {
                before.turns.push(node);
                continue;
            }
            if self.graph.nodes[node].kind == Kind::LeftRail || !before.seen.insert(node) {
                continue;
            }
            before.reads.extend(self.reads(node));
            match self.graph.nodes[node].kind {
                Kind::Contact(_, modifier) if modifier.edge != Edge::None && !modifier.negated => {
                    before.turns.push(node);
                }
                Kind::Block { .. } if node != root && self.class(node).is_some_and(has_turn) => {
                    waiting.push((node, true));
                }
                _ => {}
            }
            let pins = self.graph.nodes[node].inputs.iter();
            let ends: Vec<&End> = pins.flat_map(|pin| &pin.from).collect();
            let ends = ends.into_iter().rev().filter(|end| {
                let is_above = self.state.executed[end.node] || self.tags.results.contains_key(end);
                !is_above && !self.graph.feedback.contains(&(node, **end))
            });
            waiting.extend(ends.map(|end| (end.node, false)));
        }
        before
    }

    /// Runs what feeds an element one by one, if it would run otherwise in one network.
    pub(super) fn take_turns(&mut self, node: usize) -> bool {
        if !self.facts.has_turns {
            return false;
        }
        let before = self.before(node);
        self.state.work += before.seen.len();
        let is_block = |node: &&usize| matches!(self.graph.nodes[**node].kind, Kind::Block { .. });
        let mut blocks = before.turns.iter().filter(is_block);
        if !blocks.any(|block| self.is_read_out_of_turn(*block, node, &before)) {
            return false;
        }
        self.flush();
        for (number, turn) in before.turns.iter().enumerate() {
            match self.graph.nodes[*turn].kind {
                Kind::Block { .. } => self.run_alone(*turn, &before.turns[number + 1..]),
                _ => self.see_edge(*turn),
            }
        }
        true
    }

    /// Whether something would read what a block writes at another time than it does in the source: not what comes after it in
    /// the wire, nor what leads to nothing but the block.
    fn is_read_out_of_turn(&self, block: usize, root: usize, before: &Before) -> bool {
        let written = self.writes(block);
        if !written.iter().any(|tag| before.reads.contains(tag)) {
            return false;
        }
        let reads = |node: &&usize| self.reads(**node).iter().any(|tag| written.contains(tag));
        let users = |node: usize| self.users(node).filter(|user| before.seen.contains(user));
        before.seen.iter().filter(reads).any(|reader| {
            let comes_after = match self.graph.nodes[*reader].kind {
                Kind::Value(..) => users(*reader).all(|user| self.comes_after(user, block)),
                // An edge is seen before all that feeds its contact.
                Kind::Contact(_, modifier) if modifier.edge != Edge::None && !modifier.negated => {
                    !self.is_fed_by(*reader, block) && self.comes_after(*reader, block)
                }
                _ => self.comes_after(*reader, block),
            };
            let mut past = HashSet::new();
            let mut waiting = vec![*reader];
            while let Some(node) = waiting.pop() {
                if node != block && past.insert(node) {
                    waiting.extend(users(node));
                }
            }
            !comes_after && past.contains(&root)
        })
    }

    /// Whether an element is after a block in the wire. What comes to a later pin of an AND is in series after the pins before.
    fn comes_after(&self, node: usize, block: usize) -> bool {
        let mut node = node;
        for _ in 0..self.graph.nodes.len() {
            if self.is_fed_by(node, block) {
                return true;
            }
            let mut users = self.users(node);
            let (Some(user), None) = (users.next(), users.next()) else {
                return false;
            };
            let Some(Class::Gate(gate)) = self.class(user) else {
                return false;
            };
            let is_here = |pin: &&Pin| pin.from.iter().any(|end| end.node == node);
            let earlier = self.graph.nodes[user]
                .inputs
                .iter()
                .take_while(|pin| !is_here(pin));
            let is_after = |end: &End| end.node == block || self.is_fed_by(end.node, block);
            if gate == Gate::And && earlier.flat_map(|pin| &pin.from).any(is_after) {
                return true;
            }
            node = user;
        }
        false
    }

    /// Whether power or a value comes to an element from a block.
    fn is_fed_by(&self, node: usize, block: usize) -> bool {
        let mut met = HashSet::new();
        let mut waiting = vec![node];
        while let Some(node) = waiting.pop() {
            let pins = self.graph.nodes[node].inputs.iter();
            for end in pins.flat_map(|pin| &pin.from) {
                if self.graph.feedback.contains(&(node, *end)) {
                    continue;
                }
                if end.node == block {
                    return true;
                }
                if met.insert(end.node) {
                    waiting.push(end.node);
                }
            }
        }
        false
    }

    /// Whether power or a value comes from a block to another pin of an element than this one.
    pub(super) fn feeds_another(&self, block: usize, node: usize, pin: usize) -> bool {
        let pins = self.graph.nodes[node].inputs.iter().enumerate();
        let mut ends = pins
            .filter(|(other, _)| *other != pin)
            .flat_map(|(_, other)| &other.from);
        ends.any(|end| end.node == block || self.is_fed_by(end.node, block))
    }

    /// Runs the blocks that feed an element, each in a network of its own.
    pub(super) fn run_blocks_before(&mut self, node: usize) {
        let turns = self.before(node).turns;
        for (number, turn) in turns.iter().enumerate() {
            if matches!(self.graph.nodes[*turn].kind, Kind::Block { .. }) {
                self.run_alone(*turn, &turns[number + 1..]);
            }
        }
    }

    /// Runs a block in a network of its own. A comparison has one if it reads what a later block writes.
    fn run_alone(&mut self, block: usize, later: &[usize]) {
        if self.class(block).is_some_and(Class::acts) {
            self.prepare(block);
            return self.execute(block);
        }
        let reads = self.before(block).reads;
        let is_written = later
            .iter()
            .flat_map(|turn| self.writes(*turn))
            .any(|tag| reads.contains(&tag));
        let output = power_output(self, block).unwrap_or(0);
        let end = End { node: block, output };
        if is_written && !self.tags.results.contains_key(&end) && !self.is_refused(block) {
            self.prepare(block);
            let tag = self.helper("decided", "BOOL", "what a condition decided");
            self.network(&[Target::End(end, tag)]);
        }
    }

    /// A tag is high while a contact sees its edge.
    fn see_edge(&mut self, contact: usize) {
        let Kind::Contact(_, modifier) = self.graph.nodes[contact].kind else {
            return;
        };
        if self.tags.edges.contains_key(&contact) || self.is_refused(contact) {
            return;
        }
        let (like, comment) = match modifier.edge {
            Edge::Falling => ("fell", "a contact sees that its tag falls"),
            _ => ("rose", "a contact sees that its tag rises"),
        };
        let tag = self.helper(like, "BOOL", comment);
        if self.network(&[Target::Edge(contact, tag.clone())]) {
            self.tags.edges.insert(contact, tag);
        }
    }

    /// The contacts of a network that see a fall somewhere in the wire, and not at its rail. There they would see none in the
    /// first scan, as the standard has it, so that a network above does.
    pub(super) fn falls_within(&self, root: usize, pin: Option<usize>) -> Vec<usize> {
        let mut falls = Vec::new();
        if !self.facts.has_falls {
            return falls;
        }
        let mut met = HashSet::new();
        let mut waiting = vec![(root, pin, true)];
        while let Some((node, only, is_at_rail)) = waiting.pop() {
            let drawn = &self.graph.nodes[node];
            if drawn.kind == Kind::LeftRail || !met.insert((node, is_at_rail)) {
                continue;
            }
            let is_first = is_at_rail
                && matches!(drawn.inputs.first().map(|pin| &pin.from[..]), Some([end]) if self.graph.nodes[end.node].kind == Kind::LeftRail);
            if self.falls(node) && !is_first && !falls.contains(&node) {
                falls.push(node);
            }
            let class = self.class(node);
            let pins = match (only, class) {
                (Some(pin), _) => vec![pin],
                (None, Some(class)) if class.acts() || matches!(class, Class::Compare(_)) => {
                    power_pins(self, node)
                }
                _ => (0..drawn.inputs.len()).collect(),
            };
            let is_series = only.is_none()
                && matches!(class, Some(class) if class.acts() || class == Class::Gate(Gate::And));
            for (number, pin) in pins.into_iter().enumerate() {
                let ends = drawn.inputs[pin].from.iter().filter(|end| {
                    let is_above = self.state.executed[end.node] || self.tags.results.contains_key(end);
                    !is_above && !self.graph.feedback.contains(&(node, **end))
                });
                waiting.extend(ends.map(|end| (end.node, None, is_at_rail && !(is_series && number > 0))));
            }
        }
        falls.sort_unstable();
        falls
    }

    fn falls(&self, node: usize) -> bool {
        let drawn = &self.graph.nodes[node];
        matches!(drawn.kind, Kind::Contact(_, modifier) if modifier.edge == Edge::Falling && !modifier.negated)
            && !self.tags.edges.contains_key(&node)
            && !self.tags.results.contains_key(&End { node, output: 0 })
    }

    /// Networks above the next one for the falls in it; comes back with their contacts.
    pub(super) fn see_falls(&mut self, targets: &[Target]) -> Vec<usize> {
        let mut seen = Vec::new();
        for target in targets {
            let (root, pin) = match target {
                Target::Root(node) => (*node, None),
                Target::Pin(node, pin, _) => (*node, Some(*pin)),
                Target::End(end, _) => (end.node, None),
                Target::Value(..) | Target::Edge(..) => continue,
            };
            for contact in self.falls_within(root, pin) {
                self.see_edge(contact);
                seen.push(contact);
            }
        }
        seen
    }

    /// Whether power that leaves an output comes to something that is in no network yet, and not in this one.
    pub(super) fn goes_on_from(&self, end: End, here: &HashSet<usize>) -> bool {
        let mut met = HashSet::new();
        let mut waiting: Vec<usize> = self.facts.uses.get(&end).cloned().unwrap_or_default();
        while let Some(user) = waiting.pop() {
            if !met.insert(user) || self.state.merged[user] {
                continue;
            }
            let is_root = self.is_root(user);
            if is_root && !here.contains(&user) && !self.state.executed[user] && !self.state.seen[user] {
                return true;
            }
            // Power goes through coils and stops at blocks.
            if !is_root || matches!(self.graph.nodes[user].kind, Kind::Coil(..)) {
                waiting.extend(self.users(user));
            }
        }
        false
    }

    /// Whether a variable takes the result of a block later than the block makes it: something that has its turn between the two
    /// reads or writes the same tag, and not only for the block.
    pub(super) fn is_written_later(&self, block: usize, user: usize, tag: &Path) -> bool {
        let end = Some(self.facts.places[user]).filter(|place| *place >= self.state.turn);
        let between = self.state.turn..end.unwrap_or(self.facts.order.len());
        let is_between = |node: usize| between.contains(&self.facts.places[node]);
        let tags = reads(&tag.into());
        let mut writers = tags
            .iter()
            .filter_map(|name| self.facts.writers.get(name))
            .flatten();
        if writers.any(|node| is_between(*node)) {
            return true;
        }
        let mut met = HashSet::new();
        let readers = tags
            .iter()
            .filter_map(|name| self.facts.readers.get(name))
            .flatten();
        let mut waiting: Vec<usize> = readers.copied().collect();
        while let Some(node) = waiting.pop() {
            if node == block || node == user || !met.insert(node) {
                continue;
            }
            if is_between(node) && self.is_root(node) {
                return true;
            }
            waiting.extend(self.users(node));
        }
        false
    }

    /// What takes what leaves an element.
    fn users(&self, node: usize) -> impl Iterator<Item = usize> {
        let outputs = 0..self.graph.nodes[node].outputs.len();
        let users = outputs.filter_map(move |output| self.facts.uses.get(&End { node, output }));
        users.flatten().copied()
    }

    /// Whether an element does something.
    fn is_root(&self, node: usize) -> bool {
        match self.graph.nodes[node].kind {
            Kind::Coil(..) | Kind::Variable(..) | Kind::Jump(..) | Kind::Return(_) => true,
            Kind::Block { .. } => self.class(node).is_some_and(Class::acts),
            _ => false,
        }
    }

    /// Whether what a condition decided goes on to something that is not here, and may have changed until then.
    pub(super) fn is_asked_again(&self, end: End, here: &HashSet<usize>) -> bool {
        let is_condition = self.class(end.node).is_some_and(|class| !class.acts());
        if !is_condition || !self.goes_on_from(end, here) {
            return false;
        }
        let before = self.before(end.node);
        before
            .reads
            .iter()
            .any(|tag| self.facts.writers.contains_key(tag))
    }
}
