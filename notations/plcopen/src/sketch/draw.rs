//! One network: everything that feeds what is done in it, as wires between points.

mod hold;

use super::blocks::{Class, power_output, power_pins};
use super::body::Body;
use crate::graph::{Edge, End, Kind, Modifier};
use ladder_format::Circuit;
use ladder_format::program::{Block, Element, Expression, Path};
use ladder_instructions::Op;
use ladder_notation::circuit::{Wires, in_order};
use std::collections::{HashMap, HashSet};

/// What a network is for.
#[derive(Debug, Clone)]
pub(super) enum Target {
    /// Something that is done.
    Root(usize),
    /// The power at a pin goes into a tag.
    Pin(usize, usize, Path),
    /// The power that leaves an element goes into a tag.
    End(End, Path),
    /// The value of an expression goes into a tag.
    Value(End, Path),
    /// What a contact sees of its tag's edges goes into a tag.
    Edge(usize, Path),
}

/// A network has no more elements.
const MOST_ELEMENTS: usize = 256;

/// A network has no more characters, were each of its branches a line as long as all of its elements.
const MOST_CHARACTERS: usize = 400_000;

/// The same of all networks of a drawing.
const MOST_IN_ALL: usize = 8_000_000;

/// No more wires end at one pin.
const MOST_BRANCHES: usize = 200;

/// The number of the left rail.
pub(super) const RAIL: usize = Wires::SOURCE;

/// Why something cannot be drawn: which element, and why.
pub(super) type Refused = (usize, String);

/// What was made for an element, or why it cannot be drawn.
pub(super) fn at<T>(node: usize, made: Result<T, impl Into<String>>) -> Result<T, Refused> {
    made.map_err(|why| (node, why.into()))
}

/// `[ ]( tag )`, negated `[/]( tag )`
pub(super) fn contact_on(tag: impl Into<Expression>, is_negated: bool) -> Block {
    if is_negated {
        Block::negated_contact(tag)
    } else {
        Block::contact(tag)
    }
}

/// A network that was drawn.
pub(super) struct Drawn {
    /// None: nothing is in it.
    pub(super) circuit: Option<Circuit<Element>>,
    /// The blocks in it.
    pub(super) executed: Vec<usize>,
    /// All elements in it.
    pub(super) shown: HashSet<usize>,
    /// The tags that hold what leaves them.
    pub(super) results: Vec<(End, Path)>,
}

/// A network on its way.
pub(super) struct Pencil<'d, 'b> {
    pub(super) body: &'d mut Body<'b>,
    elements: Vec<Element>,
    wires: Vec<(usize, usize, Vec<usize>)>,
    points: usize,
    /// The points that outputs are, from which point on.
    ends: HashMap<(End, usize), usize>,
    pins: HashMap<(usize, usize, usize), usize>,
    /// The points where several outputs come together, from which point on.
    joins: HashMap<(Vec<End>, usize), usize>,
    /// The points after coils and blocks.
    after: HashMap<usize, usize>,
    executed: Vec<usize>,
    pub(super) shown: HashSet<usize>,
    /// What is done in it.
    done: HashSet<usize>,
    /// The pins of which it puts the power into tags.
    put: Vec<(usize, usize)>,
    held: Vec<(End, Path)>,
}

impl Drawn {
    /// Draws a network. None: it is not made of series and branches in the order in which it runs, or is too large.
    ///
    /// # Errors
    ///
    /// If an element of it has no counterpart.
    pub(super) fn of(body: &mut Body<'_>, targets: &[Target]) -> Result<Option<Drawn>, Refused> {
        let helpers = body.made.helpers.len();
        if let Some(drawn) = Drawn::holding(body, targets, true)? {
            return Ok(Some(drawn));
        }
        // What conditions decide may not be held where it stands: then it is in pieces, and in the end they are asked again.
        let is_held = body.made.helpers.len() > helpers;
        body.made.helpers.truncate(helpers);
        if is_held && !body.next.is_in_pieces {
            return Ok(None);
        }
        Drawn::holding(body, targets, false)
    }

