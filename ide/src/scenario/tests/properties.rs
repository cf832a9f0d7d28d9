//! Properties and assumptions: what is proposed, shown, found and renamed in them.

use super::super::{scenario_definition, scenario_highlights, scenario_hover, scenario_outline};
use super::Asked;
use crate::references::scenario_references;
use crate::rename::rename_in_scenario;
use expect_test::{Expect, expect};
use ladder_format::{Options, apply};

const PROPERTIES: &str = "program main.clad\n\nassume not (start and lib.go)\n\nproperty \"it follows\"\nwithin 500ms of rises(start): run or warm.Q\n\n\
    scenario \"one\"\nstart _-\nrun => _-\n\nwhen list[1] > 2: not run until SYS.SCAN > 5\n";

fn at(place: &str) -> Asked {
    let text = PROPERTIES.replacen(&place.replace("$0", ""), place, 1);
    Asked::at(&text)
}

#[test]
fn forms_and_what_is_in_them_is_proposed() {
    let check = |text: &str, expected: Expect| {
        let completions = Asked::at(&format!("program main.clad\n{text}")).completions(None);
        let first: Vec<&str> = completions.lines().take(8).collect();
        expected.assert_eq(&first.join("\n"));
    };
    check(
        "property \"p\"\n\n$0",
        expect![[r#"
        never|property|never ${1:condition}
        always|property|always ${1:condition}
        when|property|when ${1:condition}: ${2:what holds}
        when until|property|when ${1:condition}: ${2:what holds} until ${3:end}
        after|property|after ${1:condition}: ${2:what holds then}
        within|property|within ${1:500ms} of ${2:condition}: ${3:answer}
        possible|property|possible ${1:condition}
        no faults|property|no faults"#]],
    );
    check(
        "property \"p\" ne$0",
        expect![[r#"
        never|property|never ${1:condition}
        always|property|always ${1:condition}
        when|property|when ${1:condition}: ${2:what holds}
        when until|property|when ${1:condition}: ${2:what holds} until ${3:end}
        after|property|after ${1:condition}: ${2:what holds then}
        within|property|within ${1:500ms} of ${2:condition}: ${3:answer}
        possible|property|possible ${1:condition}
        no faults|property|no faults"#]],
    );
    check("property \"p$0", expect![[""]]);
    check(
        "never $0",
        expect![[r#"
        rises(||rises(${1:condition})
        falls(||falls(${1:condition})
        was(||was(${1:condition})
        not|the opposite|not 
        start|BOOL, input|start
        run|BOOL, output|run
        total|DINT, internal|total
        warm.Q|BOOL, internal|warm.Q"#]],
    );
    check(
        "never r$0 and x",
        expect![[r#"
        rises(||rises(${1:condition})
        falls(||falls(${1:condition})
        was(||was(${1:condition})
        not|the opposite|not 
        run|BOOL, output|run
        start|BOOL, input|start
        total|DINT, internal|total
        warm.Q|BOOL, internal|warm.Q"#]],
    );
    check(
        "never run $0",
        expect![[r#"
        and|both|and 
        or|one of them or both|or 
        xor|one of them, not both|xor "#]],
    );
    check(
        "never not (run and wa$0",
        expect![[r#"
        rises(||rises(${1:condition})
        falls(||falls(${1:condition})
        was(||was(${1:condition})
        not|the opposite|not 
        warm.Q|BOOL, internal|warm.Q
        warm.ET|TIME, internal|warm.ET
        warm.IN|BOOL, internal|warm.IN
        warm.PT|TIME, internal|warm.PT"#]],
    );
    check(
        "within $0",
        expect![[r#"
        500ms|a time|500ms
        1s|a time|1s
        3 scans|a number of scans|3 scans"#]],
    );
    check("within 3 $0", expect!["scans of|so many scans|scans of"]);
    check("within 500ms $0", expect!["of||of "]);
    check(
        "within 500ms of rises($0",
        expect![[r#"
        rises(||rises(${1:condition})
        falls(||falls(${1:condition})
        was(||was(${1:condition})
        not|the opposite|not 
        start|BOOL, input|start
        run|BOOL, output|run
        total|DINT, internal|total
        warm.Q|BOOL, internal|warm.Q"#]],
    );
    check(
        "within 500ms of start:$0",
        expect![[r#"
        rises(||rises(${1:condition})
        falls(||falls(${1:condition})
        was(||was(${1:condition})
        not|the opposite|not 
        start|BOOL, input|start
        run|BOOL, output|run
        total|DINT, internal|total
        warm.Q|BOOL, internal|warm.Q"#]],
    );
    check(
        "when start: run $0",
        expect![[r#"
        and|both|and 
        or|one of them or both|or 
        xor|one of them, not both|xor 
        until||until "#]],
    );
    check(
        "possible run within $0",
        expect![[r#"
        500ms|a time|500ms
        1s|a time|1s
        3 scans|a number of scans|3 scans"#]],
    );
    check("no $0", expect!["faults|no block records a fault|faults"]);
    check(
        "assume not start or lib.t$0",
        expect![[r#"
        rises(||rises(${1:condition})
        falls(||falls(${1:condition})
        was(||was(${1:condition})
        not|the opposite|not 
        lib.total|BOOL, internal of lib.clad|lib.total
        start|BOOL, input|start
        run|BOOL, output|run
        total|DINT, internal|total"#]],
    );
    check(
        "scenario \"s\"\nstart _-\nnever sys$0",
        expect![[r#"
        rises(||rises(${1:condition})
        falls(||falls(${1:condition})
        was(||was(${1:condition})
        not|the opposite|not 
        SYS.FIRST_SCAN|BOOL|SYS.FIRST_SCAN
        SYS.SCAN|DINT|SYS.SCAN
        SYS.TIME|TIME|SYS.TIME
        SYS.SCAN_TIME|TIME|SYS.SCAN_TIME"#]],
    );
}

#[test]
fn members_are_proposed_after_a_point() {
    let found = Asked::at("program main.clad\nnever warm.$0\n").completions(Some('.'));
    expect![[r#"
        warm.Q|BOOL, internal|warm.Q
        warm.ET|TIME, internal|warm.ET
        warm.IN|BOOL, internal|warm.IN
        warm.PT|TIME, internal|warm.PT
        start|BOOL, input|start
        run|BOOL, output|run
        total|DINT, internal|total
        list[1]|INT, internal|list[1]
        list[2]|INT, internal|list[2]
        lib.total|BOOL, internal of lib.clad|lib.total
        lib.go|BOOL, internal of lib.clad|lib.go
    "#]]
    .assert_eq(&found);
}

#[test]
fn a_row_that_is_called_like_a_form_stays_a_row() {
    let found = Asked::at("program main.clad\nscenario \"s\"\nstart _-\nnever => _$0\n").completions(None);
    assert_eq!(found, "");
}

#[test]
fn hover_says_what_a_form_demands_and_shows_the_tag() {
    let check = |place: &str, expected: Expect| {
        let asked = at(place);
        let found = asked.ask(|it| scenario_hover(it, asked.offset));
        let shown = found.map(|(it, _)| format!("[{}]\n{}\n", &asked.text[it.range], it.markdown));
        expected.assert_eq(&shown.unwrap_or_default());
    };
    check(
        "with$0in 500ms",
        expect![[r#"
        [within]
        `within 500ms of a: b` is violated if `b` does not come so soon after `a`: a time, or a number of scans as in `within 3 scans of a: b`.
    "#]],
    );
    check(
        "prop$0erty \"it",
        expect![[r#"
        [property]
        What must hold in every run of the program, whatever goes into it. Its name is in quotes, its form after that or on the next line. `ladder prove` decides it.
    "#]],
    );
    check(
        "\"it fol$0lows\"",
        expect![[r#"
        ["it follows"]
        `within 500ms of a: b` is violated if `b` does not come so soon after `a`: a time, or a number of scans as in `within 3 scans of a: b`.
    "#]],
    );
    check(
        "ri$0ses(start)",
        expect![[r#"
        [rises]
        `rises(e)`: `e` is TRUE now and was not after the scan before; what is TRUE after the first scan has risen.
    "#]],
    );
    check(
        "un$0til SYS",
        expect![[r#"
        [until]
        Up to the scan after which this is TRUE; in that one nothing is demanded any more.
    "#]],
    );
    check(
        "assu$0me",
        expect![[r#"
        [assume]
        What is assumed of the inputs, in every scan: runs in which it does not hold are left out of all proofs of this file.
    "#]],
    );
    check(
        "rises(st$0art)",
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

        What it is after a scan.
    "#]],
    );
    check(
        "SYS.SC$0AN",
        expect![[r#"
        [SYS.SCAN]
        `SYS.SCAN` : DINT

        What it is after a scan.
    "#]],
    );
    check(
        "not run u$0ntil",
        expect![[r#"
        [until]
        Up to the scan after which this is TRUE; in that one nothing is demanded any more.
    "#]],
    );
    check("> $02: not", expect![[""]]);
}

#[test]
fn a_name_in_a_property_is_a_place_of_its_tag() {
    let check = |place: &str, expected: Expect| {
        let asked = at(place);
        let mut shown = String::new();
        asked.ask(|it| {
            for target in scenario_definition(it, asked.offset) {
                shown.push_str(&format!(
                    "definition {}\n",
                    asked.fixture.show(&target.file, target.focus)
                ));
            }
            for found in scenario_references(it, asked.offset) {
                shown.push_str(&format!(
                    "{} {:?}\n",
                    asked.fixture.show(&found.file, found.range),
                    found.usage
                ));
            }
            for found in scenario_highlights(it, asked.offset) {
                shown.push_str(&format!(
                    "highlight {} {:?}\n",
                    asked.fixture.show("main.ladder-test", found.range),
                    found.usage
                ));
            }
        });
        expected.assert_eq(&shown);
    };
    check(
        "start): r$0un",
        expect![[r#"
        definition main.clad:2:12 run
        main.clad:2:12 run Definition
        main.clad:4:42 run Write
        main.clad:5:9 run Read
        other.ladder-test:4:1 run Read
        main.ladder-test:6:31 run Read
        main.ladder-test:10:1 run Read
        main.ladder-test:12:23 run Read
        highlight main.ladder-test:6:31 run Read
        highlight main.ladder-test:10:1 run Read
        highlight main.ladder-test:12:23 run Read
    "#]],
    );
    check(
        "lib.g$0o",
        expect![[r#"
        definition lib.clad:1:12 go
        lib.clad:1:12 go Definition
        lib.clad:2:25 go Read
        main.ladder-test:3:27 go Read
        highlight main.ladder-test:3:27 go Read
    "#]],
    );
    check(
        "li$0st[1] > 2",
        expect![[r#"
        definition main.clad:3:31 list
        main.clad:3:31 list Definition
        main.clad:5:49 list Write
        main.ladder-test:12:6 list Read
        highlight main.ladder-test:12:6 list Read
    "#]],
    );
}

#[test]
fn rename_reaches_properties_and_assumptions() {
    let check = |place: &str, new: &str, expected: Expect| {
        let asked = at(place);
        let renamed = asked.ask(|it| rename_in_scenario(it, asked.offset, new, &Options::default()));
        let files = renamed.expect("it can be renamed");
        let own = files
            .iter()
            .find(|it| *it.file == *"main.ladder-test")
            .expect("it has the name");
        expected.assert_eq(&apply(asked.fixture.text(&own.file), &own.edits));
    };
    check(
        "start): r$0un",
        "motor",
        expect![[r#"
        program main.clad

        assume not (start and lib.go)

        property "it follows"
        within 500ms of rises(start): motor or warm.Q

        scenario "one"
        start   _-
        motor => _-

        when list[1] > 2: not motor until SYS.SCAN > 5
    "#]],
    );
    check(
        "not (st$0art",
        "go_now",
        expect![[r#"
        program main.clad

        assume not (go_now and lib.go)

        property "it follows"
        within 500ms of rises(go_now): run or warm.Q

        scenario "one"
        go_now _-
        run  => _-

        when list[1] > 2: not run until SYS.SCAN > 5
    "#]],
    );
    check(
        "or wa$0rm.Q",
        "heat",
        expect![[r#"
        program main.clad

        assume not (start and lib.go)

        property "it follows"
        within 500ms of rises(start): run or heat.Q

        scenario "one"
        start _-
        run => _-

        when list[1] > 2: not run until SYS.SCAN > 5
    "#]],
    );
}

#[test]
fn properties_are_in_the_outline() {
    let asked = at("$0program");
    let parts = asked.ask(scenario_outline);
    let shown = parts.iter().map(|it| {
        format!(
            "{} ({}) [{}] {}\n",
            it.name,
            it.detail,
            &asked.text[it.focus],
            if it.is_property { "property" } else { "scenario" }
        )
    });
    expect![[r#"
        it follows (within 500ms of rises(start): run or warm.Q) ["it follows"] property
        one (2 steps) ["one"] scenario
        when list[1] > 2: not run until SYS.SCAN > 5 (property) [when list[1] > 2: not run until SYS.SCAN > 5] property
    "#]].assert_eq(&shown.collect::<Vec<_>>().concat());
}
