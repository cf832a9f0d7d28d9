//! The drawing of the program that runs, line by line: its elements, what its contacts look at, and the tags that its
//! operands name. Nothing is computed for lines that nobody asks for.

use std::collections::HashMap;
use std::ops::Range;

use ladder_analysis::program::{
    Argument, Block, BlockKind, Bound, ElementKind, ExprKind, Location, Network, Place, Step, TagId,
};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;
use ladder_instructions::{Group, Op};
use ladder_simulator::{Point, Simulation};
use ladder_syntax::TextRange;

use ladder_documents::Revision;

/// Numbers from here on are those of verticals, which the engine does not know. Texts are shorter.
const VERTICALS: usize = 1 << 31;

/// Where the networks of the program's own text are.
#[derive(Debug)]
pub(crate) struct Drawing {
    /// In the order of the text.
    networks: Vec<NetworkPlace>,
    /// The program's tags where its own text declares them, in the order of the text.
    declared: Vec<(TextRange, TagId)>,
}

/// A network of the program's own text.
#[derive(Debug, Clone, Copy)]
struct NetworkPlace {
    range: TextRange,
    /// Its number in the program.
    number: usize,
    /// The engine's number of its first element.
    first: usize,
}

/// An element of the drawing.
#[derive(Debug)]
pub(crate) struct Element {
    /// The engine's number for it.
    pub(crate) number: usize,
    /// Where it is.
    pub(crate) range: TextRange,
    /// What the contact that it is looks at.
    pub(crate) contact: Option<Contact>,
}

/// A contact.
#[derive(Debug)]
pub(crate) struct Contact {
    /// The engine's number of an element that carries the power which comes to it.
    comes: Option<usize>,
    condition: Condition,
}

/// What a contact looks at.
#[derive(Debug)]
enum Condition {
    /// A bit, and what it must be.
    Bit(Point, bool),
    /// Two values.
    Comparison(Op, Operand, Operand),
    /// What only the scan itself knows, as an edge.
    Unknown,
}

#[derive(Debug)]
enum Operand {
    Point(Point),
    Constant(Value),
}

/// An operand that has values.
#[derive(Debug)]
pub(crate) struct Named {
    pub(crate) range: TextRange,
    pub(crate) block: TextRange,
    /// The most telling one first; none if a computed index leads to no element now.
    pub(crate) points: Vec<Point>,
    /// How its block is drawn tells the value.
    pub(crate) drawn: bool,
    /// It is the name in a declaration.
    pub(crate) declared: bool,
    /// The place, if it may be another element with each scan, or each block that runs.
    pub(crate) indexed: Option<Place>,
}

impl Named {
    /// Which element a computed index leads to, as it is put before the value: `[2]=`.
    pub(crate) fn index(&self) -> Option<String> {
        let point = self.indexed.as_ref().and(self.points.first())?;
        point.index().map(|index| format!("{index}="))
    }
}

impl Drawing {
    pub(crate) fn of(simulation: &Simulation) -> Drawing {
        let program = simulation.program();
        let elements = simulation.power().enumerate();
        let elements = elements.filter(|(_, (_, location, _))| location.file == 0);
        // The elements of a network follow one another.
        let firsts: HashMap<_, _> = elements
            .map(|(number, (_, location, _))| (location.range.start(), number))
            .collect();
        let own = program.networks.iter().enumerate();
        let own = own.filter(|(_, network)| network.location.file == 0);
        let mut networks: Vec<NetworkPlace> = own
            .filter_map(|(number, network)| {
                let first = network.elements.first()?;
                Some(NetworkPlace {
                    range: network.location.range,
                    number,
                    first: *firsts.get(&first.range.start())?,
                })
            })
            .collect();
        networks.sort_by_key(|place| place.range.start());
        let mut drawing = Drawing {
            networks,
            declared: Vec::new(),
        };
        let tags = program.tags.iter().enumerate();
        // A tag that no text declares is where a network uses it first.
        let declared = tags.filter(|(_, tag)| {
            let Location { file, range } = tag.location;
            file == 0 && tag.block.is_none() && drawing.networks_in(range).is_empty()
        });
        let mut declared: Vec<_> = declared
            .map(|(number, tag)| (tag.location.range, TagId(number as u32)))
            .collect();
        declared.sort_by_key(|(range, _)| range.start());
        drawing.declared = declared;
        drawing
    }

    /// The tags that are declared in a stretch of the text.
    pub(crate) fn declared_in(&self, stretch: TextRange, simulation: &Simulation) -> Vec<Named> {
        let from = self
            .declared
            .partition_point(|(range, _)| range.start() < stretch.start());
        let declared = self.declared[from..].iter();
        let declared = declared.take_while(|(range, _)| range.start() < stretch.end());
        let named = declared.map(|&(range, tag)| {
            let name = &simulation.program().tags[tag.0 as usize].name;
            let mut points = members(tag, simulation);
            points.extend(simulation.resolve(name));
            Named {
                range,
                block: range,
                points,
                drawn: false,
                declared: true,
                indexed: None,
            }
        });
        named.filter(|named| !named.points.is_empty()).collect()
    }

