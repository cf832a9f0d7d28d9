//! Which code an instruction of the table becomes.

use super::arguments::Arguments;
use super::{Compiler, Result};
use crate::memory::Bit;
use ladder_analysis::program::Block;
use ladder_instructions::{Counting, Instruction, Op, Serial, StatePower, Tables, Timing};

impl Compiler<'_> {
    /// The power after a timer or counter.
    fn after_state(&self, output: Bit, en: Bit) -> Bit {
        match self.semantics.state_power {
            StatePower::Output => output,
            StatePower::En => en,
        }
    }

    /// One instruction of the table. A new row does not compile until it has its line here.
    pub(super) fn instruction(&mut self, row: &Instruction, block: &Block, en: Bit) -> Result<Bit> {
        let arguments = Arguments::of(block);
        match row.op {
            Op::Contact
            | Op::NegatedContact
            | Op::RisingContact
            | Op::FallingContact
            | Op::Inverter
            | Op::OneShotRising
            | Op::OneShotFalling
            | Op::Eq
            | Op::Ne
            | Op::Gt
            | Op::Ge
            | Op::Lt
            | Op::Le => self.condition(row, arguments, en),

            Op::Mov | Op::Sel | Op::Mux if arguments.are_parts() => self.select_parts(row.op, arguments, en),
            Op::Bmov if arguments.are_parts() => self.move_ranges(arguments, en),
            Op::Fill if arguments.are_parts() => self.fill_ranges(arguments, en),
            op if self.is_as_in_c(op) => self.c_arithmetic(op, arguments, en),
            Op::Lut | Op::Pwl if self.semantics.tables == Tables::Open => {
                self.open_table(row.op, arguments, en)
            }
            Op::Mov
            | Op::Typ
            | Op::Wrap
            | Op::Add
            | Op::Mul
            | Op::Sub
            | Op::Div
            | Op::Mod
            | Op::Exp
            | Op::Not
            | Op::And
            | Op::Or
            | Op::Xor
            | Op::Shl
            | Op::Shr
            | Op::Rol
            | Op::Ror
            | Op::Abs
            | Op::Neg
            | Op::Trunc
            | Op::Sqrt
            | Op::Ln
            | Op::Log
            | Op::Expe
            | Op::Sin
            | Op::Cos
            | Op::Tan
            | Op::Asin
            | Op::Acos
            | Op::Atan
            | Op::Rad
            | Op::Deg
            | Op::Min
            | Op::Max
            | Op::Limit
            | Op::Sel
            | Op::Calc
            | Op::Mux
            | Op::Lut
            | Op::Pwl
            | Op::Len
            | Op::Left
            | Op::Right
            | Op::Mid
            | Op::Concat
            | Op::Insert
            | Op::Delete
            | Op::Replace
            | Op::Find => self.data(row.op, arguments, en),
            Op::Bmov => self.move_range(arguments, en),
            Op::Fill => self.fill_range(arguments, en),
            Op::Pack => self.pack(arguments, en),
            Op::Unpack => self.unpack(arguments, en),
            Op::Shift => self.shift_range(arguments, en),
            Op::Search => self.search(arguments, en),

            Op::Ton | Op::Tof | Op::Tp | Op::Rto | Op::Rtof => match self.semantics.timing {
                Timing::Clock => {
                    let output = self.timer(row.op, arguments, en)?;
                    Ok(self.after_state(output, en))
                }
                Timing::Scans => self.scan_timer(row.op, arguments, en),
                Timing::Ticks => self.tick_timer(row.op, arguments, en),
                Timing::Units => self.unit_timer(row.op, arguments, en),
            },
            Op::Ctu | Op::Ctd | Op::Ctud | Op::Ctc => match self.semantics.counting {
                Counting::Saturating => {
                    let output = self.counter(row.op, arguments, en)?;
                    Ok(self.after_state(output, en))
                }
                Counting::Wrapping => self.wrapping_counter(row.op, arguments, en),
                Counting::Latching => self.latching_counter(row.op, arguments, en),
                Counting::Comparing => self.comparing_counter(row.op, arguments, en),
            },
            Op::Sr | Op::Rs => self.bistable(row.op, arguments, en),

            // That the tag is retentive is known from its declaration or from the coil, when the program starts.
            Op::Coil
            | Op::NegatedCoil
            | Op::SetCoil
            | Op::ResetCoil
            | Op::RisingCoil
            | Op::FallingCoil
            | Op::RetentiveCoil
            | Op::RetentiveSet
            | Op::RetentiveReset => self.coil(row, arguments, en),
            Op::Res => self.clear(arguments, en),

            // What PERSIST does is known when the program starts.
            Op::Lbl | Op::Fun | Op::Next | Op::Persist => Ok(en),
            Op::Jmp => self.jump(arguments, en),
            Op::Call => self.call(arguments, en),
            Op::Ret => Ok(self.ret(en)),
            Op::End => Ok(self.end(en)),
            Op::For => self.for_loop(arguments, en),
            Op::Mcr => Ok(self.mcr(en)),

            Op::Adc => self.analog_input(arguments, en),
            Op::Pwm => self.pulse_output(arguments, en),
            Op::Usnd if self.semantics.serial == Serial::EverySecondScan => self.send_slowly(arguments, en),
            Op::Usnd => self.send(arguments, en),
            Op::Urcv => self.receive(arguments, en),
            Op::Fmt if self.semantics.serial == Serial::EverySecondScan => {
                self.send_text_slowly(arguments, en)
            }
            Op::Fmt => self.send_text(arguments, en),
            Op::Scantime => self.scan_time(arguments, en),
        }
    }
}
