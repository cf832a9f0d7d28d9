//! The declarations that a selection is about, and how some of them give way to others.

use crate::symbol::declared::names_of;
use crate::symbol::{Symbol, occurrences, tag_of};
use ladder_analysis::context::Context;
use ladder_analysis::names::scope::{SectionKind, TagFacts};
use ladder_format::Edit;
use ladder_syntax::ast::{AstNode, Declaration, NodeView};
use ladder_syntax::{LineKind, Name, TextRange, TextSize};

/// A declared tag.
pub(crate) struct DeclaredTag<'c> {
    /// As declared.
    pub(crate) name: String,
    pub(crate) symbol: Symbol,
    pub(crate) tag: &'c TagFacts,
    pub(crate) kind: SectionKind,
    pub(crate) scope: usize,
    /// The number of its section.
    pub(crate) section: usize,
    /// The number of its line.
    pub(crate) line: usize,
    /// Where its name is.
    pub(crate) at: TextRange,
}

/// All that are declared in sections like the one of a line: of the same kind, RETAIN or CONSTANT or neither, in the same scope.
pub(super) fn like_section_of(context: &Context, line: usize) -> Vec<DeclaredTag<'_>> {
    let sections = &context.parse.frame().sections;
    let Some(section) = sections.iter().find(|section| section.lines.contains(&line)) else {
        return Vec::new();
    };
    let header = header(context, section.lines.start);
    let alike = sections.iter().enumerate().filter(|(_, other)| {
        other.block == section.block && self::header(context, other.lines.start) == header
    });
    alike
        .flat_map(|(number, _)| in_section(context, number))
        .collect()
}

/// All that a selection reaches into.
pub(super) fn selected(context: &Context, range: TextRange) -> Vec<DeclaredTag<'_>> {
    let sections = 0..context.parse.frame().sections.len();
    let touches = |tag: &DeclaredTag<'_>| {
        let line = context.parse.line_range(tag.line);
        if range.is_empty() {
            tag.at.contains_inclusive(range.start())
        } else {
            tag.at.start() < range.end() && range.start() < line.end()
        }
    };
    sections
        .flat_map(|section| in_section(context, section))
        .filter(touches)
        .collect()
}

/// The one whose name is at a place.
pub(crate) fn at(context: &Context, name: TextRange) -> Option<DeclaredTag<'_>> {
    let sections = 0..context.parse.frame().sections.len();
    let mut found = sections.flat_map(|section| in_section(context, section));
    found.find(|tag| tag.at.contains_range(name))
}

fn in_section(context: &Context, section: usize) -> Vec<DeclaredTag<'_>> {
    let names = names_of(context, section).into_iter();
    let found = names.filter_map(|declared| {
        let scope = &context.scopes[declared.scope];
        let tag = &scope.tags[scope.find(&declared.name)?];
        Some(DeclaredTag {
            name: context.parse.text_in(declared.at).to_string(),
            symbol: tag_of(context, declared.scope, &declared.name)?,
            tag,
            kind: declared.section,
            scope: declared.scope,
            section,
            line: context.parse.line_at(declared.at.start())?,
            at: declared.at,
        })
    });
    found.collect()
}

/// The words of a section's first line.
fn header(context: &Context, line: usize) -> Vec<String> {
    let text = context.parse.lines()[line].text();
    let words = text.split('#').next().unwrap_or(text).split_whitespace();
    words.map(str::to_ascii_uppercase).collect()
}

/// What a declaration says, in three parts.
pub(crate) struct Parts {
    /// Its names.
    pub(crate) names: Vec<(String, TextRange)>,
    /// From after them to the last comment: ` : BOOL;  # it runs #`.
    pub(crate) says: String,
    /// Where the names are, and all of it without the blanks around, in the file.
    pub(crate) list: TextRange,
    pub(crate) whole: TextRange,
}

/// The parts of the declaration on a line.
pub(crate) fn parts(context: &Context, line: usize) -> Option<Parts> {
    let found = &context.parse.lines()[line];
    let start = context.parse.line_start(line);
    let tree = found.tree();
    let declaration = Declaration::cast(NodeView::root(&tree))?;
    let names: Vec<(String, TextRange)> = declaration
        .names()
        .map(|name| (name.text().to_owned(), name.text_range() + start))
        .collect();
    let list = names.first()?.1.cover(names.last()?.1);
    let text = found.text();
    let end = start + TextSize::of(text.trim_end());
    Some(Parts {
        says: text[usize::from(list.end() - start)..usize::from(end - start)].to_owned(),
        names,
        list,
        whole: TextRange::new(list.start(), end),
    })
}

