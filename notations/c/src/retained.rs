//! What a program keeps over a loss of power, as bytes.

use ladder_simulator::compiled::{Compiled, Home, state_size, timer};
use std::fmt::Write;

/// Before the values is a number that other programs do not have.
const MARK: usize = 4;

const PUT_WORD: &str = "static uint8_t *put_word(uint8_t *at, int64_t value)\n{\n    int n;\n    for (n = 0; n < 64; n += 8) *at++ = (uint8_t)((uint64_t)value >> n);\n    return at;\n}\n\n";

const TAKE_WORD: &str = "static const uint8_t *take_word(const uint8_t *at, int64_t *value)\n{\n    uint64_t bits = 0;\n    int n;\n    for (n = 0; n < 64; n += 8) bits |= (uint64_t)*at++ << n;\n    *value = (int64_t)bits;\n    return at;\n}\n\n";

/// A stretch of slots.
enum Stretch {
    Bits(u32, u32),
    /// What a timer is doing: more than a bit.
    Phase(u32),
    Words(u32, u32),
    Text(u32, usize),
    /// An instant, kept as the time since.
    Since(u32),
}

fn stretches(compiled: &Compiled) -> Vec<Stretch> {
    let mut all = Vec::new();
    for kept in &compiled.retained {
        match kept.home {
            Home::Bits { at, len, .. } => all.push(Stretch::Bits(at.0, len)),
            Home::Words { at, len, .. } => all.push(Stretch::Words(at.0, len)),
            Home::Texts { at, len, max, .. } => {
                all.extend((at.0..at.0 + len).map(|slot| Stretch::Text(slot, usize::from(max))));
            }
            Home::State { state, bits, words } => {
                let (bit_count, word_count) = state_size(state);
                if state.is_timer() {
                    all.push(Stretch::Bits(bits.0, timer::PHASE));
                    all.push(Stretch::Phase(bits.0 + timer::PHASE));
                    all.push(Stretch::Words(words.0, timer::SINCE));
                    all.push(Stretch::Since(words.0 + timer::SINCE));
                } else {
                    all.push(Stretch::Bits(bits.0, bit_count));
                    all.push(Stretch::Words(words.0, word_count));
                }
            }
            Home::Borrowed(_) => {}
        }
    }
    all
}

/// How many bytes there are.
pub(crate) fn size(compiled: &Compiled) -> usize {
    let sizes = stretches(compiled).into_iter().map(|stretch| match stretch {
        Stretch::Bits(_, len) => len as usize,
        Stretch::Phase(_) => 1,
        Stretch::Words(_, len) => 8 * len as usize,
        Stretch::Text(_, room) => 2 + room,
        Stretch::Since(_) => 8,
    });
    MARK + sizes.sum::<usize>()
}

/// The names and places of what is kept, as one number (FNV-1a).
fn mark(compiled: &Compiled) -> u32 {
    let text: String = compiled
        .retained
        .iter()
        .flat_map(|kept| {
            [
                kept.name.clone(),
                format!(
                    "{:?}
",
                    kept.home
                ),
            ]
        })
        .collect();
    text.bytes().fold(0x811c_9dc5_u32, |hash, byte| {
        (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193)
    })
}

/// The two functions; nothing if nothing is kept.
pub(crate) fn functions(p: &str, compiled: &Compiled) -> String {
    if compiled.retained.is_empty() {
        return String::new();
    }
    let (mut save, mut restore) = (String::new(), String::new());
    for stretch in stretches(compiled) {
        let (kept, back) = match stretch {
            Stretch::Bits(at, len) => (
                format!("for (n = {at}; n < {}; n++) *at++ = self->b[n];", at + len),
                format!("for (n = {at}; n < {}; n++) self->b[n] = *at++ != 0;", at + len),
            ),
            Stretch::Phase(at) => (
                format!("*at++ = self->b[{at}];"),
                format!("self->b[{at}] = *at++ & 7;"),
            ),
            Stretch::Words(at, len) => (
                format!(
                    "for (n = {at}; n < {}; n++) at = put_word(at, self->w[n]);",
                    at + len
                ),
                format!(
                    "for (n = {at}; n < {}; n++) at = take_word(at, &self->w[n]);",
                    at + len
                ),
            ),
            Stretch::Since(at) => (
                format!("at = put_word(at, minus_held(self->w[{at}], then));"),
                format!("at = take_word(at, &self->w[{at}]);"),
            ),
            Stretch::Text(slot, room) => (
                format!(
                    "*at++ = (uint8_t)self->length[{slot}]; *at++ = (uint8_t)(self->length[{slot}] >> 8); memset(at, 0, {room}); memcpy(at, text_of(self, {slot}), self->length[{slot}]); at += {room};"
                ),
                format!(
                    "set_text(self, {slot}, at + 2, (size_t)at[0] | (size_t)at[1] << 8); at += {};",
                    room + 2
                ),
            ),
        };
        let _ = writeln!(save, "    {kept}");
        let _ = writeln!(restore, "    {back}");
    }
    let mark = mark(compiled);
    let put = if save.contains("put_word") { PUT_WORD } else { "" };
    let take = if restore.contains("take_word") {
        TAKE_WORD
    } else {
        ""
    };
    format!(
        "{put}{take}void {p}_save(const {p} *self, uint8_t *bytes)\n{{\n    const int64_t then = plus_held(self->now, self->w[2]);\n    uint8_t *at = bytes;\n    uint32_t n;\n    (void)then;\n    (void)n;\n    \
         for (n = 0; n < 32; n += 8) *at++ = (uint8_t)(UINT32_C({mark}) >> n);\n{save}    (void)at;\n}}\n\n\
         bool {p}_restore({p} *self, const uint8_t *bytes)\n{{\n    const uint8_t *at = bytes;\n    uint32_t n;\n    for (n = 0; n < 32; n += 8)\n        if (*at++ != (uint8_t)(UINT32_C({mark}) >> n)) return false;\n{restore}    (void)at;\n    return true;\n}}\n\n"
    )
}
