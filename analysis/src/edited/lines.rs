//! Where a text differs from an earlier one, and whether what is known of that can be followed to it.

use super::declarations;
use crate::context::Context;
use crate::profile;
use crate::user_block::is_doubtful;
use ladder_syntax::{Line, LineKind, Mode, Parse};
use std::ops::Range;

/// Where two texts differ, in lines and bytes.
pub(crate) struct Lines {
    /// The lines of the earlier text, and of the later one.
    pub(crate) old: Range<usize>,
    pub(crate) new: Range<usize>,
    /// How many more lines and bytes the later one has.
    pub(crate) added: isize,
    pub(crate) added_bytes: i64,
}

/// What an edit has changed.
pub(crate) enum Change {
    /// Networks, and nothing but networks.
    Networks(Lines),
    /// Lines of declarations.
    Declarations(Lines),
}

/// Where the texts differ, if that can be followed.
pub(crate) fn change(before: &Context, parse: &Parse) -> Option<Change> {
    let (old, new) = (before.parse.lines(), parse.lines());
    let (above, below) = new.shared_with(old);
    let change = Lines {
        old: above..old.len() - below,
        new: above..new.len() - below,
        added: new.len() as isize - old.len() as isize,
        added_bytes: i64::from(u32::from(parse.text_len())) - i64::from(u32::from(before.parse.text_len())),
    };
    let drawn = |line: &Line| {
        line.mode_after == Mode::Network
            && (line.kind == LineKind::Rung || line.kind == LineKind::Stray || line.kind.is_decoration())
    };
    if before.parse.unclosed_comment().is_some() || parse.unclosed_comment().is_some() {
        return None;
    }
    if above < before.declared_to && declarations::are_lines_of(before, &change, new) {
        return Some(Change::Declarations(change));
    }
    // In a file without networks all tags are new ones, of which nothing is known.
    let first = before.networks.first()?;
    let below_first = first.first_line + first.line_count() <= above;
    let says_the_same = || profile::profile(parse) == before.profile && profile::cycle(parse) == before.cycle;
    // Callers of a block know less of one with such a line.
    let doubtful = |parse: &Parse, lines: &Range<usize>| {
        let mut numbers = lines.clone();
        let blocks = &parse.frame().blocks;
        let in_block = |line: usize| blocks.iter().any(|block| block.lines.contains(&line));
        numbers.any(|line| is_doubtful(&parse.lines()[line]) && in_block(line))
    };
    let plain = (below_first || says_the_same())
        && !doubtful(&before.parse, &change.old)
        && !doubtful(parse, &change.new)
        && old.range(change.old.clone()).all(drawn)
        && new.range(change.new.clone()).all(drawn);
    plain.then_some(Change::Networks(change))
}

/// Where a network's lines are in the earlier text, if they are there.
pub(crate) fn same_lines(drawn: &Range<usize>, change: &Lines) -> Option<usize> {
    if drawn.end <= change.new.start {
        Some(drawn.start)
    } else if drawn.start >= change.new.end {
        Some(drawn.start.wrapping_add_signed(-change.added))
    } else {
        None
    }
}
