//! Tags by name: what a person writes (`t1.ET`, `a[3]`, `w.3`) to where it lives.

mod point;

use crate::compile::{CHANNELS, Ports};
use crate::groups;
use crate::layout::{self, Home, MemberSlot};
use crate::members::{member_of, members};
use crate::memory::Bit;
use crate::system::{System, SystemSlot};
use ladder_analysis::program::{Program, Role, SystemTag, Tag, TagId};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::with_article;
use ladder_syntax::Name;
pub use point::{Point, PointSlot};
pub(crate) use point::{Within, is_inside};
use std::collections::HashMap;

/// Why a name leads to no value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnknownTag {
    /// What is wrong and what to do.
    pub message: String,
}

impl std::fmt::Display for UnknownTag {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for UnknownTag {}

fn unknown<T>(message: impl Into<String>) -> Result<T, UnknownTag> {
    Err(UnknownTag {
        message: message.into(),
    })
}

/// The tags of a program by name. Tags of user-defined blocks are not among them: they exist once for each place.
#[derive(Debug)]
pub(crate) struct Names {
    tags: HashMap<Name, u32>,
}

impl Names {
    pub(crate) fn of(program: &Program) -> Names {
        let visible = program
            .tags
            .iter()
            .enumerate()
            .filter(|(_, tag)| tag.block.is_none());
        // The program's own tags are before those of other files and shadow them.
        let mut tags = HashMap::new();
        for (index, tag) in visible {
            tags.entry(Name::new(&tag.name)).or_insert(index as u32);
        }
        for other in program.other_names.iter().filter(|other| other.block.is_none()) {
            tags.entry(Name::new(&other.name)).or_insert(other.tag.0);
        }
        let addresses = (0u32..).zip(&program.tags).filter(|(_, tag)| tag.block.is_none());
        for (index, address) in addresses.filter_map(|(index, tag)| Some((index, tag.address.as_ref()?))) {
            tags.entry(Name::new(address)).or_insert(index);
        }
        // What is a plant's needs its name only where the program, or another plant, has such a tag.
        let mut of_plants: HashMap<Name, Option<u32>> = HashMap::new();
        for plant in &program.plants {
            let all = (0u32..).zip(&program.tags).filter(|(_, tag)| tag.block.is_none());
            for (index, own) in all.filter_map(|(index, tag)| Some((index, plant.tag_in(&tag.name)?))) {
                let known = of_plants.entry(Name::new(own));
                known.and_modify(|known| *known = None).or_insert(Some(index));
            }
        }
        for (name, index) in of_plants
            .into_iter()
            .filter_map(|(name, index)| Some((name, index?)))
        {
            tags.entry(name).or_insert(index);
        }
        Names { tags }
    }

    /// The tags of one place where a user-defined block is, and those at direct addresses that its body has names for.
    pub(crate) fn of_instance(program: &Program, block: usize, tags: impl Iterator<Item = TagId>) -> Names {
        let named = tags.map(|tag| (Name::new(&program.tags[tag.0 as usize].name), tag.0));
        let others = program.other_names.iter();
        let others = others.filter(|other| other.block == Some(block));
        let others = others.map(|other| (Name::new(&other.name), other.tag.0));
        Names {
            tags: named.chain(others).collect(),
        }
    }

    /// The value that a text names.
    pub(crate) fn resolve(&self, program: &Program, homes: &[Home], text: &str) -> Result<Point, UnknownTag> {
        let text = text.trim();
        if let Some(index) = self.find(text) {
            let tag = &program.tags[index];
            if let (Type::Scalar(_), Some(point)) = (tag.ty, groups::element(tag, homes[index], 0)) {
                return Ok(point);
            }
            return match tag.ty {
                Type::State(state) => unknown(format!(
                    "{} is {}: name one of its members, as in {}.{}",
                    tag.name,
                    with_article(state.name()),
                    tag.name,
                    members(state)[0].0
                )),
                Type::Array { first, .. } => unknown(format!(
                    "{} is an array: name one of its elements, as in {}[{first}]",
                    tag.name, tag.name
                )),
                Type::Scalar(_) | Type::Compound(_) => {
                    unknown(format!("{} has no value that can be shown", tag.name))
                }
            };
        }
        if let Some(found) = self.in_column(program, homes, text) {
            return found;
        }
        if let Some((array, index)) = text.strip_suffix(']').and_then(|text| text.rsplit_once('[')) {
            return self.element(program, homes, array.trim_end(), index.trim());
        }
        if let Some((whole, member)) = text.rsplit_once('.') {
            return self.member(program, homes, whole.trim_end(), member.trim());
        }
        self.unknown_tag(program, text)
    }

