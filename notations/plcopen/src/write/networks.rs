//! The networks of a unit as one drawing, with comments between them.

use super::added::Added;
use super::declare::named;
use super::element::Writer;
use super::rung::{self, Rung, pin};
use super::unit::{Project, Unit};
use crate::along;
use crate::graph::{End, Graph, Kind, Modifier, Node, Storage};
use ladder_analysis::context::Body as OwnBody;
use ladder_analysis::networks::NetworkAt;
use ladder_analysis::program::Network;
use ladder_instructions::Op;
use ladder_notation::{LineColumn, Report, comments};
use ladder_syntax::{Item, TextSize};
use std::collections::HashMap;

/// The networks of a unit on their way.
pub(super) struct Networks<'n, 'u> {
    pub(super) unit: &'n Unit<'u>,
    pub(super) project: &'n Project<'n>,
    pub(super) graph: Graph,
    pub(super) report: &'n mut Report,
    pub(super) made: Added,
}

/// What is not run as it stands, from one network on.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Under {
    Nothing,
    /// So many loops are open.
    Loops(usize),
    MasterControl,
}

impl Networks<'_, '_> {
    /// What a block's ENO begins with: its EN.
    pub(super) fn power(&mut self, enters: &str, leaves: &str) {
        let contact = Kind::Contact(enters.to_owned(), Modifier::default());
        self.network_of(Some(contact), leaves.to_owned());
    }

    /// Calls the block that sets the globals of `SYS`.
    pub(super) fn calls_system(&mut self, name: &str) {
        let at = self.unit.place(TextSize::default());
        let comment = "sets what is SYS in ladder text";
        let instance = self.made.variable(at, "system", named(name), comment);
        let block = Kind::Block {
            name: name.to_owned(),
            instance: Some(instance),
            code: None,
        };
        let sink = self.made.sink(at);
        self.network_of(Some(block), sink);
    }

    /// Adds a network that has no effect to a body that has none: compilers take no body without statements.
    pub(super) fn does_something(&mut self) {
        let is_done = |node: &Node| {
            matches!(
                node.kind,
                Kind::Coil(..) | Kind::Variable(..) | Kind::Block { .. }
            )
        };
        if !self.graph.nodes.iter().any(is_done) {
            let sink = self.made.sink(self.unit.place(TextSize::default()));
            self.network_of(None, sink);
        }
    }

    /// A network with at most one element before its coil.
    fn network_of(&mut self, element: Option<Kind>, coil: String) {
        let at = self.unit.place(TextSize::default());
        let coil = Kind::Coil(coil, Modifier::default(), Storage::None);
        let mut from = None;
        for kind in [Some(Kind::LeftRail), element, Some(coil)].into_iter().flatten() {
            let is_block = matches!(kind, Kind::Block { .. });
            let name = if is_block { "EN" } else { "" };
            let inputs = from.map(|node| pin(name, vec![End { node, output: 0 }]));
            let mut node = Node::new(at, kind, inputs.into_iter().collect());
            if is_block {
                along::RUNS.clone_into(&mut node.outputs[0].name);
            }
            from = Some(self.graph.nodes.len());
            self.graph.nodes.push(node);
        }
    }

    /// Whether the first network of a block does that anyway.
    pub(super) fn begins_with_power(&self, block: Option<usize>) -> bool {
        let Some(block) = block else { return true };
        let context = self.unit.context();
        let mut networks = context.networks.iter();
        let first = networks.find(|network| context.bodies[network.index] == OwnBody::Block(block));
        let Some(first) = first else { return false };
        let told: Vec<String> = first
            .blocks()
            .map(|block| {
                self.unit.text[block.range()]
                    .replace(' ', "")
                    .to_ascii_uppercase()
            })
            .collect();
        told == ["[](EN)", "()(ENO)"]
    }

