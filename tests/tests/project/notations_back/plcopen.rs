//! Programs as PLCopen XML and as units of TwinCAT, and back.

use super::says::{Says, networks};
use super::tables::{PLCOPEN, PLCOPEN_ALONG};
use expect_test::{Expect, expect};
use ladder_analysis::analyze;
use ladder_analysis::networks::NetworkAt;
use ladder_format::Options;
use ladder_invariants::generator::Dice;
use ladder_invariants::trace::{Stimulus, compile, next_to, programs_next_to};
use ladder_notations::{Notation, Outcome, Source, by_name, convert};
use ladder_syntax::parse;
use std::sync::Arc;

#[test]
fn plcopen() {
    let (same, through_tags) = come_back(&PLCOPEN, &["[NOT]", "[TON]( t1, T#"]);
    assert!(same > 5 && through_tags > 5, "{same} {through_tags}");
}

#[test]
fn what_is_written_along_comes_back() {
    let (same, _) = come_back(&PLCOPEN_ALONG, &["[RTO]( t1", "[RTOF]( t1", "[CTC]( c1"]);
    assert!(same > 5, "{same}");
}

#[test]
fn twincat() {
    let says = Says {
        notation: "twincat",
        ..PLCOPEN
    };
    let (same, through_tags) = come_back(&says, &["[NOT]", "[TON]( t1, T#", "(P)"]);
    assert!(same > 5 && through_tags > 5, "{same} {through_tags}");
    let says = Says {
        notation: "twincat",
        ..PLCOPEN_ALONG
    };
    let (same, _) = come_back(&says, &["[RTO]( t1", "[RTOF]( t1", "[CTC]( c1", "(P)"]);
    assert!(same > 5, "{same}");
}

/// Of 100 programs, how many are drawn as they were, and how many have tags for powers. All do the same, and have the same blocks with
/// state. Those with one of these words may be drawn otherwise.
fn come_back(says: &Says, otherwise: &[&str]) -> (usize, usize) {
    let notation: &dyn Notation = by_name(says.notation).expect("the notation is registered");
    let (mut same, mut through_tags) = (0, 0);
    for seed in 0..100 {
        let text = says.program(&mut Dice::new(seed));
        let analysis = analyze(&Arc::new(parse(&text)), "test.clad");
        let writing = notation
            .write(&analysis)
            .unwrap_or_else(|error| panic!("{error}\n{text}"));
        let remarks: Vec<_> = writing.report.remarks().collect();
        assert!(remarks.is_empty(), "{remarks:?}\n{text}");
        let shown = String::from_utf8_lossy(&writing.bytes);
        assert!(notation.recognises(&writing.bytes), "{shown}");
        let source = Source {
            companions: writing.companions,
            ..Source::alone("test", &writing.bytes)
        };
        let back = convert(notation, &source, &Options::default());
        let back = back.unwrap_or_else(|error| panic!("{error}\n{shown}\nof\n{text}"));
        let ladder = back.written.text;
        let remarks: Vec<_> = back.report.remarks().collect();
        assert!(
            remarks.is_empty(),
            "seed {seed}: {remarks:?}\n{ladder}\nof\n{text}"
        );
        let different = next_to(&text, &ladder, Stimulus { seed, scans: 60 });
        assert_eq!(different, None, "seed {seed}\n{ladder}\nof\n{text}");
        let is_through_tags =
            ladder.contains("power at a point") || ladder.contains("at the last evaluation");
        for (_, ty, _) in says.states {
            let block = format!("[{ty}]");
            let count = |text: &str| text.matches(&block).count();
            assert_eq!(count(&ladder), count(&text), "seed {seed}\n{ladder}\nof\n{text}");
        }
        let is_otherwise = otherwise.iter().any(|word| text.contains(word));
        if is_through_tags {
            through_tags += 1;
        } else if !is_otherwise {
            same += 1;
            assert_eq!(networks(&ladder), networks(&text), "seed {seed}");
        }
    }
    (same, through_tags)
}

