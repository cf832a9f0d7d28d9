//! What an editor waits for: from a keystroke to its diagnostics, and from a request to its answer, over the real
//! program and real pipes.
//!
//! Programs of each kind (`typed_programs::KINDS`) are opened in `ladder lsp`. A letter is typed in the middle again and again, in a number, in the
//! name of an operand and in a declaration, and lines of declarations and networks come and go; each time until the diagnostics of that very version arrive. Then everything
//! else is asked, some of it at once after the edit, as an editor does, some once the diagnostics are there. Next to it
//! is the bare limit: the round trip of a request that the server does not know, which has the same framing, pipes and
//! scheduling, and no work.
//!
//! Run with `cargo build --release -p ladder-cli --bins && cargo bench -p ladder-tests --bench language_server`. Numbers
//! of rungs and names of kinds (`clean`, `warned`, ...) may follow as arguments.

use ladder_syntax::{MAX_OPEN_BYTES, MAX_OPEN_LINES};
use ladder_tests::client::Server;
use ladder_tests::typed_programs::{KINDS, Kind, Program, Spot};
use serde_json::{Value, json};
use std::time::{Duration, Instant};

/// So long after the last answer the server has given back what it needed for it.
const SETTLED: Duration = Duration::from_secs(5);

/// An open document in which a user types.
struct Typing {
    server: Server,
    spot: Spot,
    version: i64,
    uri: String,
}

impl Typing {
    /// A letter in, a letter out.
    fn type_on(&mut self) {
        let Spot { line, column, letter } = self.spot;
        let breaks = letter.matches('\n').count();
        let (end, new) = match (self.version % 2 == 1, breaks) {
            (true, _) => ((line, column), letter),
            (false, 0) => ((line, column + letter.len()), ""),
            // Whole lines.
            (false, _) => ((line + breaks, 0), ""),
        };
        self.version += 1;
        let place = |(line, character): (usize, usize)| json!({ "line": line, "character": character });
        self.server.send(
            &json!({ "jsonrpc": "2.0", "method": "textDocument/didChange", "params": {
            "textDocument": { "uri": self.uri, "version": self.version },
            "contentChanges": [{ "range": { "start": place((line, column)), "end": place(end) }, "text": new }] } }),
        );
    }

    /// From each edit to its diagnostics.
    fn edits(&mut self, count: usize) -> Vec<Duration> {
        let edit = |_| {
            let started = Instant::now();
            self.type_on();
            self.server.diagnostics_of(self.version);
            started.elapsed()
        };
        (0..count).map(edit).collect()
    }

    /// From a request to its answer, sent right after an edit or once its diagnostics are there. What the answer is must
    /// not be an error.
    fn requests(&mut self, count: usize, method: &str, params: &Value, settled: bool) -> Vec<Duration> {
        let mut params = params.clone();
        params["textDocument"] = json!({ "uri": self.uri });
        let request = |_| {
            self.type_on();
            if settled {
                self.server.diagnostics_of(self.version);
            }
            let started = Instant::now();
            let answer = self.server.request(method, &params);
            let took = started.elapsed();
            let answer: Value = serde_json::from_slice(&answer).expect("the server answers JSON");
            assert!(answer.get("error").is_none(), "{method}: {answer}");
            // A delta refers to what was sent before.
            if let Some(id) = answer["result"].get("resultId") {
                params["previousResultId"] = id.clone();
            }
            if !settled {
                self.server.diagnostics_of(self.version);
            }
            took
        };
        (0..count).map(request).collect()
    }
}

fn show(what: &str, mut times: Vec<Duration>) {
    times.sort_unstable();
    let at = |share: f64| times[((times.len() - 1) as f64 * share) as usize];
    println!(
        "  {what:<32} median {:>9.1?}   99th percentile {:>9.1?}",
        at(0.5),
        at(0.99)
    );
}

