//! A drawing as networks of trees.
//!
//! A tree is evaluated from its inputs to its root, one tree after the other, and what two trees take is a wire that begins in the
//! first. What is done must be done in the order of the drawing: a box that a tree would run too late or too early is by itself,
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
    let mut next = Network::default();
    let (mut at, mut wire) = (0, 1);
    let is_begin = |node: &Node| matches!(node.kind, Kind::Comment(_) | Kind::LeftRail);
    while at < graph.nodes.len() {
        let rest = graph.nodes[at + 1..].iter().position(is_begin);
        let nodes = at..rest.map_or(graph.nodes.len(), |rest| at + 1 + rest);
        let told = match &graph.nodes[at].kind {
            Kind::Comment(told) => Some(told),
            _ => None,
        };
        if let Some(told) = told {
            // A network has one comment.
            if !next.comment.is_empty() {
                out.push(std::mem::take(&mut next));
            }
            next.comment.clone_from(told);
        }
        for node in &graph.nodes[nodes.clone()] {
            let Kind::Label(label) = &node.kind else { continue };
            // And one label.
            if !next.label.is_empty() {
                out.push(std::mem::take(&mut next));
            }
            next.label.clone_from(label);
        }
        if told.is_none() {
            let mut trees = Trees::of(graph, nodes.clone(), wire);
            match trees.items() {
                Ok(()) => next.items = trees.items,
                Err(why) => {
                    let told = format!("{}\nA network is not written: {why}", next.comment);
                    told.trim_start().clone_into(&mut next.comment);
                    refused.push((graph.nodes[at].place, why));
                }
            }
            wire = trees.wire;
        }
        if told.is_none() || !next.label.is_empty() {
            out.push(std::mem::take(&mut next));
        }
        at = nodes.end;
    }
    if !next.comment.is_empty() {
        out.push(next);
    }
    (out, wire)
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
            for from in trees.inputs(node) {
                trees.count(from);
            }
        }
        trees
    }

    /// Takes in an element that others do not ask for.
    fn root(&mut self, node: usize) {
        let drawn = &self.graph.nodes[node];
        let is_coil = |node: usize| matches!(self.graph.nodes[node].kind, Kind::Coil(..));
        if let Some(end) = of_box(drawn).filter(|end| !self.taken.contains_key(end)) {
            self.taken.insert(end, node);
            return;
        }
        match &drawn.kind {
            Kind::Coil(..) | Kind::Variable(..) | Kind::Jump(..) | Kind::Return(_) => {
                let from = self.resolved(drawn.inputs.first());
                let boxes = self.waiting.last().copied().unwrap_or(0);
                let is_next_to =
                    |root: &&mut Root| is_coil(node) && is_coil(root.nodes[0]) && boxes < root.nodes[0];
                match self.roots.last_mut().filter(is_next_to) {
                    Some(root) if root.from == from => root.nodes.push(node),
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

    /// Where what enters a pin comes from: coils pass on what they have, and the rail has power whatever else there is.
    fn resolved(&self, pin: Option<&Pin>) -> Vec<End> {
        let (mut ends, mut seen) = (Vec::new(), HashSet::new());
        let mut open: Vec<End> = pin.iter().flat_map(|pin| pin.from.iter().copied()).collect();
        while let Some(end) = open.pop() {
            let node = &self.graph.nodes[end.node];
            match node.kind {
                _ if !seen.insert(end) => {}
                Kind::Coil(..) => open.extend(node.inputs.iter().flat_map(|pin| &pin.from)),
                Kind::LeftRail => return vec![end],
                _ => ends.push(end),
            }
        }
        ends.sort_unstable();
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
            let tree = self.power(&from, 0)?;
            let targets = nodes.iter().map(|node| self.target(*node)).collect();
            self.items.push(Item::Assign(targets, tree));
        }
        self.all_before(usize::MAX)
    }

    /// Lets those boxes stand by themselves that must run before an element, unless its tree runs them in their turn.
    fn before(&mut self, node: usize, from: &[End]) -> Result<(), String> {
        let waiting = self.waiting.partition_point(|at| *at < node);
        if waiting <= MOST_IN_A_TREE && self.is_in_turn(from, &self.waiting[..waiting]) {
            return Ok(());
        }
        self.all_before(node)
    }

    /// Whether a tree runs these boxes, no other ones, and all of its elements where they stand among them.
    fn is_in_turn(&self, from: &[End], boxes: &[usize]) -> bool {
        let mut order = Vec::new();
        self.order(from, &mut order, &mut HashSet::new(), 0);
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
            let tree = self.element(end, 0)?;
            let item = match self.uses.get(&vec![end]) {
                Some(_) => self.begun(vec![end], tree),
                None => tree,
            };
            self.items.push(Item::Tree(item));
        }
    }

    /// The elements of a tree in the order in which it runs them.
    fn order(&self, from: &[End], out: &mut Vec<usize>, seen: &mut HashSet<Vec<End>>, depth: usize) {
        if depth > DEEPEST || self.wires.contains_key(from) || !seen.insert(from.to_vec()) {
            return;
        }
        match from {
            [end] => {
                for from in self.inputs(end.node) {
                    self.order(&from, out, seen, depth + 1);
                }
                if !matches!(self.graph.nodes[end.node].kind, Kind::LeftRail) {
                    out.push(end.node);
                }
            }
            all => all
                .iter()
                .for_each(|end| self.order(&[*end], out, seen, depth + 1)),
        }
    }

    /// A wire that begins where this tree is.
    fn begun(&mut self, from: Vec<End>, tree: Tree) -> Tree {
        let number = self.wire;
        self.wire += 1;
        self.wires.insert(from, number);
        Tree::Wire(number, Some(Box::new(tree)))
    }

    fn power(&mut self, from: &[End], depth: usize) -> Result<Tree, String> {
        if depth > DEEPEST {
            return Err(format!("more than {DEEPEST} boxes are one in the other"));
        }
        if let Some(number) = self.wires.get(from) {
            return Ok(Tree::Wire(*number, None));
        }
        let tree = match from {
            [] => return Err("something in it has no power".to_owned()),
            [end] => self.element(*end, depth)?,
            all => {
                let parts = all.iter().map(|end| self.power(&[*end], depth + 1));
                Tree::gate("OR", parts.collect::<Result<Vec<Tree>, String>>()?)
            }
        };
        let is_shared = self.uses.get(from).is_some_and(|uses| *uses > 1);
        Ok(match tree {
            Tree::Rail => tree,
            tree if is_shared => self.begun(from.to_vec(), tree),
            tree => tree,
        })
    }

    fn element(&mut self, end: End, depth: usize) -> Result<Tree, String> {
        let node = &self.graph.nodes[end.node];
        if end.output > 0 {
            return Err("something takes an output of a box that is not its power".to_owned());
        }
        match &node.kind {
            Kind::LeftRail => Ok(Tree::Rail),
            Kind::Contact(..) => {
                let mut parts = vec![contact(node)];
                let mut from = self.resolved(node.inputs.first());
                // One after the other, as long as nothing else takes the power between them.
                while let [end] = from[..]
                    && let before = &self.graph.nodes[end.node]
                    && matches!(before.kind, Kind::Contact(..))
                    && self.uses.get(&from) == Some(&1)
                {
                    parts.push(contact(before));
                    from = self.resolved(before.inputs.first());
                }
                match self.power(&from, depth + 1)? {
                    Tree::Rail => {}
                    before => parts.push(before),
                }
                parts.reverse();
                Ok(Tree::gate("AND", parts))
            }
            Kind::Value(text, is_negated) => Ok(Tree::Operand(Target {
                flags: if *is_negated { flag::NEGATED } else { 0 },
                ..Target::variable(text.clone())
            })),
            Kind::Block { name, instance, .. } => {
                self.call(end.node, node, (name, instance.as_deref()), depth + 1)
            }
            _ => Err("an element in it has no counterpart".to_owned()),
        }
    }

    fn call(
        &mut self,
        at: usize,
        node: &Node,
        (name, instance): (&str, Option<&str>),
        depth: usize,
    ) -> Result<Tree, String> {
        self.waiting.retain(|waiting| *waiting != at);
        let mut inputs = Vec::new();
        for pin in node.inputs.iter().filter(|pin| !pin.from.is_empty()) {
            let from = self.resolved(Some(pin));
            inputs.push((pin_name(name, &pin.name).to_owned(), self.power(&from, depth)?));
        }
        if let ("AND", None, Some(_)) = (name, instance, inputs.first())
            && inputs[0].0 != "EN"
        {
            let parts = inputs.into_iter().map(|(_, tree)| tree);
            return Ok(Tree::gate(name, parts.collect()));
        }
        let is_in_out = |name: &str| node.inputs.iter().any(|pin| pin.in_out && pin.name == name);
        let mut outputs = Vec::new();
        for (output, it) in node
            .outputs
            .iter()
            .enumerate()
            .filter(|(_, it)| !is_in_out(&it.name))
        {
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
            name: name.to_owned(),
            instance: instance.map(str::to_owned),
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

fn contact(node: &Node) -> Tree {
    let (text, flags) = match &node.kind {
        Kind::Contact(tag, modifier) => (tag.as_str(), flags(*modifier)),
        _ => ("", 0),
    };
    Tree::Operand(Target {
        text: text.to_owned(),
        flags,
        is_boolean: true,
    })
}

fn flags(modifier: Modifier) -> u32 {
    let edge = match modifier.edge {
        Edge::None => 0,
        Edge::Rising => flag::RISING,
        Edge::Falling => flag::FALLING,
    };
    edge | if modifier.negated { flag::NEGATED } else { 0 }
}

/// The output of a box that a variable takes, if its power is another one.
fn of_box(node: &Node) -> Option<End> {
    let (Kind::Variable(..), [pin]) = (&node.kind, &node.inputs[..]) else {
        return None;
    };
    matches!(pin.from[..], [end] if end.output > 0).then(|| pin.from[0])
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