    /// The networks that have something in a stretch of the text.
    fn networks_in(&self, stretch: TextRange) -> &[NetworkPlace] {
        let from = self
            .networks
            .partition_point(|it| it.range.end() <= stretch.start());
        let to = self
            .networks
            .partition_point(|it| it.range.start() < stretch.end());
        &self.networks[from..to.max(from)]
    }

    /// A stretch of the text, and the rest of the networks that it cuts through.
    pub(crate) fn whole_networks(&self, stretch: TextRange) -> TextRange {
        let networks = self.networks_in(stretch).iter();
        networks.fold(stretch, |whole, network| whole.cover(network.range))
    }

    /// The elements that are in a stretch of the text.
    pub(crate) fn elements_in(
        &self,
        stretch: TextRange,
        revision: &Revision,
        simulation: &Simulation,
    ) -> Vec<Element> {
        let mut elements = Vec::new();
        for place in self.networks_in(stretch) {
            let network = &simulation.program().networks[place.number];
            for (index, element) in network.elements.iter().enumerate() {
                if element.range.start() >= stretch.end() || element.range.end() <= stretch.start() {
                    continue;
                }
                let block = (element.kind == ElementKind::Block)
                    .then(|| block_at(network, element.range))
                    .flatten();
                let contact = block.and_then(|(number, block)| {
                    let condition = condition(block, revision, simulation)?;
                    let comes = comes_to(network, number).map(|index| place.first + index);
                    Some(Contact { comes, condition })
                });
                elements.push(Element {
                    number: place.first + index,
                    range: element.range,
                    contact,
                });
            }
            elements.extend(verticals_in(place.range, stretch, revision));
        }
        // A network's own order is that of the evaluation.
        elements.sort_by_key(|element| element.range.start());
        elements
    }

    /// The operands of the blocks that begin in a stretch of the text.
    pub(crate) fn operands_in(
        &self,
        stretch: TextRange,
        revision: &Revision,
        simulation: &Simulation,
    ) -> Vec<Named> {
        let mut operands = Vec::new();
        for place in self.networks_in(stretch) {
            let network = &simulation.program().networks[place.number];
            for block in &network.blocks {
                if stretch.contains(block.location.range.start()) {
                    operands_of(block, revision, simulation, &mut operands);
                }
            }
        }
        operands
    }
}

impl Contact {
    /// Whether it lets power through, or would.
    pub(crate) fn state(&self, on: bool, simulation: &Simulation) -> super::messages::Contact {
        use super::messages::Contact;
        let comes = self.comes.is_some_and(|comes| simulation.is_live(comes));
        // As it is now: a tag that is given a value moves its contacts at once, and the power with the next scan.
        match (comes, self.condition.holds(simulation).unwrap_or(on)) {
            (_, true) => Contact::Closed,
            (true, false) => Contact::Blocks,
            (false, false) => Contact::Open,
        }
    }
}

impl Condition {
    fn holds(&self, simulation: &Simulation) -> Option<bool> {
        match self {
            Condition::Bit(point, wanted) => Some(simulation.value(point) == Value::Bool(*wanted)),
            Condition::Comparison(op, left, right) => {
                let order = match (left.value(simulation), right.value(simulation)) {
                    (Value::Int(left), Value::Real(right)) => (left as f64).partial_cmp(&right)?,
                    (Value::Real(left), Value::Int(right)) => left.partial_cmp(&(right as f64))?,
                    (Value::Int(left), Value::Int(right)) => left.cmp(&right),
                    (Value::Real(left), Value::Real(right)) => left.partial_cmp(&right)?,
                    (left, right) if left == right => std::cmp::Ordering::Equal,
                    _ => return None,
                };
                match op {
                    Op::Eq => Some(order.is_eq()),
                    Op::Ne => Some(order.is_ne()),
                    Op::Gt => Some(order.is_gt()),
                    Op::Ge => Some(order.is_ge()),
                    Op::Lt => Some(order.is_lt()),
                    Op::Le => Some(order.is_le()),
                    _ => None,
                }
            }
            Condition::Unknown => None,
        }
    }
}

impl Operand {
    fn of(bound: &Bound, revision: &Revision, simulation: &Simulation) -> Option<Operand> {
        let Argument::Value(expr) = &bound.argument else {
            return None;
        };
        let mut expr = expr;
        while let ExprKind::Pass(inner) = &expr.kind {
            expr = inner;
        }
        // Unsigned numbers past the middle are kept as negative ones: only the scan knows.
        if matches!(expr.ty, Scalar::Ulint | Scalar::Lword) {
            return None;
        }
        match &expr.kind {
            ExprKind::Constant(value) => Some(Operand::Constant(value.clone())),
            ExprKind::Read(place) => {
                let written = revision.stretch(bytes(expr.range));
                simulation.point_at(place, &written).map(Operand::Point)
            }
            _ => None,
        }
    }

