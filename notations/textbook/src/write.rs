//! From a program to the textbook grammar: a line for each network of contacts and coils.

use super::word::Element;
use ladder_analysis::Analysis;
use ladder_analysis::program::{
    Argument, Block, BlockKind, ExprKind, Network, Place as Operand, Program, Role, TagId,
};
use ladder_analysis::values::value::Value;
use ladder_format::Circuit;
use ladder_notation::circuit::series_parallel;
use ladder_notation::{LineColumn, Lines, Report, WriteError, Writing, comments, no_program};
use ladder_syntax::Item;
use std::collections::{BTreeSet, HashMap, HashSet};

/// Writes all networks that the grammar can say.
pub(super) fn write(analysis: &Analysis) -> Result<Writing, WriteError> {
    let Some(program) = analysis.program() else {
        return Err(no_program(analysis, &analysis.context.parse.to_string()));
    };
    let text = analysis.context.parse.to_string();
    let lines = Lines::of(&text);
    let mut writer = Writer {
        program,
        names: names(program),
        used: BTreeSet::new(),
        report: Report::default(),
        place: LineColumn::START,
    };
    let mut out = String::new();
    let mut written = 0;
    let parse = &analysis.context.parse;
    let mut networks = program
        .networks
        .iter()
        .filter(|network| network.location.file == 0);
    for item in &parse.structure().items {
        let lines_of = match *item {
            Item::Decoration(line) => line..line + 1,
            Item::Network(number) => parse.structure().networks[number].lines.clone(),
            _ => continue,
        };
        for comment in lines_of.flat_map(|line| comments::on_line(parse, line)) {
            comments::told(&comment).for_each(|line| out.push_str(&format!("# {line}\n")));
        }
        let Item::Network(_) = item else { continue };
        let Some(network) = networks.next() else { break };
        let range = network.location.range;
        writer.place = lines.place(&text, range.start().into());
        match writer.network(network) {
            Ok(line) => {
                writer.report.translated(writer.place, "network");
                out.push_str(&format!("start {line} end\n"));
                written += 1;
            }
            Err(why) => {
                for row in text[range].lines() {
                    out.push_str(&format!("# {row}\n"));
                }
                writer.report.refused(writer.place, "network", why);
            }
        }
    }
    if written == 0 {
        let why = writer.report.remarks().next().map(|entry| entry.outcome.clone());
        let why = match why {
            Some(ladder_notation::Outcome::Refused(why)) => format!(": {why}"),
            _ => String::new(),
        };
        return Err(WriteError::new(format!(
            "no network of the program can be written in the textbook grammar{why}"
        )));
    }
    writer.renamed();
    Ok(Writing {
        bytes: out.into_bytes(),
        report: writer.report,
        companions: Vec::new(),
    })
}

/// What the grammar calls each tag: as it is where that is a name there, else the next free one.
fn names(program: &Program) -> HashMap<TagId, String> {
    let tags = || {
        program
            .tags
            .iter()
            .enumerate()
            .map(|(index, tag)| (TagId(index as u32), tag))
    };
    let mut names = HashMap::new();
    let mut taken = HashSet::new();
    for (id, tag) in tags() {
        let upper = tag.name.to_ascii_uppercase();
        let number = upper
            .strip_prefix(['I', 'M', 'Q'])
            .and_then(|number| number.parse::<u32>().ok());
        if number.is_some_and(|number| upper[1..] == number.to_string()) {
            taken.insert(upper.clone());
            names.insert(id, upper);
        }
    }
    let mut next = HashMap::from([('I', 0), ('Q', 0), ('M', 0)]);
    for (id, tag) in tags() {
        let letter = match tag.role {
            Role::Input => 'I',
            Role::Output => 'Q',
            Role::Internal => 'M',
        };
        names.entry(id).or_insert_with(|| {
            let number = next.entry(letter).or_insert(0);
            loop {
                let name = format!("{letter}{number}");
                *number += 1;
                if !taken.contains(&name) {
                    return name;
                }
            }
        });
    }
    names
}

