//! Ports (LANGUAGE §5.6). Analog inputs and pulse outputs are arrays of words, the serial port two queues.

use super::arguments::Arguments;
use super::place::Slot;
use super::{Cell, Compiler, Result};
use crate::code::{ArrayPlace, Instr};
use crate::memory::{Bit, Word};
use crate::operation::{Conversion, Width};
use crate::routine::{Routine, type_operand};
use ladder_analysis::program::Expr;
use ladder_analysis::values::types::Scalar;
use ladder_instructions::Serial;

/// How many analog inputs and pulse outputs there are, counted from 0.
pub const CHANNELS: u32 = 64;

/// Where the ports of a program begin; none where it does not use them.
#[derive(Debug, Clone, Copy, Default)]
pub struct Ports {
    /// Analog inputs.
    pub analog: Option<Word>,
    /// Duty of each pulse output, in percent, then the frequency of each, in hertz.
    pub pulse: Option<Word>,
    /// Whether it uses the serial port.
    pub serial: bool,
}

impl Compiler<'_> {
    /// Words for all channels of a port.
    fn channels(&mut self, known: Option<Word>, count: u32) -> Word {
        known.unwrap_or_else(|| {
            let first = self.layout.word();
            for _ in 1..count {
                self.layout.word();
            }
            first
        })
    }

    /// The slot of a channel; a number that no channel has is a fault.
    fn channel(&mut self, base: Word, number: &Expr) -> Result<Word> {
        let index = self.count(number)?;
        let to = self.layout.word();
        let array = self.array(ArrayPlace {
            base: base.0,
            first: 0,
            last: i64::from(CHANNELS) - 1,
        });
        self.emit(Instr::Index { to, index, array });
        Ok(to)
    }

    /// `[ADC]`
    pub(super) fn analog_input(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        let (place, ty) = arguments.place(0)?;
        let base = self.channels(self.ports.analog, CHANNELS);
        self.ports.analog = Some(base);
        let (out, start) = self.begin_powered(en);
        let spot = self.spot(place)?;
        let at = self.channel(base, arguments.value(1)?)?;
        let value = self.layout.word();
        self.emit(Instr::LoadWord { to: value, at });
        let value = self.convert(
            Conversion::Fit {
                from: Width::I64,
                to: Width::of(ty),
            },
            value,
        );
        self.write_result(spot, Slot::Word(value));
        self.end_powered(start);
        Ok(out)
    }

    /// `[PWM]`
    pub(super) fn pulse_output(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        let base = self.channels(self.ports.pulse, 2 * CHANNELS);
        self.ports.pulse = Some(base);
        let (out, start) = self.begin_powered(en);
        let [duty, frequency] = [self.count(arguments.value(0)?)?, self.count(arguments.value(1)?)?];
        let bases = [base, base.offset(CHANNELS)];
        let writes = match arguments.named_value("CH")? {
            Some(number) => {
                let [duty_at, frequency_at] =
                    [self.channel(bases[0], number)?, self.channel(bases[1], number)?];
                [(duty_at, duty), (frequency_at, frequency)].map(|(at, from)| Instr::StoreWord { at, from })
            }
            None => [(bases[0], duty), (bases[1], frequency)].map(|(to, from)| Instr::Move { to, from }),
        };
        for write in writes {
            self.emit(write);
        }
        self.end_powered(start);
        Ok(out)
    }

    /// `[USND]`
    pub(super) fn send(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        self.ports.serial = true;
        let (out, start) = self.begin_powered(en);
        let from = self.count(arguments.value(0)?)?;
        self.routine(Routine::Send, &[from.0]);
        self.end_powered(start);
        Ok(out)
    }

    /// `[URCV]`: its power shows whether a byte came.
    pub(super) fn receive(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        self.ports.serial = true;
        let (place, ty) = arguments.place(0)?;
        let (out, start) = self.begin_powered(en);
        let spot = self.spot(place)?;
        let byte = self.layout.word();
        let came = self.layout.bit();
        let routine = match self.semantics.serial {
            Serial::AtOnce => Routine::Receive,
            Serial::EverySecondScan => Routine::ReceiveNewest,
        };
        self.routine(routine, &[byte.0, came.0]);
        // A second power on the same slot: low where none came, and then nothing is written.
        let inner = self.code.instrs.len();
        self.emit(Instr::Powered {
            out,
            en: came,
            end: 0,
        });
        let value = self.convert(
            Conversion::Fit {
                from: Width::I64,
                to: Width::of(ty),
            },
            byte,
        );
        self.write_result(spot, Slot::Word(value));
        let end = self.here();
        self.code.instrs[inner] = Instr::Powered { out, en: came, end };
        self.end_powered(start);
        Ok(out)
    }

    /// `[FMT]`
    pub(super) fn send_text(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        self.ports.serial = true;
        let (out, start) = self.begin_powered(en);
        let text = self.text(arguments.value(0)?)?;
        let values = arguments.values_from(1)?;
        let mut list = vec![text.0, 2 * values.len() as u32];
        for value in values {
            list.extend([self.word(value)?.0, type_operand(value.ty)]);
        }
        self.routine(Routine::SendText, &list);
        self.end_powered(start);
        Ok(out)
    }

    /// The word that holds from which scan on the serial port is free.
    fn line_free(&mut self) -> Word {
        self.ports.serial = true;
        if let Some(word) = self.line_free {
            return word;
        }
        let word = self.layout.word();
        self.line_free = Some(word);
        word
    }

    /// `[USND]` that waits for the line.
    pub(super) fn send_slowly(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        let free = self.line_free();
        let from = self.count(arguments.value(0)?)?;
        let out = self.layout.bit();
        self.routine(Routine::SendWhenFree, &[out.0, en.0, from.0, free.0]);
        Ok(out)
    }

    /// `[FMT]` likewise.
    pub(super) fn send_text_slowly(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        let free = self.line_free();
        let text = self.text(arguments.value(0)?)?;
        let number = match arguments.values_from(1)?.first() {
            Some(value) => Some(self.word(value)?),
            None => None,
        };
        let [sent, rest] = [self.layout.word(), self.layout.word()];
        let [out, before, blank] = [self.layout.bit(), self.layout.bit(), self.layout.bit()];
        for cell in [
            Cell::Word(sent),
            Cell::Word(rest),
            Cell::Bit(before),
            Cell::Bit(blank),
        ] {
            self.remember(cell);
        }
        self.routine(
            Routine::SendTextSlowly,
            &[
                out.0,
                en.0,
                text.0,
                u32::from(number.is_some()),
                number.unwrap_or(rest).0,
                free.0,
                sent.0,
                rest.0,
                before.0,
                blank.0,
            ],
        );
        Ok(out)
    }

    /// `[SCANTIME]`
    pub(super) fn scan_time(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        let (out, start) = self.begin_powered(en);
        if arguments.by_place().next().is_none() {
            self.ports.serial = true;
            let last = self.layout.word();
            self.remember(Cell::Word(last));
            self.routine(Routine::SendScanTime, &[last.0]);
            self.end_powered(start);
            return Ok(out);
        }
        let (place, ty) = arguments.place(0)?;
        let spot = self.spot(place)?;
        let conversion = if ty.is_real() {
            Conversion::TimeToReal {
                single: ty == Scalar::Real,
            }
        } else {
            Conversion::ToMilliseconds(Width::of(ty))
        };
        let value = self.convert(conversion, Word::SCAN_TIME);
        self.write_result(spot, Slot::Word(value));
        self.end_powered(start);
        Ok(out)
    }
}
