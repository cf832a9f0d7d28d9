//! Ends and returns, loops and calls, timers and counters that appear twice, pins.

use super::super::address::Tag;
use super::super::bank::Bank;
use super::super::model::{
    Action, Bits, Condition, ContactKind, CounterKind, Instruction, Program, Routine, Rung, TimerKind,
};
use super::words::Pin;
use super::{Found, actions};
use ladder_notation::LineColumn;
use std::collections::{HashMap, HashSet};

pub(super) fn check(program: &Program, out: &mut Found) {
    for routine in program.routines() {
        end(routine, out);
        loops(routine, out);
        for rung in routine.rungs.iter().filter(|rung| rung.actions.is_empty()) {
            out.error(
                rung.place,
                "click-c0003",
                "the rung has no instruction: add a coil, or delete the rung",
            );
        }
    }
    calls(program, out);
    outputs(program, out);
    blocks(program, out);
}

/// Whether an action happens in every scan that reaches it.
fn is_unconditional(rung: &Rung, action: &Action) -> bool {
    rung.condition.is_always() && action.condition.is_always()
}

/// An end in the main program, a return in each subroutine.
fn end(routine: &Routine, out: &mut Found) {
    let is_main = routine.name == "main";
    let mut found = false;
    for rung in &routine.rungs {
        for action in &rung.actions {
            match (&action.what, is_main) {
                (Instruction::End, true) | (Instruction::Return, false) => {
                    found |= is_unconditional(rung, action);
                }
                (Instruction::End, false) => {
                    let back = out.words.back();
                    let message =
                        format!("end() is for the main program: a subroutine goes back with {back}");
                    out.error(action.place, "click-end", message);
                }
                (Instruction::Return, true) => {
                    let back = out.words.back();
                    let message = format!("{back} is for subroutines: the main program ends with end()");
                    out.error(action.place, "click-end", message);
                }
                _ => {}
            }
        }
    }
    match (found, is_main) {
        (true, _) => {}
        (false, true) => {
            let message = format!(
                "the main program needs an unconditional end(): write it {} at its end",
                out.words.alone()
            );
            out.error(routine.place, "click-c0201", message);
        }
        (false, false) => {
            let name = &routine.name;
            let message = format!(
                "the subroutine `{name}` needs an unconditional {}: write it {} at its end",
                out.words.back(),
                out.words.alone()
            );
            out.error(routine.place, "click-c0105", message);
        }
    }
}

/// Loops have their ends, and do not nest.
fn loops(routine: &Routine, out: &mut Found) {
    let mut open = None;
    for rung in &routine.rungs {
        for action in &rung.actions {
            match &action.what {
                Instruction::For(_) if open.is_some() => {
                    let message = format!(
                        "loops do not nest: end the loop above with {} first",
                        out.words.next()
                    );
                    out.error(action.place, "click-c0103", message);
                }
                Instruction::For(_) => open = Some(action.place),
                Instruction::Next => {
                    if open.take().is_none() {
                        let message = format!("there is no loop that this {} could end", out.words.next());
                        out.error(action.place, "click-c0102", message);
                    }
                    if rung.actions.len() > 1 || !is_unconditional(rung, action) {
                        let message = format!("{} is {}", out.words.next(), out.words.alone_on_rung());
                        out.error(action.place, "click-c0009", message);
                    }
                }
                Instruction::Timer(_) if open.is_some() => {
                    let message = "a timer in a loop counts the scan several times";
                    out.warning(action.place, "click-c1004", message);
                }
                _ => {}
            }
        }
    }
    if let Some(place) = open {
        let message = format!(
            "the loop has no end: write {} {} after what it repeats",
            out.words.next(),
            out.words.alone()
        );
        out.error(place, "click-c0101", message);
    }
}

/// Calls lead to subroutines, from the main program.
fn calls(program: &Program, out: &mut Found) {
    let mut names = HashSet::new();
    for routine in &program.subroutines {
        if !names.insert(routine.name.as_str()) || routine.name == "main" {
            out.error(
                routine.place,
                "click-subroutine",
                format!("there is another `{}`", routine.name),
            );
        }
    }
    for (routine, _, action) in actions(program) {
        let Instruction::Call(name) = &action.what else {
            continue;
        };
        if !names.contains(name.as_str()) {
            let message = format!("there is no subroutine `{name}`: {}", out.words.subroutine());
            out.error(action.place, "click-c010c", message);
        }
        if routine.name != "main" {
            let message = "a subroutine calls no other: Click has one level of them";
            out.error(action.place, "click-nested-call", message);
        }
    }
}

