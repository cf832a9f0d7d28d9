//! The prover's functions of bits next to the simulator: every tag in every scan, on generated programs.

use super::compile;
use ladder_analysis::values::value::Value;
use ladder_generator::generator::{Dice, Mode, program};
use ladder_generator::runs::value;
use ladder_prover::Concrete;
use ladder_simulator::{Options, Simulation, Status, value_text};
use std::collections::BTreeMap;

/// What was compared.
#[derive(Debug, Default)]
pub(crate) struct Tally {
    pub(crate) equal: usize,
    pub(crate) open: usize,
    /// Programs that cannot be followed, by why.
    pub(crate) blocked: BTreeMap<String, usize>,
}

/// How many programs of a kind there are: `GENERATED_PROGRAMS=500 cargo test -p ladder-tests followed` tries more.
pub(crate) fn programs() -> u64 {
    let asked = std::env::var("GENERATED_PROGRAMS").ok();
    asked.and_then(|asked| asked.parse().ok()).unwrap_or(20)
}

/// Compares one program over so many scans; the difference, if there is one.
pub(crate) fn compare(text: &str, seed: u64, scans: usize, tally: &mut Tally) -> Option<String> {
    compare_two([text, text], (seed, scans), tally)
}

/// The same of two programs: the simulator runs the first, and the prover has the second.
fn compare_two([text, other]: [&str; 2], (seed, scans): (u64, usize), tally: &mut Tally) -> Option<String> {
    let program = compile(text)?;
    let options = Options {
        watchdog: 20_000,
        ..Options::default()
    };
    let mut simulation = Simulation::new(program, options).ok()?;
    let other = Simulation::new(compile(other)?, options).ok()?;
    let mut followed = match Concrete::new(&other) {
        Ok(followed) => followed,
        Err(why) => {
            *tally.blocked.entry(why).or_default() += 1;
            return None;
        }
    };
    let mut dice = Dice::new(seed);
    let names: Vec<String> = followed.inputs().map(str::to_owned).collect();
    let mut given: BTreeMap<String, Value> = BTreeMap::new();
    for scan in 0..scans {
        for name in &names {
            if scan == 0 || dice.one_in(3) {
                let point = simulation.resolve(name).expect("inputs are tags");
                let value = value(&mut dice, point.ty);
                simulation.set(&point, value.clone()).expect("it fits");
                given.insert(name.clone(), value);
            }
        }
        // What the program writes over it is given once more.
        for (name, value) in &given {
            let point = simulation.resolve(name).expect("inputs are tags");
            simulation.set(&point, value.clone()).expect("it fits");
        }
        if !simulation.scan() {
            return None;
        }
        followed.scan(|name| given[name].clone());
        for (point, found) in followed.values() {
            let wanted = simulation.value(point);
            match found {
                None => tally.open += 1,
                Some(found) if found == wanted => tally.equal += 1,
                Some(found) => {
                    let shown = |value: &Value| value_text::display(value, point.ty);
                    return Some(format!(
                        "{} is {} in scan {scan}, and {} to the prover\n{text}",
                        point.name,
                        shown(&wanted),
                        shown(&found)
                    ));
                }
            }
        }
        if simulation.status() != Status::Ready {
            return None;
        }
    }
    None
}

fn check(mode: Mode, least: usize) {
    let mut tally = Tally::default();
    for seed in 0..programs() {
        if let Some(difference) = compare(&program(seed, mode), seed, 20, &mut tally) {
            panic!("seed {seed}: {difference}");
        }
    }
    println!("{mode:?}: {tally:?}");
    assert!(tally.equal >= least, "{tally:?}");
}

#[test]
fn contacts_and_coils_are_followed() {
    check(Mode::Boolean, 1_000);
}

#[test]
fn sensible_programs_are_followed() {
    check(Mode::Sensible, 2_000);
}

#[test]
fn wild_programs_are_followed() {
    check(Mode::Wild, 0);
}

#[test]
fn programs_with_types_are_followed() {
    check(Mode::Typed, 0);
}

