//! What is Structured Text stays that: units that are files of their own in a folder, where such a file means the same as the networks
//! that the unit becomes.

use super::structured;
use super::tasks::{Run, When};
use super::{BlockItems, Parts};
use crate::declarations::text;
use crate::model::Unit;
use ladder_format::Options;
use ladder_format::program::{Declaration, Item, ProgramSketch, Section, SectionKind};
use ladder_notation::{Bytes, Companion, Notation, Source};
use ladder_notation_st::St;
use std::collections::HashMap;

/// What tags begin with anyway.
const ZEROS: [&str; 5] = ["0", "0.0", "FALSE", "T#0s", "''"];

/// A unit, as a file of its own.
struct Candidate<'p> {
    unit: &'p Unit,
    file: Companion,
    /// What it becomes in its project.
    ladder: String,
}

/// The texts of the units that stay as they are. `programs`: what runs, as networks.
pub(super) fn texts(
    parts: &Parts<'_>,
    order: &[Run<'_>],
    programs: &[Vec<Item>],
) -> HashMap<*const Unit, String> {
    let blocks = parts.blocks.iter().filter_map(|block| {
        let is_block = |item: &&Item| matches!(item, Item::Block { .. });
        candidate(
            block.unit,
            std::slice::from_ref(block.items.iter().find(is_block)?),
        )
    });
    let runs = order.iter().zip(programs).filter(|(run, _)| {
        let of_unit = order.iter().filter(|other| std::ptr::eq(other.unit, run.unit));
        of_unit.count() == 1 && !matches!(run.when, When::Never)
    });
    let runs = runs.filter_map(|(run, items)| candidate(run.unit, items));
    let mut all: Vec<Candidate<'_>> = blocks.chain(runs).collect();
    // Without one the others may mean something else.
    loop {
        let before = all.len();
        let drawn = drawn(parts, &all);
        let files: Vec<Companion> = all.iter().map(|one| one.file.clone()).chain(drawn).collect();
        all.retain(|one| is_the_same(one, &files));
        if all.is_empty() || all.len() == before {
            let texts = all.into_iter();
            return texts
                .map(|one| {
                    let text = String::from_utf8_lossy(&one.file.bytes).into_owned();
                    (std::ptr::from_ref(one.unit), text)
                })
                .collect();
        }
    }
}

fn candidate<'p>(unit: &'p Unit, items: &[Item]) -> Option<Candidate<'p>> {
    let (body, _) = structured::text(unit)?;
    if !unit.parts.is_empty() {
        return None;
    }
    let file = Companion {
        name: format!("{}.st", unit.name),
        bytes: file_of(unit, body).into(),
    };
    Some(Candidate {
        unit,
        file,
        ladder: networks(items.iter().cloned()),
    })
}

/// A unit as a file of Structured Text.
fn file_of(unit: &Unit, body: &str) -> String {
    let mut alone = unit.clone();
    let mut out = String::new();
    if let Some(told) = alone.comment.take() {
        out.push_str(&format!("(* {} *)\n", told.trim().replace("*)", "* )")));
    }
    let declared = text::unit(&alone).replace("\n\t", "\n    ");
    let word = declared.split_whitespace().next().unwrap_or_default();
    let body = body.trim_start_matches(['\r', '\n']).trim_end();
    let body = body.replace("\r\n", "\n");
    out + &format!("{declared}\n{body}\nEND_{word}\n")
}

/// What of the project is in ladder text beside the candidates.
fn drawn(parts: &Parts<'_>, all: &[Candidate<'_>]) -> [Companion; 3] {
    let is_drawn = |block: &&BlockItems<'_>| all.iter().all(|one| !std::ptr::eq(one.unit, block.unit));
    let blocks = parts.blocks.iter().filter(is_drawn);
    let blocks: Vec<Item> = blocks.flat_map(|block| block.items.clone()).collect();
    [
        ("types", &parts.types),
        ("globals", &parts.globals),
        ("blocks", &blocks),
    ]
    .map(|(name, items)| {
        let sketch = ProgramSketch { items: items.clone() };
        Companion {
            name: format!("{name}.clad"),
            bytes: Bytes::from(sketch.write(&Options::default()).text),
        }
    })
}

/// Whether a file of its own becomes what the unit does in its project.
fn is_the_same(one: &Candidate<'_>, files: &[Companion]) -> bool {
    let source = Source {
        name: one.unit.name.as_str().into(),
        bytes: &one.file.bytes,
        companions: files
            .iter()
            .filter(|other| *other != &one.file)
            .cloned()
            .collect(),
    };
    let read = St.read(&source);
    read.is_ok_and(|read| read.findings.is_empty() && networks(read.program.items) == one.ladder)
}

/// What is declared and what runs, without what is only told, and in one order. Inputs of blocks begin with zero where nothing is said.
fn networks(items: impl IntoIterator<Item = Item>) -> String {
    let (mut declared, mut runs) = (Vec::new(), Vec::new());
    for item in items {
        match item {
            Item::Blank | Item::Comment(_) => {}
            Item::Section(section) if section.kind == SectionKind::VarExternal => {}
            Item::Section(Section {
                kind,
                qualifier,
                declarations,
            }) => {
                for Declaration {
                    names,
                    address,
                    ty,
                    initial,
                    ..
                } in declarations
                {
                    let initial = initial.filter(|value| !ZEROS.contains(&value.as_str()));
                    declared.extend(
                        names.iter().map(|name| {
                            format!("{kind:?} {qualifier:?} {name} {address:?} {ty} {initial:?}")
                        }),
                    );
                }
            }
            Item::Block { header, items, .. } => declared.push(header + &networks(items)),
            item => runs.push(item),
        }
    }
    declared.sort();
    declared.join("\n") + &ProgramSketch { items: runs }.write(&Options::default()).text
}
