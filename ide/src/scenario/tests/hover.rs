//! What is shown of a row, a value and a file.

use super::super::{scenario_hover, scenario_outline};
use super::{Asked, HEAD};
use expect_test::{Expect, expect};

#[test]
fn hover_says_what_a_row_and_a_value_mean() {
    let check = |rows: &str, expected: Expect| {
        let asked = Asked::at(&format!("{HEAD}{rows}"));
        let found = asked.ask(|it| scenario_hover(it, asked.offset));
        let shown = found.map(|(it, file)| {
            let file = file.filter(|file| **file != *"main.clad");
            let links = file.map_or(String::new(), |file| format!("(lines of {file})\n"));
            format!("[{}]\n{}\n{links}", &asked.text[it.range], it.markdown)
        });
        expected.assert_eq(&shown.unwrap_or_default());
    };
    check(
        "st$0art _-_\n",
        expect![[r#"
        [start]
        the green \*button

        ```clad
        start : BOOL
        ```
        Input (declared in VAR_INPUT on line [1](#L1))  
        Written: nowhere  
        Read: line [4](#L4)

        ```clad
        +--[ ]( start )--[TON]( warm, 5s )--( )( run )--+
        ```

        ---

        Given before the first scan of each step.
    "#]],
    );
    check(
        "time . $03s\nstart _ -\n",
        expect![[r#"
        [3s]
        step 2 of 2: 100ms to 3s100ms
    "#]],
    );
    check(
        "time . 3s\nstart _ -\ntime 1s\nstart $0_\nrun => .\n",
        expect![[r#"
        [_]
        `start` is given: low (`FALSE`)  
        step 3 of 3: 3s100ms to 4s100ms
    "#]],
    );
    check(
        "ti$0me . 3s\nstart _ -\n",
        expect![[r#"
        [time]
        How long each of the steps below it is, such as `3s`; `.` for one as long as `step` says. A second row `time` goes on with more steps.
    "#]],
    );
    check(
        "warm.E$0T => 1s\n",
        expect![[r#"
        [warm.ET]
        `warm.ET` : TIME, of

        ```clad
        warm : TON
        ```
        Internal tag (declared in VAR on line [3](#L3))  
        Written: line [4](#L4)  
        Read: line [4](#L4)

        ```clad
        +--[ ]( start )--[TON]( warm, 5s )--( )( run )--+
        ```

        ---

        Expected after the last scan of each step.
    "#]],
    );
    check(
        "start _-$0_\n",
        expect![[r#"
        [_]
        `start` is given: low (`FALSE`)  
        step 3 of 3: 200ms to 300ms
    "#]],
    );
    check(
        "start _-.$0\n",
        expect![[r#"
        [.]
        `start` is not given again; last it was high (`TRUE`)  
        step 3 of 3: 200ms to 300ms
    "#]],
    );
    check(
        "run =$0> _-\n",
        expect![[r#"
        [=>]
        What is after `=>` is expected of the program after each step.
    "#]],
    );
    check(
        "run => _.$0-\n",
        expect![[r#"
        [-]
        `run` is expected to be high (`TRUE`)  
        step 3 of 3: 200ms to 300ms
    "#]],
    );
    check(
        "total => 1 16#0$0F\n",
        expect![[r#"
        [16#0F]
        `total` is expected to be `15`  
        step 2 of 2: 100ms to 200ms
    "#]],
    );
    check(
        "lib.li$0st[2] => 0 1\n",
        expect![[r#"
        [lib.list[2]]
        `lib.list[2]` : INT, of

        ```clad
        list : ARRAY[1..2] OF INT
        ```
        Internal tag (declared in VAR on line [1](#L1))  
        Written: nowhere  
        Read: nowhere

        ---

        Expected after the last scan of each step.
        (lines of lib.clad)
    "#]],
    );
    check(
        "lib.go _$0-\n",
        expect![[r#"
        [-]
        `lib.go` is given: high (`TRUE`)  
        step 2 of 2: 100ms to 200ms
    "#]],
    );
    check(
        "total => 1 2 ± 1$0%\n",
        expect![[r#"
        [± 1%]
        How far a value may be from what is expected: `± 0.01`, or a part of it, `± 1%`.
    "#]],
    );
    let asked = Asked::at("program ma$0in.clad\n");
    let found = asked.ask(|it| scenario_hover(it, asked.offset)).unwrap().0;
    expect!["main.clad: 3 networks, 5 tags"].assert_eq(&found.markdown);
    let asked = Asked::at("program main.clad\nst$0ep 1s\n");
    let found = asked.ask(|it| scenario_hover(it, asked.offset)).unwrap().0;
    assert!(found.markdown.starts_with("How long a step is"));
}

#[test]
fn the_outline_holds_scenarios_with_their_rows() {
    let asked = Asked::at(&format!("{HEAD}start _-$0\nrun => _-\nscenario \"two\"\n"));
    let mut shown = String::new();
    for part in asked.ask(scenario_outline) {
        shown.push_str(&format!(
            "{} ({}) {:?}\n",
            part.name, part.detail, &asked.text[part.range]
        ));
        for row in part.children {
            shown.push_str(&format!(
                "    {} ({}) {:?}\n",
                row.name, row.detail, &asked.text[row.range]
            ));
        }
    }
    expect![[r#"
        one (2 steps) "scenario \"one\"\nstart _-\nrun => _-"
            start (given) "start _-"
            run (expected) "run => _-"
        two (0 steps) "scenario \"two\""
    "#]]
    .assert_eq(&shown);
}