/// The edits that take some tags out of their declarations and put others in the place of the first.
///
/// # Errors
/// Why that cannot be done.
pub(crate) fn replaced(
    context: &Context,
    out: &[DeclaredTag<'_>],
    with: &[String],
) -> Result<Vec<Edit>, String> {
    let mut lines: Vec<usize> = out.iter().map(|tag| tag.line).collect();
    lines.dedup();
    let mut edits = Vec::new();
    for (number, line) in lines.into_iter().enumerate() {
        let parts = parts(context, line).ok_or("a declaration cannot be read")?;
        if context.parse.text_in(parts.list).contains('#') {
            return Err("a comment stands between the names of a declaration".to_owned());
        }
        let goes = |(_, at): &&(String, TextRange)| out.iter().any(|tag| tag.at == *at);
        let first = parts
            .names
            .iter()
            .position(|name| goes(&name))
            .unwrap_or_default();
        let stay = |names: &[(String, TextRange)]| {
            let names: Vec<&str> = names
                .iter()
                .filter(|name| !goes(name))
                .map(|(name, _)| name.as_str())
                .collect();
            (!names.is_empty()).then(|| format!("{}{}", names.join(", "), parts.says))
        };
        // In the order of the names; without anything between them what stays is one list.
        let new: Vec<String> = if number == 0 && !with.is_empty() {
            let (before, after) = parts.names.split_at(first);
            stay(before)
                .into_iter()
                .chain(with.to_vec())
                .chain(stay(after))
                .collect()
        } else {
            stay(&parts.names).into_iter().collect()
        };
        let range = context.parse.line_range(line);
        edits.push(if new.is_empty() {
            Edit {
                range,
                text: String::new(),
            }
        } else {
            Edit {
                range: parts.whole,
                text: new.join(&between(context, range, parts.whole)),
            }
        });
    }
    edits.extend(emptied(context, out, with));
    Ok(edits)
}

/// What is between two declarations in the place of one: a new line, if that has one of its own.
fn between(context: &Context, line: TextRange, whole: TextRange) -> String {
    let before = context
        .parse
        .text_in(TextRange::new(line.start(), whole.start()))
        .to_string();
    let after = context
        .parse
        .text_in(TextRange::new(whole.end(), line.end()))
        .to_string();
    let line_end = after.trim_start_matches([' ', '\t']);
    if line_end.is_empty() {
        return " ".to_owned();
    }
    let indent = before.rsplit(['\n', '\r']).next().unwrap_or_default();
    format!("{line_end}{indent}")
}

/// Sections of which nothing is left go as a whole.
fn emptied(context: &Context, out: &[DeclaredTag<'_>], with: &[String]) -> Vec<Edit> {
    let parse = &context.parse;
    let keeps = out.first().filter(|_| !with.is_empty()).map(|tag| tag.section);
    let mut sections: Vec<usize> = out.iter().map(|tag| tag.section).collect();
    sections.dedup();
    let left = |section: &usize| {
        let lines = parse.frame().sections[*section].lines.clone();
        let goes = |line: usize| {
            let kind = parse.lines()[line].kind;
            let declares = kind == LineKind::Declaration
                && parts(context, line).is_some_and(|parts| {
                    parts
                        .names
                        .iter()
                        .all(|(_, at)| out.iter().any(|tag| tag.at == *at))
                });
            let frames = matches!(
                kind,
                LineKind::SectionHeader | LineKind::SectionEnd | LineKind::Blank
            );
            declares || (frames && !parse.lines()[line].text().contains('#'))
        };
        Some(*section) != keeps && lines.into_iter().all(goes)
    };
    let gone = sections.into_iter().filter(left).flat_map(|section| {
        let lines = parse.frame().sections[section].lines.clone();
        let frames = lines.filter(|line| parse.lines()[*line].kind != LineKind::Declaration);
        frames.map(|line| Edit {
            range: parse.line_range(line),
            text: String::new(),
        })
    });
    gone.collect()
}

/// Where a tag is used, its declaration aside.
pub(crate) fn uses(context: &Context, tag: &DeclaredTag<'_>) -> Vec<TextRange> {
    let places = occurrences(context, &tag.symbol).into_iter();
    let uses = places.filter(|place| !place.usage.declares());
    uses.map(|place| place.range).collect()
}

/// Why a tag cannot become a member, or a member a tag: others know it by its name.
///
/// # Errors
/// That.
pub(super) fn is_inner(tag: &DeclaredTag<'_>) -> Result<(), String> {
    let name = &tag.name;
    let why = match tag.kind {
        SectionKind::Global | SectionKind::External => "other files know it by its name",
        SectionKind::Input | SectionKind::Output | SectionKind::InOut if tag.scope > 0 => {
            "it is an operand of its block"
        }
        _ if tag.tag.constant => "bounds of arrays may name it",
        _ if tag.tag.cold.address.is_some() => "it is at a direct address",
        _ if tag.tag.mistyped || tag.tag.ty.is_none() => "its type is not known",
        _ => return Ok(()),
    };
    Err(format!("`{name}`: {why}"))
}

/// Whether a name is free for a new tag.
pub(super) fn is_free(context: &Context, name: &Name) -> bool {
    context.scopes.iter().all(|scope| scope.find(name).is_none())
        && context.others.globals(name).next().is_none()
        && !context.types.has_value(name)
        && context
            .types
            .find(name.as_str())
            .is_none_or(|ty| ty.declaration.key != *name)
}
