//! The one table of ladder instructions.
//!
//! Every other crate asks this table what a block is: the parser's diagnostics (arity, shape, did-you-mean),
//! type inference, the formatter (what acts and what is a condition), hover and completion, the simulator and
//! the language reference. It is data only: no parsing, no evaluation.
//!
//! [`TABLE`] holds one [`Instruction`] per row of LANGUAGE §5, in the order of [`Op`]. From a text one comes to a
//! row by its brackets and its spelling:
//!
//! ```
//! use ladder_instructions::{Shape, closest, in_other_shape, lookup};
//!
//! let timer = lookup(Shape::Logical, "ton").next().unwrap();
//! assert_eq!(timer.signature(), "[TON]( t, PT, R := )");
//! // `<TON>` exists in other brackets, `[TOM]` is a slip of the finger.
//! assert_eq!(in_other_shape(Shape::Function, "TON").next().unwrap().op, timer.op);
//! assert_eq!(closest(Shape::Logical, "TOM").unwrap().op, timer.op);
//! ```
//!
//! A mnemonic may have two rows that differ in their operands (`[NOT]` the inverter and `[NOT]( y, a )` the
//! bitwise one); [`Instruction::takes`] tells them apart. Everything here is made when the crate is compiled:
//! a look-up allocates nothing.
//!
//! Adding an instruction is one row in its section under `table/`, one variant of [`Op`] (the compiler refuses
//! one without the other), one function in the simulator (refused likewise) and one scenario.

mod instruction;
mod likeness;
mod lookup;
mod op;
mod operand;
mod origin;
mod power;
mod profile;
mod purpose;
mod semantics;
mod spelling;
mod table;

pub use instruction::{Acts, Group, Instruction, Role, Shape};
pub use likeness::{name_in_us, names_elsewhere};
pub use lookup::{by_op, closest, in_other_shape, known_elsewhere, lookup, slip_of};
pub use op::Op;
pub use operand::{Accepts, Direction, Operand, Presence, StateType, TypeClass};
pub use origin::{Origin, origin};
pub use power::{Coil, Edge, Power};
pub use profile::{Profile, Profiles};
pub use purpose::{Purpose, purpose};
pub use semantics::{
    Arithmetic, Controller, Conversion, Counting, Division, Edges, FirstEdges, Relay, Remainder, Semantics,
    Serial, SetPower, StatePower, States, Tables, Timing, Truth, Width, Writers,
};
pub use table::TABLE;
