//! Renaming leaves the same program: the same model apart from names, the same trace, the same drawing apart from
//! widths; and the old name brings the old text back.

use ladder_analysis::analyze;
use ladder_analysis::program::{ElementKind, Program, Role};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;
use ladder_format::{Edit, Options, apply, format_text};
use ladder_ide::{Alone, prepare_rename, rename};
use ladder_simulator::{Options as Run, Point, Simulation};
use ladder_syntax::{TextSize, parse};
use ladder_tests::generator::{Dice, Mode, program};
use ladder_tests::project;
use ladder_tests::trace::compile;
use std::sync::Arc;

const SCANS: usize = 12;

/// The names that things get; no program has them.
const NAMES: [&str; 3] = ["zz", "zeta_9", "a_name_that_is_longer_than_any_other_name"];

/// A program's model without names and places, and without wires: where they are missing layout draws them.
fn model(program: &Program) -> String {
    let mut program = program.clone();
    for network in &mut program.networks {
        network
            .elements
            .retain(|element| element.kind != ElementKind::Wire);
    }
    // Nor what types are called, and how long names are.
    for column in program.tags.iter_mut().filter_map(|tag| tag.column.as_mut()) {
        let column = Arc::make_mut(column);
        (column.declared, column.root) = ((0, Type::BOOL), 0);
    }
    let text = format!("{program:?}");
    let text = without(&text, "EnumId(");
    let text = without(&text, "TypeId(");
    let mut out = String::with_capacity(text.len());
    let mut rest = text.as_str();
    while let Some(c) = rest.chars().next() {
        if c == '"' {
            let end = rest[1..].find('"').map_or(rest.len(), |end| end + 2);
            rest = &rest[end..];
            continue;
        }
        if c.is_ascii_digit() {
            let end = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
            let (number, after) = rest.split_at(end);
            if let Some(second) = after.strip_prefix("..") {
                let end = second.find(|c: char| !c.is_ascii_digit()).unwrap_or(second.len());
                if end > 0 {
                    rest = &second[end..];
                    continue;
                }
            }
            out.push_str(number);
            rest = after;
            continue;
        }
        out.push(c);
        rest = &rest[c.len_utf8()..];
    }
    out
}

/// A text without what is in parentheses after a word: the name of a type.
fn without(text: &str, word: &str) -> String {
    let mut parts = text.split(word);
    let first = parts.next().unwrap_or_default();
    let rest = parts.map(|part| part.split_once(')').map_or(part, |(_, after)| after));
    std::iter::once(first).chain(rest).collect()
}

/// Runs both with the same inputs; they must show the same values under either name, and the same power.
fn same_trace(old: &Arc<Program>, new: &Arc<Program>, names: &dyn Fn(&str) -> String, seed: u64) {
    let start = |program: &Arc<Program>| {
        let options = Run {
            watchdog: 20_000,
            ..Run::default()
        };
        Simulation::new(Arc::clone(program), options)
    };
    let (Ok(mut old), Ok(mut new)) = (start(old), start(new)) else {
        return;
    };
    let points: Vec<(Point, Point)> = old
        .points()
        .iter()
        .map(|point| {
            let name = names(&point.name);
            // A type may have the name of a tag, and only one of them is renamed.
            let other = new.resolve(&name).or_else(|_| new.resolve(&point.name));
            (
                point.clone(),
                other.unwrap_or_else(|_| panic!("no {name} for {}", point.name)),
            )
        })
        .collect();
    let mut dice = Dice::new(seed);
    for scan in 0..SCANS {
        for (a, b) in points
            .iter()
            .filter(|(a, _)| a.role == Role::Input && !a.read_only)
        {
            if !dice.one_in(3) {
                continue;
            }
            let value = match a.ty {
                Scalar::Bool => Value::Bool(dice.one_in(2)),
                Scalar::Real | Scalar::Lreal => Value::Real(dice.between(-9, 9) as f64),
                Scalar::String(_) => Value::Text(dice.of(&[&b""[..], b"12"]).into()),
                _ => Value::Int(dice.between(0, 9)),
            };
            // A value that the type does not take is one less for both.
            let _ = old.set(a, value.clone());
            let _ = new.set(b, value);
        }
        assert_eq!(old.scan(), new.scan(), "scan {scan}");
        for (a, b) in &points {
            assert_eq!(old.value(a), new.value(b), "{} in scan {scan}", a.name);
        }
        let power = |simulation: &Simulation| -> Vec<(ElementKind, bool)> {
            let power = simulation.power().filter(|(kind, ..)| *kind != ElementKind::Wire);
            power.map(|(kind, _, power)| (kind, power)).collect()
        };
        assert_eq!(power(&old), power(&new), "power in scan {scan}");
    }
}

fn sorted_and_apart(edits: &[Edit]) {
    for pair in edits.windows(2) {
        assert!(pair[0].range.end() < pair[1].range.start(), "{pair:?}");
    }
}

