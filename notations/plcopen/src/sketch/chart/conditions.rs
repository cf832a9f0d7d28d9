//! The conditions of a chart as what has power if they hold.

use super::drawn::Apart;
use super::{Read, Reader, Source};
use crate::chart::Flow;
use crate::graph::Graph;
use crate::sketch::blocks;
use ladder_format::Circuit;
use ladder_format::program::{Drawing as Shown, Element, Expression, Item, Network, Path};
use ladder_instructions::Op;
use ladder_notation::LineColumn;
use ladder_notation::chart::Condition;
use ladder_notation_st::read as st;
use std::collections::HashMap;

/// Conditions that are drawn, by their transitions, each with the tag of its coil.
#[derive(Default)]
pub(super) struct Drawings {
    pub(super) conditions: HashMap<usize, (Graph, String)>,
    pub(super) apart: Apart,
}

impl<'u> Reader<'_, '_, 'u> {
    /// The condition that a text is.
    pub(super) fn condition(
        &mut self,
        source: Source<'u>,
        bodies: &mut [Option<st::Body>],
    ) -> Read<Condition> {
        let mut before = self.items(source, bodies);
        match before.pop() {
            Some(Item::Network(Network {
                drawing: Shown::Circuit(circuit),
                ..
            })) => {
                before.retain(|item| *item != Item::Blank);
                let power = vec![circuit];
                Ok(Condition { before, power })
            }
            _ => Err("its condition is not known".to_owned()),
        }
    }

    /// The conditions that are drawn, with what runs apart from them, in the order in which a generator meets them.
    pub(super) fn drawings(
        &mut self,
        flow: &Flow,
        sources: &[Source<'u>],
    ) -> Result<Drawings, (LineColumn, String)> {
        let mut all = Drawings::default();
        let by_transition: HashMap<usize, &Source<'u>> = flow
            .transitions
            .iter()
            .map(|(number, ..)| *number)
            .zip(sources)
            .collect();
        let scope = &mut self.made.scope;
        let helpers = &mut self.made.helpers;
        for number in &flow.met {
            let Some(Source::Graph(graph, node)) = by_transition.get(number) else {
                continue;
            };
            let tag = scope.fresh("holds");
            let mut fresh = || {
                let name = scope.fresh("decided");
                let about = "what a condition sees in the next scan".to_owned();
                helpers.push((name.clone(), "BOOL".to_owned(), about));
                name
            };
            let cone = all
                .apart
                .condition(graph, (*node, &tag), &mut fresh)
                .map_err(|why| (self.drawn.elements[*number].place, why))?;
            all.conditions.insert(*number, (cone, tag));
        }
        let graphs = sources.iter().filter_map(|source| match source {
            Source::Graph(graph, _) => Some(*graph),
            _ => None,
        });
        let mut graphs: Vec<&Graph> = graphs.chain([&self.drawn.conditions]).collect();
        graphs.dedup_by_key(|graph| std::ptr::from_ref(*graph));
        for node in graphs.into_iter().flat_map(|graph| all.apart.unasked(graph)) {
            let why = "no condition asks for it, and generators leave it out";
            let shown = blocks::shown(node);
            self.reading.report.approximated(node.place, shown, why);
        }
        Ok(all)
    }

    /// A condition of contacts.
    pub(super) fn drawn_condition(&mut self, cone: &Graph, tag: &str) -> Read<Condition> {
        let told = self.reading.report.entries.len();
        let items = self.draw(cone);
        // The coil at its end is no coil here.
        let own = format!("coil {tag}");
        for entry in &mut self.reading.report.entries[told..] {
            if entry.element == own {
                "condition".clone_into(&mut entry.element);
            }
        }
        let mut networks = items.into_iter().filter(|item| *item != Item::Blank);
        let (Some(Item::Network(network)), None) = (networks.next(), networks.next()) else {
            return Err("its condition is not one network".to_owned());
        };
        let power = match network.drawing {
            Shown::Circuit(circuit) => without_coil(circuit, tag),
            Shown::Rungs(_) => None,
        };
        Ok(Condition {
            before: Vec::new(),
            power: power.ok_or_else(|| "its condition is not one of contacts".to_owned())?,
        })
    }
}

/// What is before the coil of a tag at the end of a circuit.
fn without_coil(circuit: Circuit<Element>, tag: &str) -> Option<Vec<Circuit<Element>>> {
    let mut parts = match circuit {
        Circuit::Series(parts) => parts,
        one => vec![one],
    };
    let Some(Circuit::Element(element)) = parts.pop() else {
        return None;
    };
    let block = element.as_block()?;
    let is_coil = block.op() == Some(Op::Coil)
        && block.only().and_then(Expression::path).and_then(Path::whole) == Some(tag);
    is_coil.then_some(parts)
}
