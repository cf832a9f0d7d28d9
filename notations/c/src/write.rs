//! From a program to its two files.

use crate::code::{self, Body, nesting};
use crate::constants::Constants;
use crate::interface::{self, Field, Interface};
use crate::pieces::PIECES;
use crate::{data, header, names, retained};
use ladder_analysis::Analysis;
use ladder_analysis::program::{Clock, Location};
use ladder_notation::{Companion, LineColumn, Lines, Report, WriteError, Writing, no_program};
use ladder_simulator::compiled::{CHANNELS, Compiled, Word, compile};
use std::collections::BTreeSet;
use std::fmt::Write;

/// The time from one scan to the next that a program is made for which does not say so, in nanoseconds: what some
/// instructions of other systems count in.
const INTERVAL: i64 = 10_000_000;

/// Types as the runtime names them, by their place in the simulator's list.
const TYPES: &str = "enum {\n    TYPE_BOOL = 0, TYPE_LWORD = 4, TYPE_LINT = 8, TYPE_ULINT = 12, TYPE_REAL = 13, TYPE_LREAL = 14, TYPE_TIME = 15,\n    TYPE_STRING = 19\n};\n\n";

/// Writes the library.
pub(crate) fn write(analysis: &Analysis) -> Result<Writing, WriteError> {
    let text = analysis.context.parse.to_string();
    let program = analysis.program().ok_or_else(|| no_program(analysis, &text))?;
    let compiled = compile(program, program.cycle.unwrap_or(INTERVAL))
        .map_err(|error| WriteError::new(error.message))?;
    let lines = Lines::of(&text);
    let place = |location: Location| match location.file {
        0 => lines.place(&text, location.range.start().into()),
        _ => LineColumn::START,
    };
    let comment = |network: usize| {
        let network = program.networks.get(network)?;
        let rungs = (network.location.file == 0).then(|| &text[network.location.range])?;
        Some(
            rungs
                .lines()
                .flat_map(|line| {
                    [
                        "    /* ".into(),
                        header::comment(line),
                        " */
"
                        .into(),
                    ]
                })
                .collect(),
        )
    };
    // The file that is written may be called otherwise than the program.
    let file = &*analysis.context.name;
    let file = file.strip_suffix(".clad").unwrap_or(file);
    let stem = file.rsplit('/').next().unwrap_or(file);
    let name = names::library(stem);
    let interface = interface::interface(&name, program, &compiled);
    let constants = Constants::of(&name, &interface);
    let body = code::body(&compiled, &constants, comment, &|location| {
        place(location).line + 1
    });
    let mut report = Report::default();
    for network in &program.networks {
        if network.location.file == 0 {
            report.translated(place(network.location), "network");
        }
    }
    if let Some((at, what)) = body.missing.first() {
        let block = compiled
            .code
            .blocks
            .iter()
            .rfind(|block| block.start <= *at && *at < block.end);
        let place = match block.map(|block| block.location) {
            Some(location) if location.file == 0 => format!("{}: ", place(location)),
            Some(location) => format!("in {}: ", program.files[location.file as usize]),
            None => String::new(),
        };
        return Err(WriteError::new(format!(
            "{place}a C library does not have {what}; take this block out, or write the program in another notation"
        )));
    }
    for part in &compiled.code.unread {
        let at = part.location.map_or(LineColumn::START, place);
        let why = "what it does is not known: a scan runs past it";
        report.approximated(at, format!("unread part {}", part.name), why);
    }
    // The header is called as the source is, but for what cannot stand in an `#include`.
    let is_plain = |c: char| !c.is_control() && !"\"\\<>:?".contains(c);
    let header = if !stem.is_empty() && stem.chars().all(is_plain) {
        stem
    } else {
        &name
    };
    Ok(Writing {
        bytes: source(&name, header, &interface, &compiled, &body).into_bytes(),
        companions: vec![Companion {
            name: format!("{header}.h"),
            bytes: header::header(&name, &interface, &constants, &compiled).into(),
        }],
        report,
    })
}

