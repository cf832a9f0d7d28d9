//! A drawing as networks of trees.
//!
//! A tree is evaluated from its inputs to its root, one tree after the other, and what two trees take is a wire that begins in the
//! first. What is done must be done in the order of the drawing: a box that a tree would run too late or too early stands by itself,
//! before that tree.

use super::tree::{Call, Item, Network, Target, Tree};
use crate::flag;
use ladder_notation::LineColumn;
use ladder_notation_plcopen::graph::{Edge, End, Graph, Kind, Modifier, Node, Pin, Storage};
use std::collections::{HashMap, HashSet};
use std::ops::Range;

/// No more boxes are one in the other: see the reader.
const DEEPEST: usize = 90;

/// No more boxes that do something are in one tree.
const MOST_IN_A_TREE: usize = 20;

/// A network that is not written: where, and why.
pub(super) type Refused = (LineColumn, String);

/// All networks of a body. Wires have numbers of their own in it; comes back the next one, too.
pub(super) fn networks(graph: &Graph, refused: &mut Vec<Refused>) -> (Vec<Network>, usize) {
    let mut out: Vec<Network> = Vec::new();
    let mut wire = 1;
    let mut comment: Option<String> = None;
    let mut at = 0;
    while at < graph.nodes.len() {
        match &graph.nodes[at].kind {
            Kind::Comment(said) => {
                out.extend(comment.replace(said.clone()).map(alone));
                at += 1;
            }
            // Of a network that is not written.
            Kind::Label(label) => {
                let label = label.clone();
                out.push(Network {
                    label,
                    ..alone(comment.take().unwrap_or_default())
                });
                at += 1;
            }
            _ => {
                let is_end = |node: &Node| matches!(node.kind, Kind::Comment(_) | Kind::LeftRail);
                let rest = graph.nodes[at + 1..].iter().position(is_end);
                let nodes = at..rest.map_or(graph.nodes.len(), |rest| at + 1 + rest);
                let mut trees = Trees::of(graph, nodes.clone(), wire);
                let made = trees.items().map(|()| trees.items);
                wire = trees.wire;
                let items = made.unwrap_or_else(|why| {
                    let said = format!("A network is not written: {why}");
                    comment = Some(comment.take().map_or(said.clone(), |above| format!("{above}\n{said}")));
                    refused.push((graph.nodes[at].place, why));
                    Vec::new()
                });
                let mut labels = graph.nodes[nodes.clone()].iter().filter_map(|node| match &node.kind {
                    Kind::Label(label) => Some(label.clone()),
                    _ => None,
                });
                let mut network = alone(comment.take().unwrap_or_default());
                network.label = labels.next().unwrap_or_default();
                for label in labels {
                    let next = alone(String::new());
                    out.push(std::mem::replace(&mut network, Network { label, ..next }));
                }
                out.push(Network { items, ..network });
                at = nodes.end;
            }
        }
    }
    out.extend(comment.map(alone));
    (out, wire)
}

fn alone(comment: String) -> Network {
    Network {
        comment,
        ..Network::default()
    }
}

/// Coils, or one other element that takes power; the power that they take.
struct Root {
    nodes: Vec<usize>,
    from: Vec<End>,
}

/// A network on its way.
struct Trees<'g> {
    graph: &'g Graph,
    roots: Vec<Root>,
    /// How many things take what leaves these outputs together.
    uses: HashMap<Vec<End>, usize>,
    /// What the outputs of boxes go into.
    taken: HashMap<End, usize>,
    /// The boxes that do something, in their order, from the first that is not in a tree yet.
    waiting: Vec<usize>,
    wires: HashMap<Vec<End>, usize>,
    wire: usize,
    items: Vec<Item>,
}

