//! Which tag a point is a part of, found without a look at every tag: a controller is asked for tens of thousands of points.

use crate::layout::{Home, state_size};
use crate::tags::{Point, PointSlot};
use ladder_analysis::program::{Program, TagId};
use ladder_analysis::values::types::Type;
use std::collections::HashMap;

/// A bank of the memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Bank {
    Bits,
    Words,
    Texts,
}

/// Where the tags of a program are.
#[derive(Debug)]
pub(super) struct Held {
    /// The slots of each tag, from the first to the one after the last. Of tags with one address there is the first.
    slots: Vec<(Bank, u32, u32, TagId)>,
    /// The tags that have the states of blocks.
    holders: HashMap<String, TagId>,
}

impl Held {
    pub(super) fn of(homes: &[Home], program: &Program) -> Held {
        let all = (0..).zip(homes).flat_map(|(tag, home)| {
            let part = |bank, start: u32, len: u32| Some((bank, start, start + len, TagId(tag)));
            match *home {
                Home::Bits { at, len, .. } => [part(Bank::Bits, at.0, len), None],
                Home::Words { at, len, .. } => [part(Bank::Words, at.0, len), None],
                Home::Texts { at, len, .. } => [part(Bank::Texts, at.0, len), None],
                Home::State { state, bits, words } => {
                    let (few, many) = state_size(state);
                    [part(Bank::Bits, bits.0, few), part(Bank::Words, words.0, many)]
                }
                Home::Borrowed(_) => [None, None],
            }
        });
        let mut slots: Vec<_> = all.flatten().filter(|(_, start, end, _)| start < end).collect();
        slots.sort_by_key(|&(bank, start, _, tag)| (bank, start, tag.0));
        slots.dedup_by_key(|&mut (bank, start, ..)| (bank, start));
        let mut holders = HashMap::new();
        for (tag, declared) in (0..).zip(&program.tags) {
            if matches!(declared.ty, Type::Compound(ty) if ty.block().is_some()) {
                holders.entry(declared.name.clone()).or_insert(TagId(tag));
            }
        }
        Held { slots, holders }
    }

    /// The tag that a point is, or is a part of. None for system tags and ports.
    pub(super) fn tag_of(&self, point: &Point) -> Option<TagId> {
        let (bank, slot) = match point.slot {
            PointSlot::Bit(slot) | PointSlot::Timing { input: slot, .. } => (Bank::Bits, slot.0),
            PointSlot::Word(slot) | PointSlot::BitOf { word: slot, .. } => (Bank::Words, slot.0),
            PointSlot::Text(slot) => (Bank::Texts, slot.0),
        };
        let after = self
            .slots
            .partition_point(|&(of, start, ..)| (of, start) <= (bank, slot));
        let &(of, _, end, tag) = self.slots.get(after.checked_sub(1)?)?;
        (of == bank && slot < end).then_some(tag)
    }

    /// The tag that has the state of a block in which a point is: `m1` of `m1.t.ET`.
    pub(super) fn holder_of(&self, point: &Point) -> Option<TagId> {
        let mut dots = point.name.match_indices('.');
        dots.find_map(|(dot, _)| self.holders.get(&point.name[..dot]).copied())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simulation::{Options, Simulation};
    use std::sync::Arc;

    /// It is what a look at every tag finds, also of tags at one address, in structures, arrays and the states of blocks.
    #[test]
    fn it_finds_what_a_look_at_every_tag_does() {
        let text = "\
TYPE
    Cell : STRUCT on : BOOL; level : INT; wait : TON; END_STRUCT;
END_TYPE
VAR
    a AT %MX0.0 : BOOL;
    again AT %MX0.0 : BOOL;
    cells : ARRAY[1..3] OF Cell;
    words : ARRAY[0..7] OF WORD;
    t : TON;
    z : CTU;
    m1, m2 : $Twice;
    said : STRING;
END_VAR
+--[ ]( a )--[TON]( t, 1s )--[CTU]( z, 5 )--( )( cells[2].on )--+
+--[$Twice]( m1 )--[$Twice]( m2 )--+
FUNCTION_BLOCK [$Twice]
VAR
    n : INT;
    t : TON;
END_VAR
+--[TON]( t, 1s )--[ADD]( n, n, 1 )--+
END_FUNCTION_BLOCK
";
        let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(text)), "held.clad");
        let program = analysis.program().cloned();
        let program = program.unwrap_or_else(|| panic!("{:?}", analysis.errors().collect::<Vec<_>>()));
        let simulation = Simulation::new(program, Options::default()).unwrap();
        let homes = &simulation.compiled.homes;
        let held = Held::of(homes, simulation.program());
        let mut holders = 0;
        for point in simulation.points() {
            let plain = homes.iter().position(|home| home.holds(point.slot));
            assert_eq!(
                held.tag_of(point).map(|tag| tag.0 as usize),
                plain,
                "{}",
                point.name
            );
            if let Some(holder) = held.holder_of(point) {
                let name = &simulation.program().tags[holder.0 as usize].name;
                assert!(point.name.starts_with(&format!("{name}.")), "{}", point.name);
                holders += 1;
            }
        }
        assert!(simulation.points().len() > 30 && holders > 3, "{holders}");
    }
}