struct Writer<'p> {
    program: &'p Program,
    names: HashMap<TagId, String>,
    /// The tags of the networks that were written.
    used: BTreeSet<TagId>,
    report: Report,
    place: LineColumn,
}

impl Writer<'_> {
    fn network(&mut self, network: &Network) -> Result<String, String> {
        let Some(circuit) = series_parallel(network) else {
            return Err("it is more than what is in series and in parallel".to_owned());
        };
        let mut elements = Vec::new();
        let text = self.circuit(&circuit, network, &mut elements)?;
        match (elements.first(), elements.last()) {
            (Some(first), _) if first.is_coil() => Err("it does not begin with a contact".to_owned()),
            (_, Some(last)) if !last.is_coil() => Err("it does not end with a coil".to_owned()),
            (Some(_), Some(_)) => {
                self.used.extend(network.blocks.iter().filter_map(operand));
                Ok(text)
            }
            _ => Err("it has no contact and no coil".to_owned()),
        }
    }

    fn circuit(
        &self,
        circuit: &Circuit<usize>,
        network: &Network,
        out: &mut Vec<Element>,
    ) -> Result<String, String> {
        let (parts, between) = match circuit {
            Circuit::Element(block) => {
                let (element, name) = self.element(&network.blocks[*block])?;
                out.push(element);
                let (one, two) = element.words();
                return Ok(format!("{one} {two} {name}"));
            }
            Circuit::Series(parts) if parts.is_empty() => {
                return Err("the grammar has no bare wire next to a branch".to_owned());
            }
            Circuit::Series(parts) => (parts, " & "),
            Circuit::Parallel(branches) => (branches, " V "),
        };
        let mut texts = Vec::with_capacity(parts.len());
        for part in parts {
            let text = self.circuit(part, network, out)?;
            texts.push(match part {
                Circuit::Element(_) => text,
                // Precedence is not the paper's to say, so nothing is left to it.
                Circuit::Series(_) | Circuit::Parallel(_) => format!("({text})"),
            });
        }
        Ok(texts.join(between))
    }

    fn element(&self, block: &Block) -> Result<(Element, String), String> {
        let only = "the grammar has contacts and coils of single tags only";
        let BlockKind::Instruction(row) = block.kind else {
            return Err(only.to_owned());
        };
        let element = Element::ALL.into_iter().find(|element| element.op() == row.op);
        let element = element.ok_or_else(|| format!("the grammar has no `{}`; {only}", row.block()))?;
        let tag = operand(block).ok_or(only)?;
        let name = self.names.get(&tag).cloned().unwrap_or_default();
        let is_input = !element.is_coil() && name.starts_with('I');
        let on = self.program.tags[tag.0 as usize].initial.first() == Some(&Value::Bool(true));
        let value = if is_input {
            format!(".{}", u8::from(on))
        } else {
            String::new()
        };
        Ok((element, name + &value))
    }

    /// Says which tags have another name now.
    fn renamed(&mut self) {
        for id in &self.used {
            let (tag, Some(name)) = (&self.program.tags[id.0 as usize], self.names.get(id)) else {
                continue;
            };
            if !tag.name.eq_ignore_ascii_case(name) {
                let why = format!("the grammar knows names such as I0, M0 and Q0 only; it is `{name}` there");
                self.report
                    .approximated(LineColumn::START, format!("tag `{}`", tag.name), why);
            }
        }
    }
}

/// The tag of a contact or coil, if it is a tag as a whole.
fn operand(block: &Block) -> Option<TagId> {
    match &block.arguments.first()?.argument {
        Argument::Value(value) => match value.kind {
            ExprKind::Read(Operand::Tag(tag)) => Some(tag),
            _ => None,
        },
        Argument::Place(Operand::Tag(tag), _) => Some(*tag),
        _ => None,
    }
}
