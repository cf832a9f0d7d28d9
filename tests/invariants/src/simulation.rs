//! The simulator does what the language's definition says, whichever way a scan is run.
//!
//! The first byte chooses the kind of program, the second the inputs; each byte after them is a choice in making it.

use crate::generator::{Dice, Mode, program_of, typed_of};
use crate::input::Numbers;
use crate::reference::Boolean;
use crate::trace::{Engine, Stimulus, compare, compare_typed, compile, difference, trace};
use ladder_analysis::program::Program;
use ladder_analysis::values::types::{Scalar, Type};
use ladder_format::{Options, format_text};
use ladder_simulator::{Simulation, Stepped};
use std::sync::Arc;

/// So many scans show what a program does.
pub(crate) const SCANS: usize = 10;

/// More elements, or bytes of texts, are not run: a scan of them takes long.
const MOST_ELEMENTS: i64 = 2_000;

/// More blocks are not run.
const MOST_BLOCKS: usize = 400;

/// More user-defined blocks are not run: each may hold several of the one below it.
const MOST_USER_BLOCKS: usize = 5;

pub(crate) fn check(data: &[u8]) {
    let mut numbers = Numbers(data);
    let mode = [Mode::Boolean, Mode::Wild, Mode::Sensible, Mode::Typed][numbers.small() % 4];
    let stimulus = Stimulus {
        seed: numbers.small() as u64,
        scans: SCANS,
    };
    let text = program_of(&mut Dice::of_bytes(numbers.0), mode);
    if mode == Mode::Boolean {
        compare(&text, &mut Boolean::new(&text), stimulus);
    }
    if mode == Mode::Typed {
        compare_typed(&typed_of(&mut Dice::of_bytes(numbers.0)), stimulus, 2);
    }
    let Some(program) = compile(&text) else {
        panic!("this is not a program:\n{text}");
    };
    let fused = trace(&text, stimulus, Engine::Fused);
    let plain = trace(&text, stimulus, Engine::Plain);
    assert_eq!(difference(&fused, &plain), None, "the two codes differ\n{text}");
    let laid_out = format_text(&text, &Options::default());
    let as_laid_out = trace(&laid_out, stimulus, Engine::Fused);
    assert_eq!(
        difference(&fused, &as_laid_out),
        None,
        "it does something else\n{text}\n=>\n{laid_out}"
    );
    in_steps(&program, &text);
}

/// A scan in steps, with a look back, does the same as a whole one.
fn in_steps(program: &Arc<Program>, text: &str) {
    let options = ladder_simulator::Options {
        watchdog: 5_000,
        ..Default::default()
    };
    let start =
        || Simulation::new(program.clone(), options).unwrap_or_else(|error| panic!("{error:?}\n{text}"));
    let (mut whole, mut stepped) = (start(), start());
    for scan in 0..3 {
        let ran = whole.scan();
        let before = stepped.state();
        // Some of it is undone.
        stepped.step_block();
        stepped.step_block();
        assert!(stepped.restore(&before), "in scan {scan} of\n{text}");
        // Faults are reported once, whatever becomes of their scan.
        stepped.take_faults();
        while let Stepped::At(_) = stepped.step_block() {}
        for point in whole.points() {
            let (one, other) = (whole.value(point), stepped.value(point));
            assert_eq!(one, other, "{} in scan {scan} of\n{text}", point.name);
        }
        assert_eq!(whole.status(), stepped.status(), "in scan {scan} of\n{text}");
        assert_eq!(
            whole.take_faults(),
            stepped.take_faults(),
            "in scan {scan} of\n{text}"
        );
        assert_eq!(
            whole.take_serial(),
            stepped.take_serial(),
            "in scan {scan} of\n{text}"
        );
        if !ran {
            break;
        }
    }
}

/// Whether some scans of a program take no time worth mentioning.
pub(crate) fn is_small(program: &Program) -> bool {
    let size = |ty: Type| match ty {
        Type::Array { first, last, element } => bytes(element).saturating_mul(last - first + 1),
        Type::Scalar(scalar) => bytes(scalar),
        Type::State(_) => 4,
        Type::Compound(_) => 1,
    };
    let elements: i64 = program.tags.iter().map(|tag| size(tag.ty)).sum();
    let blocks: usize = program.networks.iter().map(|network| network.blocks.len()).sum();
    elements <= MOST_ELEMENTS && blocks <= MOST_BLOCKS && program.blocks.len() <= MOST_USER_BLOCKS
}

fn bytes(scalar: Scalar) -> i64 {
    match scalar {
        Scalar::String(length) => 1 + i64::from(length) / 16,
        _ => 1,
    }
}
