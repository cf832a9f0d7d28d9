//! What keeps its value over a warm restart (LANGUAGE §5.4).
//!
//! Always a whole tag: `(M)( w.3 )` keeps all of `w`, `[PERSIST]( a[2] )` the array, and of a timer, counter or
//! bistable everything it remembers. The state of a user-defined block that is a retentive tag is kept whole, with its edges and
//! the blocks in it. Any other memory of edges belongs to a place in the text and is not kept.

mod kept;

use crate::layout::{Home, state_size, timer};
use crate::memory::{Bit, Memory, TextSlot, Word};
pub use kept::Kept;
pub(crate) use kept::{kept, restore};
use ladder_analysis::program::{Argument, BlockKind, ParameterKind, Program, Tag, TagId};
use ladder_instructions::Op;
use std::collections::HashMap;

/// One retentive tag, or an edge of a block whose state is one.
#[derive(Debug, Clone, PartialEq)]
pub struct Retained {
    /// Its name; for a tag in the body of a user-defined block with the place where the block is, counted in
    /// the order in which they run first: `$Debounce[2].t`. An edge has that of the state, what remembers it and its number there:
    /// `door.OSR#1`.
    pub name: String,
    /// None of an edge.
    pub(crate) tag: Option<TagId>,
    /// Where it lives.
    pub home: Home,
}

impl Retained {
    /// Whether it is at the same place as another, whatever their names are.
    pub(crate) fn lives_as(&self, other: &Retained) -> bool {
        (self.tag, self.home) == (other.tag, other.home)
    }

    /// Copies the tag's value from a memory that was running until `then`. A timer goes on where it was: its
    /// instant is moved to before the new clock's zero.
    pub(crate) fn restore(&self, memory: &mut Memory, kept: &Memory, then: i64) {
        copy(self.home, memory, kept);
        self.shift_clock(memory, then.saturating_neg());
    }

    /// Moves the instant of a timer, whose clock did not run for a while or begins elsewhere.
    pub(crate) fn shift_clock(&self, memory: &mut Memory, by: i64) {
        if let Home::State { state, words, .. } = self.home
            && state.is_timer()
        {
            let since = &mut memory.words[words.offset(timer::SINCE).0 as usize];
            *since = since.saturating_add(by);
        }
    }
}

/// Copies what lives there from another memory of the same program.
pub(crate) fn copy(home: Home, memory: &mut Memory, from: &Memory) {
    let mut bits = |at: Bit, len: u32| {
        let range = at.0 as usize..(at.0 + len) as usize;
        memory.bits[range.clone()].copy_from_slice(&from.bits[range]);
    };
    let mut words = |at: Word, len: u32| {
        let range = at.0 as usize..(at.0 + len) as usize;
        memory.words[range.clone()].copy_from_slice(&from.words[range]);
    };
    match home {
        Home::Bits { at, len, .. } => bits(at, len),
        Home::Words { at, len, .. } => words(at, len),
        Home::Texts { at, len, .. } => {
            for slot in at.0..at.0 + len {
                memory.texts[slot as usize].set(from.text(TextSlot(slot)));
            }
        }
        Home::State {
            state,
            bits: first_bit,
            words: first_word,
        } => {
            let (bit_count, word_count) = state_size(state);
            bits(first_bit, bit_count);
            words(first_word, word_count);
        }
        Home::Borrowed(_) => {}
    }
}

/// The retentive tags of a program, see [`kept_tags`]. `of_bodies` are those of user-defined blocks, one for each
/// place, in the order of the code, `edges` those of blocks whose states are retentive.
pub(crate) fn retained(
    program: &Program,
    homes: &[Home],
    keeps: &[bool],
    of_bodies: &[(TagId, Home)],
    edges: Vec<(String, Home)>,
) -> Vec<Retained> {
    let is_shared = |tag: &Tag| tag.block.is_none();
    let shared = (0..).map(TagId).zip(homes.iter().zip(&program.tags).zip(keeps));
    let shared = shared.filter(|(_, ((_, tag), keep))| **keep && is_shared(tag));
    let mut retained: Vec<Retained> = shared
        .map(|(id, ((home, tag), _))| Retained {
            name: tag.name.clone(),
            tag: Some(id),
            home: *home,
        })
        .collect();
    let mut places: HashMap<TagId, u32> = HashMap::new();
    retained.extend(of_bodies.iter().map(|&(id, home)| {
        let place = places.entry(id).or_default();
        *place += 1;
        let tag = &program.tags[id.0 as usize];
        let block = tag.block.map_or("", |block| &program.blocks[block].name);
        Retained {
            name: format!("{block}[{place}].{}", tag.name),
            tag: Some(id),
            home,
        }
    }));
    let edges = edges.into_iter();
    retained.extend(edges.map(|(name, home)| Retained {
        name,
        tag: None,
        home,
    }));
    retained
}

/// Of each tag whether it is retentive: declared so, or written by `(M)` `(SM)` `(RM)`, or named by `[PERSIST]`; also
/// where a user-defined block does that to what an in-out stands for.
pub(crate) fn kept_tags(program: &Program) -> Vec<bool> {
    // What a plant keeps never leaves memory: the machine does not go away.
    let is_of_plant = |tag: &Tag| program.plant_of(&tag.name).is_some();
    let mut keeps: Vec<bool> = program.tags.iter().map(|tag| tag.retain).collect();
    let blocks = || program.networks.iter().flat_map(|network| &network.blocks);
    for block in blocks() {
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
    // Blocks inside blocks hand in-outs on.
    let mut grew = !program.blocks.is_empty();
    while grew {
        grew = false;
        for block in blocks() {
            let BlockKind::User(index) = block.kind else {
                continue;
            };
            for bound in &block.arguments {
                let parameter = bound
                    .parameter
                    .and_then(|n| program.blocks[index].parameters.get(n));
                if let Some(&(inner, ParameterKind::InOut)) = parameter
                    && keeps[inner.0 as usize]
                    && let Some(outer) = tag_of(&bound.argument)
                {
                    grew |= !std::mem::replace(&mut keeps[outer.0 as usize], true);
                }
            }
        }
    }
    for (body, own) in program.instances.iter().flat_map(|instance| &instance.tags) {
        keeps[own.0 as usize] |= keeps[body.0 as usize];
    }
    for (keep, _) in keeps
        .iter_mut()
        .zip(&program.tags)
        .filter(|(_, tag)| is_of_plant(tag))
    {
        *keep = false;
    }
    keeps
}

fn tag_of(argument: &Argument) -> Option<TagId> {
    match argument {
        Argument::Place(place, _) => place.root(),
        Argument::Range(range) => Some(range.tag),
        Argument::State(tag) => Some(*tag),
        Argument::ChosenState(chosen) => Some(chosen.first),
        _ => None,
    }
}
