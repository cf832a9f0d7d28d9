//! The serial port.

use super::Operands;
use crate::memory::{Memory, SERIAL_ROOM, Word};
use crate::timers::Clock;
use crate::value_text;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use std::collections::VecDeque;
use std::fmt::{self, Write};

/// What is sent, seen as something to write to. What was sent longest ago goes if it is not fetched.
struct Line<'m>(&'m mut VecDeque<u8>);

impl Write for Line<'_> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.push(text.as_bytes());
        Ok(())
    }
}

impl Line<'_> {
    fn push(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            if self.0.len() == SERIAL_ROOM {
                self.0.pop_front();
            }
            self.0.push_back(byte);
        }
    }
}

/// Sends bytes.
pub(super) fn push_sent(memory: &mut Memory, bytes: &[u8]) {
    Line(&mut memory.sent).push(bytes);
}

/// As `receive`, of a port that holds one byte: a newer one takes its place.
pub(super) fn receive_newest(memory: &mut Memory, with: &mut Operands) {
    if let Some(newest) = memory.received.pop_back() {
        memory.received.clear();
        memory.received.push_back(newest);
    }
    receive(memory, with);
}

/// The lowest eight bits.
pub(super) fn send(memory: &mut Memory, with: &mut Operands) {
    let byte = with.value(memory) as u8;
    Line(&mut memory.sent).push(&[byte]);
}

pub(super) fn receive(memory: &mut Memory, with: &mut Operands) {
    let (to, came) = (with.word(), with.bit());
    let byte = memory.received.pop_front();
    memory.set_bit(came, byte.is_some());
    if let Some(byte) = byte {
        memory.words[to.0 as usize] = i64::from(byte);
    }
}

/// Each `%d` is the next number; one too many stays as it is.
pub(super) fn send_text(memory: &mut Memory, with: &mut Operands) {
    let mut sent = std::mem::take(&mut memory.sent);
    let mut line = Line(&mut sent);
    let text = memory.text(with.text());
    let list = with.list();
    with.count(text.len() + list.len());
    let mut values = list.chunks_exact(2);
    let mut rest = text;
    while let Some(at) = rest.windows(2).position(|pair| pair == b"%d") {
        line.push(&rest[..at]);
        match values.next() {
            Some(value) => {
                let mut value = Operands::of(value);
                let number = Value::Int(value.value(memory));
                // A line never refuses.
                let _ = value_text::write_cell(&mut line, &number, value.ty());
            }
            None => line.push(b"%d"),
        }
        rest = &rest[at + 2..];
    }
    line.push(rest);
    memory.sent = sent;
}

/// The length of the last scan in milliseconds, once a second.
pub(super) fn send_scan_time(memory: &mut Memory, with: &mut Operands, clock: Clock) {
    let last = with.word();
    let second = clock.now.div_euclid(1_000_000_000);
    if std::mem::replace(&mut memory.words[last.0 as usize], second) == second {
        return;
    }
    let interval = Value::Int(memory.word(Word::SCAN_TIME));
    let mut line = Line(&mut memory.sent);
    let _ = value_text::write_cell(&mut line, &interval, Scalar::Time);
    line.push(b"\r\n");
}
