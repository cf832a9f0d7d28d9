//! What a check costs behind the parser: names, types, the program model and all rules.

use divan::{Bencher, counter::BytesCount};
use ladder_analysis::analyze;
use ladder_syntax::{Parse, parse};
use std::fmt::Write as _;
use std::sync::Arc;

fn main() {
    divan::main();
}

/// A program of about so many rungs, clean but for what `mistake` says.
#[derive(Clone, Copy, Debug)]
enum Kind {
    /// Every tag is declared.
    Declared,
    /// No tag is declared: every type is inferred, and every name looked at for slips.
    Undeclared,
    /// Every tenth rung has a mistake.
    Mistaken,
}

fn program(kind: Kind, rungs: usize) -> String {
    let mut text = String::with_capacity(rungs * 70);
    let networks = rungs / 3;
    if !matches!(kind, Kind::Undeclared) {
        text.push_str("VAR\n");
        for n in 0..networks {
            let _ = writeln!(
                text,
                "    start_{n}, stop_{n}, run_{n}, ready_{n} : BOOL;\n    warm_{n} : TON;"
            );
        }
        text.push_str("END_VAR\n\n");
    }
    for n in 0..networks {
        let stop = (n * 7 + 3) % networks;
        let instruction = if matches!(kind, Kind::Mistaken) && n % 4 == 0 {
            "TOM"
        } else {
            "TON"
        };
        let _ = writeln!(
            text,
            "# Station {n} #\n\
             +--\\--[ ]( start_{n} )--\\--[/]( stop_{stop} )--( )( run_{n} )--+\n\
             |  /--[ ]( run_{n} )----/                                   |\n\n\
             +--[ ]( run_{n} )--[{instruction}]( warm_{n}, T#5s )--( )( ready_{n} )--+\n"
        );
    }
    text
}

fn parsed(kind: Kind, rungs: usize) -> (Arc<Parse>, usize) {
    let text = program(kind, rungs);
    (Arc::new(parse(&text)), text.len())
}

#[divan::bench(args = [Kind::Declared, Kind::Undeclared, Kind::Mistaken])]
fn thousand_rungs(bencher: Bencher, kind: Kind) {
    let (parse, size) = parsed(kind, 1_000);
    bencher
        .counter(BytesCount::new(size))
        .bench_local(|| analyze(&parse, "bench.clad"));
}

#[divan::bench(args = [Kind::Declared, Kind::Undeclared, Kind::Mistaken], sample_count = 10)]
fn large(bencher: Bencher, kind: Kind) {
    let (parse, size) = parsed(kind, 50_000);
    bencher
        .counter(BytesCount::new(size))
        .bench_local(|| analyze(&parse, "bench.clad"));
}
