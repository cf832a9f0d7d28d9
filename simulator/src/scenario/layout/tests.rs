//! Layouts as texts, and what holds for all of them.

use super::super::parse::parse;
use super::super::suite::{Cell, Suite};
use super::layout;
use expect_test::{Expect, expect};
use proptest::prelude::*;

fn check(text: &str, expected: Expect) {
    let out = layout(text);
    keeps(text, &out);
    expected.assert_eq(&out);
}

/// What a suite says, without its places.
fn told(suite: &Suite) -> String {
    let mut out = format!(
        "{:?} {:?} {:?} {:?}\n",
        suite.program.as_ref().map(|it| &it.0),
        suite.step.map(|it| it.0),
        suite.interval.map(|it| it.0),
        suite.tolerance
    );
    for scenario in &suite.scenarios {
        out.push_str(&format!("{:?} {}\n", scenario.name, scenario.steps));
        for row in &scenario.rows {
            let cells: Vec<&Cell> = row.cells.iter().map(|it| &it.0).collect();
            let tolerance = row.tolerance.as_ref().map(|it| &it.0);
            out.push_str(&format!(
                "{} {:?} {} {cells:?} {tolerance:?}\n",
                row.name, row.direction, row.first
            ));
        }
        for time in &scenario.times {
            let cells: Vec<Option<i64>> = time.cells.iter().map(|it| it.0).collect();
            out.push_str(&format!("time {} {cells:?}\n", time.first));
        }
    }
    let mut errors: Vec<&str> = suite.errors.iter().map(|it| it.message.as_str()).collect();
    // Where nothing is before a line, the missing program and its error have one place.
    errors.sort_unstable();
    out.push_str(&errors.join("\n"));
    out
}

/// The laid out text says the same, with all comments, and is in its layout.
fn keeps(text: &str, out: &str) {
    assert_eq!(told(&parse(text)), told(&parse(out)), "{text:?}\n{out:?}");
    let letters = |text: &str| text.chars().filter(|c| !c.is_whitespace()).collect::<String>();
    assert_eq!(letters(text), letters(out));
    assert_eq!(layout(out), out, "once more, of {text:?}");
}

