//! A safe fix never changes what a program does: generated programs are damaged by one edit, and all safe fixes are made.
//!
//! Where the damage made an error, either an error is left, or the program does what it did when it was healthy. Where
//! it made none, the program does what it does with the damage.
//!
//! A failure names the seed. `GENERATED_PROGRAMS=5000 cargo test -p ladder-tests safe_fixes` tries more.

use ladder_analysis::findings::fix;
use ladder_analysis::{Analysis, Applicability, analyze};
use ladder_format::{Options, apply};
use ladder_syntax::parse;
use ladder_tests::generator::{Dice, Mode, program};
use ladder_tests::trace::{Stimulus, next_to};
use std::sync::Arc;

/// What a slip puts in, or in the place of something else.
const PIECES: [&str; 20] = [
    "-", "\\", "/", "+", "|", " ", "(", ")", "[", "]", "<", ">", ",", ";", ":", "=", "'", ".", "\n", "--",
];

fn analysis(text: &str) -> Analysis {
    analyze(&Arc::new(parse(text)), "program")
}

/// The text with one slip in it.
fn damaged(text: &str, dice: &mut Dice) -> String {
    // Most slips happen where the drawing is.
    let drawing: Vec<usize> = text
        .char_indices()
        .filter(|(_, c)| dice.one_in(6) || r"-\/+|()[]<>, ".contains(*c))
        .map(|(at, _)| at)
        .collect();
    let mut text = text.to_owned();
    if drawing.is_empty() {
        return text;
    }
    let at = drawing[dice.below(drawing.len())];
    let letters: Vec<char> = text[at..].chars().take(2).collect();
    let end = at + letters[0].len_utf8();
    match dice.below(4) {
        0 => text.replace_range(at..end, ""),
        1 => text.insert_str(at, dice.of(&PIECES)),
        2 => text.replace_range(at..end, dice.of(&PIECES)),
        _ if letters.len() > 1 => {
            let end = end + letters[1].len_utf8();
            text.replace_range(at..end, &format!("{}{}", letters[1], letters[0]));
        }
        _ => {}
    }
    text
}

/// The text with all safe fixes made, in as many rounds as they need.
fn fixed(text: &str) -> String {
    let mut text = text.to_owned();
    for _ in 0..8 {
        let found = analysis(&text).diagnostics().to_vec();
        let fixes = fix::together(&found, Applicability::Safe);
        if fixes.is_empty() {
            break;
        }
        let whole = fix::combined(fixes.iter().map(|(_, fix)| *fix));
        text = apply(&text, &fix::aligned(&text, &whole, &Options::default()));
    }
    text
}

/// What is wrong with the safe fixes of a damaged program; and whether any was made.
fn problem(healthy: &str, damaged: &str, seed: u64) -> (bool, Option<String>) {
    let fixed = fixed(damaged);
    if fixed == damaged {
        return (false, None);
    }
    let had_errors = analysis(damaged).has_errors();
    let has_errors = analysis(&fixed).has_errors();
    let stimulus = Stimulus { seed, scans: 12 };
    let differs = match (had_errors, has_errors) {
        (true, true) => None,
        (true, false) => next_to(healthy, &fixed, stimulus),
        (false, false) => next_to(damaged, &fixed, stimulus),
        (false, true) => Some("there are errors now".to_owned()),
    };
    let reported = differs
        .map(|differs| format!("seed {seed}: {differs}\n{healthy}\ndamaged\n{damaged}\nbecomes\n{fixed}"));
    (true, reported)
}

#[test]
fn a_safe_fix_gives_the_healthy_program_or_leaves_an_error() {
    let count = std::env::var("GENERATED_PROGRAMS");
    let count: u64 = count.ok().and_then(|count| count.parse().ok()).unwrap_or(120);
    let mut problems = Vec::new();
    let mut made = 0;
    for seed in 0..count {
        let mode = [Mode::Sensible, Mode::Wild, Mode::Boolean, Mode::Typed][(seed % 4) as usize];
        let healthy = program(seed, mode);
        if analysis(&healthy).has_errors() {
            continue;
        }
        let mut dice = Dice::new(seed);
        for _ in 0..12 {
            let (any, problem) = problem(&healthy, &damaged(&healthy, &mut dice), seed);
            made += usize::from(any);
            problems.extend(problem);
        }
    }
    assert!(
        problems.is_empty(),
        "{} problems\n{}",
        problems.len(),
        problems[..problems.len().min(3)].join("\n")
    );
    // Otherwise nothing was checked.
    assert!(made as u64 > count, "only {made} programs had anything to fix");
}
