//! Sessions: steps within a scan, and breakpoints.

use crate::support::simulation;
use expect_test::{Expect, expect};
use ladder_analysis::Cancel;
use ladder_analysis::program::Location;
use ladder_analysis::values::value::Value;
use ladder_simulator::value_text::cell;
use ladder_simulator::{Breakpoint, HistoryLimits, Hit, Routine, Session, StepBy, Stepped, Stop};
use ladder_syntax::{TextRange, TextSize};

const TWO: &str = "VAR_INPUT x : BOOL; END_VAR\nVAR n : INT; END_VAR\n\
                   +--[ ]( x )--( )( y )--[ADD]( n, n, 1 )--+\n\
                   +--[ ]( y )--[ADD]( n, n, 10 )--( )( z )--+\n";

fn session(text: &str) -> Session {
    Session::of(simulation(text), HistoryLimits::default())
}

fn get(session: &Session, names: &str) -> String {
    let one = |name: &str| {
        let point = session.simulation().resolve(name).unwrap();
        format!("{name}={}", cell(&session.simulation().value(&point), point.ty))
    };
    names.split_whitespace().map(one).collect::<Vec<_>>().join(" ")
}

fn set(session: &mut Session, name: &str, high: bool) {
    let point = session.simulation().resolve(name).unwrap();
    session.set(&point, Value::Bool(high)).unwrap();
}

fn text_at(text: &str, range: TextRange) -> &str {
    text[usize::from(range.start())..usize::from(range.end())].trim_end()
}

/// Steps through a scan and shows what is next and some tags at each stop.
#[track_caller]
fn stops(text: &str, session: &mut Session, step: fn(&mut Session) -> Stepped, tags: &str, expected: Expect) {
    let mut shown = String::new();
    loop {
        let next = match step(session) {
            Stepped::At(location) => text_at(text, location.range).to_owned(),
            other => format!("{other:?}"),
        };
        shown.push_str(&format!("{}  {next}\n", get(session, tags)));
        if !session.is_open() {
            break;
        }
    }
    expected.assert_eq(&shown);
}

