//! Wide networks on a narrow screen.
//!
//! The right-hand blocks of a network are at its right rail, after wires that may be long. Where all lines of the network
//! have nothing but wire, or nothing at all, columns are left out, so that conditions and coils are seen together:
//!
//! ```text
//! +--\--[ ]( start )--\--------------------------( )( run )--+
//! |  /--[ ]( run )----/                                      |
//!
//! +--\--[ ]( start )--\--( )( run )--+      as narrow as it can be; never narrower than the screen wants
//! |  /--[ ]( run )----/              |
//! ```
//!
//! A network that is too wide even so begins at its left. Its right-hand blocks stay at the right edge, and what is between
//! them and the left part is brought into sight by the selection.

use std::ops::Range;

/// Wider drawings are only scrolled: they are no work of people.
const WIDEST: usize = 4096;

/// The left part has at least this many columns next to right-hand blocks that are held at the edge.
const LEFT_PART: usize = 16;

/// Between the rail and the values after it.
const GAP: usize = 2;

/// What is brought into sight has this many columns around it.
const AROUND: usize = 4;

/// Less room is none for a value.
const VALUE: usize = 6;

/// This many equal columns stay of a wire.
const KEPT: usize = 2;

/// What one column of a line holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Content {
    Blank,
    Wire,
    /// A block, connector, rail or comment.
    Fixed,
}

/// One line of a band, as far as folding asks.
#[derive(Debug, Default)]
pub(super) struct LineShape {
    /// Its columns up to its right rail.
    pub(super) columns: Vec<Content>,
    /// The columns of its blocks.
    pub(super) blocks: Vec<Range<usize>>,
    /// How many columns it has with all that is after the rail.
    pub(super) full: usize,
    /// How many columns the values at its end take.
    pub(super) values: usize,
}

/// Lines that are folded and scrolled together: a network, or what is between two.
#[derive(Debug, Default)]
pub(super) struct Band {
    pub(super) lines: Range<usize>,
    /// Its columns up to the right rail.
    width: usize,
    full: usize,
    /// What the values after the rail take, with the gap before them.
    values: usize,
    /// The columns that can be left out, from left to right.
    spare: Vec<Range<usize>>,
    tail: Option<Tail>,
}

/// The right-hand blocks.
#[derive(Debug, Clone, Copy)]
struct Tail {
    /// Where the first of them begins.
    start: usize,
    /// This many columns of wire before it go with it, to show that there is something between.
    wire: usize,
}

impl Band {
    /// Lines that are no network: they are only scrolled.
    pub(super) fn plain(lines: Range<usize>, full: usize) -> Band {
        Band {
            lines,
            width: full,
            full,
            ..Band::default()
        }
    }

    /// A network.
    pub(super) fn network(lines: Range<usize>, shapes: &[LineShape]) -> Band {
        let most = |of: fn(&LineShape) -> usize| shapes.iter().map(of).max().unwrap_or(0);
        let full = most(|line| line.full);
        if full > WIDEST {
            return Band::plain(lines, full);
        }
        let width = most(|line| line.columns.len());
        let mut spare: Vec<bool> = vec![true; width];
        for line in shapes {
            let at = |column: usize| line.columns.get(column).copied().unwrap_or(Content::Blank);
            for (column, spare) in spare.iter_mut().enumerate() {
                *spare &= column >= KEPT
                    && at(column) != Content::Fixed
                    && (1..=KEPT).all(|back| at(column - back) == at(column));
            }
        }
        Band {
            lines,
            width,
            full,
            values: match most(|line| line.values) {
                0 => 0,
                values => GAP + values,
            },
            spare: runs(&spare),
            tail: tail(shapes),
        }
    }

    /// The fewest columns that it can be shown in.
    fn least(&self) -> usize {
        self.width - self.spare.iter().map(Range::len).sum::<usize>()
    }
}

/// The ranges of what is true.
fn runs(flags: &[bool]) -> Vec<Range<usize>> {
    let mut runs: Vec<Range<usize>> = Vec::new();
    for (at, _) in flags.iter().enumerate().filter(|(_, flag)| **flag) {
        match runs.last_mut() {
            Some(run) if run.end == at => run.end = at + 1,
            _ => runs.push(at..at + 1),
        }
    }
    runs
}

