//! Structured Text that is read and written again: it does the same, scan by scan, and what ladder text says word for word is the same
//! statements.
//!
//! `LADDER_ST_AGAIN` is how many generated programs are tried of each kind.

use ladder_analysis::{Analysis, analyze, link_files};
use ladder_format::Options;
use ladder_invariants::generator::Dice;
use ladder_notations::{Outcome, Source, by_name, convert};
use ladder_simulator::{Options as Run, Simulation};
use ladder_syntax::parse;
use std::fmt::Write as _;
use std::sync::Arc;

const SCANS: usize = 12;
const INTERVAL: i64 = 10_000_000;

const DECLARED: &str = "\
FUNCTION Clamp : INT
VAR_INPUT v, low, high : INT; END_VAR
    IF v < low THEN Clamp := low; ELSIF v > high THEN Clamp := high; ELSE Clamp := v; END_IF;
END_FUNCTION

FUNCTION_BLOCK Total
VAR_INPUT go : BOOL; by1 : INT; END_VAR
VAR_OUTPUT sum : INT; full : BOOL; END_VAR
VAR before : BOOL; END_VAR
    IF go AND NOT before THEN sum := sum + by1; END_IF;
    before := go;
    full := sum > 20;
END_FUNCTION_BLOCK

PROGRAM Main
VAR
    a, b, c, d, e, f, g : BOOL;
    i, j, k, n, m, p0, p1, p2, p3 : INT;
    u, v : DINT;
    w : WORD;
    x : ARRAY[0..3] OF INT;
    t1 : TON; t2 : TOF; z1 : CTU; r1 : R_TRIG; s1 : Total;
END_VAR
";

/// What is compared, and set from outside.
const TAGS: [&str; 22] = [
    "a", "b", "c", "d", "e", "f", "g", "i", "j", "k", "n", "m", "u", "v", "w", "x[0]", "x[1]", "x[2]",
    "x[3]", "s1.sum", "s1.full", "t1.Q",
];

struct Writer {
    dice: Dice,
    text: String,
    /// Only what ladder text says word for word.
    is_plain: bool,
    /// Instances that have a call.
    called: Vec<&'static str>,
    depth: usize,
}

