//! Changes of the program while it runs.

use crate::support::{simulation, stimulus};
use expect_test::{Expect, expect};
use ladder_analysis::program::Program;
use ladder_analysis::values::value::Value;
use ladder_simulator::value_text::{cell, parse};
use ladder_simulator::{Breakpoint, Changeover, HistoryLimits, Session};
use std::sync::Arc;

pub(crate) fn program(text: &str) -> Arc<Program> {
    simulation(text).program().clone()
}

/// None if it has errors.
pub(crate) fn program_of(text: &str) -> Option<Arc<Program>> {
    let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(text)), "test.clad");
    analysis.program().cloned()
}

pub(crate) fn session(text: &str) -> Session {
    Session::of(simulation(text), HistoryLimits::default())
}

pub(crate) fn set(session: &mut Session, tag: &str, value: &str) {
    let point = session.simulation().resolve(tag).unwrap();
    let value = parse(value, point.ty).unwrap();
    session.set(&point, value).unwrap();
}

pub(crate) fn run(session: &mut Session, inputs: &str) {
    let (scans, rows) = stimulus(inputs);
    for scan in 0..scans {
        for (tag, cells) in &rows {
            if let Some(value) = cells.get(scan).filter(|cell| *cell != ".") {
                set(session, tag, value);
            }
        }
        session.scan();
    }
}

/// What tags hold: `run 1, t.ET 30`.
pub(crate) fn held(session: &Session, tags: &str) -> String {
    let held = tags.split_whitespace().map(|tag| {
        let point = session
            .simulation()
            .resolve(tag)
            .unwrap_or_else(|error| panic!("{error}"));
        format!("{tag} {}", cell(&session.simulation().value(&point), point.ty))
    });
    held.collect::<Vec<_>>().join(", ")
}

/// Changes the program; what was lost, with the text of its place.
pub(crate) fn change(session: &mut Session, text: &str) -> String {
    match session.change(program(text)).unwrap() {
        Changeover::None => "nothing has changed\n".to_owned(),
        Changeover::Carried { lost } => {
            let lost = lost.iter().map(|lost| {
                let place = lost.location.map_or("-", |location| {
                    &text[std::ops::Range::<usize>::from(location.range)]
                });
                format!("{place}: {}\n", lost.message)
            });
            lost.collect()
        }
    }
}

/// Runs a program, changes it and runs on: what was lost, and what tags hold before the next scan and after it.
#[track_caller]
fn check(old: &str, before: &str, new: &str, after: &str, tags: &str, expected: Expect) {
    let mut session = session(old);
    run(&mut session, before);
    let mut shown = change(&mut session, new);
    shown.push_str(&held(&session, tags));
    run(&mut session, after);
    shown.push_str(&format!("\n{}\n", held(&session, tags)));
    expected.assert_eq(&shown);
}

