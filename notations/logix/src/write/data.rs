//! Types, tags and their values.

use super::names::Kind;
use super::operand::milliseconds;
use super::{Result, Writer};
use crate::model::{DataType, Member, Raw, Tag, Usage};
use crate::opened::{has_parameters, is_built_in};
use ladder_analysis::cross_reference;
use ladder_analysis::names::scope::{Origin, Scope, SectionKind, TagFacts};
use ladder_analysis::program::ParameterKind;
use ladder_analysis::values::compound::{Compound, Structure};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::{Value, real_text};
use ladder_instructions::StateType;
use ladder_notation::comments;
use ladder_syntax::ast::{AstNode, NodeView, StructHeader};
use ladder_syntax::{LineKind, Name};
use std::collections::HashMap;

/// How long a STRING of Logix is.
const STRING: u16 = 82;
/// So many values that are all zero are not written.
const MOST_ZEROS: usize = 1_000;
/// The largest array.
const MOST_ELEMENTS: i64 = 1_000_000;

/// Whose a tag is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Home {
    Controller,
    Program(usize),
}

/// What the comments at declarations say, by the block and the tag.
pub(super) type Comments = HashMap<(String, Name), String>;

/// What Logix calls an elementary type that is not a text; none if it has none.
pub(super) fn name_of(scalar: Scalar) -> Option<&'static str> {
    Some(match scalar {
        Scalar::Byte => "USINT",
        Scalar::Word => "UINT",
        Scalar::Dword => "UDINT",
        Scalar::Lword => "ULINT",
        Scalar::Time | Scalar::Enum(_) => "DINT",
        Scalar::Date | Scalar::Tod | Scalar::Dt | Scalar::String(_) => return None,
        other => other.name(),
    })
}

/// A value as a number.
pub(super) fn number_of(value: Option<&Value>, scalar: Option<Scalar>) -> Result<String> {
    Ok(match (value, scalar) {
        (Some(Value::Bool(high)), _) => u8::from(*high).to_string(),
        (Some(Value::Int(span)), Some(Scalar::Time)) => milliseconds(*span)?.to_string(),
        (Some(Value::Int(number)), Some(Scalar::Ulint | Scalar::Lword)) => (*number as u64).to_string(),
        (Some(Value::Int(number)), _) => number.to_string(),
        (Some(Value::Real(number)), scalar) => real_text(*number, scalar.unwrap_or(Scalar::Lreal)),
        (_, Some(scalar)) if scalar.is_real() => "0.0".to_owned(),
        _ => "0".to_owned(),
    })
}

/// A type there: its name, and the size of each dimension.
#[derive(Debug, Clone)]
pub(super) struct There {
    name: String,
    dimensions: Vec<u32>,
}

/// Where a value is: the block, in capitals, and the path of the tag.
#[derive(Debug, Clone, Default)]
struct At {
    block: String,
    path: String,
}

impl At {
    fn member(&self, name: &str) -> At {
        let path = format!("{}.{name}", self.path);
        At {
            path,
            block: self.block.clone(),
        }
    }

    fn element(&self, indices: &[i64]) -> At {
        let indices: Vec<String> = indices.iter().map(i64::to_string).collect();
        let path = format!("{}[{}]", self.path, indices.join(", "));
        At {
            path,
            block: self.block.clone(),
        }
    }
}

