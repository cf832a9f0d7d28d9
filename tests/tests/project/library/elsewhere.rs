//! Blocks of the library that other systems are given: they do there what they do here.

use crate::tested::Tested;
use expect_test::expect;
use ladder_analysis::library::SOURCES;
use ladder_analysis::{analyze, link};
use ladder_format::Options;
use ladder_notations::{Source, convert};
use ladder_simulator::scenario;
use std::sync::Arc;

/// Scenarios whose rows have times as numbers.
fn in_milliseconds(scenarios: &str) -> String {
    let number = |word: &str| {
        let digits = word.trim_end_matches(|c: char| c.is_ascii_alphabetic());
        let unit = match &word[digits.len()..] {
            "ms" => 1.0,
            "s" => 1e3,
            "m" => 6e4,
            "h" => 36e5,
            "d" => 864e5,
            _ => return None,
        };
        Some((digits.parse::<f64>().ok()? * unit).to_string())
    };
    let line = |line: &str| {
        if ["step ", "interval ", "scenario "]
            .iter()
            .any(|head| line.starts_with(head))
        {
            return line.to_owned();
        }
        let words = line
            .split(' ')
            .map(|word| number(word).unwrap_or_else(|| word.to_owned()));
        words.collect::<Vec<_>>().join(" ")
    };
    let lines: Vec<String> = scenarios.lines().map(line).collect();
    lines.join("\n") + "\n"
}

#[test]
fn what_is_written_and_read_again_does_what_the_scenarios_say() {
    let mut out = String::new();
    let mut problems = Vec::new();
    for name in ["l5x", "simatic"] {
        let notation = ladder_notations::by_name(name).expect("it is known");
        out.push_str(&format!("{name}:"));
        for source in SOURCES {
            let parse = Arc::new(ladder_syntax::parse(source.example));
            let analysis = Arc::new(analyze(&parse, "plant.clad"));
            link(&analysis, &|_| None).expect("it is whole");
            let writing = notation.write(&analysis).expect("it is written");
            if writing.report.tally().refused > 0 {
                continue;
            }
            out.push_str(&format!(" {}", source.name));
            let again = Source {
                name: "plant".into(),
                bytes: &writing.bytes,
                companions: writing.companions.clone(),
            };
            let again = convert(notation, &again, &Options::default()).expect("it is read");
            // A time is a number of milliseconds in Logix.
            let scenarios = match name {
                "l5x" => in_milliseconds(source.scenarios),
                _ => source.scenarios.to_owned(),
            };
            let suite = scenario::parse(&scenarios);
            let file = format!("{name} {}", source.name).into();
            let program = format!("{}.clad", source.name).into();
            Tested::of(file, suite, program, &again.written.text).passed(&mut problems);
        }
        out.push('\n');
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    expect![[r#"
        l5x: $Alarm $Alternate $Average $Blink $Debounce $Drum $FirstOut $Hysteresis $Interval $PID $Ramp $RunTime $Scale $Step $Toggle $Total $Amount $Belt $Cylinder $Heater $Motor $Noise $Tank $Valve
        simatic: $Alarm $Alternate $Average $Blink $Debounce $Drum $FirstOut $Hysteresis $Interval $PID $Ramp $RunTime $Scale $Step $Toggle $Total $Amount $Belt $Cylinder $Heater $Motor $Noise $Tank $Valve
    "#]]
    .assert_eq(&out);
}
