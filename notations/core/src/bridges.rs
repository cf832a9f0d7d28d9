//! Networks that are no series and branches, for systems that draw nothing else: each power that is needed in more than one place is
//! kept by a tag, and the parts between are networks, in the order in which their blocks run.

use crate::circuit::series_parallel;
use crate::elements::{Around, Declared, by_origin, comments, networks, put_around};
use crate::fresh::Fresh;
use crate::rewritten::own_networks;
use ladder_analysis::Analysis;
use ladder_analysis::program::{BlockKind, Network, Step};
use ladder_format::Circuit;
use ladder_format::program::{
    self, Block, Declaration, Drawing, Element, Expression, Item, Origin, Path, ProgramSketch,
};
use ladder_instructions::Shape;
use std::collections::HashMap;

/// The comment on a tag that keeps a power.
const POWER: &str = "power at a point of a network";

/// A program of series and branches. Networks that jump, or with blocks that no power reaches, stay. None: it is one.
pub(crate) fn as_branches(analysis: &Analysis) -> Option<ProgramSketch> {
    let context = &analysis.context;
    let bridges: Vec<(&Network, usize)> = (own_networks(analysis)?.into_iter())
        .filter(|(network, _)| !jumps(network) && series_parallel(network).is_none())
        .collect();
    if bridges.is_empty() {
        return None;
    }
    let mut sketch = ProgramSketch::of_text(&context.parse);
    let (drawings, drawn) = (networks(&sketch.items), by_origin(&sketch.items));
    let mut names = Fresh::of(context, "power_");
    let (mut around, mut declared) = (HashMap::new(), Declared::default());
    for (network, number) in bridges {
        let mut parts = Parts {
            network,
            drawn: &drawn,
            names: &mut names,
            declared: Vec::new(),
            made: Vec::new(),
            powers: Vec::new(),
            waiting: None,
        };
        if parts.draw().is_none() {
            continue;
        }
        declared.add(context.bodies[number], parts.declared);
        let mut below = drawings
            .get(number)
            .map_or_else(Vec::new, |drawing| comments(drawing));
        below.extend(parts.made);
        around.insert(
            number,
            Around {
                below,
                is_gone: true,
                ..Around::default()
            },
        );
    }
    put_around(&mut sketch.items, &mut around);
    declared.put(&mut sketch.items);
    Some(sketch)
}

/// Whether a network leads to others, or is led to.
fn jumps(network: &Network) -> bool {
    let mut blocks = network.blocks.iter();
    blocks.any(|block| matches!(block.kind, BlockKind::Instruction(row) if row.shape == Shape::Function))
}

/// What leads to a power from the rail.
type Power = Vec<Circuit<Element>>;

/// A network on its way to several.
struct Parts<'n> {
    network: &'n Network,
    drawn: &'n HashMap<Origin, &'n Block>,
    names: &'n mut Fresh,
    declared: Vec<Declaration>,
    made: Vec<Item>,
    /// None: there never is any.
    powers: Vec<Option<Power>>,
    /// The power that blocks of the network lead to which are in none of those that are made.
    waiting: Option<usize>,
}

impl Parts<'_> {
    /// None: a block of it is not drawn as a sketch has it, or no power reaches one.
    fn draw(&mut self) -> Option<()> {
        let steps = &self.network.steps;
        let mut uses = vec![0; steps.len()];
        for step in steps {
            match *step {
                Step::Start { .. } => {}
                Step::Block { en, .. } => uses[en] += 1,
                Step::Join { upper, lower } => {
                    uses[upper] += 1;
                    uses[lower] += 1;
                }
            }
        }
        for (number, step) in steps.iter().enumerate() {
            let power = match *step {
                Step::Start { rail } => rail.then(Power::new),
                Step::Block { block, en } => {
                    // Blocks run in the order of the steps.
                    match self.waiting.replace(number) {
                        Some(other) if other != en && uses[other] > 0 => self.keep(other),
                        Some(other) if other != en => self.end(other),
                        _ => {}
                    }
                    let at: Origin = self.network.blocks[block].location.range.start().into();
                    let block = (*self.drawn.get(&at)?).clone();
                    let mut power = self.powers[en].clone()?;
                    power.push(Circuit::Element(Element::of(block, Some(at))));
                    Some(power)
                }
                Step::Join { upper, lower } => {
                    if self.waiting == Some(upper) || self.waiting == Some(lower) {
                        self.waiting = Some(number);
                    }
                    match (self.powers[upper].clone(), self.powers[lower].clone()) {
                        (Some(one), Some(other)) if upper != lower => Some(vec![Circuit::Parallel(vec![
                            Circuit::Series(one),
                            Circuit::Series(other),
                        ])]),
                        (one, other) => one.or(other),
                    }
                }
            };
            self.powers.push(power);
            let parts = self.powers[number].as_ref().map_or(0, Vec::len);
            if uses[number] > 1 && parts > usize::from(self.waiting != Some(number)) {
                self.keep(number);
                self.waiting = self.waiting.filter(|waiting| *waiting != number);
            }
        }
        if let Some(last) = self.waiting {
            self.end(last);
        }
        Some(())
    }

    /// Keeps a power in a tag.
    fn keep(&mut self, number: usize) {
        let name = self.names.next();
        let tag = Expression::from(Path::tag(&name));
        let element = |block| Circuit::Element(Element::of(block, None));
        if let Some(parts) = &mut self.powers[number] {
            parts.push(element(Block::coil(tag.clone())));
        }
        self.end(number);
        self.powers[number] = Some(vec![element(Block::contact(tag))]);
        self.declared.push(Declaration {
            comment: Some(POWER.to_owned()),
            ..Declaration::new(name, "BOOL")
        });
    }

    /// Ends a network with a power.
    fn end(&mut self, number: usize) {
        let parts = self.powers[number].take().unwrap_or_default();
        if !self.made.is_empty() {
            self.made.push(Item::Blank);
        }
        self.made.push(Item::Network(program::Network {
            comments: Vec::new(),
            drawing: Drawing::Circuit(Circuit::Series(parts)),
        }));
    }
}
