//! A drawing as networks: what writes is taken in the order of the source, with all that feeds it; what is taken one
//! after the other and shares elements is one network, as long as that reads and writes as the source does.

use super::blocks::{self, Class, may_be_unread};
use super::draw::{Drawn, Target};
use super::state::{Facts, Next, State, Tags};
use super::texts::Texts;
use crate::expression::{self, Meaning, Typed};
use crate::graph::{End, Graph, Kind};
use crate::model::Evaluation;
use crate::scope::{Scope, Shared};
use ladder_format::Circuit;
use ladder_format::program::{Block, Declaration, Drawing, Element, Expression, Item, Network, Path};
use ladder_notation::{Outcome, Reading, UnreadParts};
use std::collections::{HashMap, HashSet};

/// What the networks of a unit are, and what they need.
pub(super) struct Made {
    pub(super) scope: Scope,
    pub(super) items: Vec<Item>,
    /// Tags that the source does not have: name, type, what for.
    pub(super) helpers: Vec<(String, String, String)>,
    /// The tags of a chart.
    pub(super) declared: Vec<Declaration>,
    /// The tags that are read by name, in small letters.
    pub(super) needed: HashSet<String>,
    /// What is not read of this unit and those before it.
    pub(super) unread: UnreadParts,
    /// The texts of actions and methods that boxes call, by their names in small letters.
    pub(super) actions: HashMap<String, String>,
    /// The actions whose texts are in the places of their calls, by their names in small letters.
    pub(super) in_place: HashSet<String>,
    /// The texts of boxes.
    pub(super) texts: Texts,
}

impl Made {
    pub(super) fn of(scope: Scope) -> Made {
        Made {
            scope,
            items: Vec::new(),
            helpers: Vec::new(),
            declared: Vec::new(),
            needed: HashSet::new(),
            unread: UnreadParts::default(),
            actions: HashMap::new(),
            in_place: HashSet::new(),
            texts: Texts::new(),
        }
    }
}

/// What feeds all that is done in a drawing has no more elements, each counted for all that it feeds.
const MOST_WORK: usize = 1_000_000;

/// No more points of a drawing are taken apart, each counted for all that it feeds.
const MOST_PIECES: usize = 2_000;

/// A drawing on its way.
pub(super) struct Body<'b> {
    pub(super) shared: &'b Shared<'b>,
    pub(super) graph: &'b Graph,
    pub(super) made: &'b mut Made,
    pub(super) reading: &'b mut Reading,
    pub(super) facts: Facts,
    pub(super) tags: Tags,
    pub(super) state: State,
    pub(super) next: Next,
}

impl<'b> Body<'b> {
    /// The networks of a drawing.
    pub(super) fn draw(
        shared: &'b Shared<'b>,
        graph: &'b Graph,
        made: &'b mut Made,
        reading: &'b mut Reading,
    ) {
        let mut body = Body {
            shared,
            graph,
            made,
            reading,
            facts: Facts::of(graph),
            tags: Tags::default(),
            state: State::of(graph.nodes.len()),
            next: Next::default(),
        };
        body.names();
        body.hold_what_feeds_back();
        body.look_over();
        while let Some(node) = body.facts.order.get(body.state.turn).copied() {
            body.element(node);
            body.state.turn += 1;
        }
        body.flush();
        body.last_labels();
        body.lost();
        let left = std::mem::take(&mut body.next.comments);
        if !left.is_empty() {
            body.made.items.push(Item::Blank);
            body.made.items.extend(left.into_iter().map(Item::Comment));
        }
        body.report();
    }