/// Two coils on one output: the last one wins.
fn outputs(program: &Program, out: &mut Found) {
    let mut named: HashMap<&Tag, LineColumn> = HashMap::new();
    // By bank and number: ranges are a coil on each of their bits.
    let mut numbered: HashMap<Bank, Vec<Option<LineColumn>>> = HashMap::new();
    for (_, _, action) in actions(program) {
        let Instruction::Out(coil) = &action.what else {
            continue;
        };
        let place = action.place;
        let (bank, low, high) = match &coil.bits {
            Bits::Many(span) => (span.bank, span.bounds().0, span.bounds().1),
            Bits::One(tag) => match tag.address() {
                Some(address) => (address.bank, address.number, address.number),
                None => {
                    if let Some(before) = named.get(tag) {
                        twice(place, &out.words.tag(tag), *before, out);
                    }
                    named.entry(tag).or_insert(place);
                    continue;
                }
            },
        };
        // What does not exist is reported elsewhere.
        let length = usize::from(bank.last()) + 1;
        let there = numbered.entry(bank).or_insert_with(|| vec![None; length]);
        let bits = usize::from(low).min(length)..(usize::from(high) + 1).min(length);
        let mut before = None;
        for (number, first) in there[bits.clone()].iter_mut().enumerate() {
            before = before.or_else(|| first.map(|first| (bits.start + number, first)));
            first.get_or_insert(place);
        }
        if let Some((number, first)) = before {
            twice(
                place,
                &out.words.tag(&Tag::number(bank, number as u16)),
                first,
                out,
            );
        }
    }
}

fn twice(place: LineColumn, tag: &str, before: LineColumn, out: &mut Found) {
    let message = format!("{tag} has an out() at {before} too: the last one in the scan wins");
    out.warning(place, "click-c1001", message);
}

/// A timer or counter has one block, and the pins that it needs.
fn blocks(program: &Program, out: &mut Found) {
    let mut first = HashMap::new();
    for (_, rung, action) in actions(program) {
        let (tag, check, what) = match &action.what {
            Instruction::Timer(timer) => {
                if timer.kind.is_retentive() && timer.reset.is_none() {
                    let message = format!("a retentive timer needs its reset: {}", out.words.pin(Pin::Reset));
                    out.warning(action.place, "click-c0205", message);
                }
                if timer.kind == TimerKind::RetentiveOff {
                    let message = "Click itself keeps time with the on-delay alone: it has no rtof";
                    out.info(action.place, "click-rtof", message);
                }
                (&timer.tag, "click-c010a", "timer")
            }
            Instruction::Counter(counter) => {
                let both = counter.kind == CounterKind::UpDown;
                if both && counter.count_down.is_none() {
                    let message = format!("a counter of both directions needs {}", out.words.pin(Pin::Down));
                    out.warning(action.place, "click-c0207", message);
                }
                let reset = out.words.pin(Pin::Reset);
                match (both, counter.reset.is_none()) {
                    (_, false) => {}
                    // The page gives ctud no reset.
                    (true, true) => {
                        let message = format!("Click itself wants a reset here: {reset}");
                        out.info(action.place, "click-c0208", message);
                    }
                    (false, true) => {
                        let message = format!("a counter needs its reset: {reset}");
                        out.warning(action.place, "click-c0208", message);
                    }
                }
                if !has_edge(&rung.condition) && !has_edge(&action.condition) {
                    let message = format!(
                        "whether Click counts the rise of a rung or every scan depends on who is asked: write {} in its \
                         condition",
                        out.words.rise()
                    );
                    out.info(action.place, "click-counter-level", message);
                }
                (&counter.tag, "click-c010b", "counter")
            }
            Instruction::Shift(shift) => {
                if shift.clock.is_none() {
                    let clock = out.words.pin(Pin::Clock);
                    let message = format!("Click itself wants a clock here, and shifts on its rise: {clock}");
                    out.info(action.place, "click-shift-clock", message);
                }
                continue;
            }
            _ => continue,
        };
        if let Some(place) = first.get(tag) {
            let message = format!(
                "the {what} {} is at {place} already: it has one place in a program",
                out.words.tag(tag)
            );
            out.error(action.place, check, message);
        }
        first.entry(tag).or_insert(action.place);
    }
}

fn has_edge(condition: &Condition) -> bool {
    match condition {
        Condition::All(parts) | Condition::Any(parts) => parts.iter().any(has_edge),
        Condition::Contact(contact) => matches!(contact.kind, ContactKind::Rising | ContactKind::Falling),
        Condition::Compare(_) => false,
    }
}
