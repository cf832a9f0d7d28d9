//! Formatting keeps what a text means: its words, its wiring, and what it does.
//!
//! The first part of the input is a text. A second one has the width of the layout and its spacing, a byte each.

use crate::input::{Numbers, parts, text};
use crate::simulation::{SCANS, is_small};
use crate::trace::{Engine, Stimulus, compile, difference, trace};
use ladder_format::{Options, format_text};

#[path = "../../../format/tests/properties/meaning.rs"]
mod meaning;

pub(crate) fn check(data: &[u8]) {
    let parts = parts(data);
    let text = text(parts[0]);
    let options = match parts.get(1) {
        None => Options::default(),
        Some(part) => {
            let mut numbers = Numbers(part);
            Options {
                width: numbers.small() as u32,
                spacing: numbers.small() as u32,
            }
        }
    };
    meaning::check_with(&text, &options);
    if compile(&text).is_none_or(|program| !is_small(&program)) {
        return;
    }
    let stimulus = Stimulus {
        seed: data.len() as u64,
        scans: SCANS,
    };
    let as_written = trace(&text, stimulus, Engine::Fused);
    let laid_out = format_text(&text, &options);
    let as_laid_out = trace(&laid_out, stimulus, Engine::Fused);
    let differs = difference(&as_written, &as_laid_out);
    assert_eq!(differs, None, "it does something else\n{text}\n=>\n{laid_out}");
    let plain = trace(&text, stimulus, Engine::Plain);
    let differs = difference(&as_written, &plain);
    assert_eq!(differs, None, "the two codes differ\n{text}");
}
