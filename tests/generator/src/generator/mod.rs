//! A generator of valid programs: the same seed gives the same program on every machine.
//!
//! ```text
//! dice --wiring, block, operand, expression--> networks (things on rungs)   --drawing--> text, badly aligned
//!      \-- scope: tags are made when something asks for one --declarations-/
//! ```
//!
//! - [`Mode::Sensible`]: programs as a careful person writes them. `ladder check` has nothing to say.
//! - [`Mode::Wild`]: no errors, but any wiring and every instruction: staggered branches, side-by-side segments,
//!   bridges, jumps, loops, functions, user-defined blocks, comments in wires.
//! - [`Mode::Typed`]: structures, enumerations and arrays of everything, likewise for the reference.
//! - [`Mode::Boolean`]: wild wiring of contacts and coils only, for the [reference evaluation](crate::reference).

mod block;
mod dice;
mod drawing;
mod expression;
mod flow;
mod operand;
mod scope;
mod sensible;
pub mod typed;
mod user_block;
mod value;
mod wiring;

pub use dice::Dice;
pub use drawing::{Item, Network, Pen};

use flow::Region;
use ladder_analysis::values::types::Scalar;
use scope::{Scope, Section, Tag, Type};
use typed::Typed;
use user_block::Definition;

/// What kind of program is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// Nothing is found in it.
    Sensible,
    /// Nothing in it is an error.
    Wild,
    /// Any wiring of contacts and coils.
    Boolean,
    /// Types of its own, and computed indices at every place.
    Typed,
}

/// The text of a program.
pub fn program(seed: u64, mode: Mode) -> String {
    program_of(&mut Dice::new(seed), mode)
}

/// The text of the program that these choices make.
pub fn program_of(dice: &mut Dice, mode: Mode) -> String {
    match mode {
        Mode::Sensible => sensible::program(dice),
        Mode::Wild => wild(dice),
        Mode::Boolean => boolean(dice),
        Mode::Typed => typed::typed(dice).to_string(),
    }
}

/// A program with types of its own, as the reference evaluates it.
pub fn typed_of(dice: &mut Dice) -> Typed {
    typed::typed(dice)
}

fn boolean(dice: &mut Dice) -> String {
    let pen = Pen {
        longest: 1 + dice.below(8),
        line_end: "\n",
        decorated: dice.one_in(2),
        aligned: dice.one_in(3),
    };
    let region = Region {
        functions: &[],
        blocks: &[],
        may_end: false,
        is_boolean: true,
    };
    let mut scope = Scope {
        is_boolean: true,
        ..Scope::default()
    };
    let count = 1 + dice.below(5);
    let mut text = String::new();
    for network in region.networks(dice, &mut scope, &[], count) {
        pen.draw(dice, &network, &mut text);
    }
    text
}

fn wild(dice: &mut Dice) -> String {
    let line_end = dice.of(&["\n", "\n", "\n", "\r\n", "\r"]);
    let pen = Pen {
        longest: 1 + dice.below(8),
        line_end,
        decorated: dice.one_in(2),
        aligned: dice.one_in(3),
    };
    let mut text = String::new();
    let shared = shared_tags();
    let mut blocks = Vec::new();
    for number in 0..dice.below(3) {
        let definition = Definition::make(dice, number, &blocks, &shared, pen, &mut text);
        blocks.push(definition);
    }
    let functions: Vec<String> = (0..dice.below(3))
        .map(|number| format!("function_{number}"))
        .collect();
    let mut scope = Scope {
        tags: shared,
        ..Scope::default()
    };
    let region = Region {
        functions: &functions,
        blocks: &blocks,
        may_end: true,
        is_boolean: false,
    };
    let count = 2 + dice.below(6);
    let mut networks = region.networks(dice, &mut scope, &[], count);
    for (number, function) in functions.iter().enumerate() {
        // One calls only those after it: no recursion.
        let region = Region {
            functions: &functions[number + 1..],
            ..region
        };
        let count = 1 + dice.below(3);
        networks.extend(region.networks(dice, &mut scope, &[format!("<FUN>( {function} )")], count));
    }
    scope.declare(dice, line_end, &mut text);
    for network in &networks {
        text.push_str(dice.of(&["", line_end]));
        pen.draw(dice, network, &mut text);
    }
    if dice.one_in(4) {
        text.truncate(text.trim_end_matches(['\r', '\n']).len());
    }
    if dice.one_in(12) {
        text.insert(0, '\u{feff}');
    }
    text
}

/// Tags that the program and the bodies of its blocks share.
fn shared_tags() -> Vec<Tag> {
    [
        ("shared_bit", Scalar::Bool),
        ("shared_number", Scalar::Dint),
        ("shared_time", Scalar::Time),
    ]
    .map(|(name, ty)| Tag {
        name: name.to_owned(),
        ty: Type::Scalar(ty),
        section: Section::Global,
        initial: None,
        address: None,
    })
    .into()
}