#[test]
fn levels_touch_and_values_stand_in_columns() {
    check(
        "program   motor.clad # it\n step 100ms\nscenario   \"one\"\nstart _-__\nstop    __-_\nrun=>_--_\n\n\n\nscenario \"two\"\nstart _-__  # pressed\nwarmup.ET => 0 100 20 . ±  1% # warm\nstop ____\n",
        expect![[r#"
            program motor.clad  # it
            step 100ms

            scenario "one"
            start    _-__
            stop     __-_
            run   => _--_

            scenario "two"
            start        _ -   _  _       # pressed
            warmup.ET => 0 100 20 . ± 1%  # warm
            stop         _ _   _  _
        "#]],
    );
}

#[test]
fn durations_are_above_their_steps() {
    check(
        "program a.clad\nscenario \"waits\"\ntime .. 3s ... # s\nstart _--___\nrunning=>_-----\n# on\ntime 1m30s . # wide\n  start _-\n running => __\n",
        expect![[r#"
            program a.clad

            scenario "waits"
            time       .. 3s ...  # s
            start      _- -  ___
            running => _- -  ---
            # on
            time       1m30s .  # wide
            start      _     -
            running => _     _
        "#]],
    );
    check(
        "program a.clad\nscenario \"waits\"\nstart _--\nrun=>_--\ntime 3s\nrun=> _\ntime =>   1 2\n",
        expect![[r#"
            program a.clad

            scenario "waits"
            start    _--
            run   => _--

            time     3s
            run   => _
            time  => 1  2
        "#]],
    );
}

#[test]
fn blanks_stay_where_most_rows_have_them() {
    check(
        "program a.clad\nscenario \"groups\"\na ____ ---- ____\nb ____ ---- ____\nc => ________----\nd => ____----____ # wide\n# between\nrunning => ____ ____ ____\n",
        expect![[r#"
            program a.clad

            scenario "groups"
            a          ____ ---- ____
            b          ____ ---- ____
            c       => ____ ____ ----
            d       => ____ ---- ____  # wide
            #          between
            running => ____ ____ ____
        "#]],
    );
}

#[test]
fn a_ruler_goes_with_its_steps() {
    check(
        "program a.clad\nscenario \"time\"\n#     0  1  2 s\nstart _-___-___-\n# no ruler\nlong_name => __________\n#     the end, far to the right\n",
        expect![[r#"
            program a.clad

            scenario "time"
            #            0  1  2 s
            start        _-___-___-
            # no ruler
            long_name => __________
            #     the end, far to the right
        "#]],
    );
}

#[test]
fn a_scenario_keeps_its_comment_and_has_room_above() {
    check(
        "# all\nprogram a.clad\n# first\n# of two\nscenario \"a\"\nb => _\n\n\n# alone\n\nscenario \"c\"\nb => _\nscenario \"d\"\n  # indented\nb => _\n\n\n",
        expect![[r##"
            # all
            program a.clad

            # first
            # of two
            scenario "a"
            b => _

            # alone

            scenario "c"
            b => _

            scenario "d"
            # indented
            b => _
        "##]],
    );
}

#[test]
fn what_cannot_be_read_stays() {
    check(
        "program a.clad\n  what is this\nscenario no quotes\n   =>  _-_\nscenario \"a\" more\nt   => 'open\nt  a => b\nlonger => 1   2\n",
        expect![[r#"
            program a.clad
              what is this

            scenario no quotes
               =>  _-_

            scenario "a" more
            t   => 'open
            t  a => b
            longer => 1 2
        "#]],
    );
}

#[test]
fn line_ends_and_marks_stay() {
    let text = "\u{feff}program a.clad\r\nscenario \"Ü\"\r\n温度 => 1 2\r\nb _ -";
    assert_eq!(
        layout(text),
        "\u{feff}program a.clad\r\n\r\nscenario \"Ü\"\r\n温度 => 1 2\r\nb       _ -\r\n"
    );
}

#[test]
fn nothing_stays_nothing() {
    for text in ["", "\n", " \n\n", "\u{feff}"] {
        assert_eq!(layout(text), text);
    }
}

/// Lines of pieces that scenario files are made of, in any order.
fn texts() -> impl Strategy<Value = String> {
    let pieces = proptest::sample::select(vec![
        "program",
        "motor.clad",
        "step",
        "100ms",
        "interval",
        "tolerance",
        "0.01",
        "scenario",
        "\"a\"",
        "\"b c\"",
        "\"",
        "'",
        "'x # y'",
        "start",
        "a[ 3 ]",
        "a[",
        "]",
        "=>",
        "_-_",
        "-",
        ".",
        "..-",
        "12",
        "T#5s",
        "time",
        "time .. 3s",
        "16#FF",
        "±",
        "± 1%",
        "+-0.1",
        "# note",
        "#    0 1  2",
        "#",
        " ",
        "  ",
        "\t",
        "\u{a0}",
        "温度",
        "e\u{301}",
        "x",
    ]);
    let ends = proptest::sample::select(vec![
        "\n",
        "\n\n",
        "\r\n",
        "\r",
        "\n  ",
        "\nscenario \"n\"\na => _-\n",
        "\ntime . 3s .\n",
    ]);
    let glue = proptest::sample::select(vec!["", " ", "  "]);
    let joined = |parts: Vec<(&str, &str)>| parts.iter().flat_map(|(a, b)| [*a, *b]).collect::<String>();
    let line = proptest::collection::vec((pieces, glue), 0..8).prop_map(joined);
    proptest::collection::vec((line, ends), 0..12).prop_map(|lines| {
        lines
            .iter()
            .flat_map(|(line, end)| [line.as_str(), end])
            .collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn every_layout_says_the_same_and_rests(text in texts()) {
        keeps(&text, &layout(&text));
    }

    #[test]
    fn any_text_at_all(text in "\\PC*") {
        keeps(&text, &layout(&text));
    }
}

#[test]
fn a_conflict_stays_as_it_is() {
    let text = "program  motor.clad\n<<<<<<< HEAD\nscenario \"a\"\n=======\nscenario   \"b\"\n>>>>>>> theirs\nrun =>  1\n";
    assert_eq!(layout(text), text);
}
