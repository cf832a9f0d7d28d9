//! Places next to one another, which one request reads or writes.

use super::bind::Entry;
use super::place::{Place, Table};
use std::fmt;
use std::ops::Range;

/// So many places that nobody asked for are read along, if nothing else is asked for.
pub(super) const GAP: usize = 8;

/// Places that one request asks for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Block {
    pub(super) first: Place,
    /// How many bits or words from there on.
    pub(super) count: usize,
    /// Which of the entries are in it.
    pub(super) entries: Range<usize>,
}

/// How large a block may be.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits {
    /// So many bits or words of a table go with one request.
    most: fn(Table) -> usize,
    /// Entries that are so many places apart are still in one block.
    gap: usize,
}

impl Limits {
    /// What one request reads.
    pub(super) fn of_reading(gap: usize) -> Limits {
        Limits {
            most: Table::most_read,
            gap,
        }
    }

    /// What one request writes. Nothing between two entries may be written.
    pub(super) const OF_WRITING: Limits = Limits {
        most: Table::most_written,
        gap: 0,
    };
}

/// The blocks of entries that are in the order of their places. A value of several words is in one block.
pub(super) fn blocks(entries: &[Entry], limits: Limits) -> Vec<Block> {
    let mut blocks: Vec<Block> = Vec::new();
    for (index, Entry { place, width, .. }) in entries.iter().enumerate() {
        let number = usize::from(place.number);
        let fits = |block: &&mut Block| {
            let begins = usize::from(block.first.number);
            block.first.table == place.table
                && number <= begins + block.count + limits.gap
                && number + width - begins <= (limits.most)(place.table)
        };
        if let Some(block) = blocks.last_mut().filter(fits) {
            block.count = number + width - usize::from(block.first.number);
            block.entries.end = index + 1;
        } else {
            blocks.push(Block {
                first: *place,
                count: *width,
                entries: index..index + 1,
            });
        }
    }
    blocks
}

impl fmt::Display for Block {
    /// `holding 4`, `discrete 0..7`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.first)?;
        match self.count {
            0 | 1 => Ok(()),
            count => write!(f, "..{}", usize::from(self.first.number) + count - 1),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::simulation;
    use expect_test::{Expect, expect};
    use proptest::prelude::*;

    /// Entries of these widths, each so many places after the end of the one before.
    fn entries(table: Table, after: &[(usize, usize)]) -> Vec<Entry> {
        let simulation = simulation("+--[ ]( a )--( )( b )--+\n", 10_000_000);
        let point = simulation.resolve("a").unwrap();
        let mut end = 0;
        let entries = after.iter().map(|(gap, width)| {
            let number = end + gap;
            end = number + width;
            Entry {
                place: Place {
                    table,
                    number: u16::try_from(number).unwrap(),
                },
                point: point.clone(),
                width: *width,
                at: 0..0,
                may_be_written: false,
            }
        });
        entries.collect()
    }

    fn check(table: Table, after: &[(usize, usize)], limits: Limits, expected: Expect) {
        let blocks = blocks(&entries(table, after), limits);
        let blocks: Vec<String> = blocks.iter().map(ToString::to_string).collect();
        expected.assert_eq(&blocks.join(", "));
    }

    #[test]
    fn small_gaps_are_read_along_and_never_written() {
        let after = [(3, 1), (8, 2), (9, 1), (0, 4)];
        let reading = Limits::of_reading(8);
        check(
            Table::Holding,
            &after,
            reading,
            expect!["holding 3..13, holding 23..27"],
        );
        check(
            Table::Holding,
            &after,
            Limits::OF_WRITING,
            expect!["holding 3, holding 12..13, holding 23..27"],
        );
        check(Table::Coil, &[(7, 1)], Limits::OF_WRITING, expect!["coil 7"]);
    }

    #[test]
    fn a_value_is_not_cut() {
        // The 63rd would end at 126.
        let many = [(0, 2); 64];
        check(
            Table::Input,
            &many,
            Limits::of_reading(8),
            expect!["input 0..123, input 124..127"],
        );
        let many = vec![(0, 1); 2001];
        check(
            Table::Discrete,
            &many,
            Limits::of_reading(8),
            expect!["discrete 0..1999, discrete 2000"],
        );
    }

    proptest! {
        #[test]
        fn each_entry_is_in_one_block(
            after in prop::collection::vec((0usize..20, prop::sample::select(vec![1usize, 2, 4])), 0..200),
            gap in 0usize..10,
        ) {
            let entries = entries(Table::Holding, &after);
            let blocks = blocks(&entries, Limits::of_reading(gap));
            let mut next = 0;
            for block in &blocks {
                prop_assert_eq!(block.entries.start, next);
                prop_assert!(block.entries.end > next && block.count <= 125);
                next = block.entries.end;
                let own = &entries[block.entries.clone()];
                let last = own.last().unwrap();
                let end = usize::from(last.place.number) + last.width;
                prop_assert_eq!(own[0].place, block.first);
                prop_assert_eq!(end, usize::from(block.first.number) + block.count);
            }
            prop_assert_eq!(next, entries.len());
        }
    }
}
