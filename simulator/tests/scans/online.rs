//! Values of a running controller, snapshot by snapshot: their power, and what contradicts the program.

use crate::change::program;
use expect_test::{Expect, expect};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_simulator::online::{Online, Wanted};
use ladder_simulator::{diagram, value_text};

const PRESS: &str = "\
VAR_INPUT  start, stop : BOOL;  level : INT;  END_VAR
VAR  t1 : TON;  END_VAR

+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+
|  /--[ ]( run )----/                           |
+--[ ]( run )--[TON]( t1, T#5s )--( )( warm )---+
+--[GT]( level, 50 )--( )( high )---------------+
+--[ ]( start )--( )( twice )-------------------+
+--[ ]( stop )--(S)( twice )--------------------+
";

/// The drawing after snapshots, and what is in doubt after each.
fn check(snapshots: &[&str], expected: Expect) {
    let mut online = Online::new(program(PRESS)).unwrap();
    let wanted: Vec<Wanted> = online
        .points()
        .into_iter()
        .map(|point| Wanted {
            name: point.name.clone(),
            point,
        })
        .collect();
    let mut shown = String::new();
    for snapshot in snapshots {
        let given = |wanted: &Wanted| -> Option<Value> {
            let mut pairs = snapshot.split(' ').filter_map(|pair| pair.split_once('='));
            let (_, text) = pairs.find(|(name, _)| *name == wanted.name)?;
            let text = match (wanted.point.ty, text) {
                (Scalar::Bool, "1") => "TRUE",
                (Scalar::Bool, _) => "FALSE",
                (_, text) => text,
            };
            Some(value_text::parse(text, wanted.point.ty).unwrap())
        };
        let values: Vec<Option<Value>> = wanted.iter().map(given).collect();
        online.see(&wanted, &values).unwrap();
        for doubt in online.doubts() {
            let what = if doubt.is_reported() {
                "against the program"
            } else {
                "changed while reading"
            };
            shown.push_str(&format!("{snapshot}: {} {what}\n", doubt.point.name));
        }
    }
    let networks = &online.simulation().program().networks;
    for network in online.unknown() {
        let range = networks[network].location.range;
        shown.push_str(&format!("not known: {}\n", PRESS[range].lines().next().unwrap()));
    }
    let drawn = diagram(PRESS, online.simulation());
    shown.push_str(drawn.split_once("\n\n").unwrap().1);
    expected.assert_eq(&shown);
}

#[test]
fn power_is_what_the_values_say() {
    check(
        &["start=0 stop=0 run=1 level=70 high=1 warm=0 twice=0 t1.ET=T#2s t1.Q=0 t1.IN=1 t1.PT=T#5s"],
        expect![[r#"
            +==\==[ ]( start )--\==[/]( stop )==( )( run )==+
            |  /==[ ]( run )====/                           |
            +==[ ]( run )==[TON]( t1, T#5s )--( )( warm )---+
            +==[GT]( level, 50 )==( )( high )===============+
            +==[ ]( start )--( )( twice )-------------------+
            +==[ ]( stop )--(S)( twice )--------------------+
        "#]],
    );
}

#[test]
fn what_was_not_read_is_not_known() {
    check(
        &["start=1 stop=0 run=1 high=0"],
        expect![[r#"
        not known: +--[ ]( run )--[TON]( t1, T#5s )--( )( warm )---+
        not known: +--[GT]( level, 50 )--( )( high )---------------+
        +==\==[ ]( start )==\==[/]( stop )==( )( run )==+
        |  /==[ ]( run )====/                           |
        +==[ ]( run )==[TON]( t1, T#5s )--( )( warm )---+
        +==[GT]( level, 50 )--( )( high )---------------+
        +==[ ]( start )==( )( twice )===================+
        +==[ ]( stop )--(S)( twice )====================+
    "#]],
    );
}

#[test]
fn a_contradiction_is_reported_when_it_stays() {
    check(
        &[
            "start=1 stop=0 run=0 level=70 high=0",
            "start=1 stop=0 run=1 level=70 high=0",
            "start=1 stop=0 run=1 level=70 high=0",
        ],
        expect![[r#"
            start=1 stop=0 run=0 level=70 high=0: run changed while reading
            start=1 stop=0 run=0 level=70 high=0: high changed while reading
            start=1 stop=0 run=1 level=70 high=0: high changed while reading
            start=1 stop=0 run=1 level=70 high=0: high against the program
            not known: +--[ ]( run )--[TON]( t1, T#5s )--( )( warm )---+
            +==\==[ ]( start )==\==[/]( stop )==( )( run )==+
            |  /==[ ]( run )====/                           |
            +==[ ]( run )==[TON]( t1, T#5s )--( )( warm )---+
            +==[GT]( level, 50 )==( )( high )===============+
            +==[ ]( start )==( )( twice )===================+
            +==[ ]( stop )--(S)( twice )====================+
        "#]],
    );
}

#[test]
fn of_several_writers_the_last_counts() {
    check(
        &[
            "start=0 stop=1 run=0 level=0 high=0 twice=1",
            "start=1 stop=0 run=1 level=0 high=0 twice=0",
        ],
        expect![[r#"
            not known: +--[ ]( run )--[TON]( t1, T#5s )--( )( warm )---+
            +==\==[ ]( start )==\==[/]( stop )==( )( run )==+
            |  /==[ ]( run )====/                           |
            +==[ ]( run )==[TON]( t1, T#5s )--( )( warm )---+
            +==[GT]( level, 50 )--( )( high )---------------+
            +==[ ]( start )==( )( twice )===================+
            +==[ ]( stop )--(S)( twice )--------------------+
        "#]],
    );
}
