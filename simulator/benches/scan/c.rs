//! The program as C, compiled and run.

use crate::sketch::{Sketch, Type};
use crate::{BATCHES, Run};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

/// What the networks are written in. Time is in nanoseconds, as in the simulator.
const PRELUDE: &str = r"
#define _POSIX_C_SOURCE 199309L
#include <inttypes.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#define MS INT64_C(1000000)
static int64_t now;

struct timer { bool in, q, r, running; int64_t pt, et, since; };
static inline bool ton(struct timer *t, bool en, int64_t pt) {
  bool in = en && !t->r;
  t->in = in; t->pt = pt;
  if (!in) { t->running = false; t->q = false; t->et = 0; return false; }
  if (!t->running) { t->running = true; t->since = now; }
  int64_t et = now - t->since;
  if (et >= pt) t->q = true;
  t->et = et < pt ? et : pt;
  return t->q;
}
static inline bool tof(struct timer *t, bool en, int64_t pt) {
  bool in = en && !t->r;
  t->in = in; t->pt = pt;
  if (t->r) { t->running = false; t->q = false; t->et = 0; return false; }
  if (in) { t->running = true; t->q = true; t->et = 0; t->since = -1; return true; }
  if (!t->running) return t->q = false;
  if (t->since < 0) t->since = now;
  int64_t et = now - t->since;
  t->et = et < pt ? et : pt;
  t->q = et < pt;
  if (!t->q) t->running = false;
  return t->q;
}

struct counter { bool cu, r, q, before, changed; int64_t pv, cv; };
static inline bool ctu(struct counter *c, bool en, bool r, int64_t pv) {
  int64_t cv = c->cv;
  c->cu = en; c->r = r; c->pv = pv;
  if (r) cv = 0;
  else if (en && !c->before && cv < INT32_MAX) cv++;
  c->before = en;
  c->changed = cv != c->cv;
  c->cv = cv;
  return c->q = cv >= pv;
}

static uint64_t hash = UINT64_C(14695981039346656037);
static void show(uint64_t word) {
  hash = (hash ^ word) * UINT64_C(1099511628211);
}
static void show_real(double real) { uint64_t bits; memcpy(&bits, &real, 8); show(bits); }
";

/// The time is taken by the program itself.
const MAIN: &str = r#"
int main(int count, char **words) {
  uint64_t scans = strtoull(words[1], 0, 10);
  uint32_t dice = 7;
  uint64_t fastest = UINT64_MAX;
  for (int batch = atoi(words[2]); batch > 0; batch--) {
    struct timespec begin, end;
    clock_gettime(CLOCK_MONOTONIC, &begin);
    for (uint64_t n = 0; n < scans; n++) {
      dice = dice * 1103515245u + 12345u;
      *inputs[(dice >> 8) % INPUTS] ^= 1;
      scan();
      now += 10 * MS;
    }
    clock_gettime(CLOCK_MONOTONIC, &end);
    uint64_t time = (end.tv_sec - begin.tv_sec) * UINT64_C(1000000000) + end.tv_nsec - begin.tv_nsec;
    if (time < fastest) fastest = time;
  }
  show_all();
  printf("%" PRIu64 " %" PRIu64 "\n", fastest, hash);
  return 0;
}
"#;

/// Networks in one function: a compiler does not like one with all of them.
const IN_ONE: usize = 60;

/// A program that was compiled.
pub(crate) struct Compiled {
    program: PathBuf,
}

impl Compiled {
    /// Writes the C and compiles it, if there is a compiler.
    pub(crate) fn new(sketch: &Sketch, powers: bool, folder: &Path) -> Option<Compiled> {
        let source = folder.join("program.c");
        std::fs::write(&source, text(sketch, powers)).expect("there is room for the C");
        let program = folder.join("program");
        let compiled = Command::new("gcc")
            .args(["-std=c11", "-O2", "-fwrapv", "-w", "-o"])
            .args([&program, &source])
            .status()
            .ok()?;
        assert!(compiled.success(), "gcc refuses the C");
        Some(Compiled { program })
    }

    pub(crate) fn run(&self, scans: u64) -> Run {
        let output = Command::new(&self.program)
            .args([scans.to_string(), BATCHES.to_string()])
            .output()
            .expect("it was just compiled");
        let told = String::from_utf8(output.stdout).expect("it writes numbers");
        let mut numbers = told
            .split_whitespace()
            .map(|n| n.parse::<u64>().expect("it writes numbers"));
        let (time, state) = (numbers.next(), numbers.next());
        Run {
            scan: Duration::from_nanos(time.expect("its time")) / scans as u32,
            state: state.expect("its state"),
        }
    }
}

fn text(sketch: &Sketch, powers: bool) -> String {
    let mut text = String::from(PRELUDE);
    for tag in &sketch.tags {
        let ty = match tag.ty {
            Type::Bool => "bool",
            Type::Dint => "int32_t",
            Type::Lreal => "double",
            Type::Ton | Type::Tof => "struct timer",
            Type::Ctu => "struct counter",
        };
        let _ = writeln!(text, "static {ty} {};", tag.name);
    }
    if powers {
        let _ = writeln!(text, "bool power[{}];", sketch.powers);
        text.push_str("#define KEEP(n) power[n] = p##n;\n");
    } else {
        text.push_str("#define KEEP(n)\n");
    }
    let mut calls = String::new();
    for (n, networks) in sketch.c.chunks(IN_ONE).enumerate() {
        let _ = writeln!(text, "__attribute__((noinline)) static void part{n}(void) {{");
        for network in networks {
            text.push_str(network);
        }
        text.push_str("}\n");
        let _ = writeln!(calls, "  part{n}();");
    }
    let _ = writeln!(text, "static void scan(void) {{\n{calls}}}");
    let inputs: Vec<String> = sketch
        .inputs
        .iter()
        .map(|&input| format!("&{}", sketch.tags[input].name))
        .collect();
    let _ = writeln!(text, "#define INPUTS {}", inputs.len());
    let _ = writeln!(text, "static bool *inputs[] = {{ {} }};", inputs.join(", "));
    text.push_str("static void show_all(void) {\n");
    for tag in &sketch.tags {
        let name = &tag.name;
        let _ = match tag.ty {
            Type::Bool | Type::Dint => writeln!(text, "  show({name});"),
            Type::Lreal => writeln!(text, "  show_real({name});"),
            Type::Ton | Type::Tof => writeln!(text, "  show({name}.q); show({name}.et);"),
            Type::Ctu => writeln!(text, "  show({name}.q); show({name}.cv);"),
        };
    }
    text.push_str("}\n");
    text.push_str(MAIN);
    text
}
