//! How long a scan takes, next to the same program written out as straight-line C.
//!
//! Each program is made twice from one description: as ladder text, which the simulator runs, and as C, which
//! `gcc -O2` compiles. Both run the same scans, in which the same inputs change; what all tags hold at the end must be
//! equal. The C comes in two kinds: as it is, and with a store of every power that a block or a join gives, so that like
//! the simulator it knows the power of every element after a scan.
//!
//! `cargo bench -p ladder-simulator --bench scan`; after `--` may follow which part: `seal-ins`, `mixed`, `sizes`.

mod c;
mod ladder;
mod networks;
mod sketch;

use c::Compiled;
use ladder::Ladder;
use sketch::Sketch;
use std::time::Duration;

/// Time of one scan.
#[derive(Debug, Clone, Copy)]
struct Run {
    scan: Duration,
    /// What all tags hold at the end.
    state: u64,
}

/// Each is run so often; the fastest counts, on both sides.
const BATCHES: usize = 400;

fn main() {
    // `cargo test --benches` only wants to see it run.
    let is_test = std::env::args().any(|argument| argument == "--test");
    let folder = std::env::temp_dir().join(format!("ladder-bench-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("there is room for the C");
    // A batch is short, so that most run undisturbed by whatever else the machine does.
    let (rungs, networks, scans) = if is_test {
        (20, 400, 2)
    } else {
        (1_000, 20_000, 200)
    };
    let wanted = |part: &str| {
        let parts = ["seal-ins", "mixed", "sizes"];
        let mut named = std::env::args()
            .filter(|argument| parts.contains(&argument.as_str()))
            .peekable();
        named.peek().is_none() || named.any(|argument| argument == part)
    };
    println!(
        "program                     elements   simulator   C, and how many times that   C with powers, likewise"
    );
    if wanted("seal-ins") {
        compare(
            "seal-in rungs and timers",
            &networks::seal_ins(rungs),
            scans,
            &folder,
        );
    }
    if wanted("mixed") {
        compare(
            "mixed networks",
            &networks::mixed(networks),
            (scans / 50).max(1),
            &folder,
        );
    }
    if wanted("sizes") {
        println!();
        println!(
            "networks   elements       scan    per element   power of all   compiled in   parsed and analysed in"
        );
        for tenth in [100, 10, 1] {
            size(&networks::mixed(networks / tenth), (scans / 50).max(1));
        }
        size(&networks::seal_ins(networks * 5), (scans / 100).max(1));
    }
    let _ = std::fs::remove_dir_all(&folder);
}

/// One program, in the simulator and in C.
fn compare(name: &str, sketch: &Sketch, scans: u64, folder: &std::path::Path) {
    let mut ladder = Ladder::new(sketch);
    let ours = ladder.run(sketch, scans);
    let elements = ladder.elements();
    let mut line = format!("{name:26} {elements:9} {:>11}", time(ours.scan));
    for powers in [false, true] {
        let Some(theirs) = Compiled::new(sketch, powers, folder) else {
            println!("{line}   (no gcc: nothing to compare with)");
            return;
        };
        let theirs = theirs.run(scans);
        assert_eq!(ours.state, theirs.state, "{name}: the C computes something else");
        line.push_str(&format!("   {:>9}", time(theirs.scan)));
        let ratio = ours.scan.as_secs_f64() / theirs.scan.as_secs_f64();
        line.push_str(&format!(" ({ratio:.2})"));
    }
    println!("{line}");
}

/// What one program costs, by itself.
fn size(sketch: &Sketch, scans: u64) {
    let mut ladder = Ladder::new(sketch);
    let run = ladder.run(sketch, scans);
    let elements = ladder.elements();
    let per_element = run.scan.as_secs_f64() * 1e9 / elements as f64;
    println!(
        "{:8} {elements:10} {:>10} {per_element:10.2} ns {:>14} {:>13} {:>24}",
        sketch.networks(),
        time(run.scan),
        time(ladder.show_all_power()),
        time(ladder.compiled_in),
        time(ladder.analysed_in),
    );
}

fn time(duration: Duration) -> String {
    let nanoseconds = duration.as_secs_f64() * 1e9;
    match nanoseconds {
        ..1e3 => format!("{nanoseconds:.1} ns"),
        ..1e6 => format!("{:.2} µs", nanoseconds / 1e3),
        _ => format!("{:.1} ms", nanoseconds / 1e6),
    }
}
