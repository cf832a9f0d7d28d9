use ladder_simulator::{Options, Simulation};
use std::sync::Arc;
use std::time::Instant;
fn main() {
    let n: usize = std::env::args().nth(1).map_or(1000, |a| a.parse().unwrap());
    let mut text = String::new();
    let mode = std::env::args().nth(2).unwrap_or_default();
    for i in 0..n {
        if mode == "t" {
            text.push_str(&format!(
                "+--[ ]( run{i} )--[TON]( t{i}, T#50ms )--( )( y{i} )--+\n\n"
            ));
            continue;
        }
        text.push_str(&format!("+--\\--[ ]( start{i} )--\\--[/]( stop{i} )--( )( run{i} )--+\n|  /--[ ]( run{i} )----/                              |\n"));
        if i % 10 == 0 && std::env::args().nth(2).is_none() {
            text.push_str(&format!(
                "\n+--[ ]( run{i} )--[TON]( t{i}, T#50ms )--( )( y{i} )--+\n"
            ));
        }
        text.push('\n');
    }
    let t = Instant::now();
    let parse = Arc::new(ladder_syntax::parse(&text));
    println!("parse {:?}", t.elapsed());
    let t = Instant::now();
    let analysis = ladder_analysis::analyze(&parse, "x");
    println!("analyze {:?}", t.elapsed());
    let program = analysis.program.unwrap();
    let t = Instant::now();
    let mut sim = Simulation::new(program, Options::default()).unwrap();
    println!("compile {:?}", t.elapsed());
    let on = ladder_analysis::value::Value::Bool(true);
    let k = if mode == "t" { "run" } else { "start" };
    for i in (0..n).step_by(3) {
        let p = sim.resolve(&format!("{k}{i}")).unwrap();
        sim.set(&p, on.clone()).unwrap();
    }
    for i in (0..if mode == "t" { 0 } else { n }).step_by(7) {
        let p = sim.resolve(&format!("stop{i}")).unwrap();
        sim.set(&p, on.clone()).unwrap();
    }
    let scans = (2_000_000 / n / 20).max(1);
    let mut best = f64::MAX;
    for _ in 0..300 {
        let t = Instant::now();
        for _ in 0..scans {
            sim.scan();
        }
        best = best.min(t.elapsed().as_nanos() as f64 / scans as f64);
    }
    println!("{best:.1} ns/scan");
}
