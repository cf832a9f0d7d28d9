//! Boxes with texts in ST: `EXECUTE`. The texts of a unit are read together, and each runs where its box stands, if power comes to it.

use super::blocks::{is_enable, is_enable_out};
use super::body::{Body, Made};
use super::once::Once;
use super::structured::{Seen, within};
use crate::expression::Meaning;
use crate::graph::{Code, Graph, Kind, Node};
use crate::model::{Body as UnitBody, Evaluation, Unit};
use ladder_format::Circuit;
use ladder_format::program::{Block, Element, Item};
use ladder_notation::{Lines, Names, Reading, UnreadParts};
use ladder_notation_st::read::{self as st, PartKind, PartText};
use std::collections::{HashMap, HashSet};

/// A box is known by its drawing and its number there.
type Key = (*const Graph, usize);

/// A box with a text.
type Drawn<'u> = (&'u Graph, usize, &'u Code);

/// The texts of a unit; and of those that are not read, why.
pub(super) type Texts = HashMap<Key, Result<Text, String>>;

/// A text that is read.
#[derive(Clone)]
pub(super) struct Text {
    items: Vec<Item>,
    /// The label after it.
    past: String,
    /// The tags that it has, and those of them that it writes, in small letters.
    reads: HashSet<String>,
    writes: HashSet<String>,
}

/// Reads the texts in the drawings of a unit.
///
/// # Errors
///
/// Why the unit cannot be read without them: one that is not read may end its run.
pub(super) fn read(
    seen: &Seen<'_>,
    unit: &Unit,
    made: &mut Made,
    reading: &mut Reading,
) -> Result<(), String> {
    let bodies = unit.parts.iter().map(|part| &part.body).chain([&unit.body]);
    let graphs: Vec<&Graph> = bodies
        .filter_map(|body| match body {
            UnitBody::Graph(graph) => Some(graph),
            _ => None,
        })
        .collect();
    let boxes: Vec<Drawn<'_>> = graphs
        .iter()
        .flat_map(|graph| graph.codes().map(|(number, code)| (*graph, number, code)))
        .collect();
    if boxes.is_empty() {
        return Ok(());
    }
    let scope = seen.in_text(&made.scope);
    let told = (seen.dialect(), (unit.name.as_str(), &scope));
    let drawn = instances(&graphs, made);
    let mut good = Vec::new();
    let mut writes: HashMap<Key, HashSet<String>> = HashMap::new();
    for (graph, number, code) in boxes {
        let key = (std::ptr::from_ref(graph), number);
        match alone(&graph.nodes[number], code, told, &drawn) {
            Ok(body) => {
                writes.insert(key, body.writes);
                good.push((graph, number, code));
            }
            Err(why) if may_leave(&code.text) => return Err(why),
            Err(why) => drop(made.texts.insert(key, Err(why))),
        }
    }
    if seen.shared.evaluation == Evaluation::Once {
        good = kept(seen, good, &writes, made);
    }
    let parts: Vec<PartText<'_>> = good.iter().map(|(_, _, code)| part(code)).collect();
    let first = st::FirstNumbers {
        origin: reading.places.len() as u32,
        label: last_number(&graphs),
    };
    let (names, unread) = (made.scope.names_mut(), &mut made.unread);
    let bodies = match st::read_parts((&parts, told.0), told.1, first, names, unread) {
        Ok(bodies) => bodies,
        Err((_, why)) => {
            if good.iter().any(|(.., code)| may_leave(&code.text)) {
                return Err(why);
            }
            let all = good.into_iter();
            let unread =
                all.map(|(graph, number, _)| ((std::ptr::from_ref(graph), number), Err(why.clone())));
            made.texts.extend(unread);
            return Ok(());
        }
    };
    let last = bodies
        .iter()
        .map(|body| body.last_label)
        .max()
        .unwrap_or_default();
    for (past, (body, (graph, number, code))) in (last + 1..).zip(bodies.into_iter().zip(good)) {
        let at = graph.nodes[number].place;
        let lines = Lines::of(&code.text);
        let place = |byte| match code.place {
            Some(start) => within(start, lines.place(&code.text, byte)),
            None => at,
        };
        body.note(&code.text, place, reading);
        made.needed
            .extend(body.used.iter().map(|name| name.to_lowercase()));
        for tag in &body.tags {
            let names = tag.names.iter();
            made.helpers
                .extend(names.map(|name| (name.clone(), tag.ty.clone(), String::new())));
        }
        let text = Text {
            past: format!("past{past}"),
            reads: body.used.iter().map(|name| name.to_lowercase()).collect(),
            writes: body.writes,
            items: body.items,
        };
        made.texts.insert((std::ptr::from_ref(graph), number), Ok(text));
    }
    Ok(())
}

/// The boxes whose networks may be read in parts, where a network is read once.
fn kept<'u>(
    seen: &Seen<'_>,
    boxes: Vec<Drawn<'u>>,
    writes: &HashMap<Key, HashSet<String>>,
    made: &mut Made,
) -> Vec<Drawn<'u>> {
    let meaning = Meaning {
        shared: seen.shared,
        scope: &made.scope,
    };
    let mut kept = Vec::new();
    for boxes in boxes.chunk_by(|(one, ..), (other, ..)| std::ptr::eq(*one, *other)) {
        let graph = boxes[0].0;
        let key = |number| (std::ptr::from_ref(graph), number);
        let mut once = Once::of(graph, meaning);
        for (_, number, code) in boxes {
            match once.keeps(*number, &writes[&key(*number)], |other| writes.get(&key(other))) {
                Ok(()) => kept.push((graph, *number, *code)),
                Err(why) => drop(made.texts.insert(key(*number), Err(why))),
            }
        }
    }
    kept
}