impl Writer {
    fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.dice.below(all.len())]
    }

    fn line(&mut self, text: &str) {
        let _ = writeln!(self.text, "{:indent$}{text}", "", indent = 4 + 4 * self.depth);
    }

    fn condition(&mut self, depth: usize) -> String {
        let plain = |it: &mut Writer| match it.dice.below(4) {
            0 => format!("NOT {}", it.of(&["a", "b", "c"])),
            1 => {
                let (left, right) = (it.of(&["i", "j", "k"]), it.dice.between(-3, 9));
                format!("{left} {} {right}", it.of(&["<", ">", "<=", ">=", "=", "<>"]))
            }
            2 if !it.is_plain => format!("w.{}", it.dice.below(16)),
            _ => it.of(&["a", "b", "c", "d"]).to_owned(),
        };
        if depth == 0 || self.dice.one_in(2) {
            return plain(self);
        }
        let (left, right) = (self.condition(depth - 1), plain(self));
        match self.dice.below(3) {
            0 if left.contains(" OR ") => format!("({left}) AND {right}"),
            0 => format!("{left} AND {right}"),
            1 => format!("{left} OR {right}"),
            _ if self.is_plain => format!("{left} OR {right}"),
            _ => format!("NOT ({left}) XOR {right}"),
        }
    }

    fn number(&mut self, depth: usize) -> String {
        if depth == 0 || self.dice.one_in(3) {
            return match self.dice.below(4) {
                0 => self.dice.between(0, 12).to_string(),
                1 if !self.is_plain => format!("x[{}]", self.dice.below(4)),
                _ => self.of(&["i", "j", "k", "n"]).to_owned(),
            };
        }
        let (left, right) = (self.number(depth - 1), self.number(0));
        if self.is_plain {
            return format!("k + {right}");
        }
        match self.dice.below(7) {
            0 => format!("({left}) * {right}"),
            1 => format!("({left}) / 3"),
            2 => format!("MAX({left}, {right})"),
            3 => format!("Clamp(v := {left}, low := -5, high := 9)"),
            4 => format!("({left}) MOD 7"),
            5 => format!("LIMIT(-20, {left}, {right})"),
            _ => format!("{left} - ({right})"),
        }
    }

    fn assignment(&mut self) {
        let text = match self.dice.below(if self.is_plain { 3 } else { 8 }) {
            0 => format!("{} := {};", self.of(&["d", "e", "f"]), self.condition(2)),
            1 | 2 => format!("{} := {};", self.of(&["i", "j", "k"]), self.number(2)),
            3 => format!("u := INT_TO_DINT({}) * 3 - v;", self.of(&["i", "k"])),
            4 => format!("x[{}] := {};", self.dice.below(4), self.number(1)),
            5 => format!("w.%B{} := INT_TO_BYTE({});", self.dice.below(2), self.number(1)),
            6 => {
                let (on, out) = (self.condition(1), self.of(&["e", "f"]));
                format!(
                    "n := ADD(EN := {on}, IN1 := {}, IN2 := k, ENO => {out});",
                    self.number(1)
                )
            }
            _ => format!("m := DINT_TO_INT(u) + INT_TO_SINT({});", self.of(&["i", "j"])),
        };
        self.line(&text);
    }

    fn call(&mut self) {
        let instance = self.of(&["t1", "t2", "z1", "r1", "s1"]);
        if self.is_plain && self.called.contains(&instance) {
            return self.assignment();
        }
        self.called.push(instance);
        let on = self.condition(1);
        let text = match instance {
            // A counter that is written is one of its own.
            "z1" if self.is_plain => return self.assignment(),
            "z1" => format!("z1(CU := {on}, R := {}, PV := 3);", self.of(&["a", "c"])),
            "r1" if self.is_plain => return self.assignment(),
            "r1" => format!("r1(CLK := {on}); g := r1.Q;"),
            "s1" if self.is_plain => return self.assignment(),
            "s1" => format!("s1(go := {on}, by1 := {}); g := s1.full;", self.number(1)),
            timer => format!("{timer}(IN := {on}, PT := T#{}ms);", 10 * self.dice.between(1, 4)),
        };
        self.line(&text);
    }

    fn statements(&mut self, count: usize) {
        for _ in 0..=self.dice.below(count) {
            self.statement();
        }
    }

    fn inner(&mut self, count: usize) {
        self.depth += 1;
        self.statements(count);
        self.depth -= 1;
    }

    fn statement(&mut self) {
        let kinds = match (self.depth, self.is_plain) {
            (3.., _) => 4,
            (_, true) => 6,
            (_, false) => 9,
        };
        match self.dice.below(kinds) {
            0..=2 => self.assignment(),
            3 => self.call(),
            4 | 5 => {
                let condition = self.condition(2);
                self.line(&format!("IF {condition} THEN"));
                if self.is_plain {
                    self.depth += 1;
                    let number = self.dice.between(0, 9);
                    let to = self.of(&["i", "j", "k"]);
                    self.line(&format!("{to} := {number};"));
                    self.depth -= 1;
                } else {
                    self.inner(3);
                    if self.dice.one_in(2) {
                        let condition = self.condition(1);
                        self.line(&format!("ELSIF {condition} THEN"));
                        self.inner(2);
                    }
                    if self.dice.one_in(2) {
                        self.line("ELSE");
                        self.inner(2);
                    }
                }
                self.line("END_IF;");
            }
            6 => {
                let selector = self.of(&["i", "j MOD 4", "k + 1"]);
                self.line(&format!("CASE {selector} OF"));
                for label in ["0, 2:", "1:", "3..5:"] {
                    self.line(label);
                    self.inner(2);
                }
                self.line("ELSE");
                self.inner(2);
                self.line("END_CASE;");
            }
            7 => {
                let (first, more) = (self.dice.below(2), self.dice.below(3));
                let counted = ["p0", "p1", "p2", "p3"][self.depth];
                self.line(&format!("FOR {counted} := {first} TO {} DO", 2 + more));
                self.inner(2);
                self.line("END_FOR;");
            }
            _ => {
                self.line("IF a AND_THEN x[ABS(i MOD 4)] > 2 THEN k := 1; END_IF;");
            }
        }
    }
}

fn generated(seed: u64, is_plain: bool) -> String {
    let mut writer = Writer {
        dice: Dice::new(seed),
        text: DECLARED.to_owned(),
        is_plain,
        called: Vec::new(),
        depth: 0,
    };
    writer.statements(8);
    writer.text + "END_PROGRAM\n"
}

/// The ladder text of a program that is read without a loss.
fn read(text: &str) -> Result<Analysis, String> {
    let notation = by_name("st").expect("it is known");
    let source = Source::alone("main", text.as_bytes());
    let read = convert(notation, &source, &Options::default()).map_err(|error| error.to_string())?;
    if let Some(entry) = (read.report.entries.iter()).find(|entry| entry.outcome != Outcome::Translated)
        && !entry.element.starts_with("variable")
    {
        return Err(format!("{entry:?}"));
    }
    let analysis = analyze(&Arc::new(parse(&read.written.text)), "main.clad");
    let error = analysis
        .errors()
        .next()
        .map(|error| format!("{error:?}\n{}", read.written.text));
    error.map_or(Ok(analysis), Err)
}

