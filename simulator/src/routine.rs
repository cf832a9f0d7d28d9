//! Routines: the work that runs too seldom or is too long to be an instruction of its own. Each takes its operands, slots
//! and numbers, from the code's operand pool.

mod controller;
mod curve;
mod cycles;
mod formula;
mod numerals;
mod ports;
mod ranges;
mod search;
mod select;
mod slow_serial;
mod strings;
mod tables;
mod ticks;
mod units;
mod uses;

pub(crate) use formula::Operation;
pub(crate) use units::MOST_UNITS;
pub use uses::type_of;

use crate::fault::Trouble;
use crate::memory::{Bit, Memory, TextSlot, Word};
use crate::operation::Test;
use crate::timers::Clock;
use crate::work;
use ladder_analysis::values::compound::EnumId;
use ladder_analysis::values::types::Scalar;

/// Which routine; after each what its operands are. A range is two words: the slot of its first element, and how
/// many there are. A list is its length and its members.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Routine {
    // Ranges.
    /// Finds a range whose ends are known only now: first and last index, base slot, first and last index of the
    /// array, to: start, count.
    Range,
    /// Finds a range that begins at an index and is as long as another: index, count, base slot, first and last
    /// index of the array, to: start.
    RangeFrom,
    /// Whether all bits of a range are high: to, range.
    AllHigh,
    /// Whether none is: to, range.
    AllLow,
    /// Writes one bit into a range: range, from.
    FillBits,
    FillWords,
    FillTexts,
    RepeatBits,
    RepeatWords,
    RepeatTexts,
    /// Sets the bits of a range if EN is high: EN, range.
    SetBits,
    /// Clears them likewise.
    ResetBits,
    /// Copies a range: to, from.
    CopyBits,
    CopyWords,
    CopyTexts,
    /// Moves a range one up: range, what enters at the first.
    ShiftBits,
    ShiftWords,
    ShiftTexts,
    /// Bits into a word: to, its type, range.
    PackBits,
    /// Words into a wider one: to, its type, range, its type.
    PackWords,
    /// The reverse: range, from.
    UnpackBits,
    /// range, its type, from.
    UnpackWords,
    /// Adds up a range: to, its type, range, its type.
    Sum,
    /// Looks for an element: y, its type, first index of the array, test, a, its type, range, its type, base slot,
    /// NEXT, FOUND.
    Search,

    // One of several.
    /// to, selector, list.
    SelectBit,
    SelectWord,
    SelectText,
    /// A point on a curve: to, type, x, list of x0, y0, x1, y1, ...
    Curve,

    // Strings: to, then the operands in their order.
    Length,
    Left,
    Right,
    Middle,
    /// to, list.
    Concat,
    Insert,
    Delete,
    Replace,
    Find,
    /// A number or time as text: to, from, its type.
    Format,
    /// A BOOL as text: to, from.
    FormatBit,
    /// The reverse: to, its type, from.
    Parse,
    ParseBit,
    /// A number as a value of an enumeration: to, its type, from.
    Enumerate,

    // Ports.
    /// Sends a byte: from.
    Send,
    /// Takes a byte: to, and to the power that shows whether there was one.
    Receive,
    /// Sends a text with numbers in it: text, list of pairs of a number and its type.
    SendText,
    /// Sends the scan time once a second: the second that was sent last.
    SendScanTime,
    /// Takes the newest byte, and forgets those before it: as `Receive`.
    ReceiveNewest,
    /// Sends a byte when the line is free: power, EN, from, the scan from which the line is free.
    SendWhenFree,
    /// Sends a text byte by byte: power, EN, text, whether there is a number, the number, the scan from which the
    /// line is free, how many bytes are sent, what is left of the number, EN before, only zeros so far.
    SendTextSlowly,

    // Timers that count scans, counters that wrap: power, EN, PT or PV, where the tag's bits and words begin, a bit of
    // the block's own.
    ScanTon,
    ScanTof,
    ScanRto,
    WrappingCtu,
    WrappingCtd,
    WrappingCtc,

    // Timers that count a time base: power, EN, PT, where the tag's bits and words begin, time base, interval.
    TickTon,
    TickTof,
    /// EN, where the tag's bits and words begin, what it begins with, interval.
    TickReset,
    // Counters that latch: power, EN, PV, where the tag's bits and words begin.
    LatchingCtu,
    LatchingCtd,
    /// As `TickReset`.
    LatchingReset,

    // Timers that count time in a unit: power, EN, PT, where the tag's bits and words begin, unit, interval, a word of the
    // block's own.
    UnitTon,
    UnitTof,
    UnitRto,
    UnitRtof,
    // Counters whose output compares: power, EN, PV, where the tag's bits and words begin.
    ComparingCtu,
    ComparingCtd,
    ComparingCtud,

    /// A step of a formula that goes on where it slips: to, operation, type, a, b, and the bits that note a division by
    /// zero and a wrap.
    Step,
    /// The result of such a formula: to, its type, from, its type, the bits.
    Cut,
    /// A number held in another type: as `Cut`.
    Clamp,
    /// A number rounded to another type: as `Cut`.
    Round,
    /// What the controller reports of itself: slot of the array SC, its first index, how many, the same of SD, interval.
    Controller,

    /// An entry of a table: to, whether there is one, type, index, list.
    OpenTable,
    /// A point on a curve that goes on below its first point: to, whether there is one, type, x, list.
    OpenCurve,
    /// Ends the program after this scan if a bit is high.
    EndOnDivision,
}

