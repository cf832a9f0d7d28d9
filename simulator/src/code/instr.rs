//! The instructions of flat code.

use crate::memory::{Bit, TextSlot, Word};
use crate::operation::{Conversion, IntegerOp, RealFunction, RealOp, Test, Width};
use crate::routine::Routine;

/// One instruction. At most 24 bytes, so that code stays dense; a test watches over it.
///
/// `out` is the power that an instruction gives, `en` the power it takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Instr {
    // Power.
    /// EN and tag.
    Contact {
        out: Bit,
        en: Bit,
        tag: Bit,
    },
    /// EN and not tag.
    NegatedContact {
        out: Bit,
        en: Bit,
        tag: Bit,
    },
    /// A pair of connectors.
    Join {
        out: Bit,
        upper: Bit,
        lower: Bit,
    },
    /// Not EN.
    Invert {
        out: Bit,
        en: Bit,
    },
    /// The same power in a slot of its own, where the block may still take it back.
    Follow {
        out: Bit,
        en: Bit,
    },
    /// The left rail, where an `<MCR>` may have switched it off.
    Rail {
        out: Bit,
    },
    /// EN and tag is high and was low at the last evaluation.
    Rising {
        out: Bit,
        en: Bit,
        tag: Bit,
        before: Bit,
    },
    /// EN and tag is low and was high at the last evaluation.
    Falling {
        out: Bit,
        en: Bit,
        tag: Bit,
        before: Bit,
    },

    // Comparisons: EN and a op b.
    /// Whole numbers by value.
    Compare {
        test: Test,
        out: Bit,
        en: Bit,
        a: Word,
        b: Word,
    },
    /// The same where a, b or both are unsigned with 64 bits.
    CompareUnsigned {
        test: Test,
        a_unsigned: bool,
        b_unsigned: bool,
        out: Bit,
        en: Bit,
        a: Word,
        b: Word,
    },
    /// Reals.
    CompareReal {
        test: Test,
        out: Bit,
        en: Bit,
        a: Word,
        b: Word,
    },
    /// BOOLs.
    CompareBit {
        test: Test,
        out: Bit,
        en: Bit,
        a: Bit,
        b: Bit,
    },
    /// Texts, byte by byte.
    CompareText {
        test: Test,
        out: Bit,
        en: Bit,
        a: TextSlot,
        b: TextSlot,
    },

    // Coils.
    /// tag = EN
    Coil {
        en: Bit,
        tag: Bit,
    },
    /// tag = not EN
    NegatedCoil {
        en: Bit,
        tag: Bit,
    },
    /// EN high: tag = TRUE
    Set {
        en: Bit,
        tag: Bit,
    },
    /// EN high: tag = FALSE
    Reset {
        en: Bit,
        tag: Bit,
    },

    /// Begins a block that acts when EN is high: gives EN, and with EN low goes on at `end`. A fault on the way
    /// takes the power back.
    Powered {
        out: Bit,
        en: Bit,
        end: u32,
    },

    // Bits.
    MoveBit {
        to: Bit,
        from: Bit,
    },
    AndBit {
        to: Bit,
        a: Bit,
        b: Bit,
    },
    OrBit {
        to: Bit,
        a: Bit,
        b: Bit,
    },
    XorBit {
        to: Bit,
        a: Bit,
        b: Bit,
    },
    NotBit {
        to: Bit,
        a: Bit,
    },
    /// One bit of a word.
    LoadBitOf {
        to: Bit,
        word: Word,
        bit: u8,
    },
    /// The word keeps its type's representation: bit 15 of an INT is its sign.
    StoreBitOf {
        word: Word,
        bit: u8,
        width: Width,
        from: Bit,
    },

    // Words.
    Move {
        to: Word,
        from: Word,
    },
    MoveWhen {
        out: Bit,
        en: Bit,
        to: Word,
        from: Word,
    },
    Integer {
        op: IntegerOp,
        width: Width,
        to: Word,
        a: Word,
        b: Word,
    },
    IntegerWhen {
        op: IntegerOp,
        width: Width,
        out: Bit,
        en: Bit,
        to: Word,
        a: Word,
        b: Word,
    },
    Real {
        op: RealOp,
        single: bool,
        to: Word,
        a: Word,
        b: Word,
    },
    RealWhen {
        op: RealOp,
        single: bool,
        out: Bit,
        en: Bit,
        to: Word,
        a: Word,
        b: Word,
    },
    RealFunction {
        function: RealFunction,
        single: bool,
        to: Word,
        a: Word,
    },
    Convert {
        conversion: Conversion,
        to: Word,
        from: Word,
    },
    /// BOOL to a number, 0 or 1.
    BitToWord {
        to: Word,
        from: Bit,
    },

    // Texts.
    MoveText {
        to: TextSlot,
        from: TextSlot,
    },

    // Elements of arrays whose index is known only when they are reached.
    /// The slot of an element; `array` is an index into [`Code::arrays`](super::Code::arrays).
    Index {
        to: Word,
        index: Word,
        array: u32,
    },
    LoadBit {
        to: Bit,
        at: Word,
    },
    StoreBit {
        at: Word,
        from: Bit,
    },
    LoadWord {
        to: Word,
        at: Word,
    },
    StoreWord {
        at: Word,
        from: Word,
    },
    LoadText {
        to: TextSlot,
        at: Word,
    },
    StoreText {
        at: Word,
        from: TextSlot,
    },

    // Timers, counters, bistables: `bits` and `words` are where the tag's state begins.
    Ton {
        out: Bit,
        en: Bit,
        pt: Word,
        bits: Bit,
        words: Word,
    },
    Tof {
        out: Bit,
        en: Bit,
        pt: Word,
        bits: Bit,
        words: Word,
    },
    Tp {
        out: Bit,
        en: Bit,
        pt: Word,
        bits: Bit,
        words: Word,
    },
    Rto {
        out: Bit,
        en: Bit,
        pt: Word,
        bits: Bit,
        words: Word,
    },
    Rtof {
        out: Bit,
        en: Bit,
        pt: Word,
        bits: Bit,
        words: Word,
    },
    Ctu {
        out: Bit,
        en: Bit,
        pv: Word,
        bits: Bit,
        words: Word,
    },
    Ctd {
        out: Bit,
        en: Bit,
        pv: Word,
        bits: Bit,
        words: Word,
    },
    Ctud {
        out: Bit,
        en: Bit,
        pv: Word,
        bits: Bit,
        words: Word,
    },
    Ctc {
        out: Bit,
        en: Bit,
        pv: Word,
        bits: Bit,
        words: Word,
    },
    Sr {
        out: Bit,
        en: Bit,
        reset: Bit,
        bits: Bit,
    },
    Rs {
        out: Bit,
        en: Bit,
        reset: Bit,
        bits: Bit,
    },
    /// Any of these, where the words `bits` and `words` hold the slots at which the state begins. The operand is that of the
    /// instruction: the word of PT or PV, the bit of a bistable's reset.
    StateAt {
        op: ladder_instructions::Op,
        out: Bit,
        en: Bit,
        operand: u32,
        bits: Word,
        words: Word,
    },
    /// `Clear` likewise.
    ClearAt {
        en: Bit,
        state: ladder_instructions::StateType,
        bits: Word,
        words: Word,
    },
    /// `(RES)`, and `(R)` on such a tag.
    Clear {
        en: Bit,
        state: ladder_instructions::StateType,
        bits: Bit,
        words: Word,
    },

    /// Boolean networks as truth tables, see `fuse`: one of [`Code::records`](super::Code::records).
    Record {
        at: u32,
    },
    /// Several in a row.
    Records {
        start: u32,
        count: u32,
    },

    /// The rarer work: `operands` is an index into [`Code::operands`](super::Code::operands).
    Routine {
        routine: Routine,
        operands: u32,
    },

    /// An unread part, one of [`Code::unread`](super::Code::unread): nothing is done. What it may write, also its power, is
    /// written before.
    Unread {
        at: u32,
    },

    // Program flow.
    /// The network that begins here is reached; it is noted where not every scan reaches it.
    Network {
        network: u32,
    },
    /// A network is left at this step; what follows it there is not reached.
    Left {
        step: u32,
        network: u32,
    },
    /// EN high: goes on at `to`, which lies in the same frame. Ends a loop unless `to` lies in its body.
    Jump {
        en: Bit,
        to: u32,
        step: u32,
        network: u32,
    },
    /// EN high: calls.
    Call {
        en: Bit,
        to: u32,
        saved: u32,
    },
    /// EN high: returns, or in the main program ends the scan.
    Return {
        en: Bit,
        step: u32,
        network: u32,
    },
    /// EN high: ends the program.
    End {
        en: Bit,
        step: u32,
        network: u32,
    },
    /// The end of the main program or of a function.
    Finish,
    /// `<FOR>`: EN high: the turns that are to be made.
    For {
        en: Bit,
        turns: Word,
    },
    /// The end of the network of a `<FOR>`: enters the body, which ends before `after`, or goes on after it.
    Enter {
        body: u32,
        after: u32,
    },
    /// Each turn begins: its number, in the type of the tag that takes it.
    Turn {
        to: Word,
        width: Width,
    },
    /// The end of the network of a `<NEXT>`: of the loop with this body, if that is the one that runs.
    Again {
        body: u32,
    },
    /// `<MCR>`
    Mcr {
        en: Bit,
    },
    /// The body of a user-defined block begins: rails are live, loops are its own.
    EnterBody,
    /// It ends.
    LeaveBody,
}

/// For a call that cannot come back to its own network.
pub const NOTHING_SAVED: u32 = u32::MAX;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn instructions_are_small() {
        assert_eq!(size_of::<Instr>(), 24);
    }
}