    fn value(&self, simulation: &Simulation) -> Value {
        match self {
            Operand::Point(point) => simulation.value(point),
            Operand::Constant(value) => value.clone(),
        }
    }
}

/// The verticals of a network: rails where no rung joins them, and what is between connectors. They have no power of their own.
fn verticals_in(network: TextRange, stretch: TextRange, revision: &Revision) -> Vec<Element> {
    let Some(shown) = network.intersect(stretch) else {
        return Vec::new();
    };
    let mut verticals = Vec::new();
    let mut start = usize::from(shown.start());
    for line in revision.stretch(bytes(shown)).split_inclusive('\n') {
        // One in a comment is text.
        let drawn = if line.contains('#') { "" } else { line };
        for (at, _) in drawn.match_indices('|') {
            let offset = (start + at) as u32;
            verticals.push(Element {
                number: VERTICALS + offset as usize,
                range: TextRange::at(offset.into(), 1.into()),
                contact: None,
            });
        }
        start += line.len();
    }
    verticals
}

fn block_at(network: &Network, range: TextRange) -> Option<(usize, &Block)> {
    let mut blocks = network.blocks.iter().enumerate();
    blocks.find(|(_, block)| block.location.range == range)
}

/// An element of the network that carries the power which comes to a block.
fn comes_to(network: &Network, block: usize) -> Option<usize> {
    let en = network.steps.iter().find_map(|step| match *step {
        Step::Block { block: this, en } if this == block => Some(en),
        _ => None,
    })?;
    network.elements.iter().position(|element| element.step == en)
}

/// What a block looks at, if it is a contact.
fn condition(block: &Block, revision: &Revision, simulation: &Simulation) -> Option<Condition> {
    let BlockKind::Instruction(row) = block.kind else {
        return None;
    };
    if row.group != Group::Condition {
        return None;
    }
    let operand = |index: usize| Operand::of(block.arguments.get(index)?, revision, simulation);
    Some(match row.op {
        Op::Contact | Op::NegatedContact => match operand(0) {
            Some(Operand::Point(point)) => Condition::Bit(point, row.op == Op::Contact),
            _ => Condition::Unknown,
        },
        Op::Eq | Op::Ne | Op::Gt | Op::Ge | Op::Lt | Op::Le => match (operand(0), operand(1)) {
            (Some(left), Some(right)) => Condition::Comparison(row.op, left, right),
            _ => Condition::Unknown,
        },
        Op::RisingContact | Op::FallingContact => Condition::Unknown,
        // What looks at nothing but the wire is not a contact.
        _ => return None,
    })
}

fn operands_of(block: &Block, revision: &Revision, simulation: &Simulation, operands: &mut Vec<Named>) {
    let drawn = matches!(block.kind, BlockKind::Instruction(row)
        if matches!(row.op, Op::Contact | Op::NegatedContact | Op::Coil | Op::NegatedCoil));
    for bound in &block.arguments {
        let named = |range, points, indexed| Named {
            range,
            block: block.location.range,
            points,
            drawn,
            declared: false,
            indexed,
        };
        if let Argument::State(tag) = bound.argument {
            operands.push(named(bound.range, members(tag, simulation), None));
            continue;
        }
        for (place, range) in bound.places() {
            if Simulation::has_index(place) {
                let point = simulation.indexed_point(place).into_iter();
                operands.push(named(range, point.collect(), Some(place.clone())));
                continue;
            }
            let point = simulation.point_at(place, &revision.stretch(bytes(range)));
            operands.extend(point.map(|point| named(range, vec![point], None)));
        }
    }
    operands.retain(|operand| !operand.points.is_empty() || operand.indexed.is_some());
}

/// The members that show how far a timer, counter or bistable has come, the most telling one first.
pub(crate) const MEMBERS: [&str; 6] = ["ET", "CV", "Q", "QU", "QD", "Q1"];

/// What shows how far a timer, counter or bistable has come.
fn members(tag: TagId, simulation: &Simulation) -> Vec<Point> {
    let tag = &simulation.program().tags[tag.0 as usize];
    let (Type::State(_), None) = (tag.ty, tag.block) else {
        return Vec::new();
    };
    let names = MEMBERS.iter().map(|member| format!("{}.{member}", tag.name));
    names.filter_map(|name| simulation.resolve(&name).ok()).collect()
}

fn bytes(range: TextRange) -> Range<usize> {
    usize::from(range.start())..usize::from(range.end())
}