    fn holding(
        body: &mut Body<'_>,
        targets: &[Target],
        with_conditions: bool,
    ) -> Result<Option<Drawn>, Refused> {
        let mut pencil = Pencil {
            body,
            elements: Vec::new(),
            wires: Vec::new(),
            points: 0,
            ends: HashMap::new(),
            pins: HashMap::new(),
            joins: HashMap::new(),
            after: HashMap::new(),
            executed: Vec::new(),
            shown: HashSet::new(),
            done: HashSet::new(),
            put: Vec::new(),
            held: Vec::new(),
        };
        for target in targets {
            pencil.target(target)?;
        }
        pencil.hold_what_goes_on();
        if with_conditions {
            pencil.hold_what_was_decided();
        }
        let Pencil {
            elements,
            wires,
            points,
            executed,
            shown,
            held,
            ..
        } = pencil;
        let length: usize = elements.iter().map(|element| element.to_string().len() + 4).sum();
        let characters = length * wires.len();
        body.state.characters += characters;
        if elements.len() > MOST_ELEMENTS
            || characters > MOST_CHARACTERS
            || body.state.characters > MOST_IN_ALL
        {
            return Ok(None);
        }
        let done = |circuit| Drawn {
            circuit,
            executed,
            shown,
            results: held,
        };
        if elements.is_empty() {
            return Ok(Some(done(None)));
        }
        let mut all = Wires::new(points);
        for (from, to, elements) in wires {
            all.add(from, to, elements);
        }
        let circuit = all.into_circuit().filter(in_order);
        let element = |number: usize| Circuit::Element(elements[number].clone());
        Ok(circuit.map(|circuit| done(Some(circuit.replaced(&element)))))
    }
}

impl Pencil<'_, '_> {
    fn target(&mut self, target: &Target) -> Result<(), Refused> {
        match target {
            Target::Root(node) => self.root(*node),
            Target::Pin(node, pin, tag) => {
                self.done.insert(*node);
                self.put.push((*node, *pin));
                let before = self.pin(*node, *pin, RAIL)?;
                self.series(before, [Block::coil(tag)], *node);
                Ok(())
            }
            Target::End(end, tag) => {
                let before = self.end(*end, RAIL)?;
                self.series(before, [Block::coil(tag)], end.node);
                self.held.push((*end, tag.clone()));
                Ok(())
            }
            Target::Edge(node, tag) => {
                if let Kind::Contact(text, modifier) = &self.body.graph.nodes[*node].kind {
                    let contacts = self.contact(*node, text, *modifier, true)?;
                    self.series(RAIL, contacts.into_iter().chain([Block::coil(tag)]), *node);
                }
                Ok(())
            }
            Target::Value(end, tag) => {
                self.shown.insert(end.node);
                if let Kind::Value(text, _) = &self.body.graph.nodes[end.node].kind {
                    let operand = at(end.node, self.body.operand(text))?;
                    let block = at(end.node, Block::of(Op::Calc, [tag.into(), operand.value]))?;
                    self.series(RAIL, [block], end.node);
                }
                Ok(())
            }
        }
    }

    /// Wires from points to another, which has the power of all.
    pub(super) fn join(&mut self, points: Vec<usize>, to: usize) {
        self.wires
            .extend(points.into_iter().map(|from| (from, to, Vec::new())));
    }

    pub(super) fn point(&mut self) -> usize {
        self.points += 1;
        Wires::point(self.points - 1)
    }

    /// Blocks one after the other, from a point on; comes back where they end.
    pub(super) fn series(
        &mut self,
        from: usize,
        blocks: impl IntoIterator<Item = Block>,
        node: usize,
    ) -> usize {
        let origin = self.body.reading.origin(self.body.graph.nodes[node].place);
        let elements = blocks.into_iter().map(|block| Element::of(block, Some(origin)));
        self.elements_from(from, elements)
    }

