//! What a system has of ladder text, and programs in which what it lacks is expressed by what it has.

use crate::rewritten::Rewritten;
use crate::whole::{Added, whole};
use crate::{Entry, Outcome, Report, WriteError, Writing};
use crate::{arrays, bridges, formulas, functions, loops, system};
use ladder_analysis::Analysis;
use ladder_analysis::context::Context;
use ladder_analysis::program::SystemTag;
use ladder_instructions::Op;
use ladder_syntax::Name;
use std::collections::{HashMap, HashSet};

/// Blocks of which one has no form are used by others no deeper.
const DEEPEST: usize = 50;

/// The blocks of other files that a system cannot say whole, with why. They are not to be written, and neither is a call.
pub type Unwritable = HashMap<Name, String>;

/// What of a program is an instruction of a system though ladder text has it drawn.
#[derive(Default)]
pub struct Stays {
    /// The blocks, by their numbers: loops and tags of `SYS` in their bodies stay.
    pub blocks: HashSet<usize>,
    /// The tags with the turns of loops: these loops stay.
    pub turns: HashSet<Name>,
}

/// What a system has. What it lacks is expressed by other means before its writer sees a program: each pass makes a sketch of the program
/// that the one before has made. Functions and blocks of other files are the program's own in what they make.
#[derive(Clone, Copy)]
pub struct Target {
    /// The instructions on arrays that it lacks, which are among `[UNPACK]` and `[FILL]`. None: it has all, and sums of arrays.
    pub lacks_on_arrays: Option<&'static [Op]>,
    /// Whether it has loops of networks.
    pub has_loops: bool,
    /// Whether its functions see the tags of the program.
    pub has_functions: bool,
    /// Whether it has a tag of `SYS`.
    pub has_system_tag: fn(SystemTag) -> bool,
    /// Whether `MIN`, `MAX`, `LIMIT`, `SEL` and `MUX` can be called in its formulas.
    pub has_calls_in_formulas: bool,
    /// Whether it draws more than series and branches.
    pub has_bridges: bool,
    /// Whether what is used of other files can be written along.
    pub has_blocks: bool,
    /// What of a program is an instruction there, and stays.
    pub stays: fn(&Context) -> Stays,
}

impl Target {
    /// A system that has blocks of one's own and jumps, and neither functions that see the tags of the program, nor loops of
    /// networks, nor instructions on arrays.
    pub const BLOCKS_ALONE: Target = Target {
        lacks_on_arrays: Some(&[Op::Unpack, Op::Fill]),
        has_loops: false,
        has_functions: false,
        has_system_tag: |_| true,
        has_calls_in_formulas: true,
        has_bridges: true,
        has_blocks: true,
        stays: |_| Stays::default(),
    };

    /// A system whose writer is handed all that a program has, in series and branches.
    pub const SERIES_AND_BRANCHES: Target = Target {
        lacks_on_arrays: None,
        has_loops: true,
        has_functions: true,
        has_bridges: false,
        has_blocks: false,
        ..Target::BLOCKS_ALONE
    };

    /// Writes a program in which what the system lacks is expressed by other means. If part of a block of another file has no form,
    /// `write` is handed the same again, with that block among the [`Unwritable`]. The report is about the program itself.
    ///
    /// # Errors
    ///
    /// Those of `write`, and that what is used of other files cannot be one text with the program: it has another arithmetic, or the
    /// same name for something else.
    pub fn write(
        &self,
        analysis: &Analysis,
        write: impl Fn(&Analysis, &Unwritable) -> Result<Writing, WriteError>,
    ) -> Result<Writing, WriteError> {
        let (whole, added, mut unwritable) = if self.has_blocks {
            whole(analysis)?
        } else {
            (Rewritten::of(analysis), Vec::new(), Unwritable::new())
        };
        let program = self.without_what_it_lacks(whole);
        for _ in 0..DEEPEST {
            let mut writing = write(&program.analysis, &unwritable)?;
            let of_others = program.restore(&mut writing.report);
            let known = unwritable.len();
            for (number, entry) in &of_others {
                let block = &added[*number];
                if let (Outcome::Refused(why), true) = (&entry.outcome, block.is_block) {
                    let why = format!("`{}` of {} has no form there: {why}", block.name, block.file());
                    unwritable.entry(Name::new(&block.name)).or_insert(why);
                }
            }
            // What uses one of them has no form either, which the next writing shows.
            if unwritable.len() == known {
                tell(&mut writing.report, of_others, &added, &unwritable);
                return Ok(writing);
            }
        }
        Err(WriteError::new(
            "the blocks of other files use each other too deep",
        ))
    }

    fn without_what_it_lacks(&self, program: Rewritten) -> Rewritten {
        program
            .after(|analysis, _| arrays::by_elements(analysis, self.lacks_on_arrays?))
            .after(|analysis, _| (!self.has_loops).then(|| loops::as_jumps(analysis, self.stays))?)
            .after(|analysis, _| (!self.has_functions).then(|| functions::as_blocks(analysis))?)
            .after(|analysis, report| system::with_block(analysis, self, report))
            .after(|analysis, _| {
                (!self.has_calls_in_formulas).then(|| formulas::by_instructions(analysis))?
            })
            .after(|analysis, _| (!self.has_bridges).then(|| bridges::as_branches(analysis))?)
    }
}

/// Says of each block at its first call what became of it, instead of each line of it at a place that the file does not have.
fn tell(report: &mut Report, of_others: Vec<(usize, Entry)>, added: &[Added], unwritable: &Unwritable) {
    let mut told = HashSet::new();
    let (mut written, mut remarked) = (HashSet::new(), HashSet::new());
    let entries = &mut report.entries;
    for (number, entry) in of_others {
        let block = &added[number];
        written.insert(&block.name);
        if let Outcome::Refused(why) = &entry.outcome
            && !block.is_block
        {
            remarked.insert(&block.name);
            let why = format!("in `{}` of {}: {why}", block.name, block.file());
            entries.push(block.entry(Outcome::Refused(why)));
        } else if let Outcome::Approximated(why) = entry.outcome
            && !unwritable.contains_key(&Name::new(&block.name))
            && told.insert((&block.name, why.clone()))
        {
            remarked.insert(&block.name);
            entries.push(block.entry(Outcome::Approximated(why)));
        }
    }
    for block in added {
        match unwritable.get(&Name::new(&block.name)) {
            Some(why) => entries.push(block.entry(Outcome::Refused(why.clone()))),
            None if written.contains(&block.name) && !remarked.contains(&block.name) => {
                entries.push(block.entry(Outcome::Translated));
            }
            _ => {}
        }
    }
    entries.sort_by_key(|entry| entry.place);
}

impl Added {
    fn entry(&self, outcome: Outcome) -> Entry {
        Entry {
            place: self.used,
            element: if self.is_block {
                format!("[{}]", self.name)
            } else {
                format!("<CALL>( {} )", self.name)
            },
            outcome,
        }
    }
}