impl Writer<'_> {
    /// What the comments at declarations say.
    pub(super) fn comments(&self) -> Comments {
        let entries = cross_reference(&self.input.analysis.context);
        let told = entries.into_iter().filter(|entry| !entry.comment.is_empty());
        told.map(|entry| {
            let block = entry.block.unwrap_or_default().to_ascii_uppercase();
            ((block, Name::new(&entry.name)), entry.comment)
        })
        .collect()
    }

    /// The tags of a scope, each with whose it is.
    pub(super) fn tags(&mut self, scope: &Scope, block: &str, told: &Comments) -> Vec<(Home, Tag)> {
        let mut out = Vec::new();
        for facts in &scope.tags {
            let is_shared = facts.is_alias() || matches!(facts.origin, Origin::Implicit | Origin::Shared);
            if is_shared || self.facts.absorbed_names.contains(&Name::new(&facts.name)) {
                continue;
            }
            match self.tag(facts, block) {
                Ok(mut tag) => {
                    let key = (block.to_ascii_uppercase(), Name::new(&facts.name));
                    tag.comment = told
                        .get(&key)
                        .and_then(|told| self.told_of(&facts.name, &tag.name, told));
                    // A tag of a module is declared by that.
                    if self.input.layout.originals.is_none() || !tag.name.contains(':') {
                        out.push((self.home(facts), tag));
                    }
                }
                Err(why) => {
                    let place = self.place_of(facts);
                    self.report.refused(place, format!("tag {}", facts.name), why);
                }
            }
        }
        out
    }

    /// Whose a tag is.
    fn home(&self, facts: &TagFacts) -> Home {
        let at = self.input.layout.tag(&facts.name);
        if let Some(at) = at.filter(|at| at.is_original) {
            return at.program.map_or(Home::Controller, Home::Program);
        }
        match facts.origin {
            Origin::Declared(SectionKind::Global | SectionKind::External) => Home::Controller,
            _ => match at {
                Some(at) => at.program.map_or(Home::Controller, Home::Program),
                None => Home::Program(0),
            },
        }
    }

    /// What a comment says of a tag: not what it is called in the file that it comes from.
    fn told_of(&self, name: &str, original: &str, told: &str) -> Option<String> {
        let bare = match told.strip_prefix(original) {
            Some(rest) if self.input.layout.originals.is_some() && name != original => rest
                .strip_prefix(": ")
                .or(rest.is_empty().then_some(""))
                .unwrap_or(told),
            _ => told,
        };
        (!bare.is_empty()).then(|| bare.to_owned())
    }

    fn tag(&mut self, facts: &TagFacts, block: &str) -> Result<Tag> {
        let ty = facts.ty.ok_or("its type is not known")?;
        let there = self.ty(ty)?;
        if ty.scalar() == Some(Scalar::Time) && !self.input.is_own {
            let place = self.place_of(facts);
            let why = "there a time is a DINT in milliseconds";
            self.report
                .approximated(place, format!("tag {}", facts.name), why);
        }
        if let Some(address) = &facts.cold.address {
            let place = self.place_of(facts);
            let why = format!(
                "it is a tag of its own there: make it an alias of the module's data that {address} stands for"
            );
            self.report
                .approximated(place, format!("tag {}", facts.name), why);
        }
        let values = match &facts.cold.initial[..] {
            [] => ty.initial_values(),
            given => given.to_vec(),
        };
        let is_zero = |value: &Value| match value {
            Value::Bool(high) => !high,
            Value::Int(number) => *number == 0,
            Value::Real(number) => *number == 0.0,
            Value::Text(text) => text.is_empty(),
        };
        // Zeros in a large array say nothing.
        let count: u64 = there.dimensions.iter().map(|size| u64::from(*size)).product();
        let is_large = values.len() > MOST_ZEROS || count > MOST_ZEROS as u64;
        let value = if is_large && values.iter().all(is_zero) {
            None
        } else {
            let at = At {
                block: block.to_ascii_uppercase(),
                path: facts.name.to_string(),
            };
            self.raw(ty, &at, &mut values.into_iter())?
        };
        Ok(Tag {
            name: self.root(&facts.name),
            ty: there.name,
            dimensions: there.dimensions,
            usage: match facts.origin {
                Origin::Declared(SectionKind::Input) => Usage::Input,
                Origin::Declared(SectionKind::Output) => Usage::Output,
                Origin::Declared(SectionKind::InOut) => Usage::InOut,
                _ => Usage::Local,
            },
            constant: facts.constant,
            value,
            ..Tag::default()
        })
    }

    pub(super) fn ty(&mut self, ty: Type) -> Result<There> {
        let scalar = |name: String| There {
            name,
            dimensions: Vec::new(),
        };
        if let Some((dimensions, element)) = ty.array() {
            let element = self.ty(element)?;
            if !element.dimensions.is_empty() {
                return Err("an array of arrays has no counterpart there".to_owned());
            }
            let mut sizes = Vec::new();
            for (first, last) in &dimensions {
                if *first < 0 || *last >= MOST_ELEMENTS {
                    return Err("there an array begins at 0".to_owned());
                }
                sizes.push(u32::try_from(*last + 1).unwrap_or(u32::MAX));
            }
            // Bits are kept in words there.
            if let ("BOOL", [size]) = (element.name.as_str(), &mut sizes[..]) {
                *size = size.div_ceil(32) * 32;
            }
            return Ok(There {
                name: element.name,
                dimensions: sizes,
            });
        }
        Ok(match ty {
            Type::Scalar(Scalar::String(STRING)) => scalar("STRING".to_owned()),
            Type::Scalar(Scalar::String(length)) => scalar(self.text_type(length)),
            Type::Scalar(own) => scalar(name_of(own).ok_or("there are no dates there")?.to_owned()),
            Type::State(state) => scalar(match state {
                StateType::Ton | StateType::Tof | StateType::Tp | StateType::Rto => "TIMER".to_owned(),
                StateType::Ctu | StateType::Ctd | StateType::Ctud => "COUNTER".to_owned(),
                StateType::Sr | StateType::Rs => "BOOL".to_owned(),
                StateType::Rtof | StateType::Ctc => {
                    return Err("there is no such timer or counter there".to_owned());
                }
            }),
            Type::Compound(id) => match id.get() {
                Compound::Structure(structure) => scalar(self.structure(&structure)?),
                Compound::Block(name) => scalar(self.block_type(&name)?),
                Compound::Array(_) => return Err("this array has no counterpart there".to_owned()),
            },
            Type::Array { .. } => return Err("this array has no counterpart there".to_owned()),
        })
    }

    /// A text of another length than Logix' own.
    fn text_type(&mut self, length: u16) -> String {
        let name = format!("STRING_{length}");
        if self.data.types.iter().all(|ty| ty.name != name) {
            let member = |name: &str, ty: &str, size: Option<u32>| Member {
                name: name.to_owned(),
                ty: ty.to_owned(),
                dimensions: size.into_iter().collect(),
                ..Member::default()
            };
            self.data.types.push(DataType {
                name: name.clone(),
                is_string: true,
                members: vec![
                    member("LEN", "DINT", None),
                    member("DATA", "SINT", Some(u32::from(length))),
                ],
                ..DataType::default()
            });
        }
        name
    }

    /// The name of a structure, which is declared if it is not yet.
    fn structure(&mut self, structure: &Structure) -> Result<String> {
        if let Some(own) = standard(structure) {
            return Ok(own.to_owned());
        }
        if is_built_in(&structure.name) {
            return Ok(structure.name.to_string());
        }
        let name = self.names.spell(Kind::Type, &structure.name);
        // What the file knows without a declaration needs none.
        let is_there = self.input.layout.originals.as_ref().is_some_and(|originals| {
            let known = originals.types.contains_key(&Name::new(&structure.name));
            known && !originals.declared.contains(&name.to_ascii_uppercase())
        });
        if is_there || self.data.types.iter().any(|ty| ty.name == name) {
            return Ok(name);
        }
        let (comment, told) = self.structure_comments(&structure.name, &name);
        let mut members: Vec<Member> = Vec::new();
        let mut bits = 0;
        for (number, own) in structure.members.iter().enumerate() {
            let there = self.ty(own.ty)?;
            let mut member = Member {
                name: self.member_name(&own.name),
                ty: there.name,
                dimensions: there.dimensions,
                comment: told.get(&own.key).cloned(),
                ..Member::default()
            };
            if member.dimensions.len() > 1 {
                return Err("there a member has one dimension".to_owned());
            }
            // Bits share a hidden word.
            if member.ty == "BOOL" && member.dimensions.is_empty() {
                let is_first = bits % 8 == 0;
                let host = match members.iter().rev().find(|member| member.hidden) {
                    Some(host) if !is_first => host.name.clone(),
                    _ => {
                        let host = format!("ZZZZZZZZZZ{}{number}", shortened(&name));
                        members.push(Member {
                            name: host.clone(),
                            ty: "SINT".to_owned(),
                            hidden: true,
                            ..Member::default()
                        });
                        host
                    }
                };
                "BIT".clone_into(&mut member.ty);
                member.bit = Some((host, bits % 8));
                bits += 1;
            } else {
                bits = 0;
            }
            members.push(member);
        }
        self.data.types.push(DataType {
            name: name.clone(),
            members,
            comment,
            ..DataType::default()
        });
        Ok(name)
    }

    /// What the comments at the declaration of a structure say: above it, and at its members.
    fn structure_comments(&mut self, name: &str, there: &str) -> (Option<String>, HashMap<Name, String>) {
        let parse = &self.input.analysis.context.parse;
        let lines = parse.lines();
        let said_on = |line: usize| {
            let all = comments::on_line(parse, line);
            all.join(" ").split_whitespace().collect::<Vec<_>>().join(" ")
        };
        let is_it = |line: &usize| {
            if lines[*line].kind != LineKind::StructHeader {
                return false;
            }
            let tree = lines[*line].tree();
            let header = StructHeader::cast(NodeView::root(&tree));
            let mut names = header.iter().flat_map(StructHeader::names);
            names.any(|own| Name::new(own.text()) == Name::new(name))
        };
        let mut members = HashMap::new();
        let sections = parse.structure().sections.iter();
        let Some(header) = sections.flat_map(|section| section.lines.clone()).find(is_it) else {
            return (None, members);
        };
        self.data.type_order.insert(there.to_owned(), header);
        let mut above: Vec<String> = Vec::new();
        for line in (0..header)
            .rev()
            .take_while(|line| lines[*line].kind == LineKind::Comment)
        {
            above.insert(0, said_on(line));
        }
        let inside = (header + 1..lines.len()).take_while(|line| lines[*line].kind != LineKind::StructEnd);
        for line in inside.filter(|line| lines[*line].kind == LineKind::Declaration) {
            let told = said_on(line);
            let tree = lines[line].tree();
            let names = ladder_syntax::ast::Declaration::cast(NodeView::root(&tree));
            for name in names
                .iter()
                .flat_map(ladder_syntax::ast::Declaration::names)
                .filter(|_| !told.is_empty())
            {
                members.insert(Name::new(name.text()), told.clone());
            }
        }
        ((!above.is_empty()).then(|| above.join("\n")), members)
    }

    /// The values of a type, out of those of its elementary parts in their order.
    fn raw(&mut self, ty: Type, at: &At, values: &mut impl Iterator<Item = Value>) -> Result<Option<Raw>> {
        if let Some((dimensions, element)) = ty.array() {
            let there = self.ty(ty)?;
            let elements = self.elements_of(&dimensions, element, at, values)?;
            return Ok(Some(Raw::Array(there.name, there.dimensions, elements)));
        }
        Ok(Some(match ty {
            Type::Scalar(Scalar::String(_)) => {
                let name = self.ty(ty)?.name;
                let text = match values.next() {
                    Some(Value::Text(text)) => text,
                    _ => Box::default(),
                };
                let length = Raw::Scalar("DINT".to_owned(), text.len().to_string());
                let characters = Raw::Scalar(name.clone(), escaped(&text));
                let members = vec![("LEN".to_owned(), length), ("DATA".to_owned(), characters)];
                Raw::Structure(name, members)
            }
            Type::Scalar(scalar) => {
                let value = values.next();
                Raw::Scalar(self.ty(ty)?.name, number_of(value.as_ref(), Some(scalar))?)
            }
            Type::State(state) => {
                let key = (at.block.clone(), Name::new(&at.path));
                state_value(state, self.data.presets.get(&key).map_or("0", String::as_str))
            }
            Type::Compound(id) => match id.get() {
                Compound::Structure(structure) => {
                    let mut members = Vec::new();
                    for member in &structure.members {
                        let value = self.raw(member.ty, &at.member(&member.name), values)?;
                        // What the reader adds to a TIMER is none of it there.
                        let is_there = standard(&structure) != Some("TIMER") || member.name != "LAST";
                        let name = self.member_name(&member.name);
                        members.extend(value.filter(|_| is_there).map(|value| (name, value)));
                    }
                    // Of such a type the program may only know some members, and its tags have parameters there.
                    if has_parameters(&structure.name) && members.iter().all(|(_, value)| is_zero(value)) {
                        return Ok(None);
                    }
                    Raw::Structure(self.structure(&structure)?, members)
                }
                Compound::Block(name) => return self.instance(&name),
                Compound::Array(_) => return Ok(None),
            },
            Type::Array { .. } => return Ok(None),
        }))
    }

    /// What an instance of a block begins with: the values of its parameters.
    fn instance(&mut self, name: &str) -> Result<Option<Raw>> {
        let program = self.input.program;
        let Some(block) = program
            .blocks
            .iter()
            .find(|block| block.name.eq_ignore_ascii_case(name))
        else {
            return Ok(None);
        };
        let system =
            |name: &str, value: &str| (name.to_owned(), Raw::Scalar("BOOL".to_owned(), value.to_owned()));
        let mut members = vec![system("EnableIn", "1"), system("EnableOut", "0")];
        for (tag, _) in block
            .parameters
            .iter()
            .filter(|(_, kind)| *kind != ParameterKind::InOut)
        {
            let tag = &program.tags[tag.0 as usize];
            let own = tag
                .name
                .rsplit_once('.')
                .map_or(tag.name.as_str(), |(_, own)| own);
            let value = self.raw(tag.ty, &At::default(), &mut tag.initial.iter().cloned())?;
            let own = self.member_name(own);
            members.extend(value.map(|value| (own, value)));
        }
        Ok(Some(Raw::Structure(self.block_type(name)?, members)))
    }

    /// The elements of an array from index 0 on, row by row.
    fn elements_of(
        &mut self,
        dimensions: &[(i64, i64)],
        element: Type,
        at: &At,
        values: &mut impl Iterator<Item = Value>,
    ) -> Result<Vec<Raw>> {
        let mut out = Vec::new();
        let whole = self.ty(element)?;
        let zero = {
            let mut zeros = element.initial_values().into_iter();
            self.raw(element, &At::default(), &mut zeros)?
                .unwrap_or(Raw::Scalar(whole.name, "0".to_owned()))
        };
        let mut indices = vec![0i64; dimensions.len()];
        let is_bits = element.scalar() == Some(Scalar::Bool) && dimensions.len() == 1;
        let mut sizes: Vec<i64> = dimensions.iter().map(|(_, last)| last + 1).collect();
        if is_bits {
            sizes[0] = (sizes[0] + 31) / 32 * 32;
        }
        for _ in 0..sizes.iter().product::<i64>() {
            let mut all = indices.iter().zip(dimensions);
            let inside = all.all(|(index, (first, last))| (first..=last).contains(&index));
            let value = if !inside {
                None
            } else if element.scalar().is_some() {
                // What is not a timer or counter is nowhere looked for.
                self.raw(element, at, values)?
            } else {
                self.raw(element, &at.element(&indices), values)?
            };
            out.push(value.unwrap_or_else(|| zero.clone()));
            for (index, size) in indices.iter_mut().zip(&sizes).rev() {
                *index += 1;
                if *index < *size {
                    break;
                }
                *index = 0;
            }
        }
        Ok(out)
    }
}