    fn elements_from(&mut self, from: usize, elements: impl IntoIterator<Item = Element>) -> usize {
        let first = self.elements.len();
        self.elements.extend(elements);
        let numbers: Vec<usize> = (first..self.elements.len()).collect();
        if numbers.is_empty() {
            return from;
        }
        let to = self.point();
        self.wires.push((from, to, numbers));
        to
    }

    /// An unread part in the place of an element, or a comment where nothing is to be run.
    pub(super) fn stand_in(&mut self, from: usize, node: usize) -> usize {
        if let Some(block) = self.body.unread_element(node) {
            return self.series(from, [block], node);
        }
        let shown = super::blocks::shown(&self.body.graph.nodes[node]);
        let shown = crate::scope::short(&shown);
        let origin = self.body.reading.origin(self.body.graph.nodes[node].place);
        let comment = Element::comment(&format!("{shown}: not translated"), Some(origin));
        self.elements_from(from, [comment])
    }

    /// Something that is done.
    fn root(&mut self, node: usize) -> Result<(), Refused> {
        self.shown.insert(node);
        self.done.insert(node);
        let kind = &self.body.graph.nodes[node].kind;
        if self.body.is_refused(node) && !matches!(kind, Kind::Block { .. } | Kind::Contact(..)) {
            let before = self.pin(node, 0, RAIL)?;
            self.stand_in(before, node);
            return Ok(());
        }
        match kind {
            Kind::Coil(text, modifier, storage) => {
                let (modifier, storage) = (*modifier, *storage);
                let tag = self.variable(node, text)?;
                let before = self.pin(node, 0, RAIL)?;
                let (blocks, passes_on) = self.coil(node, &tag, modifier, storage)?;
                let after = self.series(before, blocks, node);
                if passes_on {
                    self.after.insert(node, after);
                }
            }
            Kind::Variable(text, negated) => {
                if let Some(value) = self.body.tags.operands.get(&(node, 0)).cloned() {
                    let block = at(node, self.body.moved(text, *negated, value))?;
                    let before = match self.body.tags.guards.get(&node).copied() {
                        Some(end) => self.end(end, RAIL)?,
                        None => RAIL,
                    };
                    self.series(before, [block], node);
                } else {
                    let op = match negated {
                        true => Op::NegatedCoil,
                        false if self.body.takes_own_enable(node) => Op::SetCoil,
                        false => Op::Coil,
                    };
                    let coil = at(node, Block::of(op, [self.variable(node, text)?]))?;
                    let before = self.pin(node, 0, RAIL)?;
                    self.series(before, [coil], node);
                }
            }
            Kind::Jump(label, negated) => {
                let jump = Block::jump(&crate::scope::member(label));
                let negated = negated.then(Block::inverter);
                let before = self.pin(node, 0, RAIL)?;
                self.series(before, negated.into_iter().chain([jump]), node);
            }
            Kind::Return(negated) => {
                let negated = negated.then(Block::inverter);
                let before = self.pin(node, 0, RAIL)?;
                self.series(before, negated.into_iter().chain([Block::ret()]), node);
            }
            Kind::Block { .. } if self.body.class(node).is_some_and(Class::acts) => {
                self.block(node)?;
            }
            _ => {
                self.end(End { node, output: 0 }, RAIL)?;
            }
        }
        Ok(())
    }

    /// The tag of a coil or variable.
    fn variable(&self, node: usize, text: &str) -> Result<Path, Refused> {
        at(node, self.body.variable(text))
    }

