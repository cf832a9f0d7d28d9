//! What remembering costs: scans with a history next to the same scans without, and how long it takes to go back and to
//! say why.
//!
//! `cargo bench -p ladder-simulator --bench history`

use ladder_analysis::analyze;
use ladder_analysis::values::value::Value;
use ladder_simulator::{HistoryLimits, Options, Session, Simulation};
use std::fmt::Write;
use std::sync::Arc;
use std::time::Instant;

/// Seal-in rungs, every tenth with a timer after it.
fn program(rungs: usize) -> String {
    let mut text = String::new();
    for n in 0..rungs {
        let _ = writeln!(
            text,
            "+--\\--[ ]( start{n} )--\\--[/]( stop{n} )--( )( run{n} )--+\n|  /--[ ]( run{n} )----/"
        );
        if n % 10 == 0 {
            let _ = writeln!(text, "+--[ ]( run{n} )--[TON]( t{n}, T#5s )--( )( done{n} )--+");
        }
    }
    text
}

fn session(text: &str, limits: HistoryLimits) -> Session {
    let analysis = analyze(&Arc::new(ladder_syntax::parse(text)), "bench.clad");
    let program = analysis.program().cloned().expect("a program without errors");
    let simulation = Simulation::new(program, Options::default()).expect("a program that fits");
    Session::of(simulation, limits)
}

/// Nanoseconds a scan: the fastest of some batches. In each scan `inputs` inputs change.
fn scan(session: &mut Session, scans: usize, inputs: usize, batches: usize) -> f64 {
    let points: Vec<_> = (0..inputs)
        .map(|n| {
            session
                .simulation()
                .resolve(&format!("start{n}"))
                .expect("an input")
        })
        .collect();
    let mut fastest = f64::MAX;
    for _ in 0..batches {
        let begun = Instant::now();
        for scan in 0..scans {
            for (n, point) in points.iter().enumerate() {
                let set = session.set(point, Value::Bool((scan + n) % 2 == 0));
                set.expect("a BOOL");
            }
            session.scan();
        }
        fastest = fastest.min(begun.elapsed().as_nanos() as f64 / scans as f64);
    }
    fastest
}

/// Each rung depends on others above it, as in a sequence with interlocks, so that reasons lead far.
fn chain(rungs: usize) -> String {
    let mut text = String::new();
    for n in 0..rungs {
        let before = |by: usize| {
            n.checked_sub(by)
                .map_or("start".to_owned(), |n| format!("run{n}"))
        };
        let _ = writeln!(
            text,
            "+--[ ]( {} )--\\--[ ]( {} )--[/]( stop{} )--\\--[ ]( {} )--( )( run{n} )--+\n|  /--[ ]( run{n} )-------------------/",
            before(1),
            before(7),
            n % 20,
            before(31),
        );
        if n % 10 == 0 {
            let _ = writeln!(text, "+--[ ]( run{n} )--[TON]( t{n}, T#5s )--( )( done{n} )--+");
        }
    }
    text
}

/// How long it takes to say why, with a full history, of the last rung and of one in the middle, on and off.
fn reasons(rungs: usize, scans: usize) {
    let text = chain(rungs);
    let mut session = session(&text, HistoryLimits::default());
    let point = |session: &Session, name: &str| session.simulation().resolve(name).expect("a tag");
    let start = point(&session, "start");
    let stops: Vec<_> = (0..20).map(|n| point(&session, &format!("stop{n}"))).collect();
    for scan in 0..scans {
        let set = session.set(&start, Value::Bool(scan % 3_000 < 2_000 && scan > 10));
        set.expect("a BOOL");
        if scan % 50 == 0 {
            let number = scan / 50 % 20;
            session
                .set(&stops[number], Value::Bool(scan / 1_000 % 4 == 1))
                .expect("a BOOL");
        }
        session.scan();
        if scan + 1 == scans || scan == scans / 2 {
            for tag in [rungs - 1, rungs / 2] {
                let point = point(&session, &format!("run{tag}"));
                let begun = Instant::now();
                let why = session.why(&point);
                println!(
                    "{rungs:5} rungs, {:6} bytes kept: run{tag} is {:?}, why in {:.1?}",
                    session.history_size(),
                    why.value,
                    begun.elapsed()
                );
            }
        }
    }
}

fn main() {
    let is_test = std::env::args().any(|argument| argument == "--test");
    let sizes: &[usize] = if is_test { &[20] } else { &[100, 1_000, 10_000] };
    println!("rungs   inputs   without   with history   a scan takes   back 100 scans   why");
    for &rungs in sizes {
        let (scans, batches) = if is_test { (10, 1) } else { (200_000 / rungs, 20) };
        let text = program(rungs);
        for inputs in [0, 10] {
            let without = scan(
                &mut session(&text, HistoryLimits::of_scans(0)),
                scans,
                inputs,
                batches,
            );
            let mut kept = session(&text, HistoryLimits::default());
            let with = scan(&mut kept, scans, inputs, batches);
            let bytes = kept.history_size() / kept.scans_behind().max(1);
            let begun = Instant::now();
            let gone = kept.step_back(100);
            let back = begun.elapsed();
            let point = kept
                .simulation()
                .resolve(&format!("run{}", rungs - 1))
                .expect("a coil");
            let begun = Instant::now();
            let _ = kept.why(&point);
            let why = begun.elapsed();
            println!(
                "{rungs:5}   {inputs:6}   {without:5.0} ns   {with:9.0} ns   {bytes:7} bytes   {gone} in {back:.1?}   {why:.1?}"
            );
        }
    }
    println!("reasons that lead far");
    for &rungs in sizes {
        reasons(rungs, if is_test { 20 } else { 10_000 });
    }
}