/// Types as operands: their place in this list.
pub const TYPES: [Scalar; 20] = [
    Scalar::Bool,
    Scalar::Byte,
    Scalar::Word,
    Scalar::Dword,
    Scalar::Lword,
    Scalar::Sint,
    Scalar::Int,
    Scalar::Dint,
    Scalar::Lint,
    Scalar::Usint,
    Scalar::Uint,
    Scalar::Udint,
    Scalar::Ulint,
    Scalar::Real,
    Scalar::Lreal,
    Scalar::Time,
    Scalar::Date,
    Scalar::Tod,
    Scalar::Dt,
    Scalar::String(0),
];

/// A type as an operand.
pub(crate) fn type_operand(ty: Scalar) -> u32 {
    if let Scalar::Enum(id) = ty {
        return TYPES.len() as u32 + id.number();
    }
    let of_text = |other: &Scalar| ty.is_string() && other.is_string();
    TYPES
        .iter()
        .position(|other| *other == ty || of_text(other))
        .unwrap_or(0) as u32
}

/// Operands in their order.
struct Operands<'c> {
    rest: std::slice::Iter<'c, u32>,
    /// Elements and characters that the routine has gone through.
    work: usize,
}

impl<'c> Operands<'c> {
    fn of(operands: &'c [u32]) -> Operands<'c> {
        Operands {
            rest: operands.iter(),
            work: 0,
        }
    }

    /// Counts elements or characters that the routine goes through; those of its ranges are counted already.
    fn count(&mut self, work: usize) {
        self.work = self.work.saturating_add(work);
    }

    fn number(&mut self) -> u32 {
        self.rest.next().copied().unwrap_or(0)
    }

    fn bit(&mut self) -> Bit {
        Bit(self.number())
    }

    fn word(&mut self) -> Word {
        Word(self.number())
    }

    fn text(&mut self) -> TextSlot {
        TextSlot(self.number())
    }

    fn ty(&mut self) -> Scalar {
        let number = self.number();
        let enumeration = || EnumId::from_number(number.checked_sub(TYPES.len() as u32)?).map(Scalar::Enum);
        let elementary = TYPES.get(number as usize).copied();
        elementary.or_else(enumeration).unwrap_or(Scalar::Lint)
    }

    fn test(&mut self) -> Test {
        Test::of_operand(self.number())
    }

    /// What a word holds.
    fn value(&mut self, memory: &Memory) -> i64 {
        memory.word(self.word())
    }

    /// The slots of a range.
    fn range(&mut self, memory: &Memory) -> std::ops::Range<usize> {
        let (start, count) = (self.value(memory), self.value(memory));
        self.count(count as usize);
        start as usize..(start + count) as usize
    }

    /// The members of a list.
    fn list(&mut self) -> &'c [u32] {
        let count = self.number() as usize;
        &self.rest.as_slice()[..count]
    }
}

