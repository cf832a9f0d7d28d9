//! What holds for every program that the generator makes.
//!
//! A failure names the seed. `GENERATED_PROGRAMS=20000 cargo test -p ladder-cli --test project generated` tries more of them.

use ladder_analysis::{Severity, analyze};
use ladder_format::{Options, format_text};
use ladder_syntax::{NodeOrToken, SyntaxKind, parse};
use ladder_tests::generator::{Mode, program};
use ladder_tests::reference::{Boolean, DrawnPart, networks};
use ladder_tests::trace::{Engine, Stimulus, compare, difference, trace};
use std::path::Path;
use std::process::Command;
use std::sync::Arc;

/// Says which program it was when a check fails.
struct Seed(u64, Mode);

impl Drop for Seed {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!(
                "program({}, Mode::{:?}) is\n{}",
                self.0,
                self.1,
                program(self.0, self.1)
            );
        }
    }
}

/// Checks so many programs of a kind, or as many as were asked for.
fn each(mode: Mode, count: u64, check: impl Fn(u64, &str)) {
    let asked = std::env::var("GENERATED_PROGRAMS")
        .ok()
        .and_then(|count| count.parse().ok());
    for seed in 0..asked.unwrap_or(count) {
        let seed = Seed(seed, mode);
        check(seed.0, &program(seed.0, mode));
    }
}

fn formatted(text: &str) -> String {
    format_text(text, &Options::default())
}

const fn stimulus(seed: u64) -> Stimulus {
    Stimulus { seed, scans: 12 }
}

#[test]
fn nothing_is_found_in_sensible_programs() {
    each(Mode::Sensible, 300, |_, text| {
        let findings = analyze(&Arc::new(parse(text)), "main").diagnostics().to_vec();
        assert!(findings.is_empty(), "{findings:#?}");
    });
}

#[test]
fn wild_programs_hold_no_errors() {
    each(Mode::Wild, 600, |_, text| {
        let findings = analyze(&Arc::new(parse(text)), "main").diagnostics().to_vec();
        let errors: Vec<_> = findings
            .iter()
            .filter(|found| found.severity == Severity::Error)
            .collect();
        assert!(errors.is_empty(), "{errors:#?}");
    });
}

#[test]
fn the_tree_holds_every_character() {
    for mode in [Mode::Sensible, Mode::Wild, Mode::Boolean, Mode::Typed] {
        each(mode, 300, |_, text| assert_eq!(parse(text).to_string(), text));
    }
}

#[test]
fn the_same_seed_gives_the_same_program() {
    for mode in [Mode::Sensible, Mode::Wild, Mode::Boolean, Mode::Typed] {
        each(mode, 100, |seed, text| assert_eq!(program(seed, mode), text));
    }
}

#[test]
fn formatting_twice_gives_the_same_text() {
    for mode in [Mode::Sensible, Mode::Wild, Mode::Boolean, Mode::Typed] {
        each(mode, 250, |_, text| {
            let once = formatted(text);
            assert_eq!(formatted(&once), once);
        });
    }
}

#[test]
fn formatting_keeps_the_tokens() {
    for mode in [Mode::Sensible, Mode::Wild, Mode::Typed] {
        each(mode, 250, |_, text| {
            assert_eq!(tokens(&formatted(text)), tokens(text));
        });
    }
}

/// All tokens but those of the layout, in capitals where the case may change.
fn tokens(text: &str) -> Vec<String> {
    parse(text)
        .syntax()
        .descendants_with_tokens()
        .filter_map(NodeOrToken::into_token)
        .filter(|token| {
            use SyntaxKind::{NEWLINE, RAIL, WHITESPACE, WIRE};
            !matches!(token.kind(), WHITESPACE | NEWLINE | WIRE | RAIL)
        })
        .map(|token| match token.kind() {
            SyntaxKind::COMMENT => token.text().to_owned(),
            _ => token.text().to_uppercase(),
        })
        .collect()
}

