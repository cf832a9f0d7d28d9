//! From the model to the sketch of a ladder program.

mod block;
mod head;

use super::element;
use super::fork::jumps::Jumps;
use super::fork::made::Made;
use super::model::{File, Leaf, Node, Rung, Version, leaves, number};
use super::tags::Tags;
use block::Translation;
use ladder_analysis::Severity;
use ladder_format::Circuit;
use ladder_format::program::{Block, Drawing, Element, Item, Network, comment_text};
use ladder_notation::{Finding, LineColumn, Reading, UnreadParts};
use std::collections::hash_map::Entry;
use std::collections::{BTreeSet, HashMap, HashSet};
use std::ops::Range;

/// The whole program.
pub(super) fn sketch(file: &File) -> Reading {
    let tags = Tags::of(file);
    let pins: HashMap<&str, (u32, &str)> = file
        .io
        .iter()
        .filter_map(|(line, entry)| entry.split_once(" at ").map(|(name, pin)| (name, (*line, pin))))
        .collect();
    let mut importer = Importer {
        file,
        tags: &tags,
        channels: channels(file, &pins),
        pins,
        jumps: Jumps::of(file),
        made: BTreeSet::new(),
        unread: UnreadParts::default(),
        reading: Reading::default(),
    };
    importer.head();
    importer.program();
    let mut reading = importer.reading;
    reading.report.entries.sort_by_key(|entry| entry.place);
    reading
}

/// How many analog inputs there are here, counted from 0.
const CHANNELS: i64 = 64;

/// The channel of each analog input: its pin, if that is a channel and no other input's, else the first that is free.
fn channels<'f>(file: &'f File, pins: &HashMap<&str, (u32, &str)>) -> HashMap<&'f str, i64> {
    let all = file.rungs.iter().flat_map(|rung| leaves(&rung.parts));
    let inputs: Vec<&str> = all
        .filter_map(|leaf| leaf.text.strip_prefix("READ_ADC "))
        .map(name_of)
        .collect();
    let mut channels: HashMap<&str, i64> = HashMap::new();
    let mut taken = HashSet::new();
    for name in &inputs {
        let pin = pins
            .get(name)
            .and_then(|(_, pin)| i64::try_from(number(pin)?).ok());
        let pin = pin.filter(|pin| (1..CHANNELS).contains(pin) && !channels.contains_key(name));
        if let Some(pin) = pin.filter(|pin| taken.insert(*pin)) {
            channels.insert(name, pin);
        }
    }
    let mut free = (0..CHANNELS).filter(|channel| !taken.contains(channel));
    for name in inputs {
        if let Entry::Vacant(unknown) = channels.entry(name)
            && let Some(channel) = free.next()
        {
            unknown.insert(channel);
        }
    }
    channels
}

struct Importer<'f> {
    file: &'f File,
    tags: &'f Tags,
    /// The port of each analog input.
    channels: HashMap<&'f str, i64>,
    /// The line and the pin of each name in the I/O list.
    pins: HashMap<&'f str, (u32, &'f str)>,
    jumps: Jumps,
    /// The blocks that the program brings along.
    made: BTreeSet<Made>,
    /// What is not read.
    unread: UnreadParts,
    reading: Reading,
}

impl<'f> Importer<'f> {
    /// The main program, after it the subprograms, and what blocks they need.
    fn program(&mut self) {
        let mut next = 0;
        for at in 0..self.jumps.subprograms.len() {
            let sub = &self.jumps.subprograms[at];
            let (name, rungs) = (sub.name.clone(), sub.rungs.clone());
            self.rungs(next..rungs.start);
            let items = &mut self.reading.program.items;
            items.extend([Item::Blank, Item::Comment(format!("ldmicro: SUBPROG {name}"))]);
            next = rungs.end;
        }
        self.rungs(next..self.file.rungs.len());
        for at in 0..self.jumps.subprograms.len() {
            self.function(at);
        }
        let items = &mut self.reading.program.items;
        for made in &self.made {
            items.extend([Item::Blank, made.item()]);
        }
        items.extend(self.unread.items());
    }

    /// A subprogram as a function.
    fn function(&mut self, at: usize) {
        let file = self.file;
        let sub = &self.jumps.subprograms[at];
        let (function, rungs) = (Block::function(&sub.function), sub.rungs.clone());
        let inside = rungs.start + 1..rungs.end - 1;
        let relay = |rung: &Rung| leaves(&rung.parts).iter().any(|leaf| leaf.text == "MASTER_RELAY");
        for (border, is_first) in [(rungs.start, true), (rungs.end - 1, false)] {
            let Some(leaf) = leaves(&file.rungs[border].parts).first().copied() else {
                continue;
            };
            let place = LineColumn::line(leaf.line);
            let report = &mut self.reading.report;
            if is_first && file.rungs[inside.clone()].iter().any(relay) {
                let why = "what its MASTER_RELAY does ends with the function here";
                report.approximated(place, &leaf.text, why);
            } else {
                report.translated(place, &leaf.text);
            }
            if is_first {
                let origin = Some(self.reading.origin(place));
                let block = Circuit::Element(Element::of(function.clone(), origin));
                self.network(Vec::new(), vec![block]);
            }
        }
        self.rungs(inside);
    }

