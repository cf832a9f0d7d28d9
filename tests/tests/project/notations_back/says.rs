//! What a notation can say, and programs of that.

use ladder_format::program::{
    Block, Declaration, Drawing, Element, Item, Network, ProgramSketch, Section, SectionKind,
};
use ladder_format::{Circuit, Options};
use ladder_invariants::generator::Dice;

/// What a notation can say.
pub(super) struct Says {
    pub(super) notation: &'static str,
    /// A directive such as `profile ldmicro`.
    pub(super) profile: Option<&'static str>,
    pub(super) rungs: Rungs,
    pub(super) inputs: &'static [&'static str],
    pub(super) outputs: &'static [&'static str],
    /// Other tags, each with its type.
    pub(super) others: &'static [(&'static str, &'static str)],
    /// Blocks that decide; `{}` is a bit that is read, `{n}` a number, `{#}` a number of the generator's own.
    pub(super) conditions: &'static [&'static str],
    /// Blocks that are last; `{y}` is a bit that is written, `{m}` a number.
    pub(super) actions: &'static [&'static str],
    /// Blocks with a tag of their own: its letter, its type, the block.
    pub(super) states: &'static [(&'static str, &'static str, &'static str)],
    /// Bits that are read and written.
    pub(super) bits: &'static [&'static str],
    pub(super) numbers: &'static [&'static str],
    /// Blocks that are there in every program: LDmicro complains of variables that nothing gives a value.
    pub(super) always: &'static [&'static str],
}

/// What rungs look like.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Rungs {
    Any,
    /// Conditions, and then instructions, timers among them.
    ConditionFirst,
    /// The same, with conditions of their own in the branches after.
    BranchesAfter,
}

impl Says {
    pub(super) fn program(&self, dice: &mut Dice) -> String {
        let mut maker = Maker {
            says: self,
            states: Vec::new(),
            elements: 0,
        };
        let mut networks = Vec::new();
        for _ in 0..=dice.below(6) {
            networks.push(Item::Blank);
            // What is above the first network may be reported of the whole program.
            let comments = if networks.len() > 1 && dice.one_in(4) {
                vec!["What this one does".to_owned()]
            } else {
                Vec::new()
            };
            maker.elements = 0;
            let drawing = Drawing::Circuit(maker.rung(dice));
            networks.push(Item::Network(Network { comments, drawing }));
        }
        for pattern in self.always {
            let parts = vec![maker.block(dice, self.conditions[0]), maker.block(dice, pattern)];
            networks.extend([
                Item::Blank,
                Item::Network(Network {
                    comments: Vec::new(),
                    drawing: Drawing::Circuit(Circuit::Series(parts)),
                }),
            ]);
        }
        let section = |kind, tags: Vec<(String, String)>| {
            let mut section = Section::new(kind);
            section.declarations = tags
                .into_iter()
                .map(|(name, ty)| Declaration::new(name, ty))
                .collect();
            Item::Section(section)
        };
        let bits = |names: &[&str]| {
            // Elements are those of one array, which the last of them ends.
            let mut out: Vec<(String, String)> = Vec::new();
            for name in names {
                let (name, ty) = match name.trim_end_matches(']').split_once('[') {
                    Some((array, last)) => (array, format!("ARRAY[1..{last}] OF BOOL")),
                    None => (*name, "BOOL".to_owned()),
                };
                out.retain(|(own, _)| own != name);
                out.push((name.to_owned(), ty));
            }
            out
        };
        let others = self
            .others
            .iter()
            .map(|(name, ty)| (name.to_string(), ty.to_string()));
        let mut items: Vec<Item> = Vec::new();
        items.extend(self.profile.map(|profile| Item::Directive(profile.to_owned())));
        items.extend([
            section(SectionKind::VarInput, bits(self.inputs)),
            section(SectionKind::VarOutput, bits(self.outputs)),
            section(SectionKind::Var, others.chain(maker.states).collect()),
        ]);
        items.extend(networks);
        ProgramSketch { items }.write(&Options::default()).text
    }
}

struct Maker<'s> {
    says: &'s Says,
    states: Vec<(String, String)>,
    /// Of this rung: wide ones are refused by some.
    elements: usize,
}

