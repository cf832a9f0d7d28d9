//! What a check costs after the parser: names, types, the program model and all rules.

use divan::{Bencher, counter::BytesCount};
use ladder_analysis::analyze;
use ladder_syntax::{Parse, parse};
use std::fmt::Write as _;
use std::sync::Arc;

fn main() {
    divan::main();
}

/// A program of about so many rungs, clean but for what `kind` says.
#[derive(Clone, Copy, Debug)]
enum Kind {
    /// Every tag is declared.
    Declared,
    /// No tag is declared: every type is inferred, and every name checked for slips.
    Undeclared,
    /// Every tenth rung has an error.
    Faulty,
    /// As `Declared`, and every network asks for a tag twice: its boolean function is worked out.
    AskedTwice,
}

fn program(kind: Kind, rungs: usize) -> String {
    let mut text = String::with_capacity(rungs * 70);
    let networks = rungs / 3;
    if !matches!(kind, Kind::Undeclared) {
        for (header, declaration) in [
            ("VAR_INPUT", "start_#, stop_# : BOOL;"),
            ("VAR_OUTPUT", "run_#, ready_# : BOOL;"),
            ("VAR", "warm_# : TON;"),
        ] {
            let _ = writeln!(text, "{header}");
            for n in 0..networks {
                let _ = writeln!(text, "    {}", declaration.replace('#', &n.to_string()));
            }
            text.push_str("END_VAR\n\n");
        }
    }
    for n in 0..networks {
        let stop = (n * 7 + 3) % networks;
        let instruction = if matches!(kind, Kind::Faulty) && n % 4 == 0 {
            "TOM"
        } else {
            "TON"
        };
        let (upper, lower) = if matches!(kind, Kind::AskedTwice) {
            (format!("--[ ]( ready_{n} )"), format!("--[/]( ready_{n} )"))
        } else {
            (String::new(), String::new())
        };
        let _ = writeln!(
            text,
            "# Station {n} #\n\
             +--\\--[ ]( start_{n} ){upper}--\\--[/]( stop_{stop} )--( )( run_{n} )--+\n\
             |  /--[ ]( run_{n} ){lower}----/                                   |\n\n\
             +--[ ]( run_{n} )--[{instruction}]( warm_{n}, T#5s )--( )( ready_{n} )--+\n"
        );
    }
    text
}

fn parsed(kind: Kind, rungs: usize) -> (Arc<Parse>, usize) {
    let text = program(kind, rungs);
    (Arc::new(parse(&text)), text.len())
}

#[divan::bench(args = [Kind::Declared, Kind::Undeclared, Kind::Faulty, Kind::AskedTwice])]
fn thousand_rungs(bencher: Bencher, kind: Kind) {
    let (parse, size) = parsed(kind, 1_000);
    bencher
        .counter(BytesCount::new(size))
        .bench_local(|| analyze(&parse, "bench.clad"));
}

#[divan::bench(args = [Kind::Declared, Kind::Undeclared, Kind::Faulty, Kind::AskedTwice], sample_count = 10)]
fn large(bencher: Bencher, kind: Kind) {
    let (parse, size) = parsed(kind, 50_000);
    bencher
        .counter(BytesCount::new(size))
        .bench_local(|| analyze(&parse, "bench.clad"));
}
