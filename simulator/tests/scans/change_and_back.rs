//! A program that is changed to another and back while it runs: the trace is as if nothing had been.

use crate::change::{COUNTS, MOTOR, program, program_of, session};
use crate::support::simulation;
use ladder_analysis::program::{Program, Role};
use ladder_analysis::values::value::Value;
use ladder_simulator::value_text::cell;
use ladder_simulator::{Changeover, Point, Session};
use std::sync::Arc;

/// Numbers that look random.
pub(crate) struct Numbers(pub(crate) u64);

impl Numbers {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }
}

/// What the name of a tag begins with that is called otherwise for a while.
const RENAMED: &str = "yy_";

/// The name that a point has in the program as it is written.
fn name_of(point: &Point) -> &str {
    point.name.strip_prefix(RENAMED).unwrap_or(&point.name)
}

/// Sets inputs at random, the same in the same scan of the same program.
pub(crate) fn give(session: &mut Session, seed: u64) {
    let mut numbers = Numbers(seed * 2 + 0x9E37_79B9_7F4A_7C15);
    let mut points: Vec<_> = session.simulation().points().to_vec();
    points.sort_by(|a, b| name_of(a).cmp(name_of(b)));
    for point in points
        .iter()
        .filter(|point| point.role == Role::Input && !point.name.starts_with("zz"))
    {
        let number = numbers.next();
        let value = if point.ty == ladder_analysis::values::types::Scalar::Bool {
            Value::Bool(number >> 20 & 1 != 0)
        } else if point.ty.bounds().is_some() {
            Value::Int((number >> 20 & 15) as i64)
        } else {
            continue;
        };
        session.set(point, value).unwrap();
    }
}

/// All that a scan left: values, and which power flowed.
fn picture(session: &Session, count: usize) -> String {
    let simulation = session.simulation();
    let values = simulation
        .points()
        .iter()
        .filter(|point| !point.name.starts_with("zz"));
    let mut values: Vec<String> = values
        .map(|point| format!("{} {}", name_of(point), cell(&simulation.value(point), point.ty)))
        .collect();
    values.sort();
    let power: String = simulation
        .power()
        .take(count)
        .map(|(_, _, on)| if on { '=' } else { '-' })
        .collect();
    format!("{}\n{power}", values.join(", "))
}

fn programs_in(folder: &str) -> Vec<String> {
    let folder = format!("{}/{folder}", env!("CARGO_MANIFEST_DIR"));
    let entries = std::fs::read_dir(folder).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    paths
        .filter(|path| path.extension().is_some_and(|extension| extension == "clad"))
        .map(|path| std::fs::read_to_string(path).unwrap())
        .collect()
}

/// The examples of all instructions, and whole programs.
pub(crate) fn programs() -> Vec<String> {
    let mut programs: Vec<String> = ladder_instructions::TABLE
        .iter()
        .map(|row| row.example.to_owned())
        .collect();
    programs.extend(programs_in("../examples"));
    programs.push(format!(
        "{COUNTS}+--[$Count]( a, x )--+\n+--[ ]( c )--[$Count]( b, y )--+\n"
    ));
    programs.push(MOTOR.to_owned());
    programs
}

#[test]
fn there_and_back_the_trace_stays() {
    let programs = programs().into_iter();
    let programs = programs.chain(programs_in("../tests/corpus/semantics"));
    for (number, text) in (0u64..).zip(programs) {
        let other = format!("{text}\n+--[ ]( zz_in )--[TON]( zz_t, T#50ms )--[OSR]--( )( zz_out )--+\n");
        // Some programs take no rung after them.
        let other = program_of(&other).unwrap_or_else(|| program(&text));
        check_there_and_back(&text, &other, number);
    }
}

#[test]
fn renamed_and_back_the_trace_stays() {
    let mut tried = 0;
    for (number, text) in (0u64..).zip(programs()) {
        let tags = program(&text).tags.clone();
        for tag in tags
            .iter()
            .filter(|tag| tag.address.is_none() && tag.block.is_none())
        {
            let other = program_of(&with_word(&text, &tag.name, &format!("{RENAMED}{}", tag.name)));
            // A word that is at one place only may be another tag.
            if let Some(other) = other.filter(|_| places(&text, &tag.name) > 1) {
                check_there_and_back(&text, &other, number);
                tried += 1;
            }
        }
    }
    assert!(tried > 100, "only {tried} tags were renamed");
}

/// A text with another word in the place of one.
fn with_word(text: &str, word: &str, other: &str) -> String {
    let mut written = String::new();
    let mut rest = text;
    while let Some(at) = rest.find(|it: char| it.is_alphanumeric() || it == '_') {
        let end = rest[at..].find(|it: char| !it.is_alphanumeric() && it != '_');
        let end = end.map_or(rest.len(), |length| at + length);
        let found = &rest[at..end];
        written.push_str(&rest[..at]);
        written.push_str(if found == word { other } else { found });
        rest = &rest[end..];
    }
    written + rest
}

fn places(text: &str, word: &str) -> usize {
    with_word(text, word, "\u{1}").matches('\u{1}').count()
}

/// Runs a program, and it again while it is changed to another and back now and then: nothing may come of that.
#[track_caller]
fn check_there_and_back(text: &str, other: &Arc<Program>, seed: u64) {
    const SCANS: u64 = 40;
    let count = simulation(text).power().count();
    let mut undisturbed = session(text);
    let mut changed = session(text);
    let mut numbers = Numbers(seed + 77);
    let this = program(text);
    let mut is_other = false;
    for scan in 0..SCANS {
        match numbers.next() % 6 {
            0 => {
                let same = if is_other { other } else { &this };
                assert_eq!(changed.change(same.clone()).unwrap(), Changeover::None);
            }
            1 | 2 => {
                changed.change(other.clone()).unwrap();
                is_other = numbers.next().is_multiple_of(2);
                if !is_other {
                    changed.change(this.clone()).unwrap();
                }
            }
            3 => {
                changed.change(this.clone()).unwrap();
                is_other = false;
            }
            _ => {}
        }
        give(&mut undisturbed, scan + 1);
        give(&mut changed, scan + 1);
        undisturbed.scan();
        changed.scan();
        let (expected, is) = (picture(&undisturbed, count), picture(&changed, count));
        assert_eq!(is, expected, "scan {scan} of\n{text}");
    }
    // Back over all changes, and forward again.
    let end = picture(&changed, count);
    loop {
        let gone = changed.step_back(7);
        if gone == 0 {
            break;
        }
        undisturbed.step_back(gone);
        assert_eq!(picture(&changed, count), picture(&undisturbed, count), "{text}");
    }
    while changed.scans_ahead() > 0 {
        changed.scan();
    }
    assert_eq!(picture(&changed, count), end, "{text}");
}
