//! How long properties take in large programs: 20 local ones, in 1,000 rungs and in 10,000, next to reading and checking the
//! same text.
//!
//! `cargo bench -p ladder-prover`

use ladder_analysis::analyze;
use ladder_prover::{Options, Verdict, prove};
use ladder_simulator::scenario::{bind_properties, parse};
use ladder_simulator::{Options as Running, Simulation};
use std::fmt::Write as _;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Each is measured so often; the middle one counts.
const TIMES: usize = 5;
const PROPERTIES: usize = 20;

/// Blocks of ten rungs that seal in, each begun by the one before, with a timer at the end.
fn program(rungs: usize) -> String {
    let mut text = String::new();
    for block in 0..rungs / 10 {
        let _ = writeln!(text, "VAR t_{block} : TON; END_VAR");
    }
    for block in 0..rungs / 10 {
        for n in 0..9 {
            let before = match n {
                0 => format!("start_{block}"),
                n => format!("run_{block}_{}", n - 1),
            };
            let run = format!("run_{block}_{n}");
            let _ = write!(
                text,
                "\n+--\\--[ ]( {before} )--\\--[/]( stop_{block} )--( )( {run} )--+\n|  /--[ ]( {run} )--/  |\n"
            );
        }
        let _ = write!(
            text,
            "\n+--[ ]( run_{block}_8 )--[TON]( t_{block}, T#2s )--( )( done_{block} )--+\n"
        );
    }
    text
}

/// Of blocks here and there.
fn properties(rungs: usize) -> String {
    let mut text = String::from("program p.clad\ninterval 100ms\n");
    for n in 0..PROPERTIES {
        let block = n * (rungs / 10) / PROPERTIES;
        let _ = match n % 2 {
            0 => writeln!(text, "never stop_{block} and run_{block}_{}", n % 9),
            _ => writeln!(text, "when done_{block}: run_{block}_8"),
        };
    }
    text
}

fn middle(mut times: Vec<Duration>) -> Duration {
    times.sort_unstable();
    times[times.len() / 2]
}

fn main() {
    // `cargo test --benches` only wants to see it run.
    let is_test = std::env::args().any(|argument| argument == "--test");
    let sizes: &[usize] = if is_test { &[200] } else { &[1_000, 10_000] };
    println!("{:>8} {:>12} {:>12}   ratio", "rungs", "checked", "proved");
    for &rungs in sizes {
        let (text, properties) = (program(rungs), properties(rungs));
        let (mut checked, mut proved) = (Vec::new(), Vec::new());
        for _ in 0..if is_test { 1 } else { TIMES } {
            let started = Instant::now();
            let analysis = analyze(&Arc::new(ladder_syntax::parse(&text)), "bench.clad");
            let program = analysis.program().expect("the program has no errors");
            let running = Running {
                interval: 100_000_000,
                ..Running::default()
            };
            let mut simulation = Simulation::new(Arc::clone(program), running).expect("there is memory");
            checked.push(started.elapsed());
            let suite = parse(&properties);
            let (mut watched, errors) = bind_properties(&suite, &simulation);
            assert_eq!(errors, []);
            let started = Instant::now();
            let answers = prove(&mut simulation, &mut watched, Options::default()).expect("runs happen");
            proved.push(started.elapsed());
            let is_proved = |verdict: &Verdict| matches!(verdict, Verdict::Proved(_));
            assert!(answers.iter().all(|answer| is_proved(&answer.verdict)));
        }
        let (checked, proved) = (middle(checked), middle(proved));
        let ratio = proved.as_secs_f64() / checked.as_secs_f64();
        println!("{rungs:>8} {checked:>12.1?} {proved:>12.1?}   {ratio:.2}");
    }
}
