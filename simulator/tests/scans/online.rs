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

/// The values of a snapshot, as `start=1 level=70`.
fn values(wanted: &[Wanted], snapshot: &str) -> Vec<Option<Value>> {
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
    wanted.iter().map(given).collect()
}

/// All that there is to know of a program.
fn wanted(online: &Online) -> Vec<Wanted> {
    let points = online.points().into_iter();
    let wanted = points.map(|point| Wanted {
        name: point.name.clone(),
        point,
    });
    wanted.collect()
}

/// The drawing after snapshots, and what is in doubt after each.
fn check(snapshots: &[&str], expected: Expect) {
    let mut online = Online::new(program(PRESS)).unwrap();
    let wanted = wanted(&online);
    let mut shown = String::new();
    for snapshot in snapshots {
        let values = values(&wanted, snapshot);
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
    let unknown = online.unknown();
    let networks = &online.simulation().program().networks;
    for network in unknown {
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

/// The drawing after a snapshot, with `?` where power is not known.
fn check_unknown(program_text: &str, snapshot: &str, expected: Expect) {
    let mut online = Online::new(program(program_text)).unwrap();
    let wanted = wanted(&online);
    online.see(&wanted, &values(&wanted, snapshot)).unwrap();
    let mut drawn = diagram(program_text, online.simulation()).into_bytes();
    for (number, (_, location, _)) in online.simulation().power().enumerate() {
        if online.is_unknown(number) {
            drawn[usize::from(location.range.start())..usize::from(location.range.end())].fill(b'?');
        }
    }
    let drawn = String::from_utf8(drawn).unwrap();
    expected.assert_eq(drawn.split_once("\n\n").unwrap().1);
}

const EDGES: &str = "\
VAR  a, b : BOOL;  END_VAR

+--[ ]( a )--[GT]( n, 5 )--( )( x )---+
+--\\--[ ]( a )--\\--( )( y )-----------+
|  /--[ ]( m )--/                     |
+--[ ]( m )--[ ]( b )--( )( z )-------+
+--[P]( a )--( )( p )--[P]( b )--( )( q )--+
+--[N]( a )--( )( r )--[N]( b )--( )( s )--+
+--[ ]( a )--[OSR]()--( )( t )--------+
+--[ ]( b )--[OSF]()--( )( u )--------+
+--[NOT]()--[ ]( m )--( )( v )--------+
";

#[test]
fn what_decides_power_and_is_not_known_marks_it_from_there_on() {
    check_unknown(
        EDGES,
        "a=1 b=0",
        expect![[r#"
        +==[ ]( a )==??????????????????????????
        +==\==[ ]( a )==\==( )( y )===========+
        |  /==??????????/                     |
        +==??????????[ ]( b )--( )( z )-------+
        +==?????????????????????????????????????????
        +==[N]( a )--( )( r )--[N]( b )--( )( s )--+
        +==[ ]( a )==??????????????????????????
        +==[ ]( b )--??????????????????????????
        +==[NOT]()--[ ]( m )--( )( v )--------+
    "#]],
    );
    check_unknown(
        EDGES,
        "a=0 b=1",
        expect![[r#"
        +==[ ]( a )--[GT]( n, 5 )--( )( x )---+
        +==\==[ ]( a )--???????????????????????
        |  /==???????????                     |
        +==????????????????????????????????????
        +==[P]( a )--( )( p )--[P]( b )--( )( q )--+
        +==?????????????????????????????????????????
        +==[ ]( a )--[OSR]()--( )( t )--------+
        +==[ ]( b )==[OSF]()--( )( u )--------+
        +==[NOT]()--[ ]( m )--( )( v )--------+
    "#]],
    );
    check_unknown(
        EDGES,
        "a=1 b=0 m=1 n=7",
        expect![[r#"
        +==[ ]( a )==[GT]( n, 5 )==( )( x )===+
        +==\==[ ]( a )==\==( )( y )===========+
        |  /==[ ]( m )==/                     |
        +==[ ]( m )==[ ]( b )--( )( z )-------+
        +==?????????????????????????????????????????
        +==[N]( a )--( )( r )--[N]( b )--( )( s )--+
        +==[ ]( a )==??????????????????????????
        +==[ ]( b )--??????????????????????????
        +==[NOT]()--[ ]( m )--( )( v )--------+
    "#]],
    );
}

/// Ten thousand rungs, of which a hundred are not as the program has them.
#[test]
#[ignore = "measures: cargo test --release -- --ignored --nocapture a_hundred_contradictions"]
fn a_hundred_contradictions_in_ten_thousand_rungs() {
    let rung = |number: usize| format!("+--[ ]( i{number} )--[/]( j{number} )--( )( o{number} )--+\n");
    let text: String = (0..10_000).map(rung).collect();
    let mut online = Online::new(program(&text)).unwrap();
    let wanted = wanted(&online);
    for against in [0, 100] {
        let is_against = |name: &str| {
            name.strip_prefix('o').is_some_and(|number| {
                number
                    .parse::<usize>()
                    .is_ok_and(|it| it % 100 == 0 && against > 0)
            })
        };
        let values: Vec<Option<Value>> = wanted
            .iter()
            .map(|it| Some(Value::Bool(is_against(&it.name))))
            .collect();
        let begun = std::time::Instant::now();
        online.see(&wanted, &values).unwrap();
        println!(
            "{against} against the program: {:?} ({})",
            begun.elapsed(),
            online.doubts().len()
        );
        assert_eq!(online.doubts().len(), against);
    }
}
