//! The parts of a file: sections with their tags, networks with their labels, functions, block definitions.

use crate::body::{line_body, line_text, without_line_end};
use crate::comments;
use crate::symbol::declared::names_of;
use ladder_analysis::AccessKind;
use ladder_analysis::context::{Body, Context, LabelFacts};
use ladder_analysis::names::scope::{SectionKind, TagFacts};
use ladder_analysis::networks::network::{Formal, Meaning};
use ladder_analysis::program::ParameterKind;
use ladder_analysis::written::facts::NodeKind;
use ladder_analysis::written::type_spec::SpecKind;
use ladder_instructions::{Accepts, Coil, Direction};
use ladder_syntax::{Item, LineKind, Name, Parse, SyntaxKind, TextRange};
use smol_str::{SmolStr, format_smolstr};

/// A part of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Outlined {
    /// What it is called.
    pub name: SmolStr,
    /// A few words more.
    pub detail: Option<SmolStr>,
    /// What it is.
    pub kind: OutlineKind,
    /// All of it, with the comments above it.
    pub range: TextRange,
    /// Its name, or where it begins; within `range`.
    pub focus: TextRange,
    /// What it holds.
    pub children: Vec<Outlined>,
}

/// What a part of a file is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum OutlineKind {
    /// VAR ... END_VAR
    Section,
    /// A declared tag.
    Tag,
    /// A tag that is declared CONSTANT.
    Constant,
    /// An input, output or in-out of a user-defined block.
    Parameter,
    /// A declared type.
    Type,
    /// A declared enumeration.
    Enumeration,
    /// A member of a structure.
    Member,
    /// A value of an enumeration.
    Value,
    /// A network. Its name is what the comment above it says.
    Network,
    /// A label.
    Label,
    /// A function.
    Function,
    /// The definition of a user-defined block.
    Block,
}

/// How many of the tags that a network writes are named.
const NAMED: usize = 3;

/// The parts of a file in the order of the text.
pub fn outline(context: &Context) -> Vec<Outlined> {
    of_context(context)
}

pub(crate) fn of_context(context: &Context) -> Vec<Outlined> {
    let mut outline = Outline {
        context,
        labels: &context.labels,
        root: Vec::new(),
        block: None,
        function: None,
    };
    for item in &context.parse.structure_once().items {
        match *item {
            Item::Section(section) => {
                let section = section_item(context, section);
                outline.add(section);
            }
            Item::Network(network) => outline.network(network),
            Item::BlockHeader(block) => {
                outline.end_block();
                outline.block = Some((block, block_item(context, block)));
            }
            Item::BlockEnd(_) => outline.end_block(),
            Item::Decoration(_) | Item::Stray(_) => {}
        }
    }
    outline.end_block();
    outline.root
}

struct Outline<'c> {
    context: &'c Context,
    /// Those of the networks to come.
    labels: &'c [LabelFacts],
    root: Vec<Outlined>,
    /// The definition that is open, with its index.
    block: Option<(usize, Outlined)>,
    /// The function that is open, likewise.
    function: Option<(usize, Outlined)>,
}

impl Outline<'_> {
    fn add(&mut self, item: Outlined) {
        if let Some((_, function)) = &mut self.function {
            function.range = function.range.cover(item.range);
            function.children.push(item);
        } else {
            self.outside(item);
        }
    }

    fn outside(&mut self, item: Outlined) {
        match &mut self.block {
            Some((_, block)) => block.children.push(item),
            None => self.root.push(item),
        }
    }

    fn end_function(&mut self) {
        if let Some((_, function)) = self.function.take() {
            self.outside(function);
        }
    }

    fn end_block(&mut self) {
        self.end_function();
        if let Some((_, block)) = self.block.take() {
            self.root.push(block);
        }
    }

    fn network(&mut self, network: usize) {
        let context = self.context;
        let mut item = network_item(context, network);
        let mine = self.labels.partition_point(|label| label.network <= network);
        let (labels, rest) = self.labels.split_at(mine);
        self.labels = rest;
        item.children = labels
            .iter()
            .filter(|label| label.network == network)
            .map(label_item)
            .collect();
        let Body::Function(function) = context.bodies[network] else {
            self.end_function();
            self.add(item);
            return;
        };
        if self.function.as_ref().is_none_or(|(open, _)| *open != function) {
            self.end_function();
            let facts = &context.functions[function];
            // One that was interrupted by a block definition goes on without its head.
            if facts.network == network {
                let head = Outlined {
                    name: facts.name.as_str().into(),
                    detail: comments::title(context, context.networks.at(network).line(0)).map(SmolStr::from),
                    kind: OutlineKind::Function,
                    range: item.range,
                    focus: facts.at,
                    children: Vec::new(),
                };
                self.function = Some((function, head));
            }
        }
        self.add(item);
    }
}