fn part(code: &Code) -> PartText<'_> {
    PartText {
        text: &code.text,
        kind: PartKind::Enclosed,
    }
}

/// Reads a text by itself, to see whether it can be.
fn alone(
    node: &Node,
    code: &Code,
    (dialect, unit): (st::Dialect, (&str, &st::Scope)),
    drawn: &HashSet<String>,
) -> Result<st::Body, String> {
    let is_plain = node.inputs.iter().all(|pin| is_enable(&pin.name))
        && node
            .outputs
            .iter()
            .all(|output| output.name.is_empty() || is_enable_out(&output.name));
    if !is_plain {
        return Err("it has other pins than EN and ENO".to_owned());
    }
    let (mut names, mut unread) = (Names::default(), UnreadParts::default());
    let first = st::FirstNumbers::default();
    let bodies = st::read_parts((&[part(code)], dialect), unit, first, &mut names, &mut unread);
    let body = bodies.map_err(|(_, why)| why)?.pop().unwrap_or_default();
    if let Some(both) = body.calls.iter().find(|name| drawn.contains(*name)) {
        return Err(format!("a box calls `{both}`, too"));
    }
    Ok(body)
}

/// The instances that boxes of drawings have, in small letters.
fn instances(graphs: &[&Graph], made: &Made) -> HashSet<String> {
    let nodes = graphs.iter().flat_map(|graph| &graph.nodes);
    let names = nodes.filter_map(|node| match &node.kind {
        Kind::Block { instance, .. } => instance.as_ref(),
        _ => None,
    });
    names
        .map(|name| match made.scope.get(name) {
            Some(known) => known.path.root.to_lowercase(),
            None => name.to_lowercase(),
        })
        .collect()
}

/// The highest number that a label of drawings ends with: those of texts are higher.
fn last_number(graphs: &[&Graph]) -> u32 {
    let nodes = graphs.iter().flat_map(|graph| &graph.nodes);
    let labels = nodes.filter_map(|node| match &node.kind {
        Kind::Label(name) => {
            let digits = name.trim_start_matches(|c: char| !c.is_ascii_digit());
            digits.parse::<u32>().ok()
        }
        _ => None,
    });
    labels
        .filter(|number| *number < u32::MAX / 2)
        .max()
        .unwrap_or_default()
}

impl Body<'_> {
    fn text(&self, node: usize) -> Option<&Result<Text, String>> {
        self.made.texts.get(&(std::ptr::from_ref(self.graph), node))
    }

    /// Whether a box is a text that is read.
    pub(super) fn has_text(&self, node: usize) -> bool {
        matches!(self.text(node), Some(Ok(_)))
    }

    /// Why the text of a box is not read.
    pub(super) fn why_no_text(&self, node: usize) -> Option<&str> {
        self.text(node)?.as_ref().err().map(String::as_str)
    }

    /// The tags that a text has, and those of them that it writes.
    pub(super) fn tags_of_text(&self, node: usize) -> Option<(&HashSet<String>, &HashSet<String>)> {
        let text = self.text(node)?.as_ref().ok()?;
        Some((&text.reads, &text.writes))
    }

    /// The label that is after a text.
    pub(super) fn past(&self, node: usize) -> Option<&str> {
        let text = self.text(node)?.as_ref().ok()?;
        Some(&text.past)
    }

    /// A box with a text has its turn.
    pub(super) fn run_text(&mut self, node: usize) {
        if !self.state.executed[node] {
            self.prepare(node);
            self.execute(node);
        }
    }

    /// The networks of a text, after what decides whether they run.
    pub(super) fn statements(&mut self, node: usize) {
        let key = (std::ptr::from_ref(self.graph), node);
        let Some(Ok(text)) = self.made.texts.get_mut(&key) else {
            return;
        };
        let mut items = std::mem::take(&mut text.items);
        let past = text.past.clone();
        let first = items.iter_mut().find_map(|item| match item {
            Item::Network(network) => Some(network),
            _ => None,
        });
        let above = std::mem::take(&mut self.next.comments);
        match first {
            Some(network) => drop(network.comments.splice(0..0, above)),
            None => self.next.comments = above,
        }
        self.made.items.append(&mut items);
        if self.state.jumped.remove(&node) {
            let origin = self.reading.origin(self.graph.nodes[node].place);
            let label = Element::of(Block::label(&past), Some(origin));
            self.next.labels.push(Circuit::Element(label));
        }
    }

    /// Labels that no network came after.
    pub(super) fn last_labels(&mut self) {
        if !self.next.labels.is_empty() {
            self.push(Circuit::Series(Vec::new()));
        }
    }
}

/// Whether a text may end the run of the unit that it is in.
pub(super) fn may_leave(text: &str) -> bool {
    let mut words = text.split(|c: char| !c.is_alphanumeric() && c != '_');
    let ends = ["RETURN", "RET", "RETC", "RETCN", "JMP", "JMPC", "JMPCN"];
    words.any(|word| ends.iter().any(|end| word.eq_ignore_ascii_case(end)))
}
