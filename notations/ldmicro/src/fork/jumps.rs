//! Labels, jumps and subprograms of the fork as labels and functions.
//!
//! A subprogram is between other rungs and is passed over; a function is after the main program. So the rungs
//! between `SUBPROG` and `ENDSUB` move to the end, and a comment keeps their place. `GOTO 5` leads to a rung by its
//! number: that rung gets a label.

use super::super::model::{File, Leaf, Node, Rung, leaves};
use super::table::{Jump, row_of};
use crate::field;
use ladder_format::program::Block;
use ladder_notation::names::Names;
use std::collections::{BTreeMap, HashMap};
use std::ops::Range;

/// What becomes of a program's jumps.
#[derive(Debug, Default)]
pub(crate) struct Jumps {
    pub(crate) subprograms: Vec<Subprogram>,
    /// The labels that rungs get because a number leads to them, by the rungs' indices.
    pub(crate) numbered: BTreeMap<usize, String>,
    /// The block for each element, by its line, or why there is none.
    blocks: HashMap<u32, Result<Block, String>>,
    /// For each rung, and the end after them, the subprogram that it is in.
    within: Vec<Option<usize>>,
    /// For each rung the first one from there on that becomes a network.
    networks: Vec<usize>,
}

/// The rungs from `SUBPROG` to `ENDSUB`, both included.
#[derive(Debug)]
pub(crate) struct Subprogram {
    pub(crate) name: String,
    /// The name of the function.
    pub(crate) function: String,
    pub(crate) rungs: Range<usize>,
}

impl Jumps {
    pub(crate) fn of(file: &File) -> Jumps {
        let mut jumps = Jumps::default();
        let all: Vec<(usize, &Leaf, Jump)> = file
            .rungs
            .iter()
            .enumerate()
            .flat_map(|(index, rung)| leaves(&rung.parts).into_iter().map(move |leaf| (index, leaf)))
            .filter_map(|(index, leaf)| Some((index, leaf, row_of(&leaf.text)?.jump()?)))
            .collect();
        if all.is_empty() {
            return jumps;
        }
        let count = file.rungs.len();
        jumps.within = vec![None; count + 1];
        jumps.networks = vec![count; count + 1];
        for index in (0..count).rev() {
            jumps.networks[index] = if is_network(&file.rungs[index]) {
                index
            } else {
                jumps.networks[index + 1]
            };
        }
        let mut names = Names::default();
        jumps.subprograms(file, &all, &mut names);
        let mut labels: HashMap<&str, (usize, String)> = HashMap::new();
        for (index, leaf, _) in all.iter().filter(|(.., jump)| *jump == Jump::Label) {
            let name = operand(leaf);
            let block = if labels.contains_key(name) {
                Err(format!(
                    "there is another label `{name}`, which the jumps lead to"
                ))
            } else {
                let label = names.spell(name).to_owned();
                labels.insert(name, (*index, label.clone()));
                Ok(Block::label(&label))
            };
            jumps.blocks.insert(leaf.line, block);
        }
        for (index, leaf, jump) in &all {
            let name = operand(leaf);
            let block = match jump {
                Jump::Goto => match field::literal(name).filter(|_| field::is_literal(name)) {
                    Some(number) => jumps.numbered(file, *index, number, &mut names),
                    None => jumps.labelled(*index, labels.get(name), name),
                },
                Jump::Gosub => match jumps.subprograms.iter().find(|sub| sub.name == name) {
                    Some(sub) => Ok(Block::call(&sub.function)),
                    None => Err(format!(
                        "there is no subprogram `{name}` that could be made a function"
                    )),
                },
                Jump::Return => match jumps.subprogram(*index) {
                    Some(_) => Ok(Block::ret()),
                    None => Err("it is in no subprogram".to_owned()),
                },
                Jump::Label | Jump::Subprog | Jump::Endsub => continue,
            };
            jumps.blocks.insert(leaf.line, block);
        }
        jumps
    }

    /// The block that an element becomes. A border of a subprogram that could be made a function is none.
    pub(crate) fn block(&self, leaf: &Leaf) -> Option<&Result<Block, String>> {
        self.blocks.get(&leaf.line)
    }

    /// The subprogram that a rung is in.
    fn subprogram(&self, rung: usize) -> Option<usize> {
        self.within.get(rung).copied().flatten()
    }