fn section_item(context: &Context, section: usize) -> Outlined {
    let parse = &context.parse;
    let facts = &parse.frame().sections[section];
    let header = line_words(parse, facts.lines.start);
    let constant = header.to_ascii_uppercase().contains("CONSTANT");
    let lines = TextRange::new(
        parse.line_start(facts.lines.start),
        parse.line_range(facts.lines.end - 1).end(),
    );
    let range = without_line_end(context, lines);
    let children = names_of(context, section).into_iter().map(|declared| {
        let scope = &context.scopes[declared.scope];
        let tag = scope.find(&declared.name).map(|tag| &scope.tags[tag]);
        let parameter = declared.scope > 0
            && matches!(
                declared.section,
                SectionKind::Input | SectionKind::Output | SectionKind::InOut
            );
        Outlined {
            name: parse.text_in(declared.at).into(),
            detail: tag.and_then(of_tag),
            kind: match (constant, parameter) {
                (true, _) => OutlineKind::Constant,
                (false, true) => OutlineKind::Parameter,
                (false, false) => OutlineKind::Tag,
            },
            // One that is not finished ends in blanks.
            range: range.intersect(declared.declaration).unwrap_or(declared.at),
            focus: declared.at,
            children: Vec::new(),
        }
    });
    let types = types_item(context, lines);
    Outlined {
        name: header.into(),
        detail: comments::title(context, facts.lines.start).map(SmolStr::from),
        kind: OutlineKind::Section,
        focus: line_body(parse, facts.lines.start),
        children: children.chain(types).collect(),
        range: with_comments(context, facts.lines.start, range),
    }
}

/// The types that a section declares, with their members and values.
fn types_item(context: &Context, section: TextRange) -> Vec<Outlined> {
    let parse = &context.parse;
    let item = |kind: OutlineKind, focus: TextRange, end: TextRange, detail: Option<SmolStr>| Outlined {
        name: parse.text_in(focus).into(),
        detail,
        kind,
        range: focus.cover(end),
        focus,
        children: Vec::new(),
    };
    let own = context.types.own().iter();
    own.filter(|ty| section.contains_range(ty.declaration.at))
        .map(|ty| {
            let spec = &ty.declaration.declared.spec;
            let (detail, parts) = match &spec.kind {
                SpecKind::Structure(members) => {
                    let members = members.iter().map(|member| {
                        let range = member.declared.spec.range;
                        let ty: SmolStr = parse.text_in(range).into();
                        item(OutlineKind::Member, member.at, range, Some(ty))
                    });
                    (Some(SmolStr::from("STRUCT")), members.collect())
                }
                SpecKind::Enumeration(values) => {
                    let values = values.iter().map(|(_, at, number)| {
                        item(OutlineKind::Value, *at, *at, Some(number.to_string().into()))
                    });
                    (None, values.collect())
                }
                _ => (ty.ty.map(|ty| SmolStr::from(ty.to_string())), Vec::new()),
            };
            let end = parts.iter().map(|part: &Outlined| part.range.end()).max();
            let end = end.unwrap_or_else(|| spec.range.end().max(ty.declaration.at.end()));
            let kind = match spec.kind {
                SpecKind::Enumeration(_) => OutlineKind::Enumeration,
                _ => OutlineKind::Type,
            };
            let range = TextRange::new(ty.declaration.at.start(), end);
            Outlined {
                children: parts,
                ..item(kind, ty.declaration.at, range, detail)
            }
        })
        .collect()
}

fn block_item(context: &Context, block: usize) -> Outlined {
    let parse = &context.parse;
    let lines = &parse.frame().blocks[block].lines;
    let facts = &context.user_blocks[block];
    let range = TextRange::new(
        parse.line_start(lines.start),
        parse.line_range(lines.end - 1).end(),
    );
    let parameters = facts.parameters.iter().map(|parameter| match parameter.kind {
        ParameterKind::Input => parameter.name.clone(),
        ParameterKind::Output => format!("{} =>", parameter.name),
        ParameterKind::InOut => format!("{} :=", parameter.name),
    });
    let (open, close) = facts.shape.brackets();
    let name = if facts.name.is_empty() { "?" } else { &facts.name };
    Outlined {
        name: format_smolstr!("{open}{name}{close}"),
        detail: Some(match parameters.collect::<Vec<_>>().join(", ") {
            none if none.is_empty() => "( )".into(),
            some => format_smolstr!("( {some} )"),
        }),
        kind: OutlineKind::Block,
        range: with_comments(context, lines.start, without_line_end(context, range)),
        focus: facts.at,
        children: Vec::new(),
    }
}