fn source(p: &str, header: &str, interface: &Interface, compiled: &Compiled, body: &Body) -> String {
    let upper = p.to_ascii_uppercase();
    let mut used: BTreeSet<&'static str> = body.used.clone();
    for field in interface.inputs.iter().chain(&interface.outputs) {
        used.extend(field.needs());
    }
    let retained = retained::functions(p, compiled);
    let needed = ["minus_held", "plus_held", "set_text", "text_of"];
    used.extend(needed.iter().filter(|piece| retained.contains(**piece)));
    let before = before(compiled, body);
    if before.contains("mod_floor") {
        used.insert("mod_floor");
    }
    let has_operands = body.says("operands + ");
    let runtime = PIECES.text(&used);
    let mut out = format!("/* The ladder program {p}; see its header. */\n#include \"{header}.h\"\n\n");
    for (header, sign) in [
        ("inttypes.h", "PRI"),
        ("math.h", "("),
        ("stdio.h", "snprintf"),
        ("stdlib.h", "strto"),
        ("string.h", "("),
    ] {
        if sign == "(" || runtime.contains(sign) {
            let _ = writeln!(out, "#include <{header}>");
        }
    }
    let _ = write!(out, "\ntypedef {p} state;\n\n");
    if runtime.contains("TYPE_") {
        out.push_str(TYPES);
    }
    out.push_str(&header::faults(&upper));
    out.push_str(&data::tables(
        compiled,
        has_operands,
        runtime.contains("text_room"),
    ));
    out.push_str(&runtime);
    if body.says("frame") {
        let loops = match nesting(&compiled.code) {
            0 => String::new(),
            most => format!(
                " uint32_t loops; struct {{ uint32_t body, after; int64_t left, turn; }} loop[{most}];"
            ),
        };
        let _ = write!(
            out,
            "/* What a call, or the body of a block, has of its own. */\ntypedef struct {{ uint32_t back; bool rail; int64_t noted;{loops} }} frame_of;\n\n",
        );
    }
    if body.says("note(") || body.says("goto stopped") {
        out.push_str(
            "static void note(state *self, int fault, uint32_t line)\n{\n    self->fault = fault;\n    self->fault_line = line;\n    self->faults++;\n    self->faulted = true;\n}\n\n",
        );
    }
    out.push_str(&retained);
    out.push_str(&transfers(interface));
    let _ = write!(out, "void {p}_init({p} *self)\n{{\n    uint32_t n;\n");
    out.push_str(
        "    memset(&self->in, 0, sizeof self->in);\n    memset(&self->out, 0, sizeof self->out);\n    self->ended = self->stopped = self->faulted = false;\n    self->faults = self->scans = self->fault_line = 0;\n    self->fault = 0;\n    self->now = self->began = 0;\n    memset(self->b, 0, sizeof self->b);\n    memset(self->w, 0, sizeof self->w);\n",
    );
    if data::sizes(compiled).texts > 0 {
        // Compilers warn of a table that no statement uses.
        out.push_str("    (void)text_at;\n    memset(self->length, 0, sizeof self->length);\n");
    }
    out.push_str(&data::start(compiled));
    out.push_str("    show_inputs(self);\n}\n\n");
    let _ = write!(out, "bool {p}_scan({p} *self, int64_t now)\n{{\n{}", body.locals);
    out.push_str(&before);
    out.push_str(&used_labels(&body.text));
    out.push_str("\ndone:;\n");
    out.push_str(&after(compiled));
    out.push_str("    put_outputs(self);\n    self->scans++;\n    return true;\n");
    if body.says("goto stopped") {
        out.push_str(
            "stopped:\n    note(self, FAULT_ENDLESS, 0);\n    self->stopped = true;\n    return false;\n",
        );
    }
    out.push_str("}\n");
    out
}

/// Without the labels that nothing goes to.
fn used_labels(text: &str) -> String {
    let targets: BTreeSet<&str> = text
        .split("goto ")
        .skip(1)
        .filter_map(|rest| rest.split(';').next())
        .collect();
    let is_used = |line: &&str| {
        line.strip_suffix(":;")
            .is_none_or(|label| targets.contains(label))
    };
    text.lines()
        .filter(is_used)
        .flat_map(|line| {
            [
                line, "
",
            ]
        })
        .collect()
}

/// The functions that copy between the structures and the memory.
fn transfers(interface: &Interface) -> String {
    let takes = interface.inputs.iter().map(Field::take).collect();
    let shows = interface.inputs.iter().map(Field::show).collect();
    let puts = interface.outputs.iter().map(Field::put).collect();
    [
        transfer("take_inputs", takes),
        "/* Inputs begin as the program declares them. */\n".into(),
        transfer("show_inputs", shows),
        transfer("put_outputs", puts),
    ]
    .concat()
}

fn transfer(name: &str, statements: String) -> String {
    let counter = if statements.contains("for (n") {
        "    uint32_t n;\n"
    } else {
        ""
    };
    let statements = if statements.is_empty() {
        "    (void)self;\n".into()
    } else {
        statements
    };
    format!("static void {name}(state *self)\n{{\n{counter}{statements}}}\n\n")
}

/// What comes before the first network: the clock, the inputs, the tags of `SYS`.
fn before(compiled: &Compiled, body: &Body) -> String {
    let mut out = String::from(
        "    if (self->ended || self->stopped) return false;\n    if (self->scans == 0) self->began = now;\n    w[2] = self->scans == 0 ? 0 : now - self->began - self->now;\n    self->now = now - self->began;\n    w[1] = self->now;\n    w[0] = (int32_t)self->scans;\n    b[1] = 1;\n    b[2] = self->scans == 0;\n    b[3] = self->faulted;\n    self->faulted = false;\n",
    );
    // No tag that is found by an index is one of them.
    let asks = |at: usize| body.says(&format!("b[{at}]"));
    for (at, clock) in (4..).zip(Clock::ALL).filter(|(at, _)| asks(*at)) {
        let period = clock.period();
        let _ = writeln!(
            out,
            "    b[{at}] = mod_floor(self->now, {}) >= {};",
            data::number(period),
            data::number(period / 2)
        );
    }
    out.push_str("    take_inputs(self);\n");
    if let Some(Word(base)) = compiled.ports.analog {
        let _ = writeln!(
            out,
            "    if (self->analog != NULL) {{\n        uint32_t n;\n        for (n = 0; n < {CHANNELS}; n++) w[{base} + n] = self->analog(self->user, n);\n    }}"
        );
    }
    out
}

/// What comes after the last one.
fn after(compiled: &Compiled) -> String {
    let Some(Word(base)) = compiled.ports.pulse else {
        return String::new();
    };
    format!(
        "    if (self->pulse != NULL) {{\n        uint32_t n;\n        for (n = 0; n < {CHANNELS}; n++) self->pulse(self->user, n, w[{base} + n], w[{} + n]);\n    }}\n",
        base + CHANNELS
    )
}