/// Runs a routine; gives what it counts for.
pub(crate) fn run<const FORCED: bool>(
    routine: Routine,
    memory: &mut Memory,
    operands: &[u32],
    clock: Clock,
) -> Result<u32, Trouble> {
    let mut operands = Operands::of(operands);
    let with = &mut operands;
    match routine {
        Routine::Range => ranges::find(memory, with)?,
        Routine::RangeFrom => ranges::find_from(memory, with)?,
        Routine::AllHigh => ranges::all(memory, with, 1),
        Routine::AllLow => ranges::all(memory, with, 0),
        Routine::FillBits => ranges::fill_bits::<FORCED>(memory, with),
        Routine::FillWords => ranges::fill_words::<FORCED>(memory, with),
        Routine::FillTexts => ranges::fill_texts::<FORCED>(memory, with),
        Routine::SetBits => ranges::write_bits_when::<FORCED>(memory, with, true),
        Routine::ResetBits => ranges::write_bits_when::<FORCED>(memory, with, false),
        Routine::RepeatBits => ranges::repeat_bits::<FORCED>(memory, with),
        Routine::RepeatWords => ranges::repeat_words::<FORCED>(memory, with),
        Routine::RepeatTexts => ranges::repeat_texts::<FORCED>(memory, with),
        Routine::CopyBits => ranges::copy_bits::<FORCED>(memory, with)?,
        Routine::CopyWords => ranges::copy_words::<FORCED>(memory, with)?,
        Routine::CopyTexts => ranges::copy_texts::<FORCED>(memory, with)?,
        Routine::ShiftBits => ranges::shift_bits::<FORCED>(memory, with),
        Routine::ShiftWords => ranges::shift_words::<FORCED>(memory, with),
        Routine::ShiftTexts => ranges::shift_texts::<FORCED>(memory, with),
        Routine::PackBits => ranges::pack_bits::<FORCED>(memory, with)?,
        Routine::PackWords => ranges::pack_words::<FORCED>(memory, with)?,
        Routine::UnpackBits => ranges::unpack_bits::<FORCED>(memory, with),
        Routine::UnpackWords => ranges::unpack_words::<FORCED>(memory, with),
        Routine::Sum => ranges::sum(memory, with)?,
        Routine::Search => search::search::<FORCED>(memory, with),
        Routine::SelectBit => select::bit(memory, with)?,
        Routine::SelectWord => select::word(memory, with)?,
        Routine::SelectText => select::text(memory, with)?,
        Routine::Curve => curve::point(memory, with)?,
        Routine::Length => strings::length(memory, with),
        Routine::Left => strings::left(memory, with)?,
        Routine::Right => strings::right(memory, with)?,
        Routine::Middle => strings::middle(memory, with)?,
        Routine::Concat => strings::concat(memory, with),
        Routine::Insert => strings::insert(memory, with)?,
        Routine::Delete => strings::delete(memory, with)?,
        Routine::Replace => strings::replace(memory, with)?,
        Routine::Find => strings::find(memory, with),
        Routine::Format => numerals::format(memory, with),
        Routine::FormatBit => numerals::format_bit(memory, with),
        Routine::Parse => numerals::parse(memory, with)?,
        Routine::ParseBit => numerals::parse_bit(memory, with)?,
        Routine::Enumerate => numerals::enumerate(memory, with)?,
        Routine::Send => ports::send(memory, with),
        Routine::Receive => ports::receive(memory, with),
        Routine::SendText => ports::send_text(memory, with),
        Routine::SendScanTime => ports::send_scan_time(memory, with, clock),
        Routine::ReceiveNewest => ports::receive_newest(memory, with),
        Routine::SendWhenFree => slow_serial::send(memory, with, clock),
        Routine::SendTextSlowly => slow_serial::send_text(memory, with, clock),
        Routine::ScanTon => cycles::timer::<FORCED>(memory, with, cycles::on_delay),
        Routine::ScanTof => cycles::timer::<FORCED>(memory, with, cycles::off_delay),
        Routine::ScanRto => cycles::timer::<FORCED>(memory, with, cycles::retentive),
        Routine::WrappingCtu => cycles::counter::<FORCED>(memory, with, cycles::up),
        Routine::WrappingCtd => cycles::counter::<FORCED>(memory, with, cycles::down),
        Routine::WrappingCtc => cycles::counter::<FORCED>(memory, with, cycles::circular),
        Routine::TickTon => ticks::timer::<FORCED>(memory, with, clock, true),
        Routine::TickTof => ticks::timer::<FORCED>(memory, with, clock, false),
        Routine::TickReset => ticks::reset_timer::<FORCED>(memory, with, clock),
        Routine::LatchingCtu => ticks::counter::<FORCED>(memory, with, true),
        Routine::LatchingCtd => ticks::counter::<FORCED>(memory, with, false),
        Routine::LatchingReset => ticks::reset_counter::<FORCED>(memory, with),
        Routine::UnitTon => units::timer::<FORCED>(memory, with, clock, units::Delay::On),
        Routine::UnitTof => units::timer::<FORCED>(memory, with, clock, units::Delay::Off),
        Routine::UnitRto => units::timer::<FORCED>(memory, with, clock, units::Delay::RetentiveOn),
        Routine::UnitRtof => units::timer::<FORCED>(memory, with, clock, units::Delay::RetentiveOff),
        Routine::ComparingCtu => units::counter::<FORCED>(memory, with, units::Way::Up),
        Routine::ComparingCtd => units::counter::<FORCED>(memory, with, units::Way::Down),
        Routine::ComparingCtud => units::counter::<FORCED>(memory, with, units::Way::Both),
        Routine::Step => formula::step(memory, with)?,
        Routine::Cut => formula::cut(memory, with),
        Routine::Clamp => formula::clamp(memory, with),
        Routine::Round => formula::round(memory, with),
        Routine::Controller => controller::tell::<FORCED>(memory, with, clock),
        Routine::OpenTable => tables::entry(memory, with),
        Routine::OpenCurve => tables::point(memory, with),
        Routine::EndOnDivision => {
            if memory.bit(with.bit()) {
                return Err(Trouble::DivisionEnds);
            }
        }
    }
    Ok(work::blocks(operands.work))
}
