//! The simulator's flat code as C statements.

mod arithmetic;
mod flow;
mod instr;
mod powers;
mod states;
mod term;

use crate::constants::Constants;
use ladder_analysis::program::Location;
use ladder_simulator::compiled::{Bit, CALL_DEPTH, Code, Compiled, Instr, Test, Width, Word};
use powers::Powers;
use std::cell::RefCell;
use std::collections::{BTreeSet, HashMap, HashSet};
use std::fmt::Write;
use term::Pending;

/// How often a scan may jump back or call before it is stopped.
const MOST_TURNS: u32 = 1_000_000;

/// The body of the function that runs a scan, and what it needs.
#[derive(Debug, Default)]
pub(crate) struct Body {
    pub(crate) text: String,
    /// What it begins with.
    pub(crate) locals: String,
    /// Pieces of the runtime.
    pub(crate) used: BTreeSet<&'static str>,
    /// What C does not have: the instruction, and what it needs.
    pub(crate) missing: Vec<(u32, &'static str)>,
}

impl Body {
    /// Whether a statement has this; what is in the drawing above it does not count.
    pub(crate) fn says(&self, what: &str) -> bool {
        let mut statements = self.text.lines().filter(|line| !line.starts_with("    /*"));
        statements.any(|line| line.contains(what))
    }
}

/// Translates all instructions. `comment` is what is above the network of a number.
///
/// `line` is the line of the program that a block is on.
pub(crate) fn body(
    compiled: &Compiled,
    constants: &Constants,
    comment: impl Fn(usize) -> Option<String>,
    line: &dyn Fn(Location) -> u32,
) -> Body {
    let code = &compiled.code;
    let is = |wanted: fn(&Instr) -> bool| code.instrs.iter().any(wanted);
    let calls = is(|instr| matches!(instr, Instr::Call { .. }));
    let loops = nesting(code) > 0;
    let zones = is(|instr| matches!(instr, Instr::Mcr { .. }));
    let powers = Powers::of(compiled);
    let mut emitter = Emitter {
        code,
        line_of: line,
        body: Body::default(),
        calls,
        loops,
        zones,
        goes_back: false,
        labels: labels(code, calls),
        constants,
        literals: &compiled.literals,
        always: powers.always(code, zones),
        once: powers.read(1),
        unread: powers.read(0),
        pending: RefCell::default(),
    };
    emitter.all(comment);
    emitter.body.locals = locals(&emitter.body, code, calls, loops, zones);
    emitter.body
}

/// The variables of the function: those that its statements may name.
fn locals(body: &Body, code: &Code, calls: bool, loops: bool, zones: bool) -> String {
    let mut locals = String::from("    uint8_t *const b = self->b;\n    int64_t *const w = self->w;\n");
    for (name, declaration) in [
        ("(fault =", "int fault"),
        ("&held", "int64_t held"),
        ("++turns", "uint32_t turns"),
    ] {
        if body.says(name) {
            let _ = writeln!(locals, "    {declaration} = 0;");
        }
    }
    if calls || loops || zones {
        let each = 1 + depth(code);
        let frames = if calls { (CALL_DEPTH + 1) * each } else { each };
        let _ = write!(
            locals,
            "    const frame_of fresh = {{0, true, 0{}}};\n    frame_of frame = fresh;\n    frame_of frames[{frames}];\n    \
             uint32_t open = 0, to = 0;\n    (void)frame;\n    (void)frames;\n    (void)open;\n    (void)to;\n",
            if loops { ", 0, {{0, 0, 0, 0}}" } else { "" }
        );
    }
    if calls {
        let widest = code.saved.iter().map(Vec::len).max().unwrap_or(0);
        locals.push_str("    uint32_t depth = 0;\n");
        if widest > 0 {
            let _ = write!(
                locals,
                "    uint8_t saved[{}];\n    uint32_t kept = 0;\n",
                CALL_DEPTH * widest
            );
        }
    }
    locals
}

/// How many loops lie in each other at most.
pub(crate) fn nesting(code: &Code) -> usize {
    let (mut open, mut most) = (0_usize, 0);
    for instr in &code.instrs {
        match instr {
            Instr::Enter { .. } => open += 1,
            Instr::Again { .. } => open = open.saturating_sub(1),
            _ => {}
        }
        most = most.max(open);
    }
    most
}

/// How many bodies of blocks lie in each other at most.
fn depth(code: &Code) -> usize {
    let (mut open, mut most) = (0_usize, 0);
    for instr in &code.instrs {
        match instr {
            Instr::EnterBody => open += 1,
            Instr::LeaveBody => open = open.saturating_sub(1),
            _ => {}
        }
        most = most.max(open);
    }
    most
}

/// The instructions that others go on at.
fn labels(code: &Code, calls: bool) -> BTreeSet<u32> {
    let mut labels = BTreeSet::new();
    for (at, instr) in code.instrs.iter().enumerate() {
        instr.for_each_target(|to| {
            labels.insert(to);
        });
        if calls && matches!(instr, Instr::Call { .. }) {
            labels.insert(at as u32 + 1);
        }
        if instr.can_fault() {
            labels.insert(code.blocks[code.block_at(at as u32) as usize].end);
        }
    }
    labels
}

struct Emitter<'c> {
    code: &'c Code,
    line_of: &'c dyn Fn(Location) -> u32,
    body: Body,
    calls: bool,
    loops: bool,
    zones: bool,
    /// Something ends in `go_back`.
    goes_back: bool,
    labels: BTreeSet<u32>,
    constants: &'c Constants,
    literals: &'c HashMap<Word, i64>,
    /// The bits that have power whenever they are read.
    always: HashSet<Bit>,
    /// The bits that are part of the expression which reads them.
    once: HashSet<Bit>,
    /// Those that nothing reads.
    unread: HashSet<Bit>,
    pending: RefCell<Vec<Pending>>,
}