/// Each example in a notation, and what is read of that. It does the same.
fn examples(notation: &str, expected: Expect) {
    let notation: &dyn Notation = by_name(notation).expect("the notation is registered");
    let mut account = String::new();
    let folder = ladder_tests::project::root().join("examples");
    let mut examples: Vec<_> = std::fs::read_dir(folder)
        .expect("there is a folder of examples")
        .map(|entry| entry.expect("it can be read").path())
        .filter(|path| path.extension().is_some_and(|end| end == "clad"))
        .collect();
    examples.sort();
    for path in examples {
        let text = ladder_tests::project::read(&path);
        let name = path
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        let analysis = analyze(&Arc::new(parse(&text)), &name);
        let writing = notation.write(&analysis).expect("an example has no errors");
        let source = Source {
            companions: writing.companions,
            ..Source::alone("test", &writing.bytes)
        };
        let back = convert(notation, &source, &Options::default()).expect("what is written is read");
        let read = back.report.remarks().count();
        // What is of the same blocks in the same order; names may have changed, comments and wires are drawn otherwise.
        let ops = |text: &str| {
            let analysis = analyze(&Arc::new(parse(text)), &name);
            let blocks = analysis.context.networks.iter().flat_map(NetworkAt::blocks);
            blocks.map(|block| block.head_text()).collect::<Vec<_>>()
        };
        let is_same = ops(&text) == ops(&back.written.text);
        account.push_str(&format!(
            "{name}: {} again, {read} remarks on that\n",
            if is_same { "the same" } else { "not the same" }
        ));
        if writing.report.tally().refused == 0 {
            let again = &back.written.text;
            let [one, other] = [&text, again].map(|text| compile(text).expect("it is a program"));
            let read = Arc::clone(&other);
            // Some names are others there.
            let named = |name: &str| {
                let mut tags = read.tags.iter();
                let is_there = tags.any(|tag| tag.name == name && tag.block.is_none());
                (is_there && !name.contains('.')).then(|| name.to_owned())
            };
            let different = programs_next_to((one, other), &named, Stimulus { seed: 1, scans: 60 });
            assert_eq!(different, None, "{name}\n{again}");
        }
        for entry in writing.report.remarks() {
            if let Outcome::Refused(why) = &entry.outcome {
                account.push_str(&format!("    {}: {why}\n", entry.place));
            }
        }
    }
    expected.assert_eq(&account);
}

#[test]
fn examples_as_plcopen() {
    examples(
        "plcopen",
        expect![[r#"
            conveyor.clad: not the same again, 0 remarks on that
            conveyor_plant.clad: not the same again, 0 remarks on that
            garage_door.clad: the same again, 0 remarks on that
            garage_door_plant.clad: not the same again, 0 remarks on that
            level_control.clad: not the same again, 0 remarks on that
            mixer.clad: the same again, 0 remarks on that
            mixer_plant.clad: not the same again, 0 remarks on that
            motor.clad: the same again, 0 remarks on that
            pump_alternation.clad: the same again, 0 remarks on that
            pump_group.clad: not the same again, 0 remarks on that
                30:5: compilers there have arrays of elementary values alone, and structures of such values and arrays: give each part a tag of its own
                38:1: the type of `pump` has no counterpart
                40:1: the type of `pump` has no counterpart
                41:1: the type of `pump` has no counterpart
                43:1: the type of `pump` has no counterpart
                48:1: the type of `pump` has no counterpart
                49:1: the type of `pump` has no counterpart
            tank.clad: the same again, 0 remarks on that
            tank_level.clad: not the same again, 0 remarks on that
            tank_plant.clad: not the same again, 0 remarks on that
            traffic_light.clad: the same again, 0 remarks on that
        "#]],
    );
}

#[test]
fn examples_as_twincat() {
    examples(
        "twincat",
        expect![[r#"
            conveyor.clad: not the same again, 0 remarks on that
            conveyor_plant.clad: not the same again, 0 remarks on that
            garage_door.clad: the same again, 0 remarks on that
            garage_door_plant.clad: not the same again, 0 remarks on that
            level_control.clad: not the same again, 0 remarks on that
            mixer.clad: the same again, 0 remarks on that
            mixer_plant.clad: not the same again, 0 remarks on that
            motor.clad: the same again, 0 remarks on that
            pump_alternation.clad: the same again, 0 remarks on that
            pump_group.clad: the same again, 0 remarks on that
            tank.clad: the same again, 0 remarks on that
            tank_level.clad: not the same again, 0 remarks on that
            tank_plant.clad: not the same again, 0 remarks on that
            traffic_light.clad: the same again, 0 remarks on that
        "#]],
    );
}