pub(crate) const MOTOR: &str = "\
+--\\--[ ]( start )--\\--[/]( stop )-------------( )( run )--+
|  /--[ ]( run )----/                                      |
+--[ ]( run )--[TON]( t, T#50ms )--( )( warm )--+
+--[ ]( run )--[P]( warm )--[CTU]( c, 3 )--+
";

#[test]
fn what_has_moved_goes_on() {
    // A rung in front, a contact within, a preset that is another one.
    check(
        MOTOR,
        "start _-____",
        "+--[ ]( other )--( )( lamp )--+\n\
         +--\\--[ ]( start )--\\--[/]( stop )--[ ]( SYS.ON )--( )( run )--+\n\
         |  /--[ ]( run )----/\n\
         +--[ ]( run )--[TON]( t, T#70ms )--( )( warm )--+\n\
         +--[ ]( run )--[P]( warm )--[CTU]( c, 3 )--+\n",
        "3",
        "run t.ET warm c.CV SYS.SCAN",
        expect![[r#"
            run 1, t.ET 40, warm 0, c.CV 0, SYS.SCAN 5
            run 1, t.ET 70, warm 1, c.CV 1, SYS.SCAN 8
        "#]],
    );
}

#[test]
fn edges_belong_to_their_place() {
    let old = "+--[ ]( a )--[OSR]--[ADD]( n, n, 1 )--+\n+--[P]( a )--[ADD]( m, m, 1 )--+\n+--[ ]( a )--(P)( y )--+\n";
    // All of them have seen `a` high: none sees a rise again, wherever it is now.
    check(
        old,
        "a _--",
        "+--[P]( a )--[ADD]( m, m, 1 )--+\n+--[ ]( b )--( )( z )--+\n+--[ ]( a )--[/]( b )--[OSR]--[ADD]( n, n, 1 )--+\n+--[ ]( a )--(P)( x )--+\n",
        "a -_-",
        "n m x",
        expect![[r#"
            n 1, m 1, x 0
            n 2, m 2, x 1
        "#]],
    );
    // Another tag is another edge.
    check(
        old,
        "a _--",
        "+--[ ]( a )--[OSR]--[ADD]( n, n, 1 )--+\n+--[P]( b )--[ADD]( m, m, 1 )--+\n+--[ ]( a )--(P)( y )--+\n",
        "b -",
        "n m",
        expect![[r#"
            [P]( b ): [P] is not the one that was there before: it forgets what it saw last
            n 1, m 1
            n 1, m 2
        "#]],
    );
}

#[test]
fn what_cannot_be_kept_is_reported() {
    check(
        "VAR n : INT := 5; t : TON; f : ARRAY[1..3] OF INT; gone : INT; old : INT; END_VAR\n\
         +--[ADD]( n, n, 1 )--[MOV]( f[2], 7 )--[MOV]( gone, 3 )--[TON]( t, T#1s )--+\n",
        "3",
        "VAR n : REAL; t : TOF; f : ARRAY[2..9] OF INT; fresh : INT := 4; END_VAR\n\
         VAR CONSTANT limit : INT := 8; END_VAR\n\
         +--[MOV]( fresh, limit )--[TOF]( t, T#1s )--[MOV]( f[9], 1 )--[ADD]( n, n, 1.0 )--+\n",
        "1",
        "n f[2] f[9] fresh t.Q",
        expect![[r#"
            n: n was an INT and is a REAL now: it begins with its initial value
            t: t was a TON and is a TOF now: it begins with its initial value
            -: gone is no more, and what it held is gone
            n 0.0, f[2] 7, f[9] 0, fresh 4, t.Q 0
            n 1.0, f[2] 7, f[9] 1, fresh 8, t.Q 1
        "#]],
    );
    check(
        "VAR n : INT := 5; END_VAR\nVAR CONSTANT limit : INT := 8; END_VAR\n+--[ADD]( n, n, limit )--+\n",
        "1",
        "VAR n : INT := 6; END_VAR\nVAR CONSTANT limit : INT := 9; END_VAR\n+--[ADD]( n, n, limit )--+\n",
        "1",
        "n",
        expect![[r#"
            n: n keeps its value: its initial value counts from the next cold start on
            n 13
            n 22
        "#]],
    );
}

#[test]
fn a_tag_with_another_name_is_the_same_one() {
    check(
        MOTOR,
        "start _-____",
        &MOTOR.replace("run", "running"),
        "3",
        "running t.ET warm c.CV",
        expect![[r#"
            running 1, t.ET 40, warm 0, c.CV 0
            running 1, t.ET 50, warm 1, c.CV 1
        "#]],
    );
    // A declared one, an edge of it, and what is forced.
    let declared = "VAR total : INT := 3; END_VAR\n+--[ ]( go )--[OSR]--[ADD]( total, total, 1 )--+\n";
    check(
        declared,
        "go _-",
        &declared.replace("total", "Sum"),
        "go -_-",
        "Sum",
        expect![[r#"
            Sum 4
            Sum 5
        "#]],
    );
    let mut session = session(declared);
    let total = session.simulation().resolve("total").unwrap();
    session.force(&total, Value::Int(70)).unwrap();
    session.add_breakpoint(Breakpoint::Change(total));
    session.scan();
    assert_eq!(change(&mut session, &declared.replace("total", "sum")), "");
    assert_eq!(session.simulation().forced().count(), 1);
    assert!(matches!(session.breakpoints(), [Breakpoint::Change(point)] if point.name == "sum"));
}

#[test]
fn another_tag_is_not_one_with_another_name() {
    // At one place only.
    let latch = "+--[ ]( fire )--(S)( alarm )--+\n";
    check(
        latch,
        "fire -",
        &latch.replace("alarm", "horn"),
        "fire _",
        "horn",
        expect![[r#"
            -: alarm is no more, and what it held is gone
            horn 0
            horn 0
        "#]],
    );
    // A tag that was there before, and one that is still there.
    let seal = "+--[ ]( run )--( )( run )--+\n+--[ ]( a )--( )( b )--+\n";
    check(
        seal,
        "run -",
        &seal.replace("run", "b"),
        "1",
        "b",
        expect![[r#"
            -: run is no more, and what it held is gone
            b 0
            b 0
        "#]],
    );
    check(
        seal,
        "run -",
        &seal.replace("run", "x").replace("( a )", "( run )"),
        "1",
        "x",
        expect![[r#"
            x 0
            x 0
        "#]],
    );
    // More was changed than the name.
    check(
        seal,
        "run -",
        &seal.replace("run", "x").replace("[ ]( a", "[/]( a"),
        "1",
        "x",
        expect![[r#"
            -: run is no more, and what it held is gone
            x 0
            x 0
        "#]],
    );
}

#[test]
fn what_was_changed_and_taken_back_before_a_scan_is_as_it_was() {
    let mut session = session(MOTOR);
    run(&mut session, "start _-____");
    let before = held(&session, "run t.ET warm c.CV");
    session.add_breakpoint(Breakpoint::Network(0));
    // Letter by letter, and a timer that is another kind for a moment.
    for text in ["[TO]", "[TOF]", "[TP]"] {
        if let Some(other) = program_of(&MOTOR.replace("[TON]", text)) {
            session.change(other).unwrap();
        }
    }
    change(&mut session, "+--[ ]( all_else )--( )( is_gone )--+\n");
    session.add_breakpoint(Breakpoint::Network(0));
    assert_eq!(
        change(
            &mut session,
            &format!("+--[ ]( all_else )--( )( is_gone )--+\n{MOTOR}")
        ),
        ""
    );
    assert_eq!(held(&session, "run t.ET warm c.CV"), before);
    assert_eq!(session.breakpoints(), [Breakpoint::Network(0)]);
    // What is given to it is not taken back.
    change(&mut session, "+--[ ]( start )--( )( y )--+\n");
    set(&mut session, "start", "1");
    change(&mut session, MOTOR);
    assert_eq!(held(&session, "start run"), "start 1, run 0");
    session.step_back(100);
    assert_eq!(session.scans_ahead(), 6);
}

pub(crate) const COUNTS: &str = "FUNCTION_BLOCK [$Count]\nVAR_INPUT up : BOOL; END_VAR\nVAR_OUTPUT n : INT; END_VAR\nVAR hold : TON; END_VAR\n\
    +--[ ]( up )--[OSR]--[ADD]( n, n, 1 )--+\n+--[ ]( up )--[TON]( hold, T#1s )--+\nEND_FUNCTION_BLOCK\n";

#[test]
fn blocks_of_ones_own_keep_what_is_in_them() {
    let old = format!("{COUNTS}+--[$Count]( a, x )--+\n+--[$Count]( b, y )--+\n");
    let new = format!("{COUNTS}+--[$Count]( b, y )--+\n+--[ ]( z )--[$Count]( a, x2 )--+\n");
    check(
        &old,
        "a _-_-_-\nb ____-_",
        &new,
        "a -_-\nb __-\nz ---",
        "y x2",
        expect![[r#"
            -: x is no more, and what it held is gone
            y 1, x2 0
            y 2, x2 4
        "#]],
    );
}

#[test]
fn what_does_the_same_is_no_change() {
    let mut session = session(MOTOR);
    run(&mut session, "start _-____");
    let power =
        |session: &Session| -> Vec<bool> { session.simulation().power().map(|(_, _, on)| on).collect() };
    session.step_block();
    let before = (session.simulation().state(), power(&session));
    let laid_out = MOTOR
        .replace("--( )( run )", "----( )( run )")
        .replace("+--[ ]( run )--[TON]", "# text #\n\n+--[ ]( run )---[TON]");
    assert_eq!(change(&mut session, &laid_out), "nothing has changed\n");
    assert_eq!((session.simulation().state(), power(&session)), before);
    assert_eq!(session.scans_behind(), 6);
    let location = session.simulation().next_block().unwrap();
    assert_eq!(
        &laid_out[std::ops::Range::<usize>::from(location.range)],
        "[ ]( start )"
    );
    session.step_back(1);
    assert_eq!(held(&session, "run t.ET"), "run 1, t.ET 40");
}

#[test]
fn power_is_shown_before_the_next_scan() {
    let mut session = session(MOTOR);
    run(&mut session, "start _-____");
    change(&mut session, &format!("+--[ ]( new )--( )( z )--+\n{MOTOR}"));
    let text = format!("+--[ ]( new )--( )( z )--+\n{MOTOR}");
    let live: Vec<&str> = session
        .simulation()
        .power()
        .filter(|(_, _, on)| *on)
        .map(|(_, location, _)| &text[std::ops::Range::<usize>::from(location.range)])
        .filter(|drawn| drawn.starts_with(['[', '(']))
        .collect();
    assert_eq!(
        live,
        [
            "[ ]( run )",
            "[/]( stop )",
            "( )( run )",
            "[ ]( run )",
            "[ ]( run )"
        ]
    );
}

#[test]
fn stepping_back_goes_across() {
    let mut session = session("+--[ADD]( n, n, 1 )--+\n");
    run(&mut session, "3");
    change(&mut session, "+--[ADD]( n, n, 10 )--[MOV]( m, n )--+\n");
    run(&mut session, "2");
    change(&mut session, "+--[ADD]( n, n, 100 )--+\n");
    run(&mut session, "2");
    assert_eq!(held(&session, "n"), "n 223");
    assert_eq!((session.scans_behind(), session.scans_ahead()), (7, 0));
    let n = session.simulation().resolve("n").unwrap();
    let past = |session: &Session| -> Vec<String> {
        let past = session.past(std::slice::from_ref(&n), 100);
        past[0].iter().map(|value| cell(value, n.ty)).collect()
    };
    assert_eq!(past(&session), ["1", "2", "3", "13", "23", "123", "223"]);
    assert_eq!(past(&session).len(), 7);
    let mut seen = Vec::new();
    while session.step_back(1) > 0 {
        seen.push((held(&session, "n"), session.generation()));
    }
    let seen: Vec<String> = seen
        .iter()
        .map(|(held, generation)| format!("{held} in {generation}"))
        .collect();
    assert_eq!(
        seen,
        [
            "n 123 in 2",
            "n 23 in 2",
            "n 13 in 1",
            "n 3 in 1",
            "n 2 in 0",
            "n 1 in 0",
            "n 0 in 0"
        ]
    );
    assert_eq!((session.scans_behind(), session.scans_ahead()), (0, 7));
    for _ in 0..4 {
        session.scan();
    }
    assert_eq!(
        (held(&session, "n m"), session.generation()),
        ("n 13, m 13".to_owned(), 1)
    );
    assert_eq!(session.step_back(100), 4);
    for _ in 0..7 {
        session.scan();
    }
    assert_eq!(
        (held(&session, "n"), session.generation()),
        ("n 223".to_owned(), 2)
    );
    session.scan();
    assert_eq!(held(&session, "n"), "n 323");
}

#[test]
fn what_is_given_in_the_past_is_given_to_the_newest_program() {
    let mut session = session("VAR n, k : DINT; END_VAR\n+--[ADD]( n, n, 1 )--+\n");
    run(&mut session, "3");
    let n = session.simulation().resolve("n").unwrap();
    change(
        &mut session,
        "VAR k, l, m, n : DINT; END_VAR\n+--[ADD]( n, n, 10 )--+\n",
    );
    run(&mut session, "2");
    session.step_back(4);
    assert_eq!((held(&session, "n"), session.generation()), ("n 1".to_owned(), 0));
    // The point is one of the program that ran then.
    session.set(&n, Value::Int(50)).unwrap();
    assert_eq!(
        (held(&session, "n k"), session.generation()),
        ("n 50, k 0".to_owned(), 1)
    );
    assert_eq!((session.scans_behind(), session.scans_ahead()), (1, 0));
    session.scan();
    assert_eq!(held(&session, "n"), "n 60");
    session.step_back(2);
    assert_eq!((held(&session, "n"), session.generation()), ("n 0".to_owned(), 0));
    session.scan();
    session.scan();
    assert_eq!(held(&session, "n"), "n 60");
}

#[test]
fn what_was_given_last_waits_across_a_change() {
    let mut session = session("+--[ ]( a )--( )( y )--+\n");
    run(&mut session, "a ___");
    change(&mut session, "+--[ ]( a )--(/)( y )--+\n");
    set(&mut session, "a", "1");
    session.step_back(2);
    assert_eq!(held(&session, "a"), "a 0");
    session.scan();
    session.scan();
    assert_eq!(
        (held(&session, "a y"), session.generation()),
        ("a 1, y 0".to_owned(), 1)
    );
    session.scan();
    assert_eq!(held(&session, "a y"), "a 1, y 0");
    set(&mut session, "a", "0");
    session.scan();
    assert_eq!(held(&session, "a y"), "a 0, y 1");
}

#[test]
fn forces_faults_and_breakpoints_stay() {
    let old = "VAR n, d : INT; END_VAR\n+--[ ]( a )--( )( y )--+\n+--[DIV]( n, n, d )--+\n";
    let new = "VAR d, n : INT; END_VAR\n+--[ ]( x )--( )( z )--+\n+--[DIV]( n, n, d )--+\n+--[ ]( a )--( )( y )--+\n";
    let mut session = session(old);
    let a = session.simulation().resolve("a").unwrap();
    session.force(&a, Value::Bool(true)).unwrap();
    session.add_breakpoint(Breakpoint::Network(1));
    session.add_breakpoint(Breakpoint::Network(0));
    session.scan();
    assert_eq!(session.faults().len(), 1);
    assert_eq!(change(&mut session, new), "");
    assert_eq!(
        session.breakpoints(),
        [Breakpoint::Network(1), Breakpoint::Network(2)]
    );
    let faults = session.faults();
    assert_eq!(
        &new[std::ops::Range::<usize>::from(faults[0].location.range)],
        "[DIV]( n, n, d )"
    );
    session.scan();
    assert_eq!(held(&session, "a y"), "a 1, y 1");
    assert_eq!(
        session
            .simulation()
            .forced()
            .map(|it| it.name.as_str())
            .collect::<Vec<_>>(),
        ["a"]
    );
    session.unforce_all();
    session.scan();
    assert_eq!(held(&session, "a y"), "a 0, y 0");
    let forced = session.simulation().resolve("a").unwrap();
    session.force(&forced, Value::Bool(true)).unwrap();
    assert_eq!(
        change(&mut session, "+--[ ]( b )--( )( y )--+\n"),
        "-: a is no more, and what it held is gone\n\
         -: a is not forced any more: the program has it no longer, or as another type\n"
    );
}

#[test]
fn a_program_that_hangs_is_fixed() {
    let mut session = session("+--<LBL>( again )--[ADD]( n, n, 1 )--<JMP>( again )--+\n");
    assert!(!session.scan());
    change(&mut session, "+--[ADD]( n, n, 1 )--+\n");
    let before = held(&session, "n");
    assert!(session.scan());
    assert_ne!(held(&session, "n"), before);
}

/// What is at an address stays there, whatever it is called now; a new name of it is a change.
#[test]
fn addresses_keep_what_they_hold() {
    let rung = "+--[ADD]( n, n, 1 )--+\n";
    let old = format!("VAR n AT %MW3 : INT; END_VAR\n{rung}");
    let mut other = session(&old);
    run(&mut other, "3");
    let renamed = "VAR m AT %MW003 : INT; END_VAR\n+--[ADD]( m, m, 1 )--+\n";
    assert_eq!(change(&mut other, renamed), "");
    assert_eq!(held(&other, "m %MW3"), "m 3, %MW3 3");
    // The name that it had is another tag now.
    let both = "VAR n : INT; m, k AT %MW3 : INT; END_VAR\n+--[ADD]( n, n, 1 )--[ADD]( k, m, 1 )--+\n";
    assert_eq!(change(&mut other, both), "");
    assert_eq!(held(&other, "n m k"), "n 0, m 3, k 3");
    let more = both.replace("m, k AT", "m, k, more AT");
    assert_eq!(change(&mut other, &more), "");
    assert_eq!(held(&other, "more"), "more 3");
    // It has moved, and nothing was there.
    run(&mut other, "1");
    let moved = more.replace("%MW3", "%MW4");
    assert_eq!(change(&mut other, &moved), "");
    assert_eq!(held(&other, "n m more %MW4"), "n 1, m 4, more 4, %MW4 4");
}

#[test]
fn a_forced_enumeration_stays_by_the_name_of_its_value() {
    let text = |ty: &str, values: &str| {
        format!("TYPE {ty} : ({values}); END_TYPE\nVAR p : {ty}; END_VAR\n+--[EQ]( p, B )--( )( y )--+\n")
    };
    let mut session = session(&text("Phase", "A, B"));
    let point = session.simulation().resolve("p").unwrap();
    session.force(&point, Value::Int(1)).unwrap();
    session.scan();
    assert_eq!(change(&mut session, &text("Phase", "C, D, A, B")), "");
    session.scan();
    assert_eq!(held(&session, "p y"), "p B, y 1");
    // The type by another name.
    assert_eq!(change(&mut session, &text("Stage", "C, D, A, B")), "");
    assert_eq!(session.simulation().forced().count(), 1);
    assert_eq!(held(&session, "p y"), "p B, y 1");
    session.scan();
    // Another one.
    assert_eq!(
        change(&mut session, &text("Step", "B, C")),
        "p: p was a Stage and is a Step now: it begins with its initial value\n\
         -: p is not forced any more: the program has it no longer, or as another type\n"
    );
    assert_eq!(session.simulation().forced().count(), 0);
}
