//! The simulator's flat code as C statements.

mod arithmetic;
mod flow;
mod states;

use crate::pieces::PIECES;
use ladder_analysis::program::Location;
use ladder_analysis::values::compound::EnumId;
use ladder_simulator::compiled::{Bit, CALL_DEPTH, Code, Compiled, Instr, Routine, TYPES, Test, Width, Word};
use std::collections::BTreeSet;
use std::fmt::Write;

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
    /// What C does not have: the instruction, and what it is.
    pub(crate) missing: Vec<(u32, String)>,
}

impl Body {
    /// Whether a statement has this; what stands in the drawing above it does not count.
    pub(crate) fn says(&self, what: &str) -> bool {
        let mut statements = self.text.lines().filter(|line| !line.starts_with("    /*"));
        statements.any(|line| line.contains(what))
    }
}

/// Translates all instructions. `comment` is what stands above the network of a number.
///
/// `line` is the line of the program that a block is on.
pub(crate) fn body(
    compiled: &Compiled,
    comment: impl Fn(usize) -> Option<String>,
    line: &dyn Fn(Location) -> u32,
) -> Body {
    let code = &compiled.code;
    let is = |wanted: fn(&Instr) -> bool| code.instrs.iter().any(wanted);
    let calls = is(|instr| matches!(instr, Instr::Call { .. }));
    let loops = is(|instr| matches!(instr, Instr::For { .. }));
    let zones = is(|instr| matches!(instr, Instr::Mcr { .. }));
    let mut emitter = Emitter {
        code,
        line_of: line,
        body: Body::default(),
        calls,
        loops,
        zones,
        goes_back: false,
        labels: labels(code, calls),
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
            "    const frame_of fresh = {{0, true, 0, 0, 0, 0, 0}};\n    frame_of frame = fresh;\n    frame_of frames[{frames}];\n    \
             uint32_t open = 0, to = 0;\n    (void)frame;\n    (void)frames;\n    (void)open;\n    (void)to;\n"
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
}

fn b(bit: Bit) -> String {
    match bit {
        Bit::LOW => "0".into(),
        Bit::HIGH => "1".into(),
        Bit(at) => format!("b[{at}]"),
    }
}

fn w(word: Word) -> String {
    format!("w[{}]", word.0)
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
        let _ = writeln!(self.body.text, "    {}", text.as_ref());
    }

    fn uses(&mut self, piece: &'static str) -> &'static str {
        self.body.used.insert(piece);
        piece
    }

    fn all(&mut self, comment: impl Fn(usize) -> Option<String>) {
        let mut places = self.code.networks.iter().peekable();
        for at in 0..self.code.instrs.len() as u32 {
            while let Some(place) = places.next_if(|place| place.start <= at) {
                if let Some(comment) = comment(place.network as usize) {
                    self.body.text.push('\n');
                    self.body.text.push_str(&comment);
                }
            }
            self.label(at);
            let instr = self.code.instrs[at as usize];
            self.instr(at, instr);
        }
        self.label(self.code.instrs.len() as u32);
        if self.goes_back {
            self.body.text.push_str(&self.going_back());
        }
    }

    fn label(&mut self, at: u32) {
        if self.labels.contains(&at) {
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
            format!("{} = 0; ", b(block.out))
        };
        self.line(format!(
            "if ((fault = {call}) != 0) {{ note(self, fault, {line}); {out}goto L{}; }}",
            block.end
        ));
    }

    fn bit(&mut self, to: Bit, value: impl AsRef<str>) {
        self.line(format!("b[{}] = {};", to.0, value.as_ref()));
    }

    /// A comparison of something with itself, of which compilers warn. No tag holds what is not equal to itself.
    fn same(&mut self, test: Test, out: Bit, en: Bit) {
        let holds = [Test::EQ, Test::GE, Test::LE].contains(&test);
        self.bit(out, if holds { b(en) } else { "0".into() });
    }

    fn powered_by(&mut self, out: Bit, en: Bit) {
        self.bit(out, b(en));
    }

    #[allow(clippy::too_many_lines, reason = "one line for each instruction")]
    fn instr(&mut self, at: u32, instr: Instr) {
        match instr {
            Instr::Contact { out, en, tag } => self.bit(out, format!("{} & {}", b(en), b(tag))),
            Instr::NegatedContact { out, en, tag } => {
                self.bit(out, format!("(uint8_t)({} & ({} ^ 1))", b(en), b(tag)));
            }
            Instr::Join { out, upper, lower } => self.bit(out, format!("{} | {}", b(upper), b(lower))),
            Instr::Invert { out, en } => self.bit(out, format!("{} ^ 1", b(en))),
            Instr::Follow { out, en } => self.bit(out, b(en)),
            Instr::Rail { out } => {
                let rail = if self.zones { "frame.rail" } else { "1" };
                self.bit(out, rail);
            }
            Instr::Rising { out, en, tag, before } => {
                let piece = self.uses("rising");
                self.bit(out, format!("{piece}({}, {}, &b[{}])", b(en), b(tag), before.0));
            }
            Instr::Falling { out, en, tag, before } => {
                let piece = self.uses("falling");
                self.bit(out, format!("{piece}({}, {}, &b[{}])", b(en), b(tag), before.0));
            }
            Instr::Compare {
                test,
                out,
                en,
                a,
                b: other,
            }
            | Instr::CompareReal {
                test,
                out,
                en,
                a,
                b: other,
            } if a == other => {
                self.same(test, out, en);
            }
            Instr::CompareBit {
                test,
                out,
                en,
                a,
                b: other,
            } if a == other => self.same(test, out, en),
            Instr::Compare {
                test,
                out,
                en,
                a,
                b: other,
            } => {
                self.bit(
                    out,
                    format!("{} & ({} {} {})", b(en), w(a), operator(test), w(other)),
                );
            }
            Instr::CompareUnsigned {
                test,
                a_unsigned,
                b_unsigned,
                out,
                en,
                a,
                b: other,
            } => {
                self.uses("order");
                let order = format!("order({}, {a_unsigned}, {}, {b_unsigned})", w(a), w(other));
                self.bit(out, format!("{} & ({order} {} 0)", b(en), operator(test)));
            }
            Instr::CompareReal {
                test,
                out,
                en,
                a,
                b: other,
            } => {
                self.uses("to_real");
                let (a, other) = (format!("to_real({})", w(a)), format!("to_real({})", w(other)));
                self.bit(out, format!("{} & ({a} {} {other})", b(en), operator(test)));
            }
            Instr::CompareBit {
                test,
                out,
                en,
                a,
                b: other,
            } => {
                self.bit(
                    out,
                    format!("{} & ({} {} {})", b(en), b(a), operator(test), b(other)),
                );
            }
            Instr::CompareText {
                test,
                out,
                en,
                a,
                b: other,
            } => {
                self.uses("text_order");
                let order = format!("text_order(self, {}, {})", a.0, other.0);
                self.bit(out, format!("{} & ({order} {} 0)", b(en), operator(test)));
            }
            Instr::Coil { en, tag } => self.bit(tag, b(en)),
            Instr::NegatedCoil { en, tag } => self.bit(tag, format!("{} ^ 1", b(en))),
            Instr::Set { en, tag } => self.line(format!("if ({}) b[{}] = 1;", b(en), tag.0)),
            Instr::Reset { en, tag } => self.line(format!("if ({}) b[{}] = 0;", b(en), tag.0)),
            Instr::Powered { out, en, end } => {
                self.powered_by(out, en);
                self.line(format!("if (!b[{}]) goto L{end};", out.0));
            }
            Instr::MoveBit { to, from } => self.bit(to, b(from)),
            Instr::AndBit { to, a, b: other } => self.bit(to, format!("{} & {}", b(a), b(other))),
            Instr::OrBit { to, a, b: other } => self.bit(to, format!("{} | {}", b(a), b(other))),
            Instr::XorBit { to, a, b: other } => self.bit(to, format!("{} ^ {}", b(a), b(other))),
            Instr::NotBit { to, a } => self.bit(to, format!("{} ^ 1", b(a))),
            Instr::LoadBitOf { to, word, bit } => {
                self.bit(to, format!("(uint8_t)((uint64_t){} >> {bit} & 1)", w(word)));
            }
            Instr::StoreBitOf {
                word,
                bit,
                width: wide,
                from,
            } => {
                self.uses("wrap");
                let mask = format!("(UINT64_C(1) << {bit})");
                let cleared = format!("((uint64_t){} & ~{mask})", w(word));
                let value = format!("(int64_t)({cleared} | (uint64_t){} << {bit})", b(from));
                self.line(format!("{} = wrap({}, {value});", w(word), width(wide)));
            }
            Instr::Move { to, from } => self.line(format!("{} = {};", w(to), w(from))),
            Instr::MoveWhen { out, en, to, from } => {
                self.powered_by(out, en);
                self.line(format!("if (b[{}]) {} = {};", out.0, w(to), w(from)));
            }
            Instr::Integer {
                op,
                width: wide,
                to,
                a,
                b: other,
            } => self.integer(at, None, op, wide, [to, a, other]),
            Instr::IntegerWhen {
                op,
                width: wide,
                out,
                en,
                to,
                a,
                b: other,
            } => {
                self.powered_by(out, en);
                self.integer(at, Some(out), op, wide, [to, a, other]);
            }
            Instr::Real {
                op,
                single,
                to,
                a,
                b: other,
            } => self.real(at, None, op, single, [to, a, other]),
            Instr::RealWhen {
                op,
                single,
                out,
                en,
                to,
                a,
                b: other,
            } => {
                self.powered_by(out, en);
                self.real(at, Some(out), op, single, [to, a, other]);
            }
            Instr::RealFunction {
                function,
                single,
                to,
                a,
            } => self.function(at, function, single, to, a),
            Instr::Convert { conversion, to, from } => self.convert(at, conversion, to, from),
            Instr::BitToWord { to, from } => self.line(format!("{} = {};", w(to), b(from))),
            Instr::MoveText { to, from } => self.text(to.0.to_string(), from.0.to_string()),
            Instr::Index { to, index, array } => {
                let place = self.code.arrays[array as usize];
                self.uses("index_of");
                let call = format!(
                    "index_of(&{}, {}, {}, {}, {})",
                    w(to),
                    w(index),
                    place.base,
                    crate::data::number(place.first),
                    crate::data::number(place.last)
                );
                self.faulting(at, &call);
            }
            Instr::LoadBit { to, at: slot } => self.bit(to, format!("b[{}]", w(slot))),
            Instr::StoreBit { at: slot, from } => self.line(format!("b[{}] = {};", w(slot), b(from))),
            Instr::LoadWord { to, at: slot } => self.line(format!("{} = w[{}];", w(to), w(slot))),
            Instr::StoreWord { at: slot, from } => self.line(format!("w[{}] = {};", w(slot), w(from))),
            Instr::LoadText { to, at: slot } => self.text(to.0.to_string(), format!("(uint32_t){}", w(slot))),
            Instr::StoreText { at: slot, from } => {
                self.text(format!("(uint32_t){}", w(slot)), from.0.to_string());
            }
            Instr::Ton {
                out,
                en,
                pt,
                bits,
                words,
            } => self.timer("ton", [out, en, bits], pt, words),
            Instr::Tof {
                out,
                en,
                pt,
                bits,
                words,
            } => self.timer("tof", [out, en, bits], pt, words),
            Instr::Tp {
                out,
                en,
                pt,
                bits,
                words,
            } => self.timer("tp", [out, en, bits], pt, words),
            Instr::Rto {
                out,
                en,
                pt,
                bits,
                words,
            } => self.timer("rto", [out, en, bits], pt, words),
            Instr::Rtof {
                out,
                en,
                pt,
                bits,
                words,
            } => self.timer("rtof", [out, en, bits], pt, words),
            Instr::Ctu {
                out,
                en,
                pv,
                bits,
                words,
            } => self.counter("ctu", [out, en, bits], pv, words),
            Instr::Ctd {
                out,
                en,
                pv,
                bits,
                words,
            } => self.counter("ctd", [out, en, bits], pv, words),
            Instr::Ctud {
                out,
                en,
                pv,
                bits,
                words,
            } => self.counter("ctud", [out, en, bits], pv, words),
            Instr::Ctc {
                out,
                en,
                pv,
                bits,
                words,
            } => self.counter("ctc", [out, en, bits], pv, words),
            Instr::Sr { out, en, reset, bits } => {
                self.bit(
                    bits,
                    format!("(uint8_t)({} | (b[{}] & ({} ^ 1)))", b(en), bits.0, b(reset)),
                );
                self.bit(out, b(bits));
            }
            Instr::Rs { out, en, reset, bits } => {
                self.bit(
                    bits,
                    format!("(uint8_t)(({} ^ 1) & ({} | b[{}]))", b(reset), b(en), bits.0),
                );
                self.bit(out, b(bits));
            }
            Instr::Clear {
                en,
                state,
                bits,
                words,
            } => self.clear(en, state, &bits.0.to_string(), &words.0.to_string()),
            Instr::ClearAt {
                en,
                state,
                bits,
                words,
            } => self.clear(en, state, &w(bits), &w(words)),
            Instr::StateAt {
                op,
                out,
                en,
                operand,
                bits,
                words,
            } => self.chosen_state(op, out, en, operand, bits, words),
            Instr::Record { .. } | Instr::Records { .. } => {
                self.body.missing.push((at, "code that was put together".into()));
            }
            Instr::Routine { routine, operands } => self.routine(at, routine, operands),
            _ => self.flow(at, instr),
        }
    }

    fn text(&mut self, to: String, from: String) {
        self.uses("move_text");
        self.line(format!("move_text(self, {to}, {from});"));
    }

    fn routine(&mut self, at: u32, routine: Routine, operands: u32) {
        let pool = &self.code.operands[operands as usize..];
        if routine == Routine::Enumerate {
            let values = usize::try_from(pool[1])
                .ok()
                .and_then(|number| EnumId::from_number(number.checked_sub(TYPES.len())? as u32));
            let (to, from) = (w(Word(pool[0])), w(Word(pool[2])));
            if let Some(id) = values {
                let tests: Vec<String> = (id.get().values.iter().map(|(_, value)| *value))
                    .map(|value| format!("{from} == {}", crate::data::number(value.into())))
                    .collect();
                let call = format!("({} ? ({to} = {from}, 0) : FAULT_RANGE)", tests.join(" || "));
                self.faulting(at, &call);
            } else {
                self.line(format!("{to} = {from};"));
            }
            return;
        }
        let name = format!("{routine:?}");
        let known = PIECES.named(&name).filter(|_| !Self::needs_more(routine, pool));
        let Some(piece) = known else {
            self.body.missing.push((at, name));
            return;
        };
        self.uses(piece);
        self.faulting(at, &format!("{piece}(self, operands + {operands})"));
    }

    /// Whether a routine works on what only some types have, and C has no text for.
    fn needs_more(routine: Routine, pool: &[u32]) -> bool {
        let has_no_text = |ty: &u32| TYPES.get(*ty as usize).is_none_or(|ty| ty.is_date());
        match routine {
            Routine::Format => has_no_text(&pool[2]),
            Routine::Parse => has_no_text(&pool[1]),
            _ => false,
        }
    }
}
