//! What counts for the watchdog: blocks, and what a block does to many elements, characters or operands.

/// This many elements of an array, characters of a text, or operands count as one block.
pub(crate) const ELEMENTS: usize = 100;

/// A scan that has done the work of this many blocks can be cancelled; a shorter one always comes to its end.
pub(crate) const UNCANCELLED: u64 = 100_000;

/// How deep calls may nest (LANGUAGE §5.5).
pub const CALL_DEPTH: usize = 64;

/// For how many further blocks these elements count.
pub(crate) fn blocks(elements: usize) -> u32 {
    u32::try_from(elements / ELEMENTS).unwrap_or(u32::MAX)
}