/// What generated programs seldom let run out, and what they pass over.
const TIMES: &str = "\
VAR_INPUT a, b, r : BOOL; ms : INT; END_VAR
VAR t1, t2, t3 : TON; t4, t5 : TOF; t6, t7 : TP; t8, t9 : RTO; t10, t11 : RTOF; END_VAR
VAR c1 : CTU; c2 : CTD; c3 : CTUD; c4 : CTC; list : ARRAY[0..4] OF INT; n, sum, tens : INT; END_VAR
+--[ ]( a )--[TON]( t1, T#55ms, R := r )--( )( q1 )--+
+--[ ]( a )--[TOF]( t4, T#55ms, R := r )--( )( q4 )--+
+--[ ]( a )--[TP]( t6, T#55ms, R := r )--( )( q6 )--+
+--[ ]( a )--[RTO]( t8, T#75ms, R := r )--( )( q8 )--+
+--[ ]( a )--[RTOF]( t10, T#75ms, R := r )--( )( q10 )--+
+--[MUL]( tens, ms, 10 )--+
+--[ ]( a )--[TON]( t2, tens )--+
+--[ ]( b )--<JMP>( over )--+
+--[ ]( a )--[TON]( t3, T#30ms )--( )( q3 )--+
+--[ ]( a )--[TOF]( t5, tens )--( )( q5 )--+
+--[ ]( a )--[TP]( t7, tens )--( )( q7 )--+
+--[ ]( a )--[RTO]( t9, tens )--( )( q9 )--+
+--[ ]( a )--[RTOF]( t11, tens )--( )( q11 )--+
+--[ ]( a )--[CTU]( c1, 3, R := r )--( )( q12 )--+
+--[ ]( a )--[CTD]( c2, 3, LD := r )--( )( q13 )--+
+--[ ]( a )--[CTUD]( c3, ms, CD := b, R := r )--( )( q14 )--+
+--[ ]( a )--[CTC]( c4, 3 )--( )( q15 )--+
+--<LBL>( over )--[ ]( r )--(RES)( t9 )--(RES)( c4 )--(RES)( t7 )--+
+--[ ]( SYS.CLOCK_100MS )--[P]( a )--<CALL>( count )--+
+--[ ]( b )--<CALL>( count )--+
+--[MOV]( sum, 0 )--+
+--<FOR>( 5, I := n )--+
+--[ADD]( sum, sum, list[n - 1] )--[GT]( sum, 6 )--<JMP>( far )--+
+--<NEXT>--+
+--<LBL>( far )--[EQ]( ms, 3 )--<END>--+
+--<FUN>( count )--[ADD]( list[ms], list[ms], 1 )--[OSR]--( )( once )--+
";

#[test]
fn times_and_loops_are_followed() {
    assert!(compile(TIMES).is_some(), "it has errors");
    let mut tally = Tally::default();
    for seed in 0..programs().div_ceil(5) {
        if let Some(difference) = compare(TIMES, seed, 120, &mut tally) {
            panic!("seed {seed}: {difference}");
        }
    }
    println!("{tally:?}");
    assert!(
        tally.equal >= 5_000 && tally.open == 0 && tally.blocked.is_empty(),
        "{tally:?}"
    );
}

/// A prover that takes one instruction for another is found: here it has another program than the simulator.
#[test]
fn planted_errors_are_found() {
    let planted = [
        ("[TON]( t1, T#55ms", "[TON]( t1, T#65ms"),
        ("[TOF]( t4, T#55ms, R := r )", "[TOF]( t4, T#55ms )"),
        ("[ ]( a )--[TP]", "[/]( a )--[TP]"),
        ("[RTO]( t8, T#75ms", "[RTO]( t8, T#85ms"),
        ("[RTOF]( t10, T#75ms", "[RTOF]( t10, T#65ms"),
        ("[MUL]( tens, ms, 10 )", "[DIV]( tens, ms, 10 )"),
        ("[ ]( b )--<JMP>", "[/]( b )--<JMP>"),
        ("[CTU]( c1, 3, R := r )", "[CTU]( c1, 3 )"),
        ("[CTD]( c2, 3, LD := r )", "[CTD]( c2, 3, R := r )"),
        ("CD := b, R := r", "CD := a, R := r"),
        ("[CTC]( c4, 3 )", "[CTC]( c4, 1 )"),
        ("(RES)( t9 )--", ""),
        ("[P]( a )", "[N]( a )"),
        ("<FOR>( 5", "<FOR>( 4"),
        ("[ADD]( sum, sum", "[SUB]( sum, sum"),
        ("[GT]( sum, 6 )", "[LT]( sum, 6 )"),
        ("list[n - 1]", "list[5 - n]"),
        ("[OSR]", "[OSF]"),
        ("[EQ]( ms, 3 )--<END>", "[EQ]( ms, 4 )--<END>"),
    ];
    let mut missed = Vec::new();
    for (right, wrong) in planted {
        let other = TIMES.replace(right, wrong);
        assert!(other != TIMES && compile(&other).is_some(), "{wrong}\n{other}");
        let differs = |seed| compare_two([TIMES, &other], (seed, 120), &mut Tally::default());
        if (0..20).all(|seed| differs(seed).is_none()) {
            missed.push((right, wrong));
        }
    }
    assert_eq!(missed, []);
}

#[test]
fn times_that_become_numbers_are_followed() {
    let text = "VAR_INPUT span : TIME; moment : DT; END_VAR
VAR_OUTPUT ms : LINT; short : INT; day : DATE; clock : TOD; END_VAR
+--[TYP]( ms, span )--[TYP]( day, moment )--[TYP]( clock, moment )--[TYP]( short, span )--+
";
    let mut tally = Tally::default();
    for seed in 0..programs() {
        assert_eq!(compare(text, seed, 20, &mut tally), None);
    }
    assert!(tally.equal > 1_000 && tally.open == 0, "{tally:?}");
}
