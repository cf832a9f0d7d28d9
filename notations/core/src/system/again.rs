//! What was written along is taken out again: the tags are those of `SYS`, where the block is as it was written.

use super::{ABOUT, BLOCK, INSTANCE, OUTPUT, block, call, output};
use crate::elements::{Call, blocks, change, rung, series};
use crate::items::{block_name, trim, without};
use crate::{Notation, Source};
use ladder_analysis::Analysis;
use ladder_analysis::program::SystemTag;
use ladder_format::Options;
use ladder_format::program::{Declaration, Item, Path, ProgramSketch, Section, SectionKind, Step};
use ladder_syntax::Name;
use std::collections::BTreeSet;

/// Names tags of `SYS` in a program where the outputs of the block were named. If that has errors, as where the system has other types,
/// the program stays as it is.
pub(crate) fn system_tags_again(program: &mut ProgramSketch, notation: &dyn Notation) {
    if !kept(program).is_some_and(|tags| is_as_written(program, &tags, notation)) {
        return;
    }
    let (own, others): (Vec<Item>, Vec<Item>) = program.items.iter().cloned().partition(is_block);
    // Another block would be left that only this one has needed.
    if !called(&own).is_subset(&called(&others)) {
        return;
    }
    let mut items = without(program.items.clone(), &|block| *block == Name::new(BLOCK));
    remove_instances(&mut items);
    change(&mut items, &mut |_, block| block.change_paths(of_system));
    let again = ProgramSketch { items };
    if !has_errors(&again) {
        *program = again;
    }
}

/// The tag of `SYS` that an output of the instance is.
fn of_system(path: &mut Path) {
    if Name::new(&path.root) == Name::new(INSTANCE)
        && let Some(Step::Member(name)) = path.steps.first_mut()
        && let Some(own) = name.strip_prefix(OUTPUT)
    {
        *name = own.to_owned();
        "SYS".clone_into(&mut path.root);
    }
}

fn has_errors(program: &ProgramSketch) -> bool {
    analyzed(&program.write(&Options::default()).text).has_errors()
}

fn analyzed(text: &str) -> Analysis {
    ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "")
}

fn is_block(item: &Item) -> bool {
    matches!(item, Item::Block { header, .. } if block_name(header) == Name::new(BLOCK))
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
    let directives = program.items.iter().filter(|item| match item {
        Item::Directive(told) => told.starts_with("profile"),
        _ => false,
    });
    let (Ok(block), Some(call)) = (block(tags), call()) else {
        return false;
    };
    let mut instance = Section::new(SectionKind::Var);
    instance.declarations.push(Declaration::new(INSTANCE, BLOCK));
    let alone = [
        Item::Section(instance),
        rung([call], None),
        Item::Blank,
        Item::Comment(ABOUT.to_owned()),
        block,
    ];
    [Vec::new(), directives.cloned().collect()]
        .into_iter()
        .any(|mut items: Vec<Item>| {
            items.extend_from_slice(&alone);
            let text = ProgramSketch { items }.write(&Options::default()).text;
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

/// The blocks of one's own that networks call.
fn called(items: &[Item]) -> BTreeSet<Name> {
    let mut called = BTreeSet::new();
    blocks(items, &mut |block| {
        called.extend(Call::of(block).map(|call| call.block));
    });
    called
}

/// Takes out the instances and their calls. A comment above a call stays.
fn remove_instances(items: &mut Vec<Item>) {
    let Some(call) = call() else {
        return;
    };
    for mut item in std::mem::take(items) {
        match &mut item {
            Item::Network(network) if series(network).is_some_and(|own| own == [&call]) => {
                items.extend(network.comments.drain(..).map(Item::Comment));
                continue;
            }
            Item::Section(section) => {
                let is_other = |declared: &Declaration| declared.names.iter().all(|name| name != INSTANCE);
                section.declarations.retain(is_other);
            }
            Item::Block { items, .. } => remove_instances(items),
            _ => {}
        }
        items.push(item);
    }
    trim(items);
}
