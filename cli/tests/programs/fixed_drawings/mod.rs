//! A fix never turns a drawing into another program. Drawings are made with what they say, in the language and in other
//! notations; whichever fixes are made, a program that comes out without an error does what the drawing says.

mod drawing;

use crate::harness::Folder;
use drawing::{Dice, Drawing, READ, drawing};
use expect_test::expect;
use ladder_analysis::findings::fix;
use ladder_analysis::values::value::Value;
use ladder_analysis::{Analysis, Severity, analyze};
use ladder_format::{Options, apply};
use ladder_simulator::Simulation;
use ladder_syntax::parse;
use std::collections::BTreeMap;
use std::sync::Arc;

fn analysis(text: &str) -> Analysis {
    analyze(&Arc::new(parse(text)), "drawing.clad")
}

/// The inputs of scan after scan: every tag changes by itself and together with others.
fn inputs(scan: u32) -> BTreeMap<&'static str, i64> {
    let bits = scan.wrapping_mul(0x9E37_79B9) >> 16;
    let mut inputs: BTreeMap<&'static str, i64> = READ
        .into_iter()
        .zip(0..)
        .map(|(tag, bit)| (tag, i64::from(bits >> bit & 1)))
        .collect();
    inputs.insert("n", i64::from(bits >> 9) % 8);
    inputs
}

/// What differs between a program and the drawing that it came from; none if it does what the drawing says, or does nothing at
/// all for it has errors.
fn difference(drawing: &Drawing, text: &str) -> Option<String> {
    let analysis = analysis(text);
    let program = analysis.program()?;
    if drawing.is_unknown() {
        return Some("it is not told what runs".to_owned());
    }
    let differs = |everywhere: bool| {
        let mut simulation = Simulation::new(program.clone(), ladder_simulator::Options::default()).ok()?;
        let mut tags = BTreeMap::new();
        for scan in 0..64 {
            for (name, value) in inputs(scan) {
                tags.insert(name, value);
                if let Ok(point) = simulation.resolve(name) {
                    let value = if name == "n" {
                        Value::Int(value)
                    } else {
                        Value::Bool(value != 0)
                    };
                    let _ = simulation.set(&point, value);
                }
            }
            simulation.scan();
            drawing.scan(&mut tags, everywhere);
            for rung in &drawing.rungs {
                let name = rung.coil.0;
                let Ok(point) = simulation.resolve(name) else {
                    return Some(format!("nothing writes `{name}`"));
                };
                let expected = Value::Bool(tags[name] != 0);
                if simulation.value(&point) != expected {
                    return Some(format!("`{name}` is not {expected:?} in scan {scan}"));
                }
            }
        }
        None
    };
    // Without a rail a rung has no power, and a fix may give it some.
    differs(true).and(differs(false))
}

fn errors(text: &str) -> usize {
    let analysis = analysis(text);
    analysis
        .diagnostics()
        .iter()
        .filter(|found| found.severity == Severity::Error)
        .count()
}

/// Makes fixes one by one as a person in an editor may choose them.
fn fixed_at_random(drawing: &Drawing, dice: &mut Dice) -> Result<(), String> {
    let mut text = drawing.text.clone();
    let mut made = String::new();
    for _ in 0..8 {
        let analysis = analysis(&text);
        let fixes: Vec<_> = analysis
            .diagnostics()
            .iter()
            .flat_map(|found| &found.fixes)
            // A preset that the drawing does not have is the one thing that is proposed without being known.
            .filter(|fix| !fix.title.starts_with("Add P"))
            .collect();
        if fixes.is_empty() {
            break;
        }
        let fix = fixes[dice.below(fixes.len())];
        let next = apply(&text, &fix::aligned(&text, fix, &Options::default()));
        made.push_str(&format!("{}: {}\n", made.lines().count(), fix.title));
        text = next;
        if let Some(difference) = difference(drawing, &text) {
            return Err(format!(
                "{difference}:\n{}\nis after\n{made}\n{text}\n{:?}",
                drawing.text, drawing.rungs
            ));
        }
    }
    Ok(())
}

fn drawings(seed: u32, count: u32) -> impl Iterator<Item = Drawing> {
    (0..count)
        .map(move |number| drawing(&mut Dice::new(seed + number)))
        .filter(|drawing| errors(&drawing.text) > 0)
}

fn report(problems: &[String]) {
    assert!(
        problems.is_empty(),
        "{} problems, the first:\n{}",
        problems.len(),
        problems[..problems.len().min(SHOWN)].join("\n=====\n")
    );
}

const SHOWN: usize = 12;

/// So many drawings are made; with `DRAWINGS` in the environment others.
fn count() -> u32 {
    std::env::var("DRAWINGS")
        .ok()
        .and_then(|count| count.parse().ok())
        .unwrap_or(250)
}

#[test]
fn single_fixes_mean_what_the_drawing_says() {
    let mut problems = Vec::new();
    for (number, drawing) in drawings(0, count()).enumerate() {
        for walk in 0..3 {
            let mut dice = Dice::new(number as u32 * 7 + walk);
            problems.extend(fixed_at_random(&drawing, &mut dice).err());
        }
    }
    report(&problems);
}