/// Where the blocks begin that have nothing but wire between them and the right rail: the leftmost of them, or of the
/// blocks that reach into their columns.
fn tail(shapes: &[LineShape]) -> Option<Tail> {
    let at_the_rail = shapes.iter().filter_map(|line| {
        let last = line.blocks.last()?;
        let (_rail, after) = line.columns.get(last.end..)?.split_last()?;
        after
            .iter()
            .all(|content| *content == Content::Wire)
            .then_some(last.start)
    });
    let mut start = at_the_rail.min()?;
    loop {
        let blocks = shapes.iter().flat_map(|line| &line.blocks);
        let reaching = blocks.filter(|block| block.start < start && start < block.end);
        match reaching.map(|block| block.start).min() {
            Some(further) => start = further,
            None => break,
        }
    }
    let is_open = |column: usize| {
        shapes.iter().all(|line| {
            line.columns
                .get(column)
                .is_none_or(|content| *content != Content::Fixed)
        })
    };
    let wire = (1..=KEPT)
        .take_while(|back| *back < start && is_open(start - back))
        .count();
    Some(Tail { start, wire })
}

/// What a pane of some width asks of all bands.
#[derive(Debug, Clone, Copy)]
pub(super) struct Folding {
    pane: usize,
    /// The width that all networks have, so that their rails are below each other; one that cannot be so narrow is as
    /// narrow as it can be.
    wanted: usize,
}

impl Folding {
    /// The width at which every network that can be shown whole has room for the values at its ends, or for some of them.
    pub(super) fn new(bands: &[Band], pane: usize) -> Folding {
        let wanted = bands
            .iter()
            .filter(|band| band.width + band.values > pane && band.least() + GAP + VALUE <= pane)
            .map(|band| band.least().max(pane.saturating_sub(band.values)))
            .min();
        Folding {
            pane,
            wanted: wanted.unwrap_or(pane),
        }
    }

    /// What is seen of a band that is scrolled by `left` columns.
    pub(super) fn window(self, band: &Band, left: usize) -> Window {
        let target = self.wanted.max(band.least()).min(band.width);
        let cuts = cuts(&band.spare, band.width - target);
        let mut window = Window {
            cuts,
            pane: self.pane,
            left,
            full: band.full - (band.width - target),
            split: None,
        };
        window.left = left.min(window.most_left());
        if let Some(tail) = band.tail.filter(|_| window.left + self.pane < target) {
            window.split = split(
                self.pane,
                window.column(tail.start) - tail.wire,
                target,
                band.values,
            );
        }
        window
    }

    /// How far to scroll so that some columns of a band are seen: not at all if that is enough, else as little as it takes.
    pub(super) fn left_for(self, band: &Band, left: usize, columns: &Range<usize>) -> usize {
        let home = self.window(band, 0);
        if home.shows(columns) {
            return 0;
        }
        let window = self.window(band, left);
        if window.shows(columns) {
            return window.left;
        }
        let (first, last) = (window.column(columns.start), window.column(columns.end));
        // Right-hand blocks that are held now may not be held there.
        let part = home.left_part();
        let left = if first < window.left {
            first.saturating_sub(AROUND).max(last.saturating_sub(part))
        } else {
            (last + AROUND).saturating_sub(part)
        };
        // Of what is wider than the pane the beginning is seen.
        left.min(first).min(window.most_left())
    }
}

/// Columns of the drawing that are left out.
#[derive(Debug)]
pub(super) struct Cut {
    pub(super) columns: Range<usize>,
    /// How many are left out before these.
    before: usize,
}