    /// The value of an elementary part by its path: `lines[2].running`. None: there is no such part.
    fn in_column(&self, program: &Program, homes: &[Home], text: &str) -> Option<Result<Point, UnknownTag>> {
        let (number, indices) = self.column(text)?;
        let tag = &program.tags[number];
        let dimensions = &tag.column.as_ref()?.dimensions;
        if dimensions.len() != indices.len() {
            return None;
        }
        let mut position = 0;
        for (index, (first, last)) in indices.iter().zip(dimensions) {
            if !(first..=last).contains(&index) {
                return Some(unknown(format!(
                    "{} does not exist: this index goes from {first} to {last}",
                    canonical(text)
                )));
            }
            position = position * (last - first + 1) + (index - first);
        }
        if let Type::Array { first, .. } = tag.ty {
            position += first;
        }
        let point = groups::element(tag, homes[number], position);
        Some(point.map_or_else(
            || unknown(format!("{} has no value that can be shown", tag.name)),
            Ok,
        ))
    }

    /// The tag that holds all elements of a part, and which of them a path names.
    fn column(&self, text: &str) -> Option<(usize, Vec<i64>)> {
        let (column, indices) = without_indices(text)?;
        if let Some(number) = self.find(&column) {
            return Some((number, indices));
        }
        // In the state of a block that is an element, the first indices belong to the name.
        let text = canonical(text);
        let ends = text.match_indices(']').map(|(at, _)| at + 1);
        ends.take(indices.len()).find_map(|end| {
            let (state, rest) = text.split_at(end);
            let (column, left) = without_indices(rest)?;
            let number = self.find(&format!("{state}{column}"))?;
            Some((number, left))
        })
    }

    /// The number of the tag with this name.
    pub(crate) fn find(&self, text: &str) -> Option<usize> {
        let found = self.tags.get(&Name::new(text));
        // The state of an element is a tag of its own, with the index in its name.
        let spaced = || {
            text.contains('[')
                .then(|| self.tags.get(&Name::new(&canonical(text))))?
        };
        found.or_else(spaced).map(|&index| index as usize)
    }

    fn element(
        &self,
        program: &Program,
        homes: &[Home],
        array: &str,
        index: &str,
    ) -> Result<Point, UnknownTag> {
        let Some(number) = self.find(array) else {
            return self.unknown_tag(program, array);
        };
        let tag = &program.tags[number];
        let Type::Array { first, last, .. } = tag.ty else {
            return unknown(format!(
                "{} is not an array: it is {} and has no elements",
                tag.name,
                with_article(tag.ty)
            ));
        };
        let Ok(position) = index.parse::<i64>() else {
            return unknown(format!(
                "`{index}` is not an index: write a number, as in {}[{first}]",
                tag.name
            ));
        };
        if !(first..=last).contains(&position) {
            return unknown(format!(
                "{}[{position}] does not exist: the array goes from {first} to {last}",
                tag.name
            ));
        }
        groups::element(tag, homes[number], position).map_or_else(
            || unknown(format!("{} has no value that can be shown", tag.name)),
            Ok,
        )
    }