#[test]
fn all_fixes_together_mean_what_the_drawing_says() {
    for arguments in [
        &["check", "--fix", "."][..],
        &["check", "--fix", "--unsafe-fixes", "."],
    ] {
        let folder = Folder::with(&[]);
        let drawings: Vec<Drawing> = drawings(10_000, count()).collect();
        for (number, drawing) in drawings.iter().enumerate() {
            folder.write(&format!("d{number}.clad"), drawing.text.as_bytes());
        }
        folder.ladder(arguments);
        let read = |number: usize| folder.read(&format!("d{number}.clad"));
        let once: Vec<String> = (0..drawings.len()).map(read).collect();
        let mut problems = Vec::new();
        let mut fixed = 0;
        for (drawing, text) in drawings.iter().zip(&once) {
            fixed += usize::from(errors(text) == 0);
            let difference = difference(drawing, text);
            problems.extend(
                difference.map(|it| format!("{it}:\n{}\nbecomes\n{text}\n{:?}", drawing.text, drawing.rungs)),
            );
        }
        folder.ladder(arguments);
        for (number, text) in once.iter().enumerate() {
            if read(number) != *text {
                problems.push(format!("a second time changes\n{text}\ninto\n{}", read(number)));
            }
        }
        report(&problems);
        // A test of programs that all have errors would show nothing.
        println!("{arguments:?}: {fixed} of {} run", drawings.len());
    }
}

/// Small drawings from the field, with all fixes made.
#[test]
fn drawings_from_the_field() {
    let corpus = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/corpus/field");
    let mut shown = String::new();
    for name in [
        "cplc_hash_touching.clad",
        "cplc_no_plus.clad",
        "fix_contact_name_becomes_instruction/input.clad",
        "fix_contact_name_becomes_instruction/lim.clad",
        "fix_contact_name_becomes_instruction/pb.clad",
        "fix_set_coil_writes_zero/input.clad",
        "paste_allen_bradley_latch/input.clad",
        "paste_nc_contact_is_deleted/input.clad",
    ] {
        let text = std::fs::read_to_string(corpus.join(name)).unwrap();
        let folder = Folder::with(&[("drawing.clad", &text)]);
        let run = folder.ladder(&[
            "check",
            "--fix",
            "--unsafe-fixes",
            "--format",
            "concise",
            "drawing.clad",
        ]);
        shown.push_str(&format!(
            "== {name}\n{}{}{}",
            run.stdout,
            run.stderr,
            folder.read("drawing.clad")
        ));
    }
    expect![[r#"
        == cplc_hash_touching.clad
        Checked 1 file: no errors found.
        +--[ ]( a# note #)--( )( y )--+
        == cplc_no_plus.clad
        fixed drawing.clad:1:1 rung-not-powered: Begin at the left rail
        Checked 1 file: no errors found. Fixed 1 finding.
        +--[ ]( a )--( )( y )--
        +--[ ]( a )--( )( z )--+
        == fix_contact_name_becomes_instruction/input.clad
        fixed drawing.clad:1:4 unknown-instruction: Write [ ]( Go )
        Checked 1 file: no errors found. Fixed 1 finding.
        +--[ ]( Go )---------------------------------------------------------( )( y )--+
        == fix_contact_name_becomes_instruction/lim.clad
        fixed drawing.clad:2:27 undeclared-tag: Declare `y : BOOL` in VAR_OUTPUT
        drawing.clad:5:4: error[unknown-instruction] there is no instruction [LIM]
        Checked 1 file: 1 error. Fixed 1 finding.
        VAR_INPUT x : INT; END_VAR
        VAR_OUTPUT
            y : BOOL;
        END_VAR
        +--[LIM]( x, 1, 2 )--( )( y )--+
        == fix_contact_name_becomes_instruction/pb.clad
        fixed drawing.clad:1:4 unknown-instruction: Write [ ]( pb )
        Checked 1 file: no errors found. Fixed 1 finding.
        +--[ ]( pb )---------------------------------------------------------( )( y )--+
        == fix_set_coil_writes_zero/input.clad
        fixed drawing.clad:1:15 unknown-instruction: Replace with (S)
        drawing.clad:1:73: info[set-without-reset] `fan` is set, and nothing resets it: once on, it stays on
        Checked 1 file: 1 info. Fixed 1 finding.
        +--[ ]( go )-------------------------------------------------------(S)( fan )--+
        == paste_allen_bradley_latch/input.clad
        fixed drawing.clad:1:14 unknown-instruction: Replace with (S)
        fixed drawing.clad:2:14 unknown-instruction: Replace with (R)
        fixed drawing.clad:3:14 unknown-instruction: Replace with [TON]
        Checked 1 file: no errors found. Fixed 3 findings.
        +--[ ]( a )----------------------------------------------------------(S)( y )--+
        +--[ ]( b )----------------------------------------------------------(R)( y )--+
        +--[ ]( a )------------------------------------------[TON]( t, 5s )--( )( z )--+
        == paste_nc_contact_is_deleted/input.clad
        fixed drawing.clad:1:16 misplaced-rail: Write [/]( ? )
        drawing.clad:1:21: error[unexpected-character] an operand is missing here: `?` holds its place
        Checked 1 file: 1 error. Fixed 1 finding.
        +--[ ]( go )---[/]( ? )---( )( fan )--+
    "#]]
    .assert_eq(&shown);
}