fn operator(test: Test) -> &'static str {
    match test {
        Test::EQ => "==",
        Test::NE => "!=",
        Test::GT => ">",
        Test::GE => ">=",
        Test::LT => "<",
        _ => "<=",
    }
}

/// Bits, negative where it is unsigned.
fn width(width: Width) -> i32 {
    match width {
        Width::I8 => 8,
        Width::I16 => 16,
        Width::I32 => 32,
        Width::I64 => 64,
        Width::U8 => -8,
        Width::U16 => -16,
        Width::U32 => -32,
        Width::U64 => -64,
    }
}

impl Emitter<'_> {
    fn line(&mut self, text: impl AsRef<str>) {
        self.flush();
        self.write_line(text.as_ref());
    }

    fn write_line(&mut self, text: &str) {
        let _ = writeln!(self.body.text, "    {text}");
    }

    /// A word that holds a whole number, for one who reads it.
    fn number(&self, word: Word) -> String {
        let literal = self.literals.get(&word);
        literal.map_or_else(|| self.w(word), |value| crate::data::number(*value))
    }

    /// A word.
    fn w(&self, word: Word) -> String {
        format!("w[{}]", self.constants.word(word))
    }

    fn uses(&mut self, piece: &'static str) -> &'static str {
        self.body.used.insert(piece);
        piece
    }

    fn all(&mut self, comment: impl Fn(usize) -> Option<String>) {
        let mut places = self.code.networks.iter().peekable();
        for at in 0..self.code.instrs.len() as u32 {
            while let Some(place) = places.next_if(|place| place.start <= at) {
                self.flush();
                if let Some(comment) = comment(place.network as usize) {
                    self.body.text.push('\n');
                    self.body.text.push_str(&comment);
                }
            }
            self.label(at);
            let instr = self.code.instrs[at as usize];
            self.instr(at, instr);
        }
        self.flush();
        self.label(self.code.instrs.len() as u32);
        if self.goes_back {
            self.body.text.push_str(&self.going_back());
        }
    }

    fn label(&mut self, at: u32) {
        if self.labels.contains(&at) {
            self.flush();
            let _ = writeln!(self.body.text, "L{at}:;");
        }
    }

    /// A call that may fault: then the block has no power, and what follows it goes on.
    fn faulting(&mut self, at: u32, call: &str) {
        let block = &self.code.blocks[self.code.block_at(at) as usize];
        let line = (self.line_of)(block.location);
        let out = if block.out == Bit::LOW || block.out == Bit::HIGH {
            String::new()
        } else {
            format!("{} = 0; ", self.slot(block.out))
        };
        self.line(format!(
            "if ((fault = {call}) != 0) {{ note(self, fault, {line}); {out}goto L{}; }}",
            block.end
        ));
    }

    fn bit(&mut self, to: Bit, value: impl AsRef<str>) {
        self.line(format!("{} = {};", self.slot(to), value.as_ref()));
    }
}