    fn member(
        &self,
        program: &Program,
        homes: &[Home],
        whole: &str,
        member: &str,
    ) -> Result<Point, UnknownTag> {
        if whole.eq_ignore_ascii_case("SYS") {
            return system_tag(member, System::CONTROLLER);
        }
        if let Some(number) = self.find(whole)
            && let Home::State { state, bits, words } = homes[number]
        {
            let tag = &program.tags[number];
            let found = member_of(state, member).and_then(|(name, member)| {
                let slot = match layout::member(state, bits, words, member)? {
                    MemberSlot::Bit(slot) => PointSlot::Bit(slot),
                    MemberSlot::Word(slot) => PointSlot::Word(slot),
                    MemberSlot::Timing { input, done } => PointSlot::Timing { input, done },
                };
                Some((name, member, slot))
            });
            let Some((name, member, slot)) = found else {
                let names: Vec<&str> = members(state).iter().map(|(name, _)| *name).collect();
                return unknown(format!(
                    "{} has no member `{member}`: {} has {}",
                    tag.name,
                    with_article(state.name()),
                    names.join(" ")
                ));
            };
            return Ok(Point {
                name: format!("{}.{name}", tag.name),
                ty: program.member_type(tag, member),
                role: tag.role,
                is_input: tag.is_input && !matches!(slot, PointSlot::Timing { .. }),
                read_only: matches!(slot, PointSlot::Timing { .. }),
                within: Within::State(state),
                slot,
            });
        }
        let point = self.resolve(program, homes, whole)?;
        let PointSlot::Word(word) = point.slot else {
            return unknown(format!(
                "{} is {} and has no members",
                point.name,
                with_article(point.ty)
            ));
        };
        let bit = member
            .parse::<u8>()
            .ok()
            .filter(|&bit| u32::from(bit) < point.ty.width());
        match bit {
            Some(bit) if point.ty.is_bits() || point.ty.is_integer() => Ok(Point {
                name: format!("{}.{bit}", point.name),
                ty: Scalar::Bool,
                role: point.role,
                is_input: point.is_input,
                read_only: point.read_only,
                within: Within::Number,
                slot: PointSlot::BitOf {
                    word,
                    bit,
                    ty: point.ty,
                },
            }),
            _ if point.ty.is_bits() || point.ty.is_integer() => unknown(format!(
                "{} has no bit `{member}`: the bits of {} are 0 to {}",
                point.name,
                with_article(point.ty),
                point.ty.width() - 1
            )),
            _ => unknown(format!(
                "{} is {} and has no members",
                point.name,
                with_article(point.ty)
            )),
        }
    }

