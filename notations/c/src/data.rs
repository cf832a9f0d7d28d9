//! Tables: memory at the start, texts, operands.

use ladder_simulator::compiled::{Compiled, Instr, Routine, Text, TextSlot};
use std::fmt::Write;

/// A number as C writes it: the smallest one has no literal.
pub(crate) fn number(value: i64) -> String {
    match value {
        i64::MIN => "INT64_MIN".into(),
        -2_147_483_647..=2_147_483_647 => value.to_string(),
        _ => format!("INT64_C({value})"),
    }
}

/// How many slots of each kind there are.
pub(crate) struct Sizes {
    pub(crate) bits: usize,
    pub(crate) words: usize,
    pub(crate) texts: usize,
    pub(crate) chars: usize,
}

pub(crate) fn sizes(compiled: &Compiled) -> Sizes {
    let memory = &compiled.initial;
    // A search asks for the types of what it compares only while it runs.
    let is_search = |instr: &Instr| {
        matches!(
            instr,
            Instr::Routine {
                routine: Routine::Search,
                ..
            }
        )
    };
    let may_compare = usize::from(compiled.code.instrs.iter().any(is_search));
    Sizes {
        bits: memory.bits.len(),
        words: memory.words.len(),
        texts: memory.texts.len().max(may_compare),
        chars: memory.texts.iter().map(Text::room).sum(),
    }
}

/// The tables that the source begins with.
pub(crate) fn tables(compiled: &Compiled, has_operands: bool, has_room: bool) -> String {
    let memory = &compiled.initial;
    let mut out = String::new();
    if has_operands {
        rows(
            &mut out,
            "static const uint32_t operands[]",
            compiled.code.operands.iter().map(u32::to_string),
        );
    }
    let texts = sizes(compiled).texts;
    if texts > 0 {
        let mut at = 0;
        let rooms = memory.texts.iter().map(Text::room).chain([0]).take(texts);
        let places = rooms.clone().map(|room| {
            let here = at;
            at += room;
            here.to_string()
        });
        rows(&mut out, "static const uint32_t text_at[]", places);
        if has_room {
            rows(
                &mut out,
                "static const uint16_t text_room[]",
                rooms.map(|room| room.to_string()),
            );
        }
    }
    let words: Vec<String> = set(memory
        .words
        .iter()
        .map(|word| (*word != 0).then(|| number(*word))));
    if !words.is_empty() {
        rows(
            &mut out,
            "static const struct { uint32_t at; int64_t value; } first_words[]",
            words.into_iter(),
        );
    }
    let bits: Vec<String> = (0..)
        .zip(&memory.bits)
        .filter(|(_, bit)| **bit != 0)
        .map(|(at, _): (usize, _)| at.to_string())
        .collect();
    if !bits.is_empty() {
        rows(&mut out, "static const uint32_t first_bits[]", bits.into_iter());
    }
    out
}

/// Where memory is something else than 0 at the start.
fn set(values: impl Iterator<Item = Option<String>>) -> Vec<String> {
    let set = values.enumerate();
    set.filter_map(|(at, value)| value.map(|value| format!("{{{at}, {value}}}")))
        .collect()
}

fn rows(out: &mut String, head: &str, values: impl Iterator<Item = String>) {
    let _ = write!(out, "{head} = {{");
    for (n, value) in values.enumerate() {
        out.push_str(if n % 12 == 0 { "\n    " } else { " " });
        let _ = write!(out, "{value},");
    }
    out.push_str("\n};\n\n");
}

/// The statements that bring memory to what it is at the start.
pub(crate) fn start(compiled: &Compiled) -> String {
    let memory = &compiled.initial;
    let mut out = String::new();
    if memory.words.iter().any(|word| *word != 0) {
        out.push_str(
            "    for (n = 0; n < sizeof first_words / sizeof *first_words; n++)\n        self->w[first_words[n].at] = first_words[n].value;\n",
        );
    }
    // One is: the rail's.
    if memory.bits.iter().any(|bit| *bit != 0) {
        out.push_str(
            "    for (n = 0; n < sizeof first_bits / sizeof *first_bits; n++) self->b[first_bits[n]] = 1;\n",
        );
    }
    let mut at = 0;
    for (slot, text) in (0..).zip(&memory.texts) {
        let bytes = memory.text(TextSlot(slot));
        if !bytes.is_empty() {
            let _ = writeln!(
                out,
                "    memcpy(self->chars + {at}, \"{}\", {});\n    self->length[{slot}] = {};",
                octal(bytes),
                bytes.len(),
                bytes.len()
            );
        }
        at += text.room();
    }
    out
}

/// Bytes as they stand in a string of C.
fn octal(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "\\{byte:03o}");
        text
    })
}