/// The type of a tag, and how often it is read, written, set and reset.
fn of_tag(tag: &TagFacts) -> Option<SmolStr> {
    let ty = tag.ty?;
    let mut detail = ty.to_string();
    for kind in [
        AccessKind::Read,
        AccessKind::Write,
        AccessKind::Set,
        AccessKind::Reset,
        AccessKind::ReadWrite,
    ] {
        match tag.uses.access_kinds().filter(|it| *it == kind).count() {
            0 => {}
            1 => detail.push_str(&format!(", {}", kind.words())),
            times => detail.push_str(&format!(", {} {times}", kind.words())),
        }
    }
    Some(detail.into())
}

fn network_item(context: &Context, network: usize) -> Outlined {
    let facts = context.networks.at(network);
    let first = facts.line(0);
    let written = written(context, network);
    let detail = match written.len() {
        0 => None,
        n if n > NAMED => Some(format_smolstr!("{}, ...", written[..NAMED].join(", "))),
        _ => Some(written.join(", ").into()),
    };
    Outlined {
        name: comments::title(context, first)
            .map_or_else(|| format_smolstr!("Network {}", network + 1), SmolStr::from),
        detail,
        kind: OutlineKind::Network,
        range: with_comments(context, first, without_line_end(context, facts.range)),
        focus: line_body(&context.parse, first),
        children: Vec::new(),
    }
}

fn label_item(label: &LabelFacts) -> Outlined {
    Outlined {
        name: label.name.as_str().into(),
        detail: Some(SmolStr::new_static("<LBL>")),
        kind: OutlineKind::Label,
        range: label.at,
        focus: label.at,
        children: Vec::new(),
    }
}

/// The tags that a network writes, each once, in the order of the text; those that it sets or resets say so.
fn written(context: &Context, network: usize) -> Vec<SmolStr> {
    let mut names: Vec<(Name, SmolStr)> = Vec::new();
    for block in context.networks.at(network).blocks() {
        for (operand, formal) in block.facts.operands.iter().zip(block.formals.iter()) {
            let writes = match (formal, block.meaning) {
                (Formal::Operand(row), _) => {
                    row.direction != Direction::In
                        && !matches!(
                            row.accepts,
                            Accepts::Label | Accepts::Function | Accepts::State(_)
                        )
                }
                (Formal::Parameter(parameter), Meaning::User(user)) => {
                    context.user_blocks[user].parameters[*parameter].kind != ParameterKind::Input
                }
                _ => false,
            };
            let mut node = &operand.value;
            while let NodeKind::Member(base, _) | NodeKind::Index(base, _) | NodeKind::Range(base, ..) =
                &node.kind
            {
                node = base;
            }
            if let (true, NodeKind::Name(name) | NodeKind::Address(name)) = (writes, &node.kind) {
                let key = Name::new(name);
                if names.iter().all(|(known, _)| *known != key) {
                    let told = match block.coil() {
                        Some(Coil::Sets) => format_smolstr!("set {name}"),
                        Some(Coil::Resets) => format_smolstr!("reset {name}"),
                        _ => name.clone(),
                    };
                    names.push((key, told));
                }
            }
        }
        if names.len() > NAMED {
            break;
        }
    }
    names.into_iter().map(|(_, name)| name).collect()
}

/// A range with the comments right above its first line.
fn with_comments(context: &Context, line: usize, range: TextRange) -> TextRange {
    match comments::above(context, line) {
        Some((first, _)) => TextRange::new(context.parse.line_start(first), range.end()),
        None => range,
    }
}

/// The words of a section's header: `VAR_INPUT RETAIN`.
fn line_words(parse: &Parse, line: usize) -> String {
    debug_assert_eq!(parse.lines()[line].kind, LineKind::SectionHeader);
    let syntax = parse.lines()[line].syntax();
    let words = syntax.descendants_with_tokens().filter_map(|it| {
        let token = it.into_token().filter(|it| it.kind() == SyntaxKind::KEYWORD)?;
        Some(token.text().to_ascii_uppercase())
    });
    words.collect::<Vec<_>>().join(" ")
}

/// The text of a range that lies in one line.
pub(crate) fn text_of(parse: &Parse, range: TextRange) -> String {
    let Some(line) = parse.line_at(range.start()) else {
        return String::new();
    };
    let text = line_text(parse, line);
    text.get(std::ops::Range::from(range - parse.line_start(line)))
        .unwrap_or_default()
        .to_owned()
}

#[cfg(test)]
mod tests;