    /// The point that a pin is. `start` is where power comes from in the place of the rail.
    pub(super) fn pin(&mut self, node: usize, pin: usize, start: usize) -> Result<usize, Refused> {
        if let Some(point) = self.pins.get(&(node, pin, start)) {
            return Ok(*point);
        }
        if self.elements.len() > MOST_ELEMENTS {
            return Ok(start);
        }
        let graph = self.body.graph;
        let (from, modifier) = match graph.nodes[node].inputs.get(pin) {
            Some(pin) => (pin.from.as_slice(), pin.modifier),
            None => (&[][..], Modifier::default()),
        };
        if modifier.negated
            && modifier.edge == Edge::None
            && let Some(point) = self.inverted(node, pin, start)?
        {
            return Ok(point);
        }
        if modifier != Modifier::default()
            && start != RAIL
            && let Some(operand) = self.body.tags.operands.get(&(node, pin))
        {
            let contact = Block::contact(operand.value.clone());
            return Ok(self.series(start, [contact], node));
        }
        let mut point = match from {
            [] => {
                self.body
                    .note(node, "nothing is wired to it: no power comes there");
                self.series(start, [Block::contact(Path::system("OFF"))], node)
            }
            [end] => self.source(node, *end, start)?,
            ends if ends.len() > MOST_BRANCHES => {
                return Err((node, format!("more than {MOST_BRANCHES} wires end at it")));
            }
            ends => {
                let mut points = Vec::new();
                for end in ends {
                    points.push(self.source(node, *end, start)?);
                }
                // The same wires that end at two pins are one point.
                let known = self.joins.get(&(ends.to_vec(), start)).copied();
                known.unwrap_or_else(|| {
                    let point = self.point();
                    self.join(points, point);
                    // Where a tag holds one of them, each pin has a contact of its own.
                    if !ends.iter().any(|end| self.has_tag(*end)) {
                        self.joins.insert((ends.to_vec(), start), point);
                    }
                    point
                })
            }
        };
        if modifier.negated {
            point = self.series(point, [Block::inverter()], node);
        }
        point = match modifier.edge {
            Edge::None => point,
            Edge::Rising => self.series(point, [Block::one_shot()], node),
            Edge::Falling => self.series(point, [Block::inverter(), Block::one_shot()], node),
        };
        self.pins.insert((node, pin, start), point);
        Ok(point)
    }

    pub(super) fn source(&mut self, node: usize, end: End, start: usize) -> Result<usize, Refused> {
        if self.body.graph.feedback.contains(&(node, end)) {
            return self.referenced(end, start);
        }
        self.end(end, start)
    }

    /// A contact on the tag that holds what leaves an output.
    fn referenced(&mut self, end: End, start: usize) -> Result<usize, Refused> {
        if self.body.is_refused(end.node) {
            return Ok(self.stand_in(start, end.node));
        }
        let tag = at(end.node, self.body.reference(end))?;
        let output = &self.body.graph.nodes[end.node].outputs.get(end.output);
        // What a condition decided is held as it leaves.
        let acts = self.body.class(end.node).is_some_and(Class::acts);
        let is_negated = acts && output.is_some_and(|output| output.negated);
        if tag == Path::system("ON") && !is_negated {
            return Ok(start);
        }
        Ok(self.series(start, [contact_on(tag, is_negated)], end.node))
    }

    /// Whether a tag holds what leaves an output. Tags that the source has count only where the drawing is taken apart.
    fn has_tag(&self, end: End) -> bool {
        let is_named = match self.body.graph.nodes[end.node].kind {
            Kind::Value(..) | Kind::Variable(..) => true,
            Kind::Block { .. } => self.body.state.executed[end.node],
            _ => false,
        };
        self.body.tags.results.contains_key(&end) || (self.body.next.is_in_pieces && is_named)
    }

    /// The point that an output is.
    fn end(&mut self, end: End, start: usize) -> Result<usize, Refused> {
        if let Some(point) = self.ends.get(&(end, start)) {
            return Ok(*point);
        }
        let point = self.find_end(end, start)?;
        // Where a tag holds it, each that takes it has a contact of its own.
        if !self.has_tag(end) {
            self.ends.insert((end, start), point);
        }
        Ok(point)
    }