    pub(super) fn meaning(&self) -> Meaning<'_> {
        Meaning {
            shared: self.shared,
            scope: &self.made.scope,
        }
    }

    /// The operand that an expression is.
    pub(super) fn operand(&self, text: &str) -> Result<Typed, String> {
        expression::operand(text, self.meaning())
    }

    /// The tag that an expression is, or the part of one.
    pub(super) fn variable(&self, text: &str) -> Result<Path, String> {
        match self.operand(text)?.value {
            Expression::Path(path) => Ok(path),
            _ => Err("it is no variable".to_owned()),
        }
    }

    /// A tag that the source does not have.
    pub(super) fn helper(&mut self, like: &str, ty: &str, comment: &str) -> Path {
        let name = self.made.scope.fresh(like);
        self.made
            .helpers
            .push((name.clone(), ty.to_owned(), comment.to_owned()));
        Path::tag(name)
    }

    /// One element, in the order of execution.
    fn element(&mut self, node: usize) {
        let drawn = &self.graph.nodes[node];
        let end = End { node, output: 0 };
        let unused = drawn
            .outputs
            .iter()
            .enumerate()
            .all(|(output, _)| !self.facts.uses.contains_key(&End { node, output }));
        match &drawn.kind {
            Kind::LeftRail | Kind::RightRail => {}
            Kind::Comment(text) if text.is_empty() => {}
            // A comment after something was begun is about what comes next.
            Kind::Comment(text) if !self.next.group.is_empty() => self.next.further.push(text.clone()),
            Kind::Comment(text) => self.next.comments.push(text.clone()),
            Kind::Label(name) => {
                self.flush();
                let origin = self.reading.origin(drawn.place);
                let block = Block::label(&crate::scope::member(name));
                self.push(Circuit::Element(Element::of(block, Some(origin))));
            }
            Kind::Coil(..) | Kind::Variable(..) | Kind::Jump(..) | Kind::Return(_) => self.root(node),
            Kind::Contact(..) => {
                if unused {
                    self.root(node);
                }
            }
            Kind::Joint => {
                if unused && !drawn.inputs.is_empty() {
                    self.root(node);
                }
            }
            Kind::Block { .. } if self.has_text(node) => self.run_text(node),
            Kind::Block { .. } => {
                if self.class(node).is_some_and(Class::acts) || unused {
                    self.root(node);
                }
                self.decide(node);
            }
            Kind::Value(text, _) => {
                if !self.facts.uses.contains_key(&end) {
                    let text = text.clone();
                    self.note(node, "nothing is wired to it: it is a comment");
                    self.next
                        .comments
                        .push(format!("{text}, which nothing is wired to"));
                }
            }
            Kind::Other(what) => {
                self.next
                    .comments
                    .push(format!("{what}, which has no counterpart here"));
                self.refuse(node, "it has no counterpart");
            }
        }
    }

    /// Something that is done.
    fn root(&mut self, node: usize) {
        if self.state.executed[node] || self.state.merged[node] {
            return;
        }
        let mut own = HashSet::new();
        self.feeds(node, &mut own);
        self.state.work += own.len();
        if self.state.work > MOST_WORK {
            self.lose(node, "the drawing is larger than what can be read");
            return;
        }
        if self.take_turns(node) {
            self.flush();
            self.prepare(node);
            if !self.state.executed[node] && !self.state.merged[node] {
                self.next.group.push(node);
                self.flush();
            }
            self.tags.edges.clear();
            return;
        }
        self.prepare(node);
        if !self.goes_on(node, &own) {
            self.flush();
        }
        if self.state.executed[node] || self.state.merged[node] {
            return;
        }
        self.next.shown.extend(own);
        self.next.group.push(node);
    }

    /// Whether what feeds an element belongs into the network so far: something of it is there, and reads nothing
    /// that is written in it before. Else all of it is read again.
    fn goes_on(&self, node: usize, own: &HashSet<usize>) -> bool {
        let mut both = own.intersection(&self.next.shown).peekable();
        if both.peek().is_none() {
            return self.next.group.is_empty();
        }
        if self.shared.evaluation == Evaluation::Once {
            return true;
        }
        let written: HashSet<String> = self
            .next
            .group
            .iter()
            .flat_map(|node| self.writes(*node))
            .collect();
        let is_written = |node: &usize| self.reads(*node).iter().any(|tag| written.contains(tag));
        !both.any(is_written) && !self.falls_within(node, None).iter().any(is_written)
    }

    /// All elements that power goes through on its way to an element.
    pub(super) fn feeds(&self, node: usize, all: &mut HashSet<usize>) {
        let mut waiting = vec![node];
        while let Some(node) = waiting.pop() {
            if self.graph.nodes[node].kind == Kind::LeftRail || !all.insert(node) {
                continue;
            }
            let inputs = &self.graph.nodes[node].inputs;
            let pins = match self.class(node) {
                Some(class) if class.acts() || matches!(class, Class::Compare(_)) => {
                    blocks::power_pins(self, node)
                }
                _ => (0..inputs.len()).collect(),
            };
            let ends = pins.into_iter().flat_map(|pin| &inputs[pin].from);
            waiting.extend(
                ends.map(|end| end.node)
                    .filter(|node| !self.state.executed[*node]),
            );
        }
    }

    /// The network so far is written.
    pub(super) fn flush(&mut self) {
        let group = std::mem::take(&mut self.next.group);
        self.next.shown.clear();
        if group.is_empty() {
            return;
        }
        self.write(group);
        let next = std::mem::take(&mut self.next.further);
        self.next.comments.extend(next);
    }

    fn write(&mut self, group: Vec<usize>) {
        let ends = self.without_passed(&group);
        if ends.len() < group.len() {
            let targets: Vec<Target> = ends.into_iter().map(Target::Root).collect();
            if self.network(&targets) {
                return;
            }
        }
        let targets: Vec<Target> = group.iter().map(|node| Target::Root(*node)).collect();
        if self.network(&targets) {
            return;
        }
        for target in targets {
            if let Target::Root(node) = target {
                self.run_blocks_before(node);
                if self.state.executed[node] {
                    continue;
                }
            }
            if !self.network(std::slice::from_ref(&target)) {
                self.in_pieces(target);
            }
        }
    }

    /// Of what a network does without the blocks that power goes through on its way to the others: they are drawn there, in the
    /// order of the wires. A contact that reads what such a block writes has to come after it.
    fn without_passed(&self, group: &[usize]) -> Vec<usize> {
        let mut passed = HashSet::new();
        for (number, node) in group.iter().enumerate().rev() {
            if passed.contains(node) {
                continue;
            }
            let mut own = HashSet::new();
            self.feeds(*node, &mut own);
            let is_read = |block: &usize| {
                let written = self.writes(*block);
                own.iter()
                    .any(|other| self.reads(*other).iter().any(|tag| written.contains(tag)))
            };
            let before = group[..number].iter().filter(|other| own.contains(other));
            let blocks = before.filter(|other| matches!(self.graph.nodes[**other].kind, Kind::Block { .. }));
            passed.extend(blocks.copied().filter(|block| !is_read(block)));
        }
        group
            .iter()
            .copied()
            .filter(|node| !passed.contains(node))
            .collect()
    }

    /// Draws a network, if it can be drawn as one, and above it what sees the falls in it.
    pub(super) fn network(&mut self, targets: &[Target]) -> bool {
        let (items, helpers) = (self.made.items.len(), self.made.helpers.len());
        let unread = self.made.unread.len();
        let (comments, labels) = (self.next.comments.clone(), self.next.labels.clone());
        let falls = self.see_falls(targets);
        let is_drawn = self.one_network(targets);
        for contact in falls {
            self.tags.edges.remove(&contact);
        }
        if !is_drawn {
            self.made.items.truncate(items);
            self.made.helpers.truncate(helpers);
            self.made.unread.truncate(unread);
            self.next.comments = comments;
            self.next.labels = labels;
        }
        is_drawn
    }

    fn one_network(&mut self, targets: &[Target]) -> bool {
        loop {
            match Drawn::of(self, targets) {
                Ok(Some(drawn)) => {
                    for node in drawn.executed {
                        self.state.executed[node] = true;
                    }
                    drawn
                        .shown
                        .into_iter()
                        .for_each(|node| self.state.seen[node] = true);
                    self.tags.results.extend(drawn.results);
                    if let Some(circuit) = drawn.circuit {
                        self.push(circuit);
                    }
                    return true;
                }
                Ok(None) => return false,
                // What is refused and still cannot be passed over ends the network.
                Err((node, _)) if self.is_refused(node) => return false,
                Err((node, why)) => self.refuse(node, why),
            }
        }
    }

    /// A network that is not of series and branches: power at its points goes into tags, one network each.
    pub(super) fn in_pieces(&mut self, target: Target) {
        let node = match target {
            Target::Root(node) | Target::Pin(node, ..) | Target::Edge(node, _) => node,
            Target::End(end, _) | Target::Value(end, _) => end.node,
        };
        self.run_blocks_before(node);
        self.next.is_in_pieces = true;
        let mut cuts = Vec::new();
        let ends = self.ends_before(node);
        self.state.pieces += ends.len();
        let ends = if self.state.pieces > MOST_PIECES {
            Vec::new()
        } else {
            ends
        };
        // What a condition decided holds for all that asks for it, and power at a point for this drawing alone: that a point has a tag
        // settles nothing of what comes after it.
        let here = HashSet::from([node]);
        let lasting: Vec<bool> = ends.iter().map(|end| self.is_asked_again(*end, &here)).collect();
        for (end, lasts) in ends.into_iter().zip(lasting) {
            let several = self.facts.uses.get(&end).is_some_and(|uses| uses.len() > 1);
            if (several || lasts) && !self.tags.results.contains_key(&end) && self.has_power(end) {
                let (like, comment) = if lasts {
                    ("decided", "what a condition decided")
                } else {
                    ("point", "power at a point of the drawing")
                };
                let tag = self.helper(like, "BOOL", comment);
                if self.network(&[Target::End(end, tag)]) && !lasts {
                    cuts.push(end);
                }
            }
        }
        if !self.network(std::slice::from_ref(&target)) {
            self.lose(node, "the drawing is larger than what can be drawn");
        }
        self.next.is_in_pieces = false;
        for end in cuts {
            self.tags.results.remove(&end);
        }
    }

    /// Whether power leaves an output, and not a value that a tag holds anyway.
    fn has_power(&self, end: End) -> bool {
        match self.graph.nodes[end.node].kind {
            Kind::Contact(..) | Kind::Joint => true,
            Kind::Block { .. } => self.class(end.node).is_some_and(|class| !class.acts()),
            _ => false,
        }
    }

    /// The outputs that feed an element, each after those that feed it.
    fn ends_before(&self, node: usize) -> Vec<End> {
        let mut done = HashSet::new();
        let mut out = Vec::new();
        let mut stack = vec![(node, false)];
        while let Some((node, is_seen)) = stack.pop() {
            if is_seen {
                let output = blocks::power_output(self, node).unwrap_or(0);
                out.push(End { node, output });
                continue;
            }
            if !done.insert(node) {
                continue;
            }
            stack.push((node, true));
            for end in self.graph.nodes[node].inputs.iter().flat_map(|pin| &pin.from) {
                let is_feedback = self.graph.feedback.contains(&(node, *end));
                if !is_feedback && !self.state.executed[end.node] {
                    stack.push((end.node, false));
                }
            }
        }
        out.pop();
        out
    }

    pub(super) fn push(&mut self, circuit: Circuit<Element>) {
        let mut parts = std::mem::take(&mut self.next.labels);
        let circuit = match circuit {
            circuit if parts.is_empty() => circuit,
            Circuit::Series(own) => {
                parts.extend(own);
                Circuit::Series(parts)
            }
            own => {
                parts.push(own);
                Circuit::Series(parts)
            }
        };
        self.made.items.push(Item::Blank);
        self.made.items.push(Item::Network(Network {
            comments: std::mem::take(&mut self.next.comments),
            drawing: Drawing::Circuit(circuit),
        }));
    }

    /// An element stays as a comment.
    pub(super) fn refuse(&mut self, node: usize, why: impl Into<String>) {
        self.state.outcomes[node] = Some(Outcome::Refused(why.into()));
    }

    /// Whether an element is a comment.
    pub(super) fn is_refused(&self, node: usize) -> bool {
        matches!(self.state.outcomes[node], Some(Outcome::Refused(_)))
    }

    /// An element that is in no network.
    pub(super) fn lose(&mut self, node: usize, why: &str) {
        self.refuse(node, why);
        self.next.comments.push(format!(
            "{}: not translated",
            blocks::shown(&self.graph.nodes[node])
        ));
    }

    /// An element says nearly the same.
    pub(super) fn note(&mut self, node: usize, why: &str) {
        let outcome = &mut self.state.outcomes[node];
        if outcome.is_none() {
            *outcome = Some(Outcome::Approximated(why.to_owned()));
        }
    }

    pub(super) fn class(&self, node: usize) -> Option<Class> {
        blocks::class(self, node)
    }

    /// What is nowhere is not left out in silence.
    fn lost(&mut self) {
        for node in 0..self.graph.nodes.len() {
            let is_told =
                self.state.seen[node] || self.state.merged[node] || self.state.outcomes[node].is_some();
            let draws = !matches!(
                self.graph.nodes[node].kind,
                Kind::LeftRail
                    | Kind::RightRail
                    | Kind::Joint
                    | Kind::Label(_)
                    | Kind::Comment(_)
                    | Kind::Other(_)
            );
            if draws && !is_told && self.is_of_unread(node) {
                self.state.seen[node] = true;
            } else if draws && !is_told {
                self.refuse(node, "it is part of what is not translated");
                self.next.comments.push(format!(
                    "{}: not translated",
                    blocks::shown(&self.graph.nodes[node])
                ));
            }
        }
    }

    fn report(&mut self) {
        for (node, outcome) in std::mem::take(&mut self.state.outcomes).into_iter().enumerate() {
            let drawn = &self.graph.nodes[node];
            let shown = blocks::shown(drawn);
            let report = &mut self.reading.report;
            match outcome {
                None => report.translated(drawn.place, shown),
                Some(Outcome::Approximated(why)) => report.approximated(drawn.place, shown, why),
                Some(Outcome::Refused(why)) if self.state.seen[node] && may_be_unread(&drawn.kind) => {
                    report.approximated(drawn.place, shown, format!("{why}: it is not run"));
                }
                Some(Outcome::Refused(why)) => report.refused(drawn.place, shown, why),
                Some(Outcome::Translated) => {}
            }
        }
    }
}