    /// All networks; returns the comment on the unit as a whole.
    pub(super) fn draw(&mut self, block: Option<usize>) -> Option<String> {
        let context = self.unit.context();
        let parse = &context.parse;
        let structure = parse.structure();
        let by_start: HashMap<TextSize, &Network> = self
            .unit
            .program
            .networks
            .iter()
            .filter(|network| network.location.file == 0)
            .map(|network| (network.location.range.start(), network))
            .collect();
        let mut current = None;
        let mut above: Vec<String> = Vec::new();
        let mut of_unit: Vec<String> = Vec::new();
        let mut under = Under::Nothing;
        let mut is_guard = block.is_some_and(|block| self.unit.is_guarded(block));
        for item in &structure.items {
            let lines = match *item {
                Item::BlockHeader(number) => {
                    if Some(number) == block {
                        of_unit.append(&mut above);
                    }
                    above.clear();
                    current = Some(number);
                    continue;
                }
                Item::BlockEnd(_) => {
                    if current == block {
                        self.leave_comments(&mut above);
                    }
                    above.clear();
                    current = None;
                    continue;
                }
                Item::Decoration(line) => line..line + 1,
                Item::Network(number) => structure.networks[number].lines.clone(),
                Item::Section(_) => {
                    if current == block {
                        of_unit.append(&mut above);
                    }
                    continue;
                }
                Item::Stray(_) => continue,
            };
            for comment in lines.flat_map(|line| comments::on_line(parse, line)) {
                let told: Vec<&str> = comments::told(&comment).collect();
                if !told.is_empty() {
                    above.push(told.join("\n"));
                }
            }
            let Item::Network(number) = *item else { continue };
            if current != block {
                above.clear();
                continue;
            }
            let facts = context.networks.at(number);
            self.leave_comments(&mut above);
            if std::mem::take(&mut is_guard) {
                continue;
            }
            let network = by_start.get(&facts.range.start()).copied();
            self.network(facts, network, &mut under);
        }
        if current == block {
            self.leave_comments(&mut above);
        }
        (!of_unit.is_empty()).then(|| of_unit.join("\n"))
    }

    fn leave_comments(&mut self, above: &mut Vec<String>) {
        for told in above.drain(..) {
            self.comment(told);
        }
    }

    fn comment(&mut self, told: String) {
        let at = self.unit.place(TextSize::default());
        self.graph
            .nodes
            .push(Node::new(at, Kind::Comment(told), Vec::new()));
    }

    fn network(&mut self, facts: NetworkAt<'_>, network: Option<&Network>, under: &mut Under) {
        let has = |op: Op| facts.blocks().any(|block| block.op() == Some(op));
        let at = self.unit.place(facts.range.start());
        if *under != Under::MasterControl && has(Op::Mcr) {
            *under = Under::MasterControl;
        } else if *under == Under::Nothing && has(Op::For) {
            *under = Under::Loops(0);
        }
        let drawn = match (*under, self.unit.context().bodies[facts.index]) {
            (Under::Loops(_), _) => Err("the standard has no loops of networks, and jumps cannot stand for this one: something jumps into it, or an <MCR> is around".to_owned()),
            (Under::MasterControl, _) => {
                Err("the standard has no <MCR>, which this is or stands after".to_owned())
            }
            (_, OwnBody::Function(_)) => Err("the standard has no functions without parameters".to_owned()),
            _ => self.rung(at, facts, network),
        };
        if let Under::Loops(open) = under {
            let left = open.saturating_sub(usize::from(has(Op::Next))) + usize::from(has(Op::For));
            *under = if left == 0 {
                Under::Nothing
            } else {
                Under::Loops(left)
            };
        }
        match drawn {
            Ok((nodes, mut made)) => {
                self.report.translated(at, "network");
                for (element, why) in made.remarks.drain(..) {
                    self.report.approximated(at, element, why);
                }
                self.graph.nodes.extend(nodes);
                self.made.add(made);
            }
            Err(why) => {
                let text = self.unit.text[facts.range].trim_end();
                self.comment(format!("Not written, because {why}:\n{text}"));
                for label in facts.blocks().filter(|block| block.op() == Some(Op::Lbl)) {
                    let operand = label.facts.operands.first();
                    let name = operand.map_or("", |it| &self.unit.text[label.absolute(it.value.range)]);
                    let kind = Kind::Label(super::names::identifier(name));
                    self.graph.nodes.push(Node::new(at, kind, Vec::new()));
                }
                self.report.refused(at, "network", why);
            }
        }
    }

    fn rung(
        &self,
        at: LineColumn,
        facts: NetworkAt<'_>,
        network: Option<&Network>,
    ) -> Result<(Vec<Node>, Added), String> {
        let network = network.ok_or("nothing uses the block that it is in")?;
        let by_start: HashMap<TextSize, usize> = facts
            .blocks()
            .enumerate()
            .map(|(number, block)| (block.range().start(), number))
            .collect();
        let element = |rung: &mut Rung<'_>, block: usize, power| {
            let block = &network.blocks[block];
            let number = by_start.get(&block.location.range.start());
            let writer = Writer {
                unit: self.unit,
                faces: self.project.faces,
                block,
                facts: facts.block(*number.ok_or("a block of it is not known")?),
            };
            writer.write(rung, power)
        };
        rung::drawn(at, self.graph.nodes.len(), &self.made.names, network, &element)
    }
}
