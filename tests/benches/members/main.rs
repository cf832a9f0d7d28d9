//! What members of structures cost: a program of 1,000 members in 100 structures next to the same program of 1,000 tags. It is opened in
//! the language server, a name is completed in it, and it is run; the goal is a ratio of 1.3.
//!
//! Run with `cargo build --release -p ladder-cli --bins && cargo bench -p ladder-tests --bench members`.

use ladder_analysis::analyze;
use ladder_simulator::{Options, Simulation};
use ladder_tests::client::Server;
use serde_json::json;
use std::sync::Arc;
use std::time::{Duration, Instant};

const STRUCTURES: usize = 100;
const MEMBERS: usize = 10;
/// Each measurement is made so often, the two programs in turn; the median counts.
const TIMES: usize = 25;
const SCANS: u32 = 20_000;

/// The declarations, and between the name of a structure and that of a member `between`.
fn program(declarations: &str, between: &str) -> String {
    let mut text = format!("{declarations}VAR_INPUT\n    start : BOOL;\nEND_VAR\n\n");
    for one in 0..STRUCTURES {
        for member in 0..MEMBERS {
            let before = match (one, member) {
                (0, 0) => "start".to_owned(),
                (_, 0) => format!("part{}{between}m{}", one - 1, MEMBERS - 1),
                _ => format!("part{one}{between}m{}", member - 1),
            };
            text += &format!(
                "+--[ ]( {before} )--[/]( part{}{between}m{member} )--( )( part{one}{between}m{member} )--+\n\n",
                (one + 1) % STRUCTURES
            );
        }
    }
    text
}

fn of_tags() -> String {
    let mut declarations = "VAR\n".to_owned();
    for one in 0..STRUCTURES {
        for member in 0..MEMBERS {
            declarations += &format!("    part{one}_m{member} : BOOL;\n");
        }
    }
    program(&(declarations + "END_VAR\n"), "_")
}

fn of_members() -> String {
    let mut declarations = "TYPE\n    Part : STRUCT\n".to_owned();
    for member in 0..MEMBERS {
        declarations += &format!("        m{member} : BOOL;\n");
    }
    declarations += "    END_STRUCT;\nEND_TYPE\n\nVAR\n";
    for one in 0..STRUCTURES {
        declarations += &format!("    part{one} : Part;\n");
    }
    program(&(declarations + "END_VAR\n"), ".")
}

/// From the text that is sent to its diagnostics, and from a question for names to the answer.
fn opened(text: &str) -> [Duration; 2] {
    let folder = tempfile::tempdir().expect("a folder can be made");
    std::fs::write(folder.path().join("ladder.toml"), "").expect("the folder can be written");
    let uri = format!("file://{}", folder.path().join("bench.clad").display());
    let mut server = Server::start();
    let started = Instant::now();
    server.send(
        &json!({ "jsonrpc": "2.0", "method": "textDocument/didOpen", "params": {
        "textDocument": { "uri": uri, "languageId": "clad", "version": 1, "text": text } } }),
    );
    server.diagnostics_of(1);
    let open = started.elapsed();
    let rung = |(_, line): &(usize, &str)| line.starts_with("+--[ ]( part");
    let (line, _) = text.lines().enumerate().filter(rung).last().expect("a rung");
    let place = json!({ "textDocument": { "uri": uri }, "position": { "line": line, "character": "+--[ ]( pa".len() } });
    let mut answers: Vec<Duration> = (0..TIMES)
        .map(|_| {
            let started = Instant::now();
            server.request("textDocument/completion", &place);
            started.elapsed()
        })
        .collect();
    answers.sort_unstable();
    [open, answers[TIMES / 2]]
}

/// A scan.
fn run(text: &str) -> Duration {
    let analysis = analyze(&Arc::new(ladder_syntax::parse(text)), "bench.clad");
    let program = analysis.program().expect("the program has no errors");
    let mut simulation = Simulation::new(Arc::clone(program), Options::default()).expect("there is memory");
    let started = Instant::now();
    for _ in 0..SCANS {
        assert!(simulation.scan());
    }
    started.elapsed() / SCANS
}

fn main() {
    let texts = [of_tags(), of_members()];
    let mut times: [[Vec<Duration>; 2]; 3] = Default::default();
    for _ in 0..TIMES {
        for (side, text) in texts.iter().enumerate() {
            let [open, complete] = opened(text);
            times[0][side].push(open);
            times[1][side].push(complete);
            times[2][side].push(run(text));
        }
    }
    println!("{:24} {:>12} {:>12}   ratio", "", "1,000 tags", "1,000 members");
    for (what, mut sides) in ["opening it", "completion", "a scan"].into_iter().zip(times) {
        let [tags, members] = &mut sides;
        tags.sort_unstable();
        members.sort_unstable();
        let (tags, members) = (tags[TIMES / 2], members[TIMES / 2]);
        let ratio = members.as_secs_f64() / tags.as_secs_f64();
        println!("{what:24} {tags:>12.1?} {members:>12.1?}   {ratio:.2}");
    }
}