/// As the independent reader of the reference sees it.
#[test]
fn formatting_keeps_the_wiring() {
    let wiring = |text: &str| -> Vec<Vec<Vec<DrawnPart>>> {
        let without_wires =
            |rung: Vec<DrawnPart>| rung.into_iter().filter(|part| *part != DrawnPart::Wire).collect();
        networks(text)
            .into_iter()
            .map(|(rungs, _)| rungs.into_iter().map(without_wires).collect())
            .collect()
    };
    each(Mode::Boolean, 1000, |_, text| {
        assert_eq!(wiring(&formatted(text)), wiring(text));
    });
}

#[test]
fn formatting_never_changes_the_trace() {
    for (mode, count) in [
        (Mode::Sensible, 100),
        (Mode::Wild, 200),
        (Mode::Boolean, 100),
        (Mode::Typed, 100),
    ] {
        each(mode, count, |seed, text| {
            let before = trace(text, stimulus(seed), Engine::Fused);
            let after = trace(&formatted(text), stimulus(seed), Engine::Fused);
            assert_eq!(
                difference(&before, &after),
                None,
                "formatted:\n{}",
                formatted(text)
            );
        });
    }
}

/// Compiled and run a second time, and as it runs while something is forced.
#[test]
fn the_same_inputs_give_the_same_trace() {
    for (mode, count) in [
        (Mode::Sensible, 100),
        (Mode::Wild, 200),
        (Mode::Boolean, 100),
        (Mode::Typed, 100),
    ] {
        each(mode, count, |seed, text| {
            let first = trace(text, stimulus(seed), Engine::Fused);
            for (engine, what) in [(Engine::Fused, "a second time"), (Engine::Plain, "plain code")] {
                let again = trace(text, stimulus(seed), engine);
                assert_eq!(difference(&first, &again), None, "{what}");
            }
        });
    }
}

#[test]
fn programs_do_something() {
    let (mut programs, mut changing, mut faults) = (0, 0, 0);
    for seed in 0..100 {
        let trace = trace(&program(seed, Mode::Wild), stimulus(seed), Engine::Fused);
        let mut scans = trace
            .lines()
            .filter(|line| !line.starts_with(' '))
            .map(|line| line.split_once("true"));
        let first = scans.next();
        programs += 1;
        changing += usize::from(scans.any(|scan| Some(scan) != first));
        faults += usize::from(trace.contains("fault in"));
    }
    assert!(
        changing * 2 > programs,
        "only {changing} of {programs} programs change a tag"
    );
    assert!(
        faults > 5 && faults < programs,
        "{faults} of {programs} programs have a fault"
    );
}

/// The simulator against the definition of a scan, written down a second time.
#[test]
fn contacts_and_coils_do_what_the_definition_says() {
    each(Mode::Boolean, 400, |seed, text| {
        for text in [text.to_owned(), formatted(text)] {
            let mut reference = Boolean::new(&text);
            compare(&text, &mut reference, stimulus(seed));
        }
    });
}

/// Two processes: nothing of a trace comes from addresses, hash seeds or the clock.
#[test]
fn two_processes_write_the_same_bytes() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("program.clad");
    for (mode, count) in [(Mode::Sensible, 10), (Mode::Wild, 40)] {
        each(mode, count, |seed, text| {
            std::fs::write(&file, text).expect("a file in the temporary folder");
            let first = run(&file);
            assert!(!first.is_empty(), "program {seed} has no trace");
            assert_eq!(run(&file), first);
            std::fs::write(&file, formatted(text)).expect("a file in the temporary folder");
            assert_eq!(run(&file), first, "formatted");
        });
    }
}

fn run(file: &Path) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_ladder"))
        .args(["sim", "--scans", "20"])
        .arg(file)
        .output()
        .expect("the program starts");
    String::from_utf8(output.stdout).expect("a trace is UTF-8")
}
