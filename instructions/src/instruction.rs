//! What a row of the table is: one instruction, its brackets, its section, and what is asked of it.

use crate::op::Op;
use crate::operand::{Accepts, Direction, Operand, Presence, StateType};
use crate::power::{Coil, Power};
use crate::profile::{Profile, Profiles};

/// The outline of a block: which brackets its first part is in (LANGUAGE §2).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Shape {
    /// `[..](..)`: contacts, comparisons, data, timers, counters, ports.
    Logical,
    /// `(..)(..)`: coils.
    Coil,
    /// `<..>(..)`: program flow.
    Function,
}

impl Shape {
    /// All of them.
    pub const ALL: [Shape; 3] = [Shape::Logical, Shape::Coil, Shape::Function];

    /// The opening and closing bracket of the first part.
    pub const fn brackets(self) -> (char, char) {
        match self {
            Shape::Logical => ('[', ']'),
            Shape::Coil => ('(', ')'),
            Shape::Function => ('<', '>'),
        }
    }
}

/// Whether a block decides about power or does something with it (LANGUAGE §8 rule 5). The formatter moves
/// acting blocks to the right.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Role {
    /// The blocks of §5.1, `<LBL>` and `<FUN>`.
    Condition,
    /// All others.
    Acting,
}

/// When a block does its work.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Acts {
    /// Only while EN is high: with EN low it neither reads nor writes its operands (an index outside its array
    /// is then no fault).
    WhenPowered,
    /// At every evaluation, whatever EN is: edges, timers, counters, coils, `<MCR>`.
    Always,
}

/// The section of LANGUAGE §5 that a row belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Group {
    /// §5.1 contacts, edges, comparisons.
    Condition,
    /// §5.2 moves, arithmetic, bits, strings, ranges.
    Data,
    /// §5.3 timers, counters, bistables.
    State,
    /// §5.4 coils.
    Coil,
    /// §5.5 program flow.
    Flow,
    /// §5.6 ports.
    Port,
}

impl Group {
    /// All of them, in the order of the reference.
    pub const ALL: [Group; 6] = [
        Group::Condition,
        Group::Data,
        Group::State,
        Group::Coil,
        Group::Flow,
        Group::Port,
    ];

    /// The heading that its instructions are under.
    pub const fn title(self) -> &'static str {
        match self {
            Group::Condition => "Conditions",
            Group::Data => "Data",
            Group::State => "Timers, counters, bistables",
            Group::Coil => "Coils",
            Group::Flow => "Program flow",
            Group::Port => "Ports",
        }
    }
}

/// One row of the table.
#[derive(Debug, Clone, Copy)]
pub struct Instruction {
    /// Which instruction this is, for exhaustive matches elsewhere.
    pub op: Op,
    /// The canonical spelling between the brackets, in capitals; a blank for the open contact and the coil.
    pub mnemonic: &'static str,
    /// Spellings of equal standing (`SET` for `MOV`): no rule asks for the canonical one.
    pub synonyms: &'static [&'static str],
    /// Spellings that are also accepted (`EQU` for `EQ`); `alternative-mnemonic` is about these.
    pub aliases: &'static [&'static str],
    /// The brackets it is written in.
    pub shape: Shape,
    /// Condition or acting.
    pub role: Role,
    /// Whether it does its work at every evaluation, or only when EN is high.
    pub acts: Acts,
    /// Section of LANGUAGE §5.
    pub group: Group,
    /// The operands in their order; optional named ones last.
    pub operands: &'static [Operand],
    /// The profiles that have it (LANGUAGE §5.8).
    pub profiles: Profiles,
    /// How it differs in other profiles than `iec`: a sentence or two in Markdown for each.
    pub differs: &'static [(Profile, &'static str)],
    /// What power leaves the block.
    pub power: Power,
    /// What it writes as a coil. None for all that is not a coil, and for `(RES)`, which writes no bit.
    pub coil: Option<Coil>,
    /// What power leaves the block, in a few words: `EN and tag`.
    pub eno: &'static str,
    /// A name of two or three words: "Open contact".
    pub title: &'static str,
    /// What it does, in Markdown: a first paragraph of one sentence that is alone, then the details a person
    /// must know. Timers show a timing diagram, in the rows of a scenario: `_` low, `-` high, one column a scan.
    pub doc: &'static str,
    /// A rung (or two) that shows it, in canonical layout, without errors when checked on its own.
    pub example: &'static str,
}

impl Instruction {
    /// The timer, counter or bistable that it runs, if it is the block of one.
    pub const fn state(&self) -> Option<StateType> {
        match self.operands {
            [first, ..] => match first.accepts {
                Accepts::State(state) => Some(state),
                _ => None,
            },
            [] => None,
        }
    }

