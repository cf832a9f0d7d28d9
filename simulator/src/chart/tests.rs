//! What is recorded of a session, and what is drawn of it.

use super::*;
use crate::session::{HistoryLimits, Session};
use crate::simulation::{Options, Simulation};
use crate::tags::Point;
use expect_test::{Expect, expect};
use ladder_analysis::values::value::Value;
use std::fmt::Write;
use std::sync::Arc;

const COUNTER: &str = "\
+--[/]( slow )--[R_TRIG]--( )( pulse )--+
+--[ ]( on )--[TON]( warm, 30ms )--( )( hot )--+
+--[ADD]( n, 1, n )--+
";

fn session(text: &str, limits: HistoryLimits) -> Session {
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "test.clad");
    let program = analysis.program().cloned().unwrap_or_else(|| {
        panic!("{:?}", analysis.diagnostics());
    });
    Session::of(Simulation::new(program, Options::default()).unwrap(), limits)
}

fn points(session: &Session, names: &[&str]) -> Vec<Point> {
    let found = names
        .iter()
        .map(|name| session.simulation().resolve(name).unwrap());
    found.collect()
}

fn set(session: &mut Session, name: &str, value: i64) {
    let point = session.simulation().resolve(name).unwrap();
    let value = match point.ty {
        ladder_analysis::values::types::Scalar::Bool => Value::Bool(value != 0),
        _ => Value::Int(value),
    };
    session.set(&point, value).unwrap();
}

/// Columns as a row: `_` low, `-` high, `|` both; numbers as `least..greatest`.
fn row(track: &Track, window: &Window, newest: u64) -> String {
    let mut out = String::new();
    let columns = track.columns(window, 0, newest);
    let last = window.column(window.last.min(newest));
    for (at, column) in columns.iter().enumerate() {
        let end = columns.get(at + 1).map_or(last + 1, |next| next.number);
        for _ in column.number..end {
            match &column.mark {
                Mark::Bit(Level::Low) => out.push('_'),
                Mark::Bit(Level::High) => out.push('-'),
                Mark::Bit(Level::Both) => out.push('|'),
                Mark::Number { least, greatest, .. } if least.to_bits() == greatest.to_bits() => {
                    let _ = write!(out, "{least} ");
                }
                Mark::Number {
                    least,
                    greatest,
                    last,
                } => {
                    let _ = write!(out, "{least}..{greatest}={last} ");
                }
                Mark::Text(text) => {
                    let _ = write!(out, "{text} ");
                }
            }
        }
    }
    out.trim_end().to_owned()
}

fn check(given: &[u8], window: Window, drawn: Expect) {
    let mut session = session(
        "+--[ ]( x )--( )( y )--+\n+--[ADD]( n, 1, n )--+\n",
        HistoryLimits::default(),
    );
    let mut recorder = Recorder::default();
    recorder.watch(points(&session, &["x", "n"]), &session);
    for level in given {
        set(&mut session, "x", i64::from(*level));
        session.scan();
        recorder.look(&session);
    }
    let rows: Vec<String> = recorder
        .tracks()
        .iter()
        .map(|track| row(track, &window, recorder.newest()))
        .collect();
    drawn.assert_eq(&rows.join("\n"));
}