    fn find_end(&mut self, end: End, start: usize) -> Result<usize, Refused> {
        let node = end.node;
        let graph = self.body.graph;
        self.shown.insert(node);
        match &graph.nodes[node].kind {
            Kind::LeftRail => Ok(start),
            Kind::RightRail | Kind::Label(_) | Kind::Comment(_) | Kind::Other(_) => {
                Ok(self.stand_in(start, node))
            }
            Kind::Contact(text, modifier) => {
                if let Some(point) = self.held_before(end, start) {
                    return Ok(point);
                }
                let before = self.pin(node, 0, start)?;
                if self.body.is_refused(node) {
                    return Ok(self.stand_in(before, node));
                }
                let contacts = match self.body.tags.edges.get(&node) {
                    Some(tag) => vec![Block::contact(tag)],
                    None => self.contact(node, text, *modifier, before == RAIL)?,
                };
                Ok(self.series(before, contacts, node))
            }
            Kind::Coil(..) => match self.after.get(&node) {
                Some(point) if start == RAIL => Ok(*point),
                _ => self.pin(node, 0, start),
            },
            Kind::Joint | Kind::Jump(..) | Kind::Return(_) => match self.held_before(end, start) {
                Some(point) => Ok(point),
                None => self.pin(node, 0, start),
            },
            Kind::Value(text, negated) => self.value(end, text, *negated, start),
            Kind::Variable(text, negated) => {
                let contact = contact_on(self.variable(node, text)?, *negated);
                Ok(self.series(start, [contact], node))
            }
            Kind::Block { .. } => self.block_end(end, start),
        }
    }

    /// A contact on the tag that a network above put the power of an output into.
    fn held_before(&mut self, end: End, start: usize) -> Option<usize> {
        let contact = Block::contact(self.body.tags.results.get(&end)?);
        Some(self.series(start, [contact], end.node))
    }

    fn block_end(&mut self, end: End, start: usize) -> Result<usize, Refused> {
        let node = end.node;
        let Some(class) = self.body.class(node) else {
            return Ok(start);
        };
        let is_negated = self.body.graph.nodes[node]
            .outputs
            .get(end.output)
            .is_some_and(|output| output.negated);
        if !class.acts() {
            if let Some(point) = self.held_before(end, start) {
                return Ok(point);
            }
            let point = self.condition(node, class, start)?;
            return Ok(if is_negated {
                self.series(point, [Block::inverter()], node)
            } else {
                point
            });
        }
        let is_power = power_output(self.body, node) == Some(end.output);
        if class == Class::Text && !self.body.state.executed[node] && !self.after.contains_key(&node) {
            return Err((node, "its text would have to run within a network".to_owned()));
        }
        if self.body.state.executed[node] || !is_power || start != RAIL {
            return self.referenced(end, start);
        }
        let point = self.block(node)?;
        Ok(if is_negated {
            self.series(point, [Block::inverter()], node)
        } else {
            point
        })
    }

    /// A block that does something, from the rail on; comes back where its power leaves.
    fn block(&mut self, node: usize) -> Result<usize, Refused> {
        if let Some(point) = self.after.get(&node) {
            return Ok(*point);
        }
        self.shown.insert(node);
        let mut point = RAIL;
        let pins = power_pins(self.body, node);
        if pins.len() > 1 {
            self.body.note(
                node,
                "without EN it stands still there; here EN and its first input are in series",
            );
        }
        let enabled = self.body.enable_taken(node);
        for pin in pins {
            let held = enabled.filter(|(enable, _)| *enable == pin);
            let held = held.and_then(|(_, end)| self.body.tags.results.get(&end).cloned());
            point = match held {
                Some(tag) => self.series(point, [Block::contact(tag)], node),
                None => self.pin(node, pin, point)?,
            };
        }
        let point = if self.body.is_refused(node) {
            self.stand_in(point, node)
        } else if self.body.has_text(node) {
            self.text(node, point)
        } else {
            let mut blocks = at(node, self.body.blocks(node))?;
            blocks.extend(self.body.tags.moves.get(&node).into_iter().flatten().cloned());
            self.series(point, blocks, node)
        };
        self.executed.push(node);
        self.done.insert(node);
        self.after.insert(node, point);
        let output = power_output(self.body, node);
        let end = output.map(|output| End { node, output });
        let feeds_back = self
            .body
            .graph
            .feedback
            .iter()
            .any(|(_, other)| Some(*other) == end);
        if let Some(end) = end.filter(|_| feeds_back || self.body.is_read_by_name(node)) {
            self.hold(end);
        }
        Ok(point)
    }
}