impl Maker<'_> {
    fn rung(&mut self, dice: &mut Dice) -> Circuit<Element> {
        // It begins with a contact, as the textbook wants it.
        let mut parts = vec![self.block(dice, self.says.conditions[0])];
        for _ in 0..dice.below(3) {
            parts.push(self.condition(dice, 2));
        }
        let has_state = !self.says.states.is_empty() && dice.one_in(3);
        let mut ends = Vec::new();
        match self.says.rungs {
            Rungs::Any if has_state => parts.push(self.state(dice)),
            _ if has_state => ends.push(self.state(dice)),
            _ => {}
        }
        // Its pins take the rows below it.
        if has_state && self.says.rungs == Rungs::BranchesAfter {
            parts.append(&mut ends);
            return flat(parts);
        }
        for _ in 0..=dice.below(2) {
            let end = dice.of(self.says.actions);
            let end = self.block(dice, end);
            let condition_after = self.says.rungs != Rungs::ConditionFirst && dice.one_in(3);
            ends.push(if condition_after {
                // Click looks at it before the rung acts: where that makes a difference the writer says so.
                let condition = match self.says.rungs {
                    Rungs::BranchesAfter => {
                        let input = dice.of(self.says.inputs);
                        self.block(dice, &format!("[/]( {input} )"))
                    }
                    _ => self.condition(dice, 0),
                };
                Circuit::Series(vec![condition, end])
            } else {
                end
            });
        }
        parts.push(match ends.len() {
            1 => ends.remove(0),
            _ => Circuit::Parallel(ends),
        });
        flat(parts)
    }

    fn condition(&mut self, dice: &mut Dice, depth: usize) -> Circuit<Element> {
        if depth == 0 || self.elements > 8 || dice.one_in(2) {
            let block = dice.of(self.says.conditions);
            return self.block(dice, block);
        }
        let mut branches = Vec::new();
        for _ in 0..2 + dice.below(2) {
            let mut parts = vec![self.block(dice, self.says.conditions[0])];
            for _ in 0..dice.below(2) {
                parts.push(self.condition(dice, depth - 1));
            }
            branches.push(flat(parts));
        }
        Circuit::Parallel(branches)
    }

    fn block(&mut self, dice: &mut Dice, pattern: &str) -> Circuit<Element> {
        self.elements += 1;
        let says = self.says;
        let mut out = String::new();
        let mut rest = pattern;
        while let Some(at) = rest.find('{') {
            out.push_str(&rest[..at]);
            let end = rest.find('}').unwrap_or(rest.len() - 1);
            let written: Vec<&str> = says
                .bits
                .iter()
                .copied()
                .filter(|bit| !says.inputs.contains(bit))
                .collect();
            match &rest[at + 1..end] {
                "" => out.push_str(dice.of(says.bits)),
                "y" if written.is_empty() || dice.one_in(2) => out.push_str(dice.of(says.outputs)),
                "y" => out.push_str(dice.of(&written)),
                "n" | "m" => out.push_str(dice.of(says.numbers)),
                _ => out.push_str(&dice.between(2, 9).to_string()),
            }
            rest = &rest[end + 1..];
        }
        out.push_str(rest);
        let block = Block::read(&out).expect("it is a block");
        Circuit::Element(Element::of(block, None))
    }

    fn state(&mut self, dice: &mut Dice) -> Circuit<Element> {
        let (letter, ty, pattern) = dice.of(self.says.states);
        let name = format!("{letter}{}", self.states.len() + 1);
        self.states.push((name.clone(), ty.to_owned()));
        let pattern = pattern.replace("{t}", &name);
        self.block(dice, &pattern)
    }
}

/// Parts in series, with what is in series among them.
fn flat(parts: Vec<Circuit<Element>>) -> Circuit<Element> {
    let mut out = Vec::new();
    for part in parts {
        match part {
            Circuit::Series(inside) => out.extend(inside),
            other => out.push(other),
        }
    }
    match out.len() {
        1 => out.remove(0),
        _ => Circuit::Series(out),
    }
}

/// The networks of a text, without its declarations.
pub(super) fn networks(text: &str) -> String {
    let start = text.rfind("END_VAR").unwrap_or(0);
    let words = |line: &str| {
        let words: Vec<&str> = line.split('-').filter(|word| !word.is_empty()).collect();
        words.join("-").trim_end_matches([' ', '|', '+']).to_owned()
    };
    text[start..].lines().map(words).collect::<Vec<_>>().join("\n")
}
