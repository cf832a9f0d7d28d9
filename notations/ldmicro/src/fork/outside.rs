//! Elements about what is outside of a program: the hardware and the registers of the controller, serial data of several
//! bytes. Each becomes an unread part that shows the element's fields, so that the program around it runs.
//! Whether power passes is what the fork's own simulator makes of them, where nothing is connected to the controller.

use ladder_notation::Power;

/// Such an element.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Outside {
    /// The word that its line begins with.
    pub(crate) word: &'static str,
    /// Whether the power that goes in comes out; else none does.
    passes: bool,
    why: &'static str,
}

const HARDWARE: &str = "it is about the hardware of the controller";
const REGISTER: &str = "it is about a register of the controller";
const RANDOM: &str = "there are no random numbers here";
const SEVERAL: &str = "it is about several bytes, or waits for the line";
const READY: &str = "the serial line is always free here";
const WAITING: &str = "no byte is ever waiting here";
const PULSES: &str = "there are no pulses here";
const CHARACTERS: &str = "LDmicro itself lacks the characters of this display";

const fn passing(word: &'static str, why: &'static str) -> Outside {
    let passes = true;
    Outside { word, passes, why }
}

const fn ending(word: &'static str, why: &'static str) -> Outside {
    let passes = false;
    Outside { word, passes, why }
}

/// All of them. Of `UART_SEND`, `UART_RECV`, `SET_PWM` and `RES` only some are.
const ALL: [Outside; 40] = [
    passing("BUS", "LDmicro itself makes nothing of it"),
    passing("9SEGMENTS", CHARACTERS),
    passing("14SEGMENTS", CHARACTERS),
    passing("16SEGMENTS", CHARACTERS),
    passing("TIME2DELAY", "how many loops it counts depends on the controller"),
    passing("DELAY", HARDWARE),
    passing("SLEEP", HARDWARE),
    passing("CLRWDT", HARDWARE),
    passing("LOCK", HARDWARE),
    passing("RSFR", REGISTER),
    passing("WSFR", REGISTER),
    passing("SSFR", REGISTER),
    passing("CSFR", REGISTER),
    passing("TSFR", REGISTER),
    passing("TCSFR", REGISTER),
    passing("RANDOM", RANDOM),
    passing("SEED_RANDOM", RANDOM),
    passing("NPULSE", PULSES),
    passing("NPULSE_OFF", PULSES),
    ending("PULSER", PULSES),
    ending("STEPPER", PULSES),
    ending("QUAD_ENCOD", PULSES),
    passing("SPI", HARDWARE),
    passing("SPI_WR", HARDWARE),
    passing("I2C_RD", HARDWARE),
    passing("I2C_WR", HARDWARE),
    passing("STRING", "LDmicro writes a number into a text as C does"),
    passing("FORMATTED_STR", HARDWARE),
    passing("SET_PWM_SOFT", HARDWARE),
    passing("SET_PWM", "its frequency is a variable"),
    passing("PWM_OFF", PULSES),
    passing("RES", "no block here ends pulses"),
    passing("UART_SEND_READY", READY),
    passing("UART_SEND_BUSY", READY),
    passing("UART_UDRE", READY),
    ending("UART_RECV_AVAIL", WAITING),
    ending("UART_SEND", SEVERAL),
    ending("UART_RECV", SEVERAL),
    ending("UART_SENDn", SEVERAL),
    ending("UART_RECVn", SEVERAL),
];

impl Outside {
    /// The one with this word.
    pub(crate) fn of(word: &str) -> Option<Outside> {
        ALL.into_iter().find(|outside| outside.word == word)
    }

    /// The name of its block, without the `$`: letters and digits, a letter first.
    pub(crate) fn name(self) -> String {
        let digits = self.word.len() - self.word.trim_start_matches(|c: char| c.is_ascii_digit()).len();
        let (size, word) = self.word.split_at(digits);
        word.replace('_', "") + size
    }

    pub(crate) const fn power(self) -> Power {
        if self.passes { Power::Passes } else { Power::Ends }
    }

    /// Whether it writes nothing but variables among its fields. What another register changes is not known, and a
    /// controller that is locked does nothing more.
    pub(crate) fn writes_its_fields(self) -> bool {
        !matches!(self.word, "WSFR" | "SSFR" | "CSFR" | "LOCK")
    }

    /// What there is to say about it.
    pub(crate) fn remark(self) -> String {
        let power = if self.passes {
            "power passes"
        } else {
            "no power comes out of it"
        };
        format!("it is not run here, and {power}: {}", self.why)
    }
}