    fn network(&mut self, comments: Vec<String>, parts: Vec<Circuit<Element>>) {
        let drawing = Drawing::Circuit(Circuit::Series(parts));
        let network = Item::Network(Network { comments, drawing });
        self.reading.program.items.extend([Item::Blank, network]);
    }

    fn rungs(&mut self, rungs: Range<usize>) {
        let file = self.file;
        let mut above: Option<String> = None;
        for index in rungs {
            let rung = &file.rungs[index];
            if let Some(comment) = only_comment(rung) {
                self.comments(above.replace(told(comment)));
                self.reading
                    .report
                    .translated(LineColumn::line(rung.line), "COMMENT");
                continue;
            }
            if leaves(&rung.parts).is_empty() {
                self.reading.program.items.push(Item::Blank);
                let comments = above.take().into_iter();
                let comments = comments.chain(["ldmicro: RUNG".to_owned()]).map(Item::Comment);
                self.reading.program.items.extend(comments);
                let why = "the rung is empty";
                self.reading
                    .report
                    .approximated(LineColumn::line(rung.line), "RUNG", why);
                continue;
            }
            let mut parts = self.nodes(&rung.parts);
            if let Some(label) = self.jumps.numbered.get(&index) {
                let number = format!("was: RUNG {}", index + 1);
                let label = Element::of(Block::label(label), None);
                let label = [label, Element::comment(&number, None)];
                parts.splice(0..0, label.map(Circuit::Element));
            }
            self.network(above.take().into_iter().collect(), parts);
        }
        self.comments(above);
    }

    /// A comment that is above no network.
    fn comments(&mut self, comment: Option<String>) {
        if let Some(comment) = comment {
            let items = &mut self.reading.program.items;
            items.extend([Item::Blank, Item::Comment(comment)]);
        }
    }

    fn nodes(&mut self, parts: &'f [Node]) -> Vec<Circuit<Element>> {
        let mut out = Vec::with_capacity(parts.len());
        for (index, part) in parts.iter().enumerate() {
            match part {
                // Several elements stay one branch of a parallel.
                Node::Leaf(leaf) => {
                    let elements = self.leaf(leaf).into_iter().map(Circuit::Element);
                    out.push(Circuit::Series(elements.collect()));
                }
                Node::Series(parts) => out.push(Circuit::Series(self.nodes(parts))),
                Node::Parallel(branches) => {
                    if index + 1 < parts.len() {
                        self.passes_on(branches);
                    }
                    // What is in a branch by itself has nothing after it.
                    let branches = branches.iter();
                    let branches = branches.map(|branch| match self.nodes(std::slice::from_ref(branch)) {
                        mut one if one.len() == 1 => one.remove(0),
                        several => Circuit::Series(several),
                    });
                    out.push(Circuit::Parallel(branches.collect()));
                }
            }
        }
        out
    }

    /// Branches that end in a coil or the like, with something after them.
    fn passes_on(&mut self, branches: &[Node]) {
        let ends = |leaf: &&&Leaf| element::row_of(&leaf.text).is_some_and(|row| row.ends_rung);
        let all = leaves(branches);
        if let Some(leaf) = all
            .iter()
            .find(ends)
            .filter(|_| self.file.version == Version::V02)
        {
            let why = "what is after these branches has the power that comes out of any of them here; in \
                       LDmicro's fork it has what goes in";
            let place = LineColumn::line(leaf.line);
            self.reading.report.approximated(place, "PARALLEL", why);
        }
    }

    fn leaf(&mut self, leaf: &'f Leaf) -> Vec<Element> {
        let place = LineColumn::line(leaf.line);
        let origin = Some(self.reading.origin(place));
        match self.translated(leaf) {
            Ok(Translation { block, remark }) => {
                match remark {
                    Some(why) => self.reading.report.approximated(place, &leaf.text, why),
                    None => self.reading.report.translated(place, &leaf.text),
                }
                let comes_back = self.comes_back(leaf, &block);
                let mut out = vec![Element::of(block, origin)];
                if !comes_back {
                    out.push(Element::comment(&format!("was: {}", leaf.text), origin));
                }
                out
            }
            Err(why) => {
                self.reading.report.refused(place, &leaf.text, &why);
                let shown: String = leaf.text.chars().take(80).collect();
                self.reading.findings.push(Finding {
                    place,
                    severity: Severity::Error,
                    check: "ldmicro-element",
                    message: format!("`{shown}` stays as a comment: {why}"),
                });
                vec![Element::comment(&format!("ldmicro: {}", leaf.text), origin)]
            }
        }
    }
}

fn name_of(entry: &str) -> &str {
    entry.split(' ').next().unwrap_or_default()
}

/// The text of a rung that is only a comment.
fn only_comment(rung: &Rung) -> Option<&str> {
    match &rung.parts[..] {
        [Node::Leaf(leaf)] => leaf.comment(),
        _ => None,
    }
}

/// A comment as ladder text has it: its lines, where they say the same, else as LDmicro's file has it.
fn told(comment: &str) -> String {
    let lines: Vec<&str> = comment.split("\\r\\n").collect();
    let is_plain = |line: &&str| {
        !line.is_empty() && line.trim() == *line && !line.contains('\\') && comment_text(line) == *line
    };
    if lines.iter().all(is_plain) && !comment.starts_with("ldmicro:") {
        return lines.join("\n");
    }
    format!("ldmicro: COMMENT {comment}")
}