#[test]
fn by_block() {
    let mut session = session(TWO);
    set(&mut session, "x", true);
    stops(
        TWO,
        &mut session,
        Session::step_block,
        "y n z",
        expect![[r#"
        y=0 n=0 z=0  [ ]( x )
        y=0 n=0 z=0  ( )( y )
        y=1 n=0 z=0  [ADD]( n, n, 1 )
        y=1 n=1 z=0  [ ]( y )
        y=1 n=1 z=0  [ADD]( n, n, 10 )
        y=1 n=11 z=0  ( )( z )
        y=1 n=11 z=1  Done
    "#]],
    );
}

#[test]
fn by_network() {
    let mut session = session(TWO);
    set(&mut session, "x", true);
    stops(
        TWO,
        &mut session,
        Session::step_network,
        "y n z",
        expect![[r#"
        y=0 n=0 z=0  +--[ ]( x )--( )( y )--[ADD]( n, n, 1 )--+
        y=1 n=1 z=0  +--[ ]( y )--[ADD]( n, n, 10 )--( )( z )--+
        y=1 n=11 z=1  Done
    "#]],
    );
}

#[test]
fn going_back_from_the_midst_of_a_scan_goes_to_its_start() {
    let mut session = session(TWO);
    session.scan();
    set(&mut session, "x", true);
    session.step_network();
    session.step_network();
    assert_eq!(
        (get(&session, "x y n"), session.is_open()),
        ("x=1 y=1 n=1".into(), true)
    );
    assert_eq!(session.step_back(1), 1);
    // With what was given for it.
    assert_eq!(
        (get(&session, "x y n"), session.is_open()),
        ("x=1 y=0 n=0".into(), false)
    );
    assert_eq!((session.simulation().scans(), session.scans_behind()), (1, 1));
    assert!(session.scan());
    assert_eq!(get(&session, "x y n"), "x=1 y=1 n=11");
    session.step_block();
    assert_eq!(session.step_back(2), 2);
    assert_eq!(get(&session, "x y n"), "x=0 y=0 n=0");
}

#[test]
fn what_was_given_is_given_again_in_parts_too() {
    let mut session = session(TWO);
    session.scan();
    set(&mut session, "x", true);
    session.scan();
    set(&mut session, "x", false);
    session.scan();
    session.step_back(2);
    session.step_network();
    session.step_network();
    assert_eq!(
        (get(&session, "x y n z"), session.scans_ahead()),
        ("x=1 y=1 n=1 z=0".into(), 2)
    );
    session.scan();
    assert_eq!(
        (get(&session, "x y n z"), session.scans_ahead()),
        ("x=1 y=1 n=11 z=1".into(), 1)
    );
    session.step_block();
    session.scan();
    assert_eq!(
        (get(&session, "x y n z"), session.scans_ahead()),
        ("x=0 y=0 n=11 z=0".into(), 0)
    );
}

#[test]
fn what_is_set_in_the_midst_of_a_scan_waits_for_its_end() {
    let mut session = session(TWO);
    session.step_block();
    set(&mut session, "x", true);
    assert_eq!(get(&session, "x"), "x=0");
    session.scan();
    assert_eq!(get(&session, "x y"), "x=1 y=0");
    assert_eq!(session.step_back(1), 1);
    session.scan();
    assert_eq!(get(&session, "x y"), "x=1 y=0");
    session.scan();
    assert_eq!(get(&session, "x y"), "x=1 y=1");
}

fn network(session: &Session, text: &str, mark: &str) -> Breakpoint {
    let offset = TextSize::try_from(text.find(mark).unwrap()).unwrap();
    Breakpoint::Network(session.network_at(0, offset).unwrap())
}

fn described(text: &str, session: &Session, (scans, stop): &(u64, Stop)) -> String {
    let why = match stop {
        Stop::Breakpoint(Hit::Network(at)) => format!("in front of {}", text_at(text, at.range)),
        Stop::Breakpoint(Hit::Block(at)) => format!("in front of {}", text_at(text, at.range)),
        Stop::Breakpoint(Hit::Change {
            point,
            before,
            after,
            block,
        }) => format!(
            "{} {} -> {} by {}",
            point.name,
            cell(before, point.ty),
            cell(after, point.ty),
            block.map_or("nothing", |block| text_at(text, block.range)),
        ),
        other => format!("{other:?}"),
    };
    format!(
        "{scans} scans, then {why}; {} done\n",
        session.simulation().scans()
    )
}

#[test]
fn a_run_stops_in_front_of_a_network() {
    let never = Cancel::default();
    let mut session = session(TWO);
    set(&mut session, "x", true);
    let second = network(&session, TWO, "+--[ ]( y )");
    session.add_breakpoint(second.clone());
    session.add_breakpoint(second.clone());
    assert_eq!(session.breakpoints().len(), 1);
    let mut shown = String::new();
    for _ in 0..3 {
        let run = session.run(10, &never);
        shown.push_str(&described(TWO, &session, &run));
    }
    assert_eq!(get(&session, "n"), "n=23");
    assert!(session.remove_breakpoint(&second));
    let run = session.run(2, &never);
    shown.push_str(&described(TWO, &session, &run));
    // The first network of a program, too, and on the way again after a step back.
    let first = network(&session, TWO, "+--[ ]( x )");
    session.add_breakpoint(first);
    session.step_back(2);
    for _ in 0..3 {
        let run = session.run(10, &never);
        shown.push_str(&described(TWO, &session, &run));
    }
    expect![[r#"
        0 scans, then in front of +--[ ]( y )--[ADD]( n, n, 10 )--( )( z )--+; 0 done
        1 scans, then in front of +--[ ]( y )--[ADD]( n, n, 10 )--( )( z )--+; 1 done
        1 scans, then in front of +--[ ]( y )--[ADD]( n, n, 10 )--( )( z )--+; 2 done
        2 scans, then Done; 4 done
        0 scans, then in front of +--[ ]( x )--( )( y )--[ADD]( n, n, 1 )--+; 2 done
        1 scans, then in front of +--[ ]( x )--( )( y )--[ADD]( n, n, 1 )--+; 3 done
        1 scans, then in front of +--[ ]( x )--( )( y )--[ADD]( n, n, 1 )--+; 4 done
    "#]]
    .assert_eq(&shown);
}

#[test]
fn a_run_stops_after_the_block_that_changes_a_tag() {
    let never = Cancel::default();
    let mut session = session(TWO);
    let point = session.simulation().resolve("n").unwrap();
    session.add_breakpoint(Breakpoint::Change(point));
    let second = network(&session, TWO, "+--[ ]( y )");
    let mut shown = String::new();
    let run = session.run(3, &never);
    shown.push_str(&described(TWO, &session, &run));
    set(&mut session, "x", true);
    for _ in 0..3 {
        let run = session.run(10, &never);
        shown.push_str(&described(TWO, &session, &run));
    }
    session.add_breakpoint(second);
    for _ in 0..4 {
        let run = session.run(10, &never);
        shown.push_str(&described(TWO, &session, &run));
    }
    expect![[r#"
        3 scans, then Done; 3 done
        0 scans, then n 0 -> 1 by [ADD]( n, n, 1 ); 3 done
        0 scans, then n 1 -> 11 by [ADD]( n, n, 10 ); 3 done
        1 scans, then n 11 -> 12 by [ADD]( n, n, 1 ); 4 done
        0 scans, then in front of +--[ ]( y )--[ADD]( n, n, 10 )--( )( z )--+; 4 done
        0 scans, then n 12 -> 22 by [ADD]( n, n, 10 ); 4 done
        1 scans, then n 22 -> 23 by [ADD]( n, n, 1 ); 5 done
        0 scans, then in front of +--[ ]( y )--[ADD]( n, n, 10 )--( )( z )--+; 5 done
    "#]]
    .assert_eq(&shown);
}

#[test]
fn a_network_in_a_function_and_in_a_body_stops_each_time() {
    let text = "FUNCTION_BLOCK [$Twice]\nVAR n : INT; END_VAR\n+--[ADD]( n, n, 1 )--+\nEND_FUNCTION_BLOCK\n\
                +--[$Twice]( )--[$Twice]( )--<CALL>( f )--<CALL>( f )--+\n\
                +--<FUN>( f )--[ADD]( k, k, 1 )--+\n";
    let never = Cancel::default();
    let mut session = session(text);
    for mark in ["+--[ADD]( n", "+--<FUN>"] {
        let breakpoint = network(&session, text, mark);
        session.add_breakpoint(breakpoint);
    }
    let mut shown = String::new();
    for _ in 0..6 {
        let run = session.run(10, &never);
        shown.push_str(&described(text, &session, &run));
    }
    expect![[r#"
        0 scans, then in front of +--[ADD]( n, n, 1 )--+; 0 done
        0 scans, then in front of +--[ADD]( n, n, 1 )--+; 0 done
        0 scans, then in front of +--<FUN>( f )--[ADD]( k, k, 1 )--+; 0 done
        0 scans, then in front of +--<FUN>( f )--[ADD]( k, k, 1 )--+; 0 done
        1 scans, then in front of +--[ADD]( n, n, 1 )--+; 1 done
        0 scans, then in front of +--[ADD]( n, n, 1 )--+; 1 done
    "#]]
    .assert_eq(&shown);
}

#[test]
fn breakpoints_change_nothing_else() {
    let never = Cancel::default();
    let mut plain = session(TWO);
    let mut stopped = session(TWO);
    for mark in ["+--[ ]( x )", "+--[ ]( y )"] {
        let breakpoint = network(&stopped, TWO, mark);
        stopped.add_breakpoint(breakpoint);
    }
    for scan in 0..9 {
        for session in [&mut plain, &mut stopped] {
            set(session, "x", scan % 3 > 0);
        }
        plain.scan();
        while stopped.run(1, &never).0 == 0 {}
        assert_eq!(get(&plain, "x y n z SYS.SCAN"), get(&stopped, "x y n z SYS.SCAN"));
    }
    assert_eq!(stopped.step_back(9), 9);
    assert_eq!(get(&stopped, "x y n z"), "x=0 y=0 n=0 z=0");
}

/// The place of the first text of this kind.
fn block(text: &str, mark: &str) -> Location {
    let start = TextSize::try_from(text.find(mark).unwrap()).unwrap();
    let range = TextRange::at(start, TextSize::of(mark));
    Location { file: 0, range }
}

#[test]
fn a_run_stops_in_front_of_a_block() {
    let never = Cancel::default();
    let mut session = session(TWO);
    set(&mut session, "x", true);
    for mark in ["[ ]( x )", "[ADD]( n, n, 10 )"] {
        session.add_breakpoint(Breakpoint::Block(block(TWO, mark)));
    }
    let mut shown = String::new();
    for _ in 0..4 {
        let run = session.run(10, &never);
        shown.push_str(&described(TWO, &session, &run));
    }
    expect![[r#"
        0 scans, then in front of [ ]( x ); 0 done
        0 scans, then in front of [ADD]( n, n, 10 ); 0 done
        1 scans, then in front of [ ]( x ); 1 done
        0 scans, then in front of [ADD]( n, n, 10 ); 1 done
    "#]]
    .assert_eq(&shown);
}

const NESTED: &str = "FUNCTION_BLOCK [$INNER]\n\
    VAR_INPUT a : BOOL; END_VAR\nVAR n : INT; t : TON; END_VAR\n\
    +--[ ]( a )--[ADD]( n, n, 1 )--[TON]( t, T#1s )--+\n\
    END_FUNCTION_BLOCK\n\
    FUNCTION_BLOCK [$OUTER]\n\
    VAR_IN_OUT total : INT; END_VAR\n\
    +--[$INNER]( TRUE )--[ADD]( total, total, 1 )--+\n\
    END_FUNCTION_BLOCK\n\
    VAR sum : INT; END_VAR\n\
    +--[$OUTER]( sum )--[$INNER]( FALSE )--[$OUTER]( sum )--+\n\
    +--<CALL>( count )--+\n\
    +--<FUN>( count )--+\n\
    +--[$INNER]( TRUE )--+\n\
    +--<RET>--+\n";

/// What is open at each stop, the innermost first, and what the innermost instance holds.
#[test]
fn what_is_open_in_a_scan() {
    let mut session = session(NESTED);
    let mut shown = String::new();
    while session.run_step(StepBy::Block).is_some() {
        let simulation = session.simulation();
        let activations = simulation.activations();
        let names = activations.iter().map(|open| {
            let routine = match (open.routine, open.instance) {
                (Routine::Main, _) => "main".to_owned(),
                (Routine::Function(function), _) => simulation.program().functions[function].name.clone(),
                (Routine::Block(_), instance) => simulation.instances()[instance.unwrap()].name.clone(),
            };
            format!("{routine} {}", text_at(NESTED, open.location.range))
        });
        let names: Vec<String> = names.collect();
        shown.push_str(&format!("{} {}\n", simulation.blocks_done(), names.join(" < ")));
    }
    expect![[r#"
        1 $OUTER#1 [$INNER]( TRUE ) < main [$OUTER]( sum )
        2 $OUTER#1.$INNER#1 [ ]( a ) < $OUTER#1 [$INNER]( TRUE ) < main [$OUTER]( sum )
        3 $OUTER#1.$INNER#1 [ADD]( n, n, 1 ) < $OUTER#1 [$INNER]( TRUE ) < main [$OUTER]( sum )
        4 $OUTER#1.$INNER#1 [TON]( t, T#1s ) < $OUTER#1 [$INNER]( TRUE ) < main [$OUTER]( sum )
        5 $OUTER#1 [ADD]( total, total, 1 ) < main [$OUTER]( sum )
        6 main [$INNER]( FALSE )
        7 $INNER#1 [ ]( a ) < main [$INNER]( FALSE )
        8 $INNER#1 [ADD]( n, n, 1 ) < main [$INNER]( FALSE )
        9 $INNER#1 [TON]( t, T#1s ) < main [$INNER]( FALSE )
        10 main [$OUTER]( sum )
        11 $OUTER#2 [$INNER]( TRUE ) < main [$OUTER]( sum )
        12 $OUTER#2.$INNER#1 [ ]( a ) < $OUTER#2 [$INNER]( TRUE ) < main [$OUTER]( sum )
        13 $OUTER#2.$INNER#1 [ADD]( n, n, 1 ) < $OUTER#2 [$INNER]( TRUE ) < main [$OUTER]( sum )
        14 $OUTER#2.$INNER#1 [TON]( t, T#1s ) < $OUTER#2 [$INNER]( TRUE ) < main [$OUTER]( sum )
        15 $OUTER#2 [ADD]( total, total, 1 ) < main [$OUTER]( sum )
        16 main <CALL>( count )
        18 count [$INNER]( TRUE ) < main <CALL>( count )
        19 $INNER#2 [ ]( a ) < count [$INNER]( TRUE ) < main <CALL>( count )
        20 $INNER#2 [ADD]( n, n, 1 ) < count [$INNER]( TRUE ) < main <CALL>( count )
        21 $INNER#2 [TON]( t, T#1s ) < count [$INNER]( TRUE ) < main <CALL>( count )
        22 count <RET> < main <CALL>( count )
    "#]]
    .assert_eq(&shown);
    assert!(session.simulation().activations().is_empty());
}

#[test]
fn tags_of_user_defined_blocks() {
    let mut session = session(NESTED);
    session.scan();
    let names = [
        "$INNER#1.n",
        "$inner#2.N",
        "$OUTER#2.$INNER#1.n",
        "$OUTER#1.total",
        "sum",
    ];
    let got: Vec<String> = names.iter().map(|name| get(&session, name)).collect();
    expect![[r#"
        $INNER#1.n=0
        $inner#2.N=1
        $OUTER#2.$INNER#1.n=1
        $OUTER#1.total=2
        sum=2"#]]
    .assert_eq(&got.join("\n"));
    let mut instances = String::new();
    for instance in session.simulation().instances() {
        let program = session.simulation().program();
        let tags = instance
            .tags()
            .map(|tag| program.tags[tag.0 as usize].name.as_str());
        instances.push_str(&format!(
            "{}: {}\n",
            instance.name,
            tags.collect::<Vec<_>>().join(" ")
        ));
    }
    expect![[r#"
        $OUTER#1: EN ENO total
        $OUTER#1.$INNER#1: EN ENO a n t
        $INNER#1: EN ENO a n t
        $OUTER#2: EN ENO total
        $OUTER#2.$INNER#1: EN ENO a n t
        $INNER#2: EN ENO a n t
    "#]]
    .assert_eq(&instances);
    for wrong in ["$INNER#9.n", "$INNER#1.x", "$", "$INNER#1", "$OUTER#1.$INNER#1"] {
        assert!(session.simulation().resolve(wrong).is_err(), "{wrong}");
    }
    let point = session.simulation().resolve("$INNER#1.n").unwrap();
    session.set(&point, Value::Int(7)).unwrap();
    session.scan();
    assert_eq!(
        get(&session, "$INNER#1.n $INNER#2.n"),
        "$INNER#1.n=7 $INNER#2.n=2"
    );
    assert_eq!(session.step_back(1), 1);
    assert_eq!(get(&session, "$INNER#2.n"), "$INNER#2.n=1");
}
