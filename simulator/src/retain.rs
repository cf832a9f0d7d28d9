//! What keeps its value over a warm restart (LANGUAGE §5.4).

use crate::layout::{Home, state_size, timer};
use crate::memory::{Bit, Memory, TextSlot, Word};
use ladder_analysis::program::{Argument, BlockKind, Place, Program, Tag, TagId};
use ladder_instructions::Op;

/// The slots of one retentive tag.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Retained(Home);

impl Retained {
    /// Copies the tag's value from a memory that was running until `then`. A timer goes on where it was: its
    /// instant is moved to before the new clock's zero.
    pub(crate) fn restore(self, memory: &mut Memory, kept: &Memory, then: i64) {
        let bits = |memory: &mut Memory, at: Bit, len: u32| {
            let range = at.0 as usize..(at.0 + len) as usize;
            memory.bits[range.clone()].copy_from_slice(&kept.bits[range]);
        };
        let words = |memory: &mut Memory, at: Word, len: u32| {
            let range = at.0 as usize..(at.0 + len) as usize;
            memory.words[range.clone()].copy_from_slice(&kept.words[range]);
        };
        match self.0 {
            Home::Bits { at, len, .. } => bits(memory, at, len),
            Home::Words { at, len, .. } => words(memory, at, len),
            Home::Texts { at, len, .. } => {
                for slot in at.0..at.0 + len {
                    memory.texts[slot as usize].set(kept.text(TextSlot(slot)));
                }
            }
            Home::State {
                state,
                bits: first_bit,
                words: first_word,
            } => {
                let (bit_count, word_count) = state_size(state);
                bits(memory, first_bit, bit_count);
                words(memory, first_word, word_count);
                if state.is_timer() {
                    let since = &mut memory.words[first_word.offset(timer::SINCE).0 as usize];
                    *since = since.saturating_sub(then);
                    memory.words[first_word.offset(timer::STAMP).0 as usize] = 0;
                }
                if state.is_counter() {
                    memory.words[first_word.offset(crate::layout::counter::STAMP).0 as usize] = 0;
                }
            }
            Home::Element { .. } | Home::BitOf { .. } | Home::BitOfAt { .. } | Home::Unbound => {}
        }
    }
}

/// The tags of a program that are retentive: declared so, or written by `(M)` `(SM)` `(RM)`, or named by
/// `[PERSIST]`.
pub(crate) fn retained(program: &Program, homes: &[Home], of_bodies: &[Home]) -> Vec<Retained> {
    let mut keeps: Vec<bool> = program.tags.iter().map(|tag| tag.retain).collect();
    for block in program.networks.iter().flat_map(|network| &network.blocks) {
        let BlockKind::Instruction(row) = block.kind else {
            continue;
        };
        if !matches!(
            row.op,
            Op::RetentiveCoil | Op::RetentiveSet | Op::RetentiveReset | Op::Persist
        ) {
            continue;
        }
        if let Some(tag) = block.arguments.first().and_then(|bound| tag_of(&bound.argument)) {
            keeps[tag.0 as usize] = true;
        }
    }
    // The tags of a body have a home for each place where the block stands; the last one is no better than the rest.
    let is_shared = |tag: &Tag| tag.block.is_none();
    let kept = homes.iter().zip(&program.tags).zip(keeps);
    let shared = kept
        .filter(|((_, tag), keep)| *keep && is_shared(tag))
        .map(|((home, _), _)| home);
    shared.chain(of_bodies).map(|home| Retained(*home)).collect()
}

fn tag_of(argument: &Argument) -> Option<TagId> {
    match argument {
        Argument::Place(place, _) => tag_of_place(place),
        Argument::Range(range) => Some(range.tag),
        Argument::State(tag) => Some(*tag),
        _ => None,
    }
}

fn tag_of_place(place: &Place) -> Option<TagId> {
    match place {
        Place::Tag(tag) | Place::Element(tag, _) | Place::Member(tag, _) => Some(*tag),
        Place::Bit(word, ..) => tag_of_place(word),
        Place::System(_) => None,
    }
}
