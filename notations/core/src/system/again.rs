//! What was written along is taken out again: the tags are those of `SYS`, where the block is as it was written.

use super::{BLOCK, INSTANCE, block, output};
use crate::elements::{change, elements, series};
use crate::{Notation, Source};
use ladder_analysis::Analysis;
use ladder_analysis::names::system_tag::SystemTag;
use ladder_format::Options;
use ladder_format::program::{Item, ProgramSketch, Section, SectionKind};
use std::collections::BTreeSet;

/// Names tags of `SYS` in a program where the outputs of the block were named. If that has errors, as where the system has other types,
/// the program stays as it is.
pub(crate) fn system_tags_again(program: &mut ProgramSketch, notation: &dyn Notation) {
    let Some(tags) = kept(program).filter(|tags| is_as_written(program, tags, notation)) else {
        return;
    };
    let mut items = program.items.clone();
    if !remove_block(&mut items) {
        return;
    }
    change(&mut items, &|text: &mut String| {
        for tag in &tags {
            let with = format!("SYS.{}", tag.name());
            *text = replaced(text, &format!("{INSTANCE}.{}", output(*tag)), &with);
        }
    });
    if !remove_instances(&mut items) {
        return;
    }
    let again = ProgramSketch { items };
    if !has_errors(&again) {
        *program = again;
    }
}

fn has_errors(program: &ProgramSketch) -> bool {
    analyzed(&program.write(&Options::default()).text).has_errors()
}

fn analyzed(text: &str) -> Analysis {
    ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "")
}

fn is_block(item: &Item) -> bool {
    matches!(item, Item::Block { header, .. } if header.trim_matches(['[', ']']) == BLOCK)
}

/// The tags that the block of a program keeps.
fn kept(program: &ProgramSketch) -> Option<Vec<SystemTag>> {
    let Some(Item::Block { items, .. }) = program.items.iter().find(|item| is_block(item)) else {
        return None;
    };
    let outputs = items.iter().filter_map(|item| match item {
        Item::Section(section) if section.kind == SectionKind::VarOutput => Some(&section.declarations),
        _ => None,
    });
    let names: Vec<&String> = outputs.flatten().flat_map(|declared| &declared.names).collect();
    let mut tags = SystemTag::ALL.to_vec();
    tags.retain(|tag| names.iter().any(|name| **name == output(*tag)));
    (tags.len() == names.len()).then_some(tags)
}

/// Whether the block is what the notation makes of the one that keeps these tags, in a program of the same profile, or of none.
fn is_as_written(program: &ProgramSketch, tags: &[SystemTag], notation: &dyn Notation) -> bool {
    let text_of = |program: &ProgramSketch| {
        let block = program.items.iter().find(|item| is_block(item));
        let items = block.into_iter().cloned().collect();
        ProgramSketch { items }.write(&Options::default()).text
    };
    let own = text_of(program);
    let directives = program.items.iter().filter_map(|item| match item {
        Item::Directive(said) if said.starts_with("profile") => Some(format!("# ladder: {said} #\n")),
        _ => None,
    });
    [String::new(), directives.collect()]
        .into_iter()
        .any(|directive| {
            let text = format!(
                "{directive}VAR\n    {INSTANCE} : {BLOCK};\nEND_VAR\n+--[{BLOCK}]( {INSTANCE} )--+\n\n{}",
                block(tags)
            );
            let Ok(writing) = notation.write(&analyzed(&text)) else {
                return false;
            };
            let source = Source {
                companions: writing.companions,
                ..Source::alone("", &writing.bytes)
            };
            notation
                .read(&source)
                .is_ok_and(|reading| text_of(&reading.program) == own)
        })
}

/// A text with one tag in the place of another.
fn replaced(text: &str, tag: &str, with: &str) -> String {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    let mut out = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once(tag) {
        let is_tag = !before.ends_with(is_part) && !after.starts_with(is_part);
        out.push_str(before);
        out.push_str(if is_tag { with } else { tag });
        rest = after;
    }
    out + rest
}

/// Takes out the block with what is said of it. False: another block would be left that only this one has needed.
fn remove_block(items: &mut Vec<Item>) -> bool {
    let Some(at) = items.iter().position(is_block) else {
        return false;
    };
    let comments = items[..at]
        .iter()
        .rev()
        .take_while(|item| matches!(item, Item::Comment(_)));
    let above = comments.count();
    let removed: Vec<Item> = items.drain(at - above..=at).collect();
    let (own, others) = (called(&removed), called(items));
    own.is_subset(&others)
}

/// The blocks of one's own that networks call, as `[$Name]`.
fn called(items: &[Item]) -> BTreeSet<String> {
    let mut called = BTreeSet::new();
    elements(items, &mut |text| {
        if text.starts_with("[$") {
            called.extend(text.split_inclusive(']').next().map(str::to_owned));
        }
    });
    called
}

/// Takes out the instances and their calls. False: something else names one of them.
fn remove_instances(items: &mut Vec<Item>) -> bool {
    let call = format!("[{BLOCK}]( {INSTANCE} )");
    let mut out: Vec<Item> = Vec::new();
    for mut item in std::mem::take(items) {
        match &mut item {
            Item::Network(network) if series(network).is_some_and(|own| own == [call.as_str()]) => {
                // What is said there stays.
                out.extend(
                    std::mem::take(&mut network.comments)
                        .into_iter()
                        .map(Item::Comment),
                );
                continue;
            }
            Item::Section(Section { declarations, .. }) => {
                let is_other = |name: &String| name != INSTANCE;
                declarations.retain(|declared| declared.names.iter().all(is_other));
                if declarations.is_empty() {
                    continue;
                }
            }
            Item::Block { items, .. } => {
                remove_instances(items);
            }
            _ => {}
        }
        out.push(item);
    }
    *items = out;
    items.dedup_by(|next, item| (&*next, &*item) == (&Item::Blank, &Item::Blank));
    let mut is_named = false;
    elements(items, &mut |text| is_named |= text.contains(INSTANCE));
    !is_named
}