/// Leaves out this many columns of the runs, of the longest first, each from its start.
pub(super) fn cuts(spare: &[Range<usize>], number: usize) -> Vec<Cut> {
    if number == 0 {
        return Vec::new();
    }
    let left_out =
        |longest: usize| -> usize { spare.iter().map(|run| run.len().saturating_sub(longest)).sum() };
    // The longest that a run may stay.
    let (mut low, mut high) = (0, spare.iter().map(Range::len).max().unwrap_or(0));
    while low < high {
        let middle = (low + high).div_ceil(2);
        if left_out(middle) >= number {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    let mut too_many = left_out(low).saturating_sub(number);
    let mut cuts = Vec::new();
    let mut before = 0;
    for run in spare {
        let mut length = run.len().saturating_sub(low);
        let back = too_many.min(length).min(1);
        length -= back;
        too_many -= back;
        if length > 0 {
            let columns = run.start..run.start + length;
            cuts.push(Cut { columns, before });
            before += length;
        }
    }
    cuts
}

/// Right-hand blocks at the edge, with room for the values after them if there is enough.
fn split(pane: usize, tail: usize, end: usize, values: usize) -> Option<Split> {
    let at = |values: usize| pane.checked_sub(end - tail + values + 1);
    // Values are worth less than half of the pane, right-hand blocks less than two thirds.
    let with_values = at(values).filter(|at| values > 0 && *at >= LEFT_PART.max(pane / 2));
    let alone = || at(0).filter(|at| *at >= LEFT_PART.max(pane / 3));
    let at = with_values.or_else(alone)?;
    Some(Split { at, tail })
}

/// What is seen of a line, and where.
#[derive(Debug)]
pub(super) struct Window {
    cuts: Vec<Cut>,
    pane: usize,
    /// How far it is scrolled; columns are those of the folded drawing.
    left: usize,
    full: usize,
    split: Option<Split>,
}

/// Where the left part ends, and the right-hand blocks go on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Split {
    /// The column of the screen between them.
    pub(super) at: usize,
    /// The first column of the folded drawing after it.
    tail: usize,
}

/// Where a column of the drawing is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ColumnPlace {
    /// In this column of the pane.
    Seen(usize),
    /// Folded away: nothing is missing there.
    Folded,
    /// Left of the pane.
    Before,
    /// Between the left part and the right-hand blocks.
    Between,
    /// Right of the pane.
    After,
}

impl Window {
    /// Where a column of the drawing is.
    pub(super) fn place(&self, column: usize) -> ColumnPlace {
        if self
            .cut_from(column)
            .is_some_and(|cut| cut.columns.contains(&column))
        {
            return ColumnPlace::Folded;
        }
        let column = self.column(column);
        if let Some(split) = self.split
            && column >= split.tail
        {
            return match split.at + 1 + column - split.tail {
                seen if seen < self.pane => ColumnPlace::Seen(seen),
                _ => ColumnPlace::After,
            };
        }
        match column.checked_sub(self.left) {
            None => ColumnPlace::Before,
            Some(seen) if seen < self.left_part() => ColumnPlace::Seen(seen),
            Some(_) if self.split.is_some() => ColumnPlace::Between,
            Some(_) => ColumnPlace::After,
        }
    }

    /// The column of the drawing that is in a column of the pane.
    pub(super) fn drawn_at(&self, seen: usize) -> Option<usize> {
        let column = match self.split {
            Some(split) if seen == split.at => return None,
            Some(split) if seen > split.at => split.tail + seen - split.at - 1,
            _ => self.left + seen,
        };
        let after = self
            .cuts
            .partition_point(|cut| cut.columns.start - cut.before <= column);
        let left_out = after.checked_sub(1).map_or(0, |last| {
            let cut = &self.cuts[last];
            cut.before + cut.columns.len()
        });
        Some(column + left_out)
    }

    /// Where the left part ends, if the right-hand blocks are held at the edge.
    pub(super) fn split(&self) -> Option<Split> {
        self.split
    }

    /// How far it is sensible to scroll.
    pub(super) fn most_left(&self) -> usize {
        self.full.saturating_sub(self.pane)
    }

    /// Whether some columns of the drawing are seen.
    pub(super) fn shows(&self, columns: &Range<usize>) -> bool {
        let (Some(last), first) = (columns.end.checked_sub(1), columns.start) else {
            return true;
        };
        // Nothing is left out within a block.
        matches!(
            (self.place(first), self.place(last)),
            (ColumnPlace::Seen(from), ColumnPlace::Seen(to)) if to - from == last - first
        )
    }

    pub(super) fn left_part(&self) -> usize {
        self.split.map_or(self.pane, |split| split.at)
    }

    /// A column of the drawing in the folded one.
    fn column(&self, column: usize) -> usize {
        let left_out = self.cut_from(column).map_or(0, |cut| {
            cut.before + cut.columns.end.min(column) - cut.columns.start
        });
        column - left_out
    }

    /// The last cut that begins at a column or before it.
    fn cut_from(&self, column: usize) -> Option<&Cut> {
        let after = self.cuts.partition_point(|cut| cut.columns.start <= column);
        self.cuts.get(after.checked_sub(1)?)
    }
}
