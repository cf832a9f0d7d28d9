//! Tags that open: arrays and timers in lists.

use crate::support::simulation;
use expect_test::{Expect, expect};
use ladder_simulator::{Entry, Point};

const PUMPS: &str = "\
VAR_INPUT trip : ARRAY[1..2] OF BOOL; END_VAR
VAR_OUTPUT pump : ARRAY[0..2] OF BOOL; END_VAR
VAR t : TON; n : INT; recipe : ARRAY[-1..400] OF INT; words : ARRAY[1..2] OF STRING[5]; END_VAR
+--[ ]( trip[1] )--[TON]( t, T#1s )--( )( pump[1] )--+
";

fn names(points: &[Point]) -> String {
    points
        .iter()
        .map(|point| point.name.as_str())
        .collect::<Vec<_>>()
        .join(" ")
}

#[test]
fn a_list_of_all_tags_has_the_elements_unless_they_are_very_many() {
    let simulation = simulation(PUMPS);
    expect!["trip[1] trip[2] pump[0] pump[1] pump[2] t.Q t.ET n words[1] words[2]"]
        .assert_eq(&names(simulation.points()));
    let entries = simulation.entries().into_iter().map(|entry| match entry {
        Entry::Value(point) => format!("{} : {}\n", point.name, point.ty),
        Entry::Group(group) => format!("{} : {}, {} parts\n", group.name, group.ty, group.parts),
    });
    expect![[r#"
        trip : ARRAY[1..2] OF BOOL, 2 parts
        pump : ARRAY[0..2] OF BOOL, 3 parts
        t.Q : BOOL
        t.ET : TIME
        n : INT
        recipe : ARRAY[-1..400] OF INT, 402 parts
        words : ARRAY[1..2] OF STRING[5], 2 parts
    "#]]
    .assert_eq(&entries.collect::<String>());
}

#[test]
fn a_name_may_stand_for_many() {
    let simulation = simulation(PUMPS);
    let all = |text: &str, expected: Expect| {
        let shown = match simulation.resolve_all(text) {
            Ok(points) => names(&points),
            Err(unknown) => unknown.message,
        };
        expected.assert_eq(&shown);
    };
    all("Pump", expect!["pump[0] pump[1] pump[2]"]);
    all("pump[1]", expect!["pump[1]"]);
    all("pump[ 1 .. 2 ]", expect!["pump[1] pump[2]"]);
    all("recipe[-1..1]", expect!["recipe[-1] recipe[0] recipe[1]"]);
    all("t", expect!["t.Q t.ET"]);
    all("n", expect!["n"]);
    all(
        "pump[2..1]",
        expect!["pump[2..1] has no elements: write the smaller index first"],
    );
    all(
        "pump[1..3]",
        expect!["pump[3] does not exist: the array goes from 0 to 2"],
    );
    all(
        "n[1..3]",
        expect!["n is not an array: it is an INT and has no elements"],
    );
    all("pmp", expect!["there is no tag `pmp`; did you mean pump?"]);
    all(
        "pump[1..x]",
        expect!["`1..x` is not an index: write a number, as in pump[0]"],
    );
    assert_eq!(simulation.resolve_all("recipe").unwrap().len(), 402);
}

#[test]
fn elements_are_found_by_a_part_of_their_name() {
    let simulation = simulation(PUMPS);
    let found = |text: &str, expected: Expect| expected.assert_eq(&names(&simulation.search(text)));
    found("UMP", expect!["pump[0] pump[1] pump[2]"]);
    found("p[2", expect!["trip[2] pump[2]"]);
    found("recipe", expect![[""]]);
    found("cipe[40", expect!["recipe[40] recipe[400]"]);
    assert_eq!(
        simulation.resolve("pump[1].x").unwrap_err().message,
        "pump[1] is a BOOL and has no members"
    );
    assert_eq!(simulation.resolve("pump[1]").unwrap().group(), Some("pump"));
    assert_eq!(simulation.resolve("n.3").unwrap().group(), None);
}
