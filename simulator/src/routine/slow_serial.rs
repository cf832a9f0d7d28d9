//! The serial port as LDmicro's simulator has it: a byte takes two scans, and a sender waits until the
//! line is free.

use super::Operands;
use super::ports::push_sent;
use crate::memory::{Memory, Word};
use crate::timers::Clock;

/// How many scans a byte takes.
const SCANS: i64 = 2;

fn is_free(memory: &Memory, free: Word, clock: Clock) -> bool {
    clock.scan >= memory.word(free)
}

fn push(memory: &mut Memory, byte: u8, free: Word, clock: Clock) {
    push_sent(memory, &[byte]);
    memory.words[free.0 as usize] = clock.scan + SCANS;
}

/// The power shows whether the line is busy.
pub(super) fn send(memory: &mut Memory, with: &mut Operands, clock: Clock) {
    let (out, en, from, free) = (with.bit(), with.bit(), with.word(), with.word());
    if memory.bit(en) && is_free(memory, free, clock) {
        let byte = memory.word(from) as u8;
        push(memory, byte, free, clock);
    }
    let busy = !is_free(memory, free, clock);
    memory.set_bit(out, busy);
}

/// What is sent in a step of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum SentByte {
    Byte(u8),
    /// A minus or a blank.
    Sign,
    /// A digit, that of this power of ten; `first` of its number.
    Digit {
        power: u32,
        first: bool,
    },
}

/// A rise of EN starts the text again; it is also sent once at the start. The power shows whether it is under way.
pub(super) fn send_text(memory: &mut Memory, with: &mut Operands, clock: Clock) {
    let (out, en, text) = (with.bit(), with.bit(), with.text());
    let (has_number, number) = (with.number() != 0, with.word());
    let (free, sent, rest) = (with.word(), with.word(), with.word());
    let (before, blank) = (with.bit(), with.bit());
    let en = memory.bit(en);
    if en && !memory.bit(before) {
        memory.words[sent.0 as usize] = 0;
    }
    memory.set_bit(before, en);
    with.count(memory.text(text).len());
    let step = memory.word(sent);
    let (part, more) = part(memory.text(text), has_number, step);
    if let Some(part) = part.filter(|_| is_free(memory, free, clock)) {
        let byte = match part {
            SentByte::Byte(byte) => byte,
            SentByte::Sign => {
                let value = memory.word(number) as i16;
                memory.words[rest.0 as usize] = i64::from(value.wrapping_abs());
                memory.set_bit(blank, true);
                if value < 0 { b'-' } else { b' ' }
            }
            SentByte::Digit { power, first } => {
                if first {
                    memory.words[rest.0 as usize] = memory.word(number);
                    memory.set_bit(blank, true);
                }
                let unit = 10_i64.pow(power);
                let value = memory.word(rest);
                let digit = value / unit;
                memory.words[rest.0 as usize] = value - digit * unit;
                if digit != 0 {
                    memory.set_bit(blank, false);
                }
                if power > 0 && digit == 0 && memory.bit(blank) {
                    b' '
                } else {
                    // Of a number that is too wide the first digit is none.
                    (i64::from(b'0') + digit) as u8
                }
            }
        };
        push(memory, byte, free, clock);
        memory.words[sent.0 as usize] = step + 1;
        memory.set_bit(out, more);
    } else {
        memory.set_bit(out, part.is_some());
    }
}

/// The part of a text that a step sends, and whether others follow. `\\3` is a number of three digits, `\\-3` one with
/// its sign, `\\\\` a backslash.
fn part(text: &[u8], has_number: bool, step: i64) -> (Option<SentByte>, bool) {
    let mut at = 0;
    let mut steps: i64 = 0;
    let mut found = None;
    while at < text.len() {
        let (signed, digits, length) = match text[at..] {
            [b'\\', b'-', n @ b'1'..=b'5', ..] if has_number => (true, u32::from(n - b'0'), 3),
            [b'\\', n @ b'1'..=b'5', ..] if has_number => (false, u32::from(n - b'0'), 2),
            [b'\\', b'\\', ..] => (false, 0, 2),
            _ => (false, 0, 1),
        };
        let count = i64::from(digits) + i64::from(signed || digits == 0);
        if (steps..steps + count).contains(&step) {
            let within = step - steps - i64::from(signed);
            found = Some(match (digits, within) {
                (0, _) => SentByte::Byte(text[at]),
                (_, ..0) => SentByte::Sign,
                (_, n) => SentByte::Digit {
                    power: digits - 1 - n as u32,
                    first: n == 0 && !signed,
                },
            });
        }
        steps += count;
        at += length;
    }
    (found, step + 1 < steps)
}
