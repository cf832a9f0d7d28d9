//! A program and its blocks: from their texts to units.

use super::declare;
use super::network;
use super::power::{POWER_IN, POWER_OUT, Power};
use super::tags::Tags;
use super::{Project, unread};
use crate::model::{Body, Net, Network, Part, RAIL, Role, Unit, Variable, Wire};
use ladder_analysis::context::Context;
use ladder_analysis::values::types::Type;
use ladder_notation::{LineColumn, Report, comments};
use ladder_syntax::{Item, LineKind};

/// What a text has of a unit.
#[derive(Debug, Default)]
pub(super) struct Source {
    /// Empty for the program itself.
    pub(super) name: String,
    /// The scope of its tags: 0 for the program, else that of the block.
    pub(super) scope: usize,
    /// Whether its jumps go out of it.
    pub(super) leads_out: bool,
    pub(super) told: Vec<String>,
    /// Whether it declares tags.
    declares: bool,
    /// Networks by their number in the structure, each with the comment above it.
    pub(super) networks: Vec<(usize, Vec<String>)>,
    /// Of an unread part: its text in SCL, or why it is not written.
    pub(super) unread: Option<Result<String, String>>,
}

/// The program, and then its blocks.
pub(super) fn sources(context: &Context) -> Vec<Source> {
    let parse = &context.parse;
    let structure = parse.structure();
    let mut units = vec![Source::default()];
    let mut at = 0;
    // Lines of comments, in groups that blank lines part.
    let mut groups: Vec<Vec<String>> = vec![Vec::new()];
    for item in &structure.items {
        match *item {
            Item::Decoration(line) => {
                let told: Vec<String> = comments::on_line(parse, line)
                    .iter()
                    .flat_map(|comment| comments::told(comment).map(str::to_owned).collect::<Vec<_>>())
                    .collect();
                if parse.lines()[line].kind == LineKind::Blank {
                    groups.push(Vec::new());
                } else if let Some(group) = groups.last_mut() {
                    group.extend(told);
                }
            }
            Item::Network(number) => {
                let own = groups.pop().unwrap_or_default();
                let before: Vec<String> = std::mem::take(&mut groups).into_iter().flatten().collect();
                groups.push(Vec::new());
                let unit = &mut units[at];
                let mut told = own;
                if unit.networks.is_empty() && !unit.declares {
                    unit.told.extend(before);
                } else {
                    told = before.into_iter().chain(told).collect();
                }
                let lines = structure.networks[number].lines.clone();
                for comment in lines.flat_map(|line| comments::on_line(parse, line)) {
                    told.extend(comments::told(&comment).map(str::to_owned));
                }
                unit.networks.push((number, told));
            }
            Item::Section(number) => {
                let unit = &mut units[at];
                unit.told
                    .extend(std::mem::take(&mut groups).into_iter().flatten());
                groups.push(Vec::new());
                let mut lines = structure.sections[number].lines.clone();
                unit.declares |= !lines.any(|line| opens_types(parse.lines()[line].text()));
            }
            Item::BlockHeader(number) => {
                let lines = structure.blocks[number].lines.clone();
                let text = parse.lines()[lines.start].text();
                let told: Vec<String> = std::mem::take(&mut groups).into_iter().flatten().collect();
                units.push(Source {
                    name: context.user_blocks[number].name[1..].to_owned(),
                    scope: number + 1,
                    leads_out: text.contains('<'),
                    unread: unread::text_of(parse, lines, &told),
                    told,
                    ..Source::default()
                });
                groups.push(Vec::new());
                at = units.len() - 1;
            }
            Item::BlockEnd(_) => {
                groups = vec![Vec::new()];
                at = 0;
            }
            Item::Stray(_) => {}
        }
    }
    units
}

/// Whether a line opens a section of types.
fn opens_types(line: &str) -> bool {
    let word = line.split_whitespace().next().unwrap_or_default();
    word.eq_ignore_ascii_case("TYPE")
}