/// The structure that every controller has which one is.
fn standard(structure: &Structure) -> Option<&'static str> {
    const NAMES: [&str; 3] = ["TIMER", "COUNTER", "CONTROL"];
    let own = NAMES
        .into_iter()
        .find(|name| structure.name.eq_ignore_ascii_case(name))?;
    let members: &[&str] = match own {
        "TIMER" => &["PRE", "ACC", "EN", "TT", "DN", "LAST"],
        "COUNTER" => &["PRE", "ACC", "CU", "CD", "DN", "OV", "UN"],
        _ => &["LEN", "POS", "EN", "EU", "DN", "EM", "ER", "UL", "IN", "FD"],
    };
    let same = structure
        .members
        .iter()
        .map(|member| member.name.as_str())
        .eq(members.iter().copied());
    same.then_some(own)
}

fn state_value(state: StateType, preset: &str) -> Raw {
    let (name, numbers, bits): (_, _, &[&str]) = match state {
        StateType::Ctu | StateType::Ctd | StateType::Ctud | StateType::Ctc => {
            ("COUNTER", ["PRE", "ACC"], &["CU", "CD", "DN", "OV", "UN"])
        }
        StateType::Sr | StateType::Rs => return Raw::Scalar("BOOL".to_owned(), "0".to_owned()),
        _ => ("TIMER", ["PRE", "ACC"], &["EN", "TT", "DN"]),
    };
    let zero = |ty: &str| Raw::Scalar(ty.to_owned(), "0".to_owned());
    let numbers = numbers.iter().zip([preset, "0"]);
    let numbers = numbers.map(|(name, number)| {
        (
            (*name).to_owned(),
            Raw::Scalar("DINT".to_owned(), number.to_owned()),
        )
    });
    let bits = bits.iter().map(|name| ((*name).to_owned(), zero("BOOL")));
    Raw::Structure(name.to_owned(), numbers.chain(bits).collect())
}

fn is_zero(value: &Raw) -> bool {
    match value {
        Raw::Scalar(_, text) => text.parse() == Ok(0.0),
        Raw::Structure(_, members) => members.iter().all(|(_, value)| is_zero(value)),
        Raw::Array(_, _, elements) | Raw::List(elements) => elements.iter().all(is_zero),
    }
}

fn shortened(name: &str) -> String {
    name.chars().take(10).collect()
}

/// Characters as Logix writes them in a text.
fn escaped(text: &[u8]) -> String {
    let mut out = String::new();
    for byte in text {
        match byte {
            b'$' => out.push_str("$$"),
            b'\'' => out.push_str("$'"),
            b' '..=b'~' => out.push(*byte as char),
            _ => out.push_str(&format!("${byte:02X}")),
        }
    }
    out
}