impl<'g> Trees<'g> {
    fn of(graph: &'g Graph, nodes: Range<usize>, wire: usize) -> Trees<'g> {
        let mut trees = Trees {
            graph,
            roots: Vec::new(),
            uses: HashMap::new(),
            taken: HashMap::new(),
            waiting: Vec::new(),
            wires: HashMap::new(),
            wire,
            items: Vec::new(),
        };
        for node in nodes {
            trees.root(node);
        }
        let roots: Vec<Vec<End>> = trees.roots.iter().map(|root| root.from.clone()).collect();
        for from in roots {
            trees.count(from);
        }
        for node in trees.waiting.clone() {
            trees.inputs(node).into_iter().for_each(|from| trees.count(from));
        }
        trees
    }

    /// Takes in an element that others do not ask for.
    fn root(&mut self, node: usize) {
        let drawn = &self.graph.nodes[node];
        let is_coil = |node: usize| matches!(self.graph.nodes[node].kind, Kind::Coil(..));
        match &drawn.kind {
            Kind::Variable(..)
                if self
                    .of_box(drawn)
                    .is_some_and(|end| !self.taken.contains_key(&end)) =>
            {
                self.taken.extend(self.of_box(drawn).map(|end| (end, node)));
            }
            Kind::Coil(..) | Kind::Variable(..) | Kind::Jump(..) | Kind::Return(_) => {
                let from = self.resolved(drawn.inputs.first());
                let is_next = |box_at: Option<&usize>, last: usize| box_at.is_none_or(|at| *at < last);
                match self.roots.last_mut() {
                    Some(last)
                        if is_coil(node)
                            && last.from == from
                            && is_coil(last.nodes[0])
                            && is_next(self.waiting.last(), last.nodes[0]) =>
                    {
                        last.nodes.push(node);
                    }
                    _ => self.roots.push(Root {
                        nodes: vec![node],
                        from,
                    }),
                }
            }
            Kind::Block { .. } if acts(drawn) => self.waiting.push(node),
            _ => {}
        }
    }

    /// The output of a box that a variable takes, if its power goes on from another one.
    fn of_box(&self, variable: &Node) -> Option<End> {
        let [end] = variable.inputs.first()?.from[..] else {
            return None;
        };
        (end.output > 0).then_some(end)
    }

    /// Where what enters a pin comes from: coils pass on what they have, and the rail has power whatever else there is.
    fn resolved(&self, pin: Option<&Pin>) -> Vec<End> {
        let mut ends = Vec::new();
        let mut open: Vec<End> = pin.iter().flat_map(|pin| pin.from.iter().copied()).collect();
        while let Some(end) = open.pop() {
            let node = &self.graph.nodes[end.node];
            match node.kind {
                Kind::Coil(..) => open.extend(node.inputs.iter().flat_map(|pin| &pin.from)),
                Kind::LeftRail => return vec![end],
                _ => ends.push(end),
            }
        }
        ends.sort_unstable();
        ends.dedup();
        ends
    }

    fn inputs(&self, node: usize) -> Vec<Vec<End>> {
        let pins = self.graph.nodes[node].inputs.iter();
        pins.map(|pin| self.resolved(Some(pin))).collect()
    }

    /// Counts what takes power, with all that feeds it: boxes that do something are counted for themselves.
    fn count(&mut self, from: Vec<End>) {
        let mut open = vec![from];
        while let Some(from) = open.pop() {
            let uses = self.uses.entry(from.clone()).or_default();
            *uses += 1;
            if *uses > 1 {
                continue;
            }
            match from[..] {
                [end] if !acts(&self.graph.nodes[end.node]) => open.extend(self.inputs(end.node)),
                [_] => {}
                _ => open.extend(from.iter().map(|end| vec![*end])),
            }
        }
    }

    fn items(&mut self) -> Result<(), String> {
        for Root { nodes, from } in std::mem::take(&mut self.roots) {
            self.before(nodes[0], &from)?;
            let tree = self.power(&from)?;
            let targets = nodes.iter().map(|node| self.target(*node)).collect();
            self.push(Item::Assign(targets, tree))?;
        }
        self.all_before(usize::MAX)
    }

    fn push(&mut self, item: Item) -> Result<(), String> {
        let (Item::Assign(_, tree) | Item::Tree(tree)) = &item;
        if tree.depth() > DEEPEST {
            return Err(format!("more than {DEEPEST} boxes are one in the other"));
        }
        self.items.push(item);
        Ok(())
    }

    /// Lets those boxes stand by themselves that must run before an element, unless its tree runs them in their turn.
    fn before(&mut self, node: usize, from: &[End]) -> Result<(), String> {
        let waiting = self.waiting.partition_point(|at| *at < node);
        if self.is_in_turn(from, &self.waiting[..waiting]) {
            return Ok(());
        }
        self.all_before(node)
    }

    /// Whether a tree runs these boxes, no other ones, and all of its elements where they stand among them.
    fn is_in_turn(&self, from: &[End], boxes: &[usize]) -> bool {
        let mut order = Vec::new();
        self.order(from, &mut order, &mut HashSet::new());
        let mut last = 0;
        let mut run = Vec::new();
        for at in order {
            last = last.max(at);
            if acts(&self.graph.nodes[at]) {
                run.push(at);
                if last > at {
                    return false;
                }
            }
        }
        run == boxes
    }

    fn all_before(&mut self, node: usize) -> Result<(), String> {
        loop {
            let waiting = self.waiting.partition_point(|at| *at < node);
            if waiting == 0 {
                return Ok(());
            }
            let end = |number: usize| End {
                node: self.waiting[number],
                output: 0,
            };
            let is_in_turn = |number: &usize| self.is_in_turn(&[end(*number)], &self.waiting[..=*number]);
            let next = (1..waiting.min(MOST_IN_A_TREE)).rev().find(is_in_turn);
            let end = end(next.unwrap_or(0));
            let tree = self.element(end)?;
            let item = match self.uses.get(&vec![end]) {
                Some(_) => self.begun(vec![end], tree),
                None => tree,
            };
            self.push(Item::Tree(item))?;
        }
    }

    /// The elements of a tree in the order in which it runs them.
    fn order(&self, from: &[End], out: &mut Vec<usize>, seen: &mut HashSet<Vec<End>>) {
        if self.wires.contains_key(from) || !seen.insert(from.to_vec()) {
            return;
        }
        match from {
            [end] => {
                for from in self.inputs(end.node) {
                    self.order(&from, out, seen);
                }
                if !matches!(self.graph.nodes[end.node].kind, Kind::LeftRail) {
                    out.push(end.node);
                }
            }
            all => all.iter().for_each(|end| self.order(&[*end], out, seen)),
        }
    }

    /// A wire that begins where this tree stands.
    fn begun(&mut self, from: Vec<End>, tree: Tree) -> Tree {
        let number = self.wire;
        self.wire += 1;
        self.wires.insert(from, number);
        Tree::Wire(number, Some(Box::new(tree)))
    }

    fn power(&mut self, from: &[End]) -> Result<Tree, String> {
        if let Some(number) = self.wires.get(from) {
            return Ok(Tree::Wire(*number, None));
        }
        let tree = match from {
            [] => return Err("something in it has no power".to_owned()),
            [end] => self.element(*end)?,
            all => {
                let parts: Result<Vec<Tree>, String> = all.iter().map(|end| self.power(&[*end])).collect();
                Tree::gate("OR", parts?)
            }
        };
        let is_shared = self.uses.get(from).is_some_and(|uses| *uses > 1);
        Ok(match tree {
            Tree::Rail => tree,
            tree if is_shared => self.begun(from.to_vec(), tree),
            tree => tree,
        })
    }

    fn element(&mut self, end: End) -> Result<Tree, String> {
        let node = &self.graph.nodes[end.node];
        if end.output > 0 {
            return Err("something takes an output of a box that is not its power".to_owned());
        }
        match &node.kind {
            Kind::LeftRail => Ok(Tree::Rail),
            Kind::Contact(tag, modifier) => {
                let contact = Tree::Operand(Target {
                    text: tag.clone(),
                    flags: flags(*modifier),
                    is_boolean: true,
                });
                let from = self.resolved(node.inputs.first());
                Ok(match self.power(&from)? {
                    Tree::Rail => contact,
                    before => Tree::gate("AND", [before, contact]),
                })
            }
            Kind::Value(text, is_negated) => Ok(Tree::Operand(Target {
                flags: if *is_negated { flag::NEGATED } else { 0 },
                ..Target::variable(text.clone())
            })),
            Kind::Block { name, instance, .. } => self.call(end.node, node, name, instance.clone()),
            _ => Err("an element in it has no counterpart".to_owned()),
        }
    }

    fn call(&mut self, at: usize, node: &Node, name: &str, instance: Option<String>) -> Result<Tree, String> {
        self.waiting.retain(|waiting| *waiting != at);
        let mut inputs = Vec::new();
        for pin in node.inputs.iter().filter(|pin| !pin.from.is_empty()) {
            let from = self.resolved(Some(pin));
            inputs.push((pin_name(name, &pin.name).to_owned(), self.power(&from)?));
        }
        if let ("AND", None, Some(_)) = (name, &instance, inputs.first())
            && inputs[0].0 != "EN"
        {
            return Ok(Tree::gate(name, inputs.into_iter().map(|(_, tree)| tree)));
        }
        let is_in_out = |name: &str| node.inputs.iter().any(|pin| pin.in_out && pin.name == name);
        let mut outputs = Vec::new();
        for (output, it) in node.outputs.iter().enumerate().filter(|(_, it)| !is_in_out(&it.name)) {
            let taker = self.taken.get(&End { node: at, output });
            let taker = taker.and_then(|taker| match &self.graph.nodes[*taker].kind {
                Kind::Variable(text, _) => Some(text.clone()),
                _ => None,
            });
            // The result of a function has no name there.
            let name = if it.name == "OUT" { "" } else { &it.name };
            outputs.push((name.to_owned(), taker));
        }
        let mut call = Call {
            name: function_name(name).to_owned(),
            instance,
            inputs,
            outputs,
        };
        if call.has_enable() && call.outputs.first().is_none_or(|(name, _)| name != "ENO") {
            call.outputs.insert(0, ("ENO".to_owned(), None));
        }
        Ok(Tree::Box(Box::new(call)))
    }

    fn target(&self, node: usize) -> Target {
        let (text, flags, is_boolean) = match &self.graph.nodes[node].kind {
            Kind::Coil(tag, modifier, storage) => {
                let flags = match storage {
                    Storage::None => flags(*modifier),
                    Storage::Set => flag::SET,
                    Storage::Reset => flag::RESET,
                };
                (tag.as_str(), flags, true)
            }
            Kind::Jump(label, _) => (label.as_str(), flag::JUMP, false),
            Kind::Variable(text, _) => (text.as_str(), 0, false),
            _ => ("???", flag::RETURN, false),
        };
        Target {
            text: text.to_owned(),
            flags,
            is_boolean,
        }
    }
}

fn flags(modifier: Modifier) -> u32 {
    let edge = match modifier.edge {
        Edge::None => 0,
        Edge::Rising => flag::RISING,
        Edge::Falling => flag::FALLING,
    };
    edge | if modifier.negated { flag::NEGATED } else { 0 }
}

/// Whether a block does something; else it only decides.
fn acts(node: &Node) -> bool {
    let Kind::Block { instance, .. } = &node.kind else {
        return false;
    };
    instance.is_some() || node.inputs.iter().any(|pin| pin.name == "EN")
}

/// What the pin of a standard block is called there.
fn pin_name<'p>(block: &str, pin: &'p str) -> &'p str {
    match (block, pin) {
        ("SR", "S1") => "SET1",
        ("SR", "R") => "RESET",
        ("RS", "S") => "SET",
        ("RS", "R1") => "RESET1",
        _ => pin,
    }
}

/// What a function is called there.
fn function_name(name: &str) -> &str {
    match name {
        "ADD_TIME" => "ADD",
        "SUB_TIME" => "SUB",
        "MULTIME" => "MUL",
        "DIVTIME" => "DIV",
        name => name,
    }
}