fn written(analysis: &Analysis) -> Result<String, String> {
    let linked = link_files(&Arc::new(analysis.clone()), &|_| None).map_err(|why| format!("{why:?}"))?;
    let writing = by_name("st")
        .expect("it is known")
        .write(&analysis.with_others(linked));
    let bytes = writing.map_err(|error| error.to_string())?.bytes;
    String::from_utf8(bytes).map_err(|error| error.to_string())
}

fn simulation(analysis: &Analysis) -> Result<Simulation, String> {
    let linked = link_files(&Arc::new(analysis.clone()), &|_| None).map_err(|why| format!("{why:?}"))?;
    let options = Run {
        interval: INTERVAL,
        watchdog: 100_000,
    };
    Simulation::new(linked.program, options).map_err(|error| error.message)
}

/// Runs both, with the same inputs.
fn compare(first: &Analysis, again: &Analysis, seed: u64) -> Result<(), String> {
    let (mut first, mut again) = (simulation(first)?, simulation(again)?);
    let mut dice = Dice::new(seed ^ 0x5EED);
    for scan in 0..SCANS {
        for name in &TAGS[..19] {
            if scan > 0 && !dice.one_in(4) {
                continue;
            }
            let number = dice.between(-4, 12);
            for simulation in [&mut first, &mut again] {
                let point = simulation.resolve(name).map_err(|_| format!("no {name}"))?;
                let value = match point.ty {
                    ladder_analysis::values::types::Scalar::Bool => {
                        ladder_analysis::values::value::Value::Bool(number > 4)
                    }
                    ladder_analysis::values::types::Scalar::Word => {
                        ladder_analysis::values::value::Value::Int(number.abs() * 4097)
                    }
                    _ => ladder_analysis::values::value::Value::Int(number),
                };
                simulation
                    .set(&point, value)
                    .map_err(|why| format!("{name}: {why:?}"))?;
            }
        }
        first.scan();
        again.scan();
        for name in TAGS {
            let (Ok(of_first), Ok(of_again)) = (first.resolve(name), again.resolve(name)) else {
                return Err(format!("no {name}"));
            };
            let (was, is) = (first.value(&of_first), again.value(&of_again));
            if was != is {
                return Err(format!("scan {scan}: {name} is {was:?}, and {is:?} again"));
            }
        }
    }
    Ok(())
}

/// The statements of the program, each on a line, without comments.
fn statements(text: &str) -> String {
    let body = &text[text
        .find("PROGRAM Main")
        .or(text.find("PROGRAM main"))
        .unwrap_or(0)..];
    let body = &body[body.rfind("END_VAR").map_or(0, |at| at + "END_VAR".len())..];
    let mut plain = String::new();
    let mut rest = body;
    while let Some(at) = rest.find("(*") {
        plain.push_str(&rest[..at]);
        rest = rest[at..].split_once("*)").map_or("", |(_, rest)| rest);
    }
    plain.push_str(rest);
    let words: Vec<&str> = plain.split_whitespace().collect();
    words.join(" ").replace("; ", ";\n").replace("THEN ", "THEN\n")
}

fn programs() -> u64 {
    let given = std::env::var("LADDER_ST_AGAIN").ok();
    given.and_then(|number| number.parse().ok()).unwrap_or(60)
}

#[test]
fn what_is_read_and_written_again_does_the_same() {
    let mut wrong = Vec::new();
    for seed in 0..programs() {
        let text = generated(seed, false);
        let tried = read(&text).and_then(|first| {
            let again = written(&first)?;
            let read = read(&again).map_err(|why| format!("again: {why}\n{again}"))?;
            compare(&first, &read, seed)
        });
        if let Err(why) = tried {
            wrong.push(format!("seed {seed}: {why}\n{text}"));
        }
    }
    let shown: Vec<&str> = wrong.iter().filter_map(|wrong| wrong.lines().next()).collect();
    assert!(
        wrong.is_empty(),
        "{} programs\n{}\n{}",
        wrong.len(),
        shown.join("\n"),
        wrong[0]
    );
}

#[test]
fn plain_statements_are_the_same_again() {
    let mut wrong = Vec::new();
    for seed in 0..programs() {
        let text = generated(seed, true);
        let again = read(&text).and_then(|first| written(&first));
        match again {
            Ok(again) if statements(&again) == statements(&text) => {}
            Ok(again) => wrong.push(format!(
                "seed {seed}:\n{}\n{}",
                statements(&text),
                statements(&again)
            )),
            Err(why) => wrong.push(format!("seed {seed}: {why}\n{text}")),
        }
    }
    let shown: Vec<&str> = wrong.iter().filter_map(|wrong| wrong.lines().next()).collect();
    assert!(
        wrong.is_empty(),
        "{} programs\n{}\n{}",
        wrong.len(),
        shown.join("\n"),
        wrong[0]
    );
}