    /// Whether it is a timer.
    pub const fn is_timer(&self) -> bool {
        matches!(self.state(), Some(state) if state.is_timer())
    }

    /// Number of operands that must be given by place.
    pub fn required(&self) -> usize {
        self.operands
            .iter()
            .map(|operand| match operand.presence {
                Presence::Required => 1,
                Presence::Repeated { least, .. } => usize::from(least),
                Presence::Trailing | Presence::Named => 0,
            })
            .sum()
    }

    /// The largest number of operands by place; none if the last ones may be given again and again.
    pub fn limit(&self) -> Option<usize> {
        (!self.repeats()).then(|| self.places())
    }

    /// How many of its operands are given by place. Those are before the named ones in every row.
    fn places(&self) -> usize {
        let by_place = |operand: &&Operand| operand.presence != Presence::Named;
        self.operands.iter().take_while(by_place).count()
    }

    /// Whether the last positional operands may be given again and again.
    pub fn repeats(&self) -> bool {
        self.group_size().is_some()
    }

    /// How many operands one repetition has.
    fn group_size(&self) -> Option<usize> {
        self.operands.iter().find_map(|operand| match operand.presence {
            Presence::Repeated { group, .. } => Some(usize::from(group)),
            _ => None,
        })
    }

    /// Whether `count` operands by place fit this row.
    pub fn takes(&self, count: usize) -> bool {
        let least = self.required();
        match self.group_size() {
            Some(group) => count >= least && (count - least).is_multiple_of(group),
            None => (least..=self.places()).contains(&count),
        }
    }

    /// The operand that the `index`-th positional value (from 0) stands for.
    pub fn positional(&self, index: usize) -> Option<&'static Operand> {
        // The repeated operands are the last of these.
        let places = self.places();
        if index < places {
            return Some(&self.operands[index]);
        }
        let group = self.group_size()?;
        Some(&self.operands[places - group + (index - places) % group])
    }

    /// The optional operand with this name, compared without case.
    pub fn named(&self, name: &str) -> Option<&'static Operand> {
        self.operands
            .iter()
            .find(|operand| operand.presence == Presence::Named && operand.name.eq_ignore_ascii_case(name))
    }

    /// Every spelling that finds this row: the canonical one, its equals, those also accepted.
    pub fn spellings(&self) -> impl Iterator<Item = &'static str> + use<> {
        std::iter::once(self.mnemonic)
            .chain(self.synonyms.iter().copied())
            .chain(self.aliases.iter().copied())
    }

    /// Whether it does its work at every evaluation, whatever EN is.
    pub fn always_acts(&self) -> bool {
        self.acts == Acts::Always
    }

    /// The first sentence of the documentation, for a list where there is no room for more.
    pub fn summary(&self) -> &'static str {
        self.doc.split_once("\n\n").map_or(self.doc, |(first, _)| first)
    }

    /// What there is to say of it in a profile next to the rest: how it differs there, or that it is not there.
    pub fn in_profile(&self, profile: Profile) -> Option<&'static str> {
        if !self.profiles.contain(profile) {
            return Some("The system has no such instruction.");
        }
        let mut differs = self.differs.iter();
        differs
            .find(|(other, _)| *other == profile)
            .map(|(_, text)| *text)
    }

    /// Those profiles in which there is something to say of it, with what it is.
    pub fn in_profiles(&self) -> impl Iterator<Item = (Profile, &'static str)> + '_ {
        let all = Profile::ALL.into_iter();
        all.filter_map(|profile| Some((profile, self.in_profile(profile)?)))
    }

    /// The block without its operands, as it is written: `[TON]`, `( )`, `<RET>`.
    pub fn block(&self) -> String {
        let (open, close) = self.shape.brackets();
        format!("{open}{}{close}", self.mnemonic)
    }

    /// The signature as a person writes it: `[TON]( t, PT, R := )`, without operands that profile `iec` does not know.
    pub fn signature(&self) -> String {
        self.signature_in(Profile::Iec)
    }

    /// As [`Instruction::signature`], in a profile.
    pub fn signature_in(&self, profile: Profile) -> String {
        if self.operands.is_empty() {
            return self.block();
        }
        let repeats_after = self
            .operands
            .iter()
            .rposition(|o| matches!(o.presence, Presence::Repeated { .. }));
        let parts: Vec<String> = self
            .operands
            .iter()
            .enumerate()
            .filter(|(_, operand)| operand.profiles.contain(profile))
            .map(|(index, operand)| match (operand.presence, operand.direction) {
                (Presence::Named, Direction::Out) => format!("{} =>", operand.name),
                (Presence::Named, _) => format!("{} :=", operand.name),
                _ if repeats_after == Some(index) => format!("{}, ...", operand.name),
                _ => operand.name.to_owned(),
            })
            .collect();
        format!("{}( {} )", self.block(), parts.join(", "))
    }
}