fn measure(name: &str, kind: Kind, rungs: usize) {
    let program = Program::new(kind, rungs);
    let text = &program.text;
    println!("{name}, {rungs} rungs, {} bytes", text.len());
    // A longer one is not read, and its edits cost nothing.
    assert!(text.len() <= MAX_OPEN_BYTES && text.lines().count() <= MAX_OPEN_LINES);
    // A workspace of its own, so that nothing else on the disk is checked.
    let folder = tempfile::tempdir().expect("a folder can be made");
    let file = folder.path().join("bench.clad");
    std::fs::write(folder.path().join("ladder.toml"), "").expect("the folder can be written");
    std::fs::write(&file, text).expect("the folder can be written");
    if let Some(next_to) = &program.next_to {
        std::fs::write(folder.path().join("next to it.clad"), next_to).expect("the folder can be written");
    }
    let uri = format!("file://{}", file.display());
    let mut server = Server::start();
    let idle = server.memory();
    server.send(
        &json!({ "jsonrpc": "2.0", "method": "textDocument/didOpen", "params": {
        "textDocument": { "uri": uri, "languageId": "clad", "version": 1, "text": text } } }),
    );
    let started = Instant::now();
    server.diagnostics_of(1);
    println!("  {:<32} {:.1?}", "opening it", started.elapsed());
    let mut typing = Typing {
        server,
        spot: program.in_a_number(),
        version: 1,
        uri,
    };
    let count = (2_000_000 / rungs).clamp(100, 400);
    let mut spots = vec![
        ("edit of a number", program.in_a_number()),
        ("edit of a name", program.in_a_name()),
        ("edit of a name without a type", program.in_a_name_without_type()),
        ("edit of a half-typed rung", program.half_typed()),
        ("edit of a declaration", program.in_a_declaration()),
        ("a line of declarations", program.with_a_declaration()),
        (
            "a half-typed declaration",
            program.with_a_half_typed_declaration(),
        ),
        ("edit of the first network", program.in_the_first_network()),
        ("a network with a label", program.with_a_label()),
    ];
    if kind == Kind::Globals {
        spots.push(("edit of a tag for all files", program.in_a_global()));
        spots.push((
            "edit of a declaration for all files",
            program.in_a_declaration_for_all(),
        ));
    }
    for (what, spot) in spots {
        typing.spot = spot;
        let before = typing.server.processor_time();
        show(what, typing.edits(count));
        if let (Some(before), Some(after)) = (before, typing.server.processor_time()) {
            let each = after.saturating_sub(before) / count as u32;
            println!("    {:<30} {each:.1?}", "processor time");
        }
    }
    let bare = |_| {
        let started = Instant::now();
        typing.server.request("ladder/nothing", &Value::Null);
        started.elapsed()
    };
    show("bare round trip", (0..400).map(bare).collect());
    requests(&mut typing, program.in_a_name(), rungs);
    let at_once = typing.server.memory();
    std::thread::sleep(SETTLED);
    if let (Some([idle, _]), Some([at_once, most]), Some([now, _])) = (idle, at_once, typing.server.memory())
    {
        let share = |bytes: u64| bytes.saturating_sub(idle) as f64 / text.len() as f64;
        println!(
            "  memory: {:.0} MB idle, {:.1} times the text above it, {:.1} times at rest, at most {:.1} times",
            idle as f64 / 1e6,
            share(at_once),
            share(now),
            share(most)
        );
    }
}

/// Everything else that an editor asks.
fn requests(typing: &mut Typing, spot: Spot, rungs: usize) {
    typing.spot = spot;
    let at = json!({ "position": { "line": spot.line, "character": spot.column } });
    let options = json!({ "options": { "tabSize": 4, "insertSpaces": true } });
    let mut rename = at.clone();
    rename["newName"] = json!("renamed_here");
    let nothing = json!({});
    let count = if rungs > 2_000 { 40 } else { 100 };
    for (what, method, params, settled) in [
        ("completion, right after an edit", "completion", &at, false),
        ("hover, right after an edit", "hover", &at, false),
        ("completion", "completion", &at, true),
        ("hover", "hover", &at, true),
        ("semantic tokens, full", "semanticTokens/full", &nothing, true),
        (
            "semantic tokens, delta",
            "semanticTokens/full/delta",
            &json!({ "previousResultId": "" }),
            true,
        ),
        ("document symbols", "documentSymbol", &nothing, true),
        ("format", "formatting", &options, true),
        ("rename", "rename", &rename, true),
    ] {
        let method = format!("textDocument/{method}");
        show(what, typing.requests(count, &method, params, settled));
    }
}

fn main() {
    let given: Vec<String> = std::env::args().skip(1).collect();
    let sizes: Vec<usize> = given.iter().filter_map(|it| it.parse().ok()).collect();
    let named = |name: &str| given.iter().any(|it| it == name);
    let any = KINDS.iter().any(|(name, _)| named(name));
    let sizes = if sizes.is_empty() {
        vec![100, 1_000, 10_000, 100_000]
    } else {
        sizes
    };
    for (name, kind) in KINDS {
        if any && !named(name) {
            continue;
        }
        for rungs in &sizes {
            measure(name, kind, *rungs);
        }
    }
}