/// Renames what is at an offset; the old name and the new text, or none if that is refused.
fn renamed(text: &str, offset: TextSize, new: &str) -> Option<(String, String)> {
    let analysis = analyze(&Arc::new(parse(text)), "program");
    let old = prepare_rename(&analysis.context, offset).ok()??.name;
    let files = rename(&analysis.context, offset, new, &Alone, &Options::default()).ok()?;
    let edits = files.into_iter().next().map_or_else(Vec::new, |file| file.edits);
    sorted_and_apart(&edits);
    Some((old, apply(text, &edits)))
}

/// Renames here and there in a text; returns how often.
fn rename_in(text: &str, seed: u64, times: usize) -> usize {
    let formatted = format_text(text, &Options::default());
    let (Some(of_text), Some(of_formatted)) = (compile(text), compile(&formatted)) else {
        return 0;
    };
    let mut dice = Dice::new(seed);
    let mut done = 0;
    let words = words(&formatted);
    for _ in 0..times.min(words.len()) {
        let new = dice.of(&NAMES);
        let offset = TextSize::new(dice.of(&words) as u32);
        let Some((old, after)) = renamed(&formatted, offset, new) else {
            continue;
        };
        let shown = format!("`{old}` -> `{new}` at {offset:?} of\n{formatted}\n=>\n{after}");
        done += 1;
        assert_eq!(format_text(&after, &Options::default()), after, "{shown}");
        let program = compile(&after).unwrap_or_else(|| panic!("no program any more: {shown}"));
        assert_eq!(model(&of_formatted), model(&program), "{shown}");
        let names = |name: &str| exchanged(name, &old, new);
        same_trace(&of_formatted, &program, &names, seed);
        // And back. A block's name is written with its `$`.
        let there = self::words(&after).into_iter().find(|at| {
            let word = after[*at..].strip_prefix('$').unwrap_or(&after[*at..]);
            word.starts_with(new)
        });
        let there = there.expect("the new name");
        let (_, back) = renamed(&after, TextSize::new(there as u32), &old)
            .unwrap_or_else(|| panic!("it does not go back: {shown}"));
        assert_eq!(back.to_lowercase(), formatted.to_lowercase(), "{shown}");
        // The same in a text that nobody laid out.
        if let Some(offset) = text.find(&old)
            && let Some((old, after)) = renamed(text, TextSize::new(offset as u32), new)
        {
            let program = compile(&after).unwrap_or_else(|| panic!("{text}\n=> `{old}`\n{after}"));
            assert_eq!(model(&of_text), model(&program), "{text}\n=> `{old}`\n{after}");
        }
    }
    done
}

/// Where words begin in a text.
fn words(text: &str) -> Vec<usize> {
    let mut before = ' ';
    let mut words = Vec::new();
    for (at, c) in text.char_indices() {
        let word = |c: char| c.is_alphanumeric() || matches!(c, '_' | '$');
        if word(c) && !word(before) {
            words.push(at);
        }
        before = c;
    }
    words
}

/// A value's name with another tag in it: `t1.ET` -> `z.ET`.
fn exchanged(name: &str, old: &str, new: &str) -> String {
    let is_end = |c: char| matches!(c, '.' | '[');
    let mut out = String::new();
    // The tag's own name, or that of a member.
    for (number, part) in name.split('.').enumerate() {
        let end = part.find(is_end).unwrap_or(part.len());
        let (head, rest) = part.split_at(end);
        let is_it = head.to_lowercase() == old.to_lowercase();
        out.push_str(if number > 0 { "." } else { "" });
        out.push_str(if is_it { new } else { head });
        out.push_str(rest);
    }
    out
}

#[test]
fn generated_programs() {
    let mut done = 0;
    for seed in 0..60 {
        done += rename_in(&program(seed, Mode::Sensible), seed, 8);
        done += rename_in(&program(seed, Mode::Wild), seed, 8);
        if seed % 3 == 0 {
            done += rename_in(&program(seed, Mode::Typed), seed, 16);
        }
    }
    assert!(done > 300, "only {done} things were renamed");
}

#[test]
fn examples() {
    let mut done = 0;
    for folder in ["examples", "tests/corpus/semantics"] {
        for (seed, path) in project::files(&project::root().join(folder), "clad")
            .iter()
            .enumerate()
        {
            done += rename_in(&project::read(path), seed as u64, 12);
        }
    }
    assert!(done > 100, "only {done} things were renamed");
}

#[test]
fn an_array_and_a_member_keep_their_types() {
    let text = "VAR a : ARRAY[1..3] OF BOOL; t : TON; END_VAR\n+--[ ]( a[1] )--[TON]( t, 5s )--( )( y )--+\n";
    let program = compile(text).unwrap();
    assert!(matches!(program.tags[0].ty, Type::Array { .. }));
    assert!(rename_in(text, 1, 40) > 5);
}