#[test]
fn each_scan_is_a_column_where_there_is_room() {
    check(
        &[0, 0, 1, 1, 0, 1],
        Window::new(6, 6, 100),
        expect![[r#"
        __--_-
        1 2 3 4 5 6"#]],
    );
    check(
        &[0, 0, 1, 1, 0, 1],
        Window::new(4, 2, 100),
        expect![[r#"
        --
        3 4"#]],
    );
}

#[test]
fn a_column_of_several_scans_shows_the_least_and_the_greatest() {
    check(
        &[0, 0, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 1],
        Window::new(14, 14, 7),
        expect![[r#"
            _|-|___-
            1 2..3=3 4..5=5 6..7=7 8..9=9 10..11=11 12..13=13 14"#]],
    );
    check(
        &[0, 0, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 1],
        Window::new(14, 14, 4),
        expect![[r#"
            ||_|
            1..3=3 4..7=7 8..11=11 12..14=14"#]],
    );
}

#[test]
fn a_window_begins_where_the_program_began() {
    assert_eq!(
        Window::new(5, 100, 50),
        Window {
            first: 1,
            last: 100,
            per: 2
        }
    );
    assert_eq!(
        Window::new(500, 100, 1000),
        Window {
            first: 401,
            last: 500,
            per: 1
        }
    );
}

/// Columns that were asked for piece by piece are those that are asked for at once.
#[test]
fn what_is_new_fits_to_what_was_there() {
    let mut session = session(COUNTER, HistoryLimits::default());
    let mut recorder = Recorder::default();
    recorder.watch(points(&session, &["pulse", "warm.ET", "n", "hot"]), &session);
    for per in [1, 3, 16] {
        let mut pieces: Vec<std::collections::BTreeMap<u64, Mark>> =
            vec![std::collections::BTreeMap::default(); 4];
        let mut since = 1;
        for scan in 0..200 {
            set(&mut session, "on", i64::from(scan % 23 > 5));
            set(&mut session, "slow", i64::from(scan % 7 > 3));
            session.scan();
            recorder.look(&session);
            if scan % 13 != 0 && scan != 199 {
                continue;
            }
            let newest = recorder.newest();
            let window = Window {
                first: 1,
                last: newest,
                per,
            };
            for (track, known) in recorder.tracks().iter().zip(&mut pieces) {
                let fresh = track.columns(&window, since, newest);
                known.split_off(&window.column(since));
                known.extend(fresh.into_iter().map(|column| (column.number, column.mark)));
            }
            since = newest;
        }
        for (track, known) in recorder.tracks().iter().zip(&pieces) {
            let window = Window {
                first: 1,
                last: since,
                per,
            };
            let whole = track.columns(&window, 0, since);
            // Pieces begin with a mark that may be that of the column before.
            let mut joined: Vec<Column> = Vec::new();
            for (number, mark) in known {
                if joined.last().is_none_or(|last| last.mark != *mark) {
                    joined.push(Column {
                        number: *number,
                        mark: mark.clone(),
                    });
                }
            }
            assert_eq!(joined, whole, "{} in columns of {per}", track.point.name);
        }
    }
}

/// What is recorded while it runs is what the history knows, wherever the session goes.
#[test]
fn the_record_is_the_history() {
    let mut session = session(COUNTER, HistoryLimits::default());
    let names = ["pulse", "warm.ET", "n", "on"];
    let all = points(&session, &names);
    let mut recorder = Recorder::default();
    recorder.watch(all.clone(), &session);
    let mut dice = 1u64;
    for step in 0..400 {
        dice = dice
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let roll = dice >> 33;
        match roll % 9 {
            0 => {
                session.step_back((roll / 9 % 7) as usize);
            }
            1 => set(&mut session, "on", (roll / 9 % 2) as i64),
            2 => {
                session.step_block();
            }
            3 => {
                let to = session.simulation().scans() + roll / 9 % 5;
                session.go_to(to);
            }
            4 if (roll / 9).is_multiple_of(20) => session.reset(),
            _ => {
                session.scan();
            }
        }
        recorder.look(&session);
        let mut afresh = Recorder::default();
        afresh.watch(all.clone(), &session);
        assert_eq!(recorder.newest(), afresh.newest(), "step {step}");
        for (track, other) in recorder.tracks().iter().zip(afresh.tracks()) {
            for scan in 1..=recorder.newest() {
                assert_eq!(
                    track.at(scan),
                    other.at(scan),
                    "{} at {scan}, step {step}",
                    track.point.name
                );
            }
            assert_eq!(track.range(), other.range(), "{}, step {step}", track.point.name);
        }
    }
}

#[test]
fn a_tag_that_comes_later_has_the_past_that_is_kept_and_what_was_stepped_back_from() {
    let mut session = session(COUNTER, HistoryLimits::of_scans(5));
    for _ in 0..9 {
        session.scan();
    }
    session.go_to(7);
    let mut recorder = Recorder::default();
    recorder.watch(points(&session, &["n"]), &session);
    let track = &recorder.tracks()[0];
    let known: Vec<Option<&Value>> = (3..=9).map(|scan| track.at(scan)).collect();
    let n = |n| Some(Value::Int(n));
    let expected = [None, n(4), n(5), n(6), n(7), n(8), n(9)];
    assert_eq!(known, expected.each_ref().map(Option::as_ref));
    assert_eq!(recorder.newest(), 9);
}

#[test]
fn another_future_is_another_record() {
    let mut session = session(COUNTER, HistoryLimits::default());
    let mut recorder = Recorder::default();
    recorder.watch(points(&session, &["on", "n"]), &session);
    for _ in 0..5 {
        session.scan();
        recorder.look(&session);
    }
    session.step_back(3);
    recorder.look(&session);
    assert_eq!((recorder.newest(), recorder.revision()), (5, 0));
    set(&mut session, "on", 1);
    recorder.look(&session);
    assert_eq!((recorder.newest(), recorder.revision()), (2, 1));
    session.reset();
    recorder.look(&session);
    assert_eq!((recorder.newest(), recorder.revision()), (0, 2));
}

#[test]
fn a_long_run_takes_no_more_room_than_a_short_one() {
    let mut track = Track::new(points(&session(COUNTER, HistoryLimits::default()), &["n"])[0].clone());
    for scan in 1..=100_000 {
        track.push(scan, Value::Int(scan as i64 % 1000));
    }
    assert_eq!(track.first(), Some(100_000 - 65_535));
    track.push(100_001, Value::Int(5000));
    assert_eq!(track.range(), Some((0.0, 5000.0)));
    track.truncate(100_000);
    assert_eq!(track.range(), Some((0.0, 999.0)));
}

#[test]
fn an_edited_program_keeps_the_tracks_of_its_tags() {
    let mut session = session(COUNTER, HistoryLimits::default());
    let mut recorder = Recorder::default();
    recorder.watch(points(&session, &["n", "hot"]), &session);
    for _ in 0..3 {
        session.scan();
        recorder.look(&session);
    }
    let text = "+--[/]( slow )--( )( other )--+\n+--[ADD]( n, 2, n )--+\n";
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "test.clad");
    session.change(Arc::clone(analysis.program().unwrap())).unwrap();
    session.scan();
    recorder.look(&session);
    let names: Vec<&str> = recorder
        .tracks()
        .iter()
        .map(|track| track.point.name.as_str())
        .collect();
    assert_eq!(names, ["n"]);
    let n: Vec<_> = (1..=4)
        .map(|scan| recorder.tracks()[0].at(scan).cloned())
        .collect();
    assert_eq!(n, [1, 2, 3, 5].map(|n| Some(Value::Int(n))));
}

#[test]
fn a_tag_that_is_renamed_keeps_its_track_and_its_past() {
    let named =
        |name: &str| format!("+--[ADD]( {name}, 1, {name} )--+\n+--[GT]( {name}, 5 )--( )( many )--+\n");
    let program = |text: &str| {
        let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "test.clad");
        Arc::clone(analysis.program().unwrap())
    };
    let mut session = session(&named("n"), HistoryLimits::default());
    let mut recorder = Recorder::default();
    recorder.watch(points(&session, &["n"]), &session);
    let mut run = |session: &mut Session| {
        session.scan();
        recorder.look(session);
        let track = &recorder.tracks()[0];
        let last = session.simulation().scans();
        let values: Vec<_> = (1..=last).map(|scan| track.at(scan).cloned()).collect();
        let counted: Vec<_> = (1..=last).map(|scan| Some(Value::Int(scan as i64))).collect();
        assert_eq!(values, counted, "{}", track.point.name);
        // Who asks only now, by any of its names, has the same past.
        let mut fresh = Recorder::default();
        for name in ["n", "count", "total"] {
            if let Ok(point) = session.find(name) {
                fresh.watch(vec![point], session);
                let values: Vec<_> = (1..=last)
                    .map(|scan| fresh.tracks()[0].at(scan).cloned())
                    .collect();
                assert_eq!(values, counted, "{name}");
            }
        }
        track.point.name.clone()
    };
    assert_eq!(run(&mut session), "n");
    session.change(program(&named("count"))).unwrap();
    assert_eq!(run(&mut session), "count");
    session.change(program(&named("total"))).unwrap();
    assert_eq!(run(&mut session), "total");
    // An undo that nothing ran before.
    session.change(program(&named("last"))).unwrap();
    session.change(program(&named("total"))).unwrap();
    assert_eq!(run(&mut session), "total");
    assert_eq!(session.find("LAST").unwrap().name, "total");
    assert_eq!(session.find("n").unwrap().name, "total");
    session.step_back(4);
    assert_eq!(session.find("total").unwrap().name, "n");
    assert!(session.find("other").is_err());
}

#[test]
fn words() {
    use ladder_analysis::values::types::Scalar;
    let says = |from: i64, to: i64, ty| {
        let (from, to) = (Value::Int(from), Value::Int(to));
        let difference = difference(&from, &to, ty);
        format!(
            "{} {} {}",
            reading(&from, ty),
            reading(&to, ty),
            difference.unwrap_or_else(|| "-".into())
        )
    };
    let told = [
        says(0, 1_500_000_000, Scalar::Time),
        says(1_500_000_000, 20_000_000, Scalar::Time),
        says(7, 7, Scalar::Dint),
        says(i64::MIN, i64::MAX, Scalar::Lint),
        says(-1, 0, Scalar::Ulint),
        says(10, 255, Scalar::Byte),
    ];
    expect![[r#"
        0ms 1.5s +1.5s
        1.5s 20ms -1.48s
        7 7 0
        -9223372036854775808 9223372036854775807 +18446744073709551615
        18446744073709551615 0 -18446744073709551615
        16#0A 16#FF -"#]]
    .assert_eq(&told.join("\n"));
}

#[test]
fn values_are_written_as_one_reads_them() {
    use ladder_analysis::values::types::Scalar;
    for (milliseconds, text) in [
        (0.0, "0ms"),
        (20.0, "20ms"),
        (0.1, "0.1ms"),
        (1000.0, "1s"),
        (90_500.0, "1m30.5s"),
        (90_000_000.0, "1d1h"),
        (-250.0, "-250ms"),
    ] {
        assert_eq!(duration((milliseconds * 1e6) as i64), text);
    }
    assert_eq!(duration(i64::MIN), "-106751d23h47m16.854775808s");
    for (value, ty, text) in [
        (Value::Bool(true), Scalar::Bool, "1"),
        (Value::Int(-7), Scalar::Dint, "-7"),
        (Value::Int(255), Scalar::Word, "16#00FF"),
        (Value::Real(0.1 + 0.2), Scalar::Lreal, "0.3"),
        (Value::Real(f64::from(0.1_f32)), Scalar::Real, "0.1"),
        (Value::Real(12.0), Scalar::Lreal, "12.0"),
        (Value::Real(1.0 / 3.0), Scalar::Lreal, "0.3333333"),
        (Value::Real(1e300), Scalar::Lreal, "1e300"),
        (Value::Real(f64::NAN), Scalar::Lreal, "NaN"),
        (
            Value::Text(b"a'b".as_slice().into()),
            Scalar::String(80),
            "'a$'b'",
        ),
    ] {
        assert_eq!(reading(&value, ty), text);
    }
}

#[test]
fn scales() {
    use ladder_analysis::values::types::Scalar;
    let ticks = |least, greatest, most, ty| {
        let ticks = scale::ticks(least, greatest, most, ty).into_iter();
        ticks.map(|tick| tick.text).collect::<Vec<_>>().join(", ")
    };
    let told = [
        ticks(0.0, 5000.0, 3, Scalar::Time),
        ticks(0.0, 100.0, 4, Scalar::Int),
        ticks(0.0, 3.0, 10, Scalar::Int),
        ticks(-2.5, 2.5, 4, Scalar::Real),
        ticks(0.001, 0.0042, 4, Scalar::Lreal),
        ticks(0.0, 3e9, 4, Scalar::Lreal),
        ticks(7.0, 7.0, 4, Scalar::Int),
        ticks(f64::MIN, f64::MAX, 4, Scalar::Lreal),
    ];
    expect![[r#"
        0, 2 s, 4 s
        0, 50, 100
        0, 1, 2, 3
        -2, 0, 2
        0.001, 0.002, 0.003, 0.004
        0, 1e9, 2e9, 3e9
        7
        -1.80e308, 1.80e308"#]]
    .assert_eq(&told.join("\n"));
}
