//! The rungs of a program in LDmicro's order: functions are as subprograms where a comment keeps their place, or
//! after the others.

use super::Exporter;
use super::fork::OWN_END;
use crate::fork::jumps;
use crate::kept::{UNSETTLED, comments};
use crate::model::{Leaf, Node, Rung, leaves};
use ladder_analysis::program::{BlockKind, Network};
use ladder_instructions::Op;
use std::collections::HashMap;

/// A function on its way to be a subprogram.
struct Subprogram {
    name: String,
    line: u32,
    rungs: Vec<Rung>,
}

impl Exporter<'_> {
    /// All networks, and the comments between them.
    pub(super) fn rungs(&mut self) -> Vec<Rung> {
        let program = self.input.program;
        let mut main = Vec::new();
        let mut subprograms: Vec<Subprogram> = Vec::new();
        let mut at = 0;
        let own = program.networks.iter().enumerate();
        for (index, network) in own.filter(|(_, network)| network.location.file == 0) {
            let range = network.location.range;
            // What defines a block is not a rung.
            if program.blocks.iter().any(|block| block.networks.contains(&index)) {
                continue;
            }
            let between = comments(&self.input.text[at..usize::from(range.start())]);
            at = range.end().into();
            let rungs = subprograms.last_mut().map_or(&mut main, |sub| &mut sub.rungs);
            rungs.extend(between);
            if let Some(name) = self.begins_function(network) {
                let line = self.place(network.location).line;
                let rungs = Vec::new();
                subprograms.push(Subprogram { name, line, rungs });
                continue;
            }
            let rung = self.network(network);
            let rungs = subprograms.last_mut().map_or(&mut main, |sub| &mut sub.rungs);
            rungs.push(rung);
        }
        let rungs = subprograms.last_mut().map_or(&mut main, |sub| &mut sub.rungs);
        rungs.extend(comments(&self.input.text[at..]));
        let mut rungs = placed(main, subprograms);
        settle(&mut rungs);
        rungs
    }

    /// The function that a network begins, where nothing else is in it.
    fn begins_function(&self, network: &Network) -> Option<String> {
        let [block] = &network.blocks[..] else {
            return None;
        };
        match block.kind {
            BlockKind::Instruction(row) if row.op == Op::Fun => {
                let name = block.arguments.first()?;
                Some(self.input.text[name.range].trim().to_owned())
            }
            _ => None,
        }
    }
}

fn border(word: &str, name: &str, line: u32) -> Rung {
    let text = format!("{word} {name}");
    Rung {
        line,
        parts: vec![Node::Leaf(Leaf { line, text })],
    }
}

/// The rungs with each subprogram in its place.
fn placed(main: Vec<Rung>, mut subprograms: Vec<Subprogram>) -> Vec<Rung> {
    let mut out = Vec::with_capacity(main.len());
    let put = |out: &mut Vec<Rung>, sub: Subprogram, name: &str| {
        out.push(border("SUBPROG", name, sub.line));
        out.extend(sub.rungs);
        out.push(border("ENDSUB", name, sub.line));
    };
    for rung in main {
        let place = match &rung.parts[..] {
            [Node::Leaf(leaf)] => leaf.text.strip_prefix(UNSETTLED),
            _ => None,
        };
        let Some(place) = place.and_then(|text| text.strip_prefix("SUBPROG ")) else {
            out.push(rung);
            continue;
        };
        let is_it = |sub: &Subprogram| {
            let (was, own) = (format!("SUBPROG {place}"), format!("SUBPROG {}", sub.name));
            jumps::same(&was, &own)
        };
        if let Some(at) = subprograms.iter().position(is_it) {
            let name = place.to_owned();
            put(&mut out, subprograms.remove(at), &name);
        }
    }
    for sub in subprograms {
        let name = sub.name.clone();
        put(&mut out, sub, &name);
    }
    out
}

/// A number that leads to a rung farther on is not checked.
const MOST_PASSED: usize = 1_000;

/// Numbers the rungs that jumps go to, and takes the labels out that only they lead to.
fn settle(rungs: &mut [Rung]) {
    let count = rungs.len();
    let mut labels: HashMap<String, usize> = HashMap::new();
    for (index, rung) in rungs.iter_mut().enumerate() {
        retain(&mut rung.parts, &mut |text| {
            let label = text
                .strip_prefix(UNSETTLED)
                .and_then(|text| text.strip_prefix("LABEL "));
            labels.extend(label.map(|label| (label.to_owned(), index)));
            label.is_none()
        });
    }
    let is_comment: Vec<bool> = rungs.iter().map(is_comment).collect();
    let subprogram = subprograms(rungs);
    for (at, rung) in rungs.iter_mut().enumerate() {
        each(&mut rung.parts, &mut |text| {
            let Some(jump) = text
                .strip_prefix(UNSETTLED)
                .and_then(|text| text.strip_prefix("GOTO "))
            else {
                return;
            };
            let (label, was) = jump.split_once(' ').unwrap_or((jump, ""));
            let found = match label {
                "" => None,
                OWN_END => subprogram.iter().rposition(|sub| *sub == subprogram[at]),
                label => labels.get(label).copied(),
            };
            if found.is_none() && !label.is_empty() {
                // The rung could not be written.
                *text = format!("GOTO {label}");
                return;
            }
            let to = found.unwrap_or(count) + 1;
            // A number that leads to comments or a subprogram above the rung leads to the rung.
            let own = subprogram.get(to - 1).copied().flatten();
            let passed =
                |rung: usize| is_comment[rung] || subprogram[rung].is_some_and(|sub| Some(sub) != own);
            let was = was
                .trim()
                .strip_prefix("GOTO ")
                .and_then(|was| was.parse::<usize>().ok());
            let same = |was: &usize| {
                let was = (*was).min(count + 1);
                (1..=to).contains(&was) && to - was < MOST_PASSED && (was..to).all(|rung| passed(rung - 1))
            };
            *text = match was.filter(same) {
                None if label == OWN_END => "RETURN".to_owned(),
                was => format!("GOTO {}", was.unwrap_or(to)),
            };
        });
    }
}

/// For each rung the subprogram that it is in.
fn subprograms(rungs: &[Rung]) -> Vec<Option<usize>> {
    let mut inside = None;
    let mut count = 0;
    let of = |rung: &Rung| {
        let word = match &rung.parts[..] {
            [Node::Leaf(leaf)] => leaf.text.split(' ').next().unwrap_or_default(),
            _ => "",
        };
        if word == "SUBPROG" {
            count += 1;
            inside = Some(count);
        }
        let own = inside;
        if word == "ENDSUB" {
            inside = None;
        }
        own
    };
    rungs.iter().map(of).collect()
}

/// Whether a rung does nothing: it is empty, or only a comment.
fn is_comment(rung: &Rung) -> bool {
    let leaves = leaves(&rung.parts);
    leaves.iter().all(|leaf| leaf.comment().is_some())
}

fn retain(parts: &mut Vec<Node>, keeps: &mut impl FnMut(&str) -> bool) {
    parts.retain_mut(|part| match part {
        Node::Leaf(leaf) => keeps(&leaf.text),
        Node::Series(inside) | Node::Parallel(inside) => {
            retain(inside, keeps);
            true
        }
    });
}

fn each(parts: &mut [Node], change: &mut impl FnMut(&mut String)) {
    for part in parts {
        match part {
            Node::Leaf(leaf) => change(&mut leaf.text),
            Node::Series(inside) | Node::Parallel(inside) => each(inside, change),
        }
    }
}
