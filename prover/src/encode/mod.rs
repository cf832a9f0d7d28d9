//! One scan of a program as functions of bits: of what goes in, and of what the scan before left.
//!
//! ```text
//! Compiled --Cells--> which cells change --Scan--> the value of each cell after a scan, over the graph of a World
//! ```
//!
//! Each instruction of the simulator's flat code has one meaning here as there. It is followed once, from the first to the
//! last: where a part of it may be passed over, `act` is high if it is not, and what is written is chosen by it.

mod alone;
mod arithmetic;
mod cells;
mod chosen;
mod controller;
mod curve;
mod cycles;
mod flow;
mod formula;
mod instr;
mod lost;
mod memory;
mod ranges;
mod real;
mod routine;
mod search;
mod slots;
mod state;
mod ticks;
mod timers;
mod units;
mod unread;
mod uses;
mod world;

pub(crate) use alone::{Left, follow_alone};
pub(crate) use cells::{Cells, InputTag};
pub(crate) use memory::{Kept, Memory};
pub(crate) use world::{Gap, Input, State, Twins, World};

use crate::graph::Lit;
use flow::{Back, Frame};
use ladder_simulator::compiled::{Code, Instr, Memory as Banks, Word};
use lost::Lost;
use rustc_hash::FxHashMap;
use slots::Reach;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::Range;

/// How times are told.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Times {
    /// In scans of the interval.
    Exact,
    /// Any: a timer runs out whenever it may.
    Open,
}

/// Code that is followed.
pub(crate) struct Scan<'w, 'c> {
    pub(crate) world: &'w mut World,
    pub(crate) code: &'c Code,
    pub(crate) memory: Memory<'c>,
    /// Execution is here.
    act: Lit,
    /// A fault was recorded.
    pub(crate) faulted: Lit,
    /// The same, before the main program: in plants.
    pub(crate) faulted_before: Lit,
    /// An `<END>` was reached.
    pub(crate) ended: Lit,
    /// Who goes on at an instruction that is still ahead.
    pending: BTreeMap<u32, Lit>,
    /// Who goes on at an instruction that it has passed, in the next round.
    back: BTreeMap<u32, Back>,
    /// The blocks that are passed over without power, the innermost last.
    regions: Vec<Region>,
    frame: Frame,
    frames: Vec<Frame>,
    /// The functions that are open, by their first instructions.
    open: Vec<u32>,
    /// Where loops are: the first instruction of the body, and the one after.
    loops: Vec<(u32, u32)>,
    /// How many instructions may still be followed.
    budget: usize,
    /// How many questions about loops may still be put to a solver.
    questions: usize,
    /// Which cells computed slots may mean.
    reach: Cow<'c, Reach>,
    /// Who goes on in a way that is not followed.
    lost: Vec<Lost>,
    /// Nothing more is followed.
    is_stopped: bool,
    /// How often each unread part was met, by its number.
    turns: FxHashMap<u32, u32>,
    pub(crate) times: Times,
    interval: i64,
    /// Its blocks are places in the program, not those of the small program of an expression.
    located: bool,
    /// The network that is followed, where it is alone.
    pub(crate) alone: Option<Range<u32>>,
}

/// A block that is passed over without power.
#[derive(Debug)]
struct Region {
    end: u32,
    /// Who reaches its end if none leaves it.
    act: Lit,
    /// Who has no power for it.
    without: Lit,
    /// Something in it goes on past its end.
    leaks: bool,
    frame: Frame,
    frames: Vec<Frame>,
}

/// More instructions than this, loops written out, are too many: also fewer than the limit of a scan, where that is low.
const MOST_FOLLOWED: usize = 200_000;
/// More questions about loops take too long.
const MOST_QUESTIONS: usize = 50;
/// More nodes are too many.
const MOST_NODES: usize = 5_000_000;

impl<'w, 'c> Scan<'w, 'c> {
    /// Before the first instruction.
    pub(crate) fn new(
        world: &'w mut World,
        code: &'c Code,
        memory: Memory<'c>,
        (times, interval): (Times, i64),
        act: Lit,
    ) -> Scan<'w, 'c> {
        let reach = memory.reach().map_or(Cow::Owned(Reach::default()), Cow::Borrowed);
        Scan {
            world,
            code,
            memory,
            act,
            faulted: Lit::FALSE,
            faulted_before: Lit::FALSE,
            ended: Lit::FALSE,
            pending: BTreeMap::new(),
            back: BTreeMap::new(),
            regions: Vec::new(),
            frame: Frame::default(),
            frames: Vec::new(),
            open: Vec::new(),
            loops: (code.instrs.iter())
                .filter_map(|instr| match *instr {
                    Instr::Enter { body, after } => Some((body, after)),
                    _ => None,
                })
                .collect(),
            budget: MOST_FOLLOWED,
            questions: MOST_QUESTIONS,
            reach,
            lost: Vec::new(),
            is_stopped: false,
            turns: FxHashMap::default(),
            times,
            interval,
            located: true,
            alone: None,
        }
    }

    /// The code of an expression's small program.
    pub(crate) fn of_expression(
        world: &'w mut World,
        (code, initial): (&'c Code, &'c Banks),
        memory: Memory<'c>,
    ) -> Scan<'w, 'c> {
        let reach = Reach::of(code, initial, |word| memory.holds(Word(word)));
        let mut scan = Scan::new(world, code, memory, (Times::Exact, 1), Lit::TRUE);
        scan.reach = Cow::Owned(reach);
        scan.located = false;
        scan
    }

    /// With the limit of a scan in the simulator.
    pub(crate) fn within(mut self, watchdog: u64) -> Self {
        let half = usize::try_from(watchdog / 2).unwrap_or(usize::MAX);
        self.budget = self.budget.min(half);
        self
    }

    /// Follows the code to its end.
    pub(crate) fn run(&mut self) {
        self.stretch(0);
        if self.located {
            self.open_lost();
        }
    }
}