    fn subprograms(&mut self, file: &File, all: &[(usize, &Leaf, Jump)], names: &mut Names) {
        let borders: Vec<&(usize, &Leaf, Jump)> = all
            .iter()
            .filter(|(.., jump)| matches!(jump, Jump::Subprog | Jump::Endsub))
            .collect();
        let mut counts: HashMap<(Jump, &str), usize> = HashMap::new();
        for (_, leaf, jump) in &borders {
            *counts.entry((*jump, operand(leaf))).or_default() += 1;
        }
        let is_only = |jump: Jump, name: &str| counts.get(&(jump, name)) == Some(&1);
        let alone = |rung: usize| matches!(&file.rungs[rung].parts[..], [Node::Leaf(_)]);
        for (at, (index, leaf, jump)) in borders.iter().enumerate() {
            let name = operand(leaf);
            if let (Jump::Subprog, Some((end, closing, Jump::Endsub))) = (jump, borders.get(at + 1))
                && operand(closing) == name
                && alone(*index)
                && alone(*end)
                && is_only(Jump::Subprog, name)
                && is_only(Jump::Endsub, name)
            {
                self.within[*index..=*end].fill(Some(self.subprograms.len()));
                self.subprograms.push(Subprogram {
                    name: name.to_owned(),
                    function: names.spell(name).to_owned(),
                    rungs: *index..*end + 1,
                });
                continue;
            }
            if self.subprogram(*index).is_none() {
                let why = "a function is made of one SUBPROG and one ENDSUB after it, each alone in its rung, \
                           with no other between them";
                self.blocks.insert(leaf.line, Err(why.to_owned()));
            }
        }
    }

    /// A jump to a label.
    fn labelled(&self, from: usize, label: Option<&(usize, String)>, name: &str) -> Result<Block, String> {
        let (to, label) = label.ok_or_else(|| format!("there is no label `{name}`"))?;
        if self.subprogram(from) != self.subprogram(*to) {
            return Err(format!(
                "it leads out of its subprogram, or into one, to `{name}`"
            ));
        }
        Ok(Block::jump(label))
    }

    /// A jump to the rung with a number, counted from 1. What lies after the last one is the end of the cycle.
    fn numbered(
        &mut self,
        file: &File,
        from: usize,
        number: i64,
        names: &mut Names,
    ) -> Result<Block, String> {
        let number = usize::try_from(number).unwrap_or(0);
        let mut to = number.checked_sub(1).ok_or("rungs are counted from 1")?;
        to = to.min(file.rungs.len());
        let within = self.subprogram(from);
        loop {
            let into = self.subprogram(to);
            match into {
                _ if into == within => {}
                // What is there passes over the subprogram.
                Some(sub) if within.is_none() && to == self.subprograms[sub].rungs.start => {
                    to = self.subprograms[sub].rungs.end;
                    continue;
                }
                _ => return Err(format!("rung {number} is in another subprogram, or in none")),
            }
            let at_end = match within {
                Some(own) => to + 1 == self.subprograms[own].rungs.end,
                None => to == file.rungs.len(),
            };
            if at_end {
                return Ok(Block::ret());
            }
            if self.networks[to] == to {
                break;
            }
            to = self.networks[to];
        }
        if within.is_some_and(|own| to == self.subprograms[own].rungs.start) {
            return Err(format!("rung {number} is where its own subprogram begins"));
        }
        let label = self
            .numbered
            .entry(to)
            .or_insert_with(|| names.fresh(&format!("rung{}", to + 1)));
        Ok(Block::jump(label))
    }
}

/// Whether a rung becomes a network: neither empty nor only a comment.
fn is_network(rung: &Rung) -> bool {
    match &rung.parts[..] {
        [Node::Leaf(leaf)] => leaf.comment().is_none(),
        parts => !leaves(parts).is_empty(),
    }
}

/// The label, as it is written.
fn operand(leaf: &Leaf) -> &str {
    leaf.text.split(' ').nth(1).unwrap_or_default()
}

/// Whether two lines lead to, or are, the same label, of which the second is spelled as it can be here.
pub(crate) fn same(was: &str, plain: &str) -> bool {
    let (Some((one, label)), Some((other, spelled))) = (was.split_once(' '), plain.split_once(' ')) else {
        return false;
    };
    let mut names = Names::default();
    let near = names.spell(label);
    let numbered = |rest: &str| {
        rest.strip_prefix('_')
            .is_some_and(|n| n.bytes().all(|c| c.is_ascii_digit()))
    };
    one == other
        && row_of(was).is_some_and(|row| row.jump().is_some())
        && spelled
            .strip_prefix(near)
            .is_some_and(|rest| rest.is_empty() || numbered(rest))
}
