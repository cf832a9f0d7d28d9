//! Which contacts of a rung would be checked too late: Click looks at all of them before the rung acts, and in ladder
//! text each is checked where it is.

use super::address::Which;
use super::bank::Bank;
use super::dsl::spell;
use super::grid;
use super::model::{Condition, Instruction, Program, Rung};
use super::tags::Tags;
use super::uses::{self, Access, What};
use ladder_notation::Report;

/// Where a condition of a rung is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    /// Before some of its instructions.
    Branch,
    /// At an input of an instruction, which begins at the left rail.
    Pin,
}

/// The conditions of a rung, and of those that go on in it, that read what one of its instructions before them writes.
pub(super) fn late<'p>(tags: &Tags<'_>, rungs: &'p [Rung]) -> Vec<(&'p Condition, Part)> {
    let mut written: Vec<What<'p>> = Vec::new();
    let mut out: Vec<(&'p Condition, Part)> = Vec::new();
    for (number, rung) in rungs.iter().enumerate() {
        let is_late = |condition: &'p Condition, written: &[What<'p>]| {
            let reads = uses::of_condition(condition);
            reads
                .iter()
                .any(|read| written.iter().any(|what| overlap(tags, &read.what, what)))
        };
        if number > 0 && is_late(&rung.condition, &written) {
            out.push((&rung.condition, Part::Branch));
        }
        for action in &rung.actions {
            let mut check = |condition: Option<&'p Condition>, part, written: &[What<'p>]| {
                let late = condition.filter(|condition| is_late(condition, written));
                if let Some(late) = late.filter(|late| !out.iter().any(|(there, _)| there == late)) {
                    out.push((late, part));
                }
            };
            check(Some(&action.condition), Part::Branch, &written);
            let pins: Vec<_> = match &action.what {
                Instruction::Timer(timer) => timer.reset.iter().collect(),
                Instruction::Counter(counter) => counter.count_down.iter().chain(&counter.reset).collect(),
                Instruction::Shift(shift) => shift.clock.iter().collect(),
                Instruction::Drum(drum) => drum.conditions().collect(),
                _ => Vec::new(),
            };
            for pin in pins {
                check(Some(pin), Part::Pin, &written);
            }
            let writes = uses::of_instruction(&action.what).into_iter();
            written.extend(
                writes
                    .filter(|one| matches!(one.access, Access::Write | Access::Own))
                    .map(|one| one.what),
            );
            // A register is cleared by a rung below the one that shifts it.
            if let Instruction::Shift(shift) = &action.what {
                check(shift.reset.as_ref(), Part::Pin, &written);
            }
        }
    }
    out
}

/// How a notation looks at the conditions of branches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Look {
    /// Before the rung acts: they are a part of it.
    Before,
    /// Where they are: each is a rung of its own.
    InPlace,
}

/// Says of the conditions of branches that a notation looks at otherwise than the ladder text does.
pub(super) fn remarks(program: &Program, look: Look, report: &mut Report) {
    let tags = Tags::of(program);
    for routine in program.routines() {
        for rungs in routine.rungs.chunk_by(|_, next| goes_on(next)) {
            for (condition, part) in late(&tags, rungs) {
                let look = if part == Part::Pin { Look::Before } else { look };
                let why = match (look, program.seen_first.contains(condition)) {
                    (Look::Before, false) => {
                        "Click looks at it before its rung acts, and here something has acted"
                    }
                    (Look::InPlace, true) => {
                        "it is checked before its rung acts, and is a rung of its own after it here"
                    }
                    _ => continue,
                };
                report.approximated(rungs[0].place, spell::condition(condition), why);
            }
        }
    }
}

/// Whether a rung of the model is a part of the one before it.
pub(super) fn goes_on(rung: &Rung) -> bool {
    rung.comments.iter().any(|comment| comment == grid::CONTINUES)
}

/// Addresses of one bank: some numbers, or a nickname without one.
#[derive(PartialEq)]
enum Addresses<'t> {
    Numbers(u16, u16),
    Nickname(&'t str),
}

fn place<'t>(tags: &Tags<'_>, what: &What<'t>) -> (Bank, Addresses<'t>) {
    let (bank, place) = match *what {
        What::One(tag) | What::From(tag, _) => {
            let count = match *what {
                What::From(_, count) => u16::try_from(count).unwrap_or(u16::MAX),
                _ => 1,
            };
            let place = match (tags.address(tag), &tag.which) {
                (Some(address), _) => {
                    Addresses::Numbers(address.number, address.number.saturating_add(count.max(1) - 1))
                }
                (None, Which::Nickname(name)) => Addresses::Nickname(name),
                (None, Which::Number(number)) => Addresses::Numbers(*number, *number),
            };
            (tag.bank, place)
        }
        What::Many(span) => (span.bank, Addresses::Numbers(span.bounds().0, span.bounds().1)),
        What::Somewhere(pointer) => (pointer.bank, Addresses::Numbers(0, u16::MAX)),
    };
    // A timer's bit and its value change together.
    let bank = match bank {
        Bank::Td => Bank::T,
        Bank::Ctd => Bank::Ct,
        other => other,
    };
    (bank, place)
}

fn overlap(tags: &Tags<'_>, one: &What<'_>, other: &What<'_>) -> bool {
    let ((bank, one), (other_bank, other)) = (place(tags, one), place(tags, other));
    bank == other_bank
        && match (one, other) {
            (Addresses::Numbers(low, high), Addresses::Numbers(other_low, other_high)) => {
                low <= other_high && other_low <= high
            }
            (one, other) => one == other,
        }
}