/// A unit under its name. `power`: of a block.
pub(super) fn unit(
    project: &Project<'_>,
    source: &Source,
    name: &str,
    power: Option<Power>,
    report: &mut Report,
) -> Unit {
    if source.leads_out {
        let why = "a block of this shape leaves the program that it stands in, and no block does there";
        report.refused(LineColumn::START, format!("block ${name}"), why);
    }
    let mut tags = Tags::new(project);
    let mut variables = declare::variables(&mut tags, source, report);
    let mut networks = Vec::new();
    if let Some(Power::Given { reads, writes }) = power {
        powered(&mut tags, &mut variables, [reads, writes]);
        networks.extend(writes.then(power_passes));
    }
    let guard = usize::from(power == Some(Power::Guarded));
    for (number, told) in source.networks.iter().skip(guard) {
        networks.extend(made(&mut tags, *number, told, report));
    }
    variables.extend(tags.made);
    Unit {
        name: name.to_owned(),
        variables,
        told: source.told.clone(),
        networks,
        ..Unit::default()
    }
}

/// The networks that one of the text becomes.
fn made(tags: &mut Tags<'_>, number: usize, told: &[String], report: &mut Report) -> Vec<Network> {
    let project = tags.project;
    let Some(network) = project.networks.get(&project.start(number)) else {
        let why = "it is part of a function that the program does not call";
        report.refused(project.place(project.start(number)), "network", why);
        return Vec::new();
    };
    let place = project.place(network.location.range.start());
    let bodies = match unread::in_scl(network, tags) {
        Some(text) => text.map(|text| (vec![Body::in_language("SCL")], text)),
        None => network::nets(tags, network)
            .map(|nets| (nets.into_iter().map(Body::Ladder).collect(), String::new())),
    };
    let (bodies, text) = match bodies {
        Ok(made) => {
            report.translated(place, "network");
            made
        }
        Err(why) => {
            report.refused(place, "network", why.clone());
            let text = project.text[network.location.range].to_owned();
            (vec![Body::Text("LAD".to_owned(), why)], text)
        }
    };
    // Others may jump to it, also if it is refused.
    let mut label = network::label(project, network).map(|label| (place, label));
    let mut told = told.to_vec();
    let networks = bodies.into_iter().map(|body| Network {
        place,
        told: std::mem::take(&mut told),
        label: label
            .take()
            .filter(|_| !matches!(&body, Body::Text(language, _) if language == "SCL")),
        text: text.clone(),
        places: Vec::new(),
        body,
    });
    networks.collect()
}

/// Declares what stands for the power of a block that reads it, or says which leaves it.
fn powered(tags: &mut Tags<'_>, variables: &mut Vec<Variable>, asked: [bool; 2]) {
    let rows = [("EN", POWER_IN, Role::Input), ("ENO", POWER_OUT, Role::Output)];
    for ((key, name, role), _) in rows.into_iter().zip(asked).filter(|(_, is_asked)| *is_asked) {
        let own = match tags.insert(name, Ok(Type::BOOL)) {
            Some(_) => Err(format!("there `{key}` is `{name}`, and a tag has that name")),
            None => Ok(Type::BOOL),
        };
        if own.is_ok() {
            variables.push(Variable {
                name: name.to_owned(),
                role,
                ..Variable::default()
            });
        }
        tags.insert(key, own);
    }
}

/// The network with which a body begins that says which power leaves it: at first it is that which enters.
fn power_passes() -> Network {
    let bit = |name, tag| Part::named(name).given("operand", format!("#\"{tag}\""));
    Network {
        body: Body::Ladder(Net {
            points: 1,
            wires: vec![Wire {
                from: RAIL,
                to: None,
                parts: vec![bit("Contact", POWER_IN), bit("Coil", POWER_OUT)],
            }],
        }),
        ..Network::default()
    }
}