    fn unknown_tag<T>(&self, program: &Program, text: &str) -> Result<T, UnknownTag> {
        let typed = Name::new(text);
        let is_part = |tag: &&Tag| {
            let rest = tag
                .name
                .get(..text.len())
                .filter(|start| Name::new(start) == typed);
            let rest = rest.and_then(|_| tag.name.get(text.len()..));
            tag.column.is_some() && rest.is_some_and(|rest| rest.starts_with(['.', '[']))
        };
        if let Some(part) = program.tags.iter().find(is_part) {
            let first = part.column.as_ref().map_or(0, |column| match *column.dimensions {
                [(first, _)] => first,
                _ => 0,
            });
            return unknown(format!(
                "{text} has parts: name one of them, as in {}",
                if part.name.contains("[]") {
                    part.element_name(first)
                } else {
                    part.name.clone()
                }
            ));
        }
        let letters = text.chars().count();
        let nearest = self
            .tags
            .iter()
            .map(|(name, &index)| (strsim::damerau_levenshtein(name.as_str(), typed.as_str()), index))
            .min()
            // Where most letters differ nothing is alike.
            .filter(|&(slips, _)| slips <= 1 + letters / 4 && slips < letters);
        match nearest {
            Some((_, index)) => unknown(format!(
                "there is no tag `{text}`; did you mean {}?",
                program.tags[index as usize].name
            )),
            None if self.tags.is_empty() => {
                unknown(format!("there is no tag `{text}`: the program has no tags"))
            }
            None => unknown(format!("there is no tag `{text}` in this program")),
        }
    }
}

/// A path without its indices, and these: `lines[2].running` is `lines[].running` at 2. None: an index is not a number.
fn without_indices(text: &str) -> Option<(String, Vec<i64>)> {
    let (mut column, mut indices) = (String::new(), Vec::new());
    let mut rest = text;
    while let Some((before, after)) = rest.split_once('[') {
        let (inside, after) = after.split_once(']')?;
        column.push_str(before.trim());
        for index in inside.split(',') {
            indices.push(index.trim().parse().ok()?);
            column.push_str("[]");
        }
        rest = after;
    }
    column.push_str(rest.trim());
    (!indices.is_empty() || column.contains('.')).then_some((column, indices))
}

/// A path as it is shown: without blanks but after the commas between its indices.
pub(crate) fn canonical(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars().filter(|c| !c.is_whitespace()) {
        out.push(c);
        if c == ',' {
            out.push(' ');
        }
    }
    out.replace("][", ", ")
}

/// A system tag.
pub(crate) fn system_tag(name: &str, system: System) -> Result<Point, UnknownTag> {
    if name.eq_ignore_ascii_case("POWER") && system == System::CONTROLLER {
        return Ok(power());
    }
    let Some(tag) = SystemTag::from_name(name) else {
        return unknown(format!(
            "there is no SYS.{name}: the system tags are {}",
            SystemTag::list()
        ));
    };
    let slot = match system.slot(tag) {
        SystemSlot::Bit(bit) => PointSlot::Bit(bit),
        SystemSlot::Word(word) => PointSlot::Word(word),
    };
    Ok(Point {
        name: format!("SYS.{}", tag.name()),
        ty: tag.ty(),
        role: Role::Internal,
        is_input: false,
        read_only: true,
        within: Within::None,
        slot,
    })
}

/// `SYS.POWER`: whether the controller has power. It is not a tag of the program.
pub(crate) fn power() -> Point {
    Point {
        name: "SYS.POWER".to_owned(),
        ty: Scalar::Bool,
        role: Role::Input,
        is_input: true,
        read_only: false,
        within: Within::None,
        slot: PointSlot::Bit(Bit::POWER),
    }
}

/// A channel of a port: `PORT.ADC[3]`, `PORT.DUTY[0]`, `PORT.FREQUENCY[0]`. None if the text names no port.
pub(crate) fn port(ports: Ports, text: &str) -> Option<Result<Point, UnknownTag>> {
    let (head, rest) = text.trim().split_at_checked(5)?;
    if !head.eq_ignore_ascii_case("PORT.") {
        return None;
    }
    let (name, channel) = rest
        .strip_suffix(']')
        .and_then(|rest| rest.split_once('['))
        .unwrap_or((rest, ""));
    let (name, base, role) = match name.to_ascii_uppercase().as_str() {
        "ADC" => ("ADC", ports.analog, Role::Input),
        "DUTY" => ("DUTY", ports.pulse, Role::Output),
        "FREQUENCY" => (
            "FREQUENCY",
            ports.pulse.map(|base| base.offset(CHANNELS)),
            Role::Output,
        ),
        _ => {
            return Some(unknown(format!(
                "there is no port `{name}`: the ports are PORT.ADC[0], PORT.DUTY[0], PORT.FREQUENCY[0]"
            )));
        }
    };
    let Some(base) = base else {
        return Some(unknown(format!("the program does not use PORT.{name}")));
    };
    let Some(channel) = channel
        .trim()
        .parse::<u32>()
        .ok()
        .filter(|&channel| channel < CHANNELS)
    else {
        return Some(unknown(format!(
            "the channels of PORT.{name} are 0 to {}",
            CHANNELS - 1
        )));
    };
    Some(Ok(Point {
        name: format!("PORT.{name}[{channel}]"),
        ty: Scalar::Lint,
        role,
        is_input: role == Role::Input,
        read_only: false,
        within: Within::None,
        slot: PointSlot::Word(base.offset(channel)),
    }))
}
