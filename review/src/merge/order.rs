//! Which entries of three lists are one, and in which order they are in the result.

use crate::matching::pairs;
use crate::outline::{Entry, Kind};

/// An entry as each side has it.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Slot<'o> {
    pub(super) base: Option<&'o Entry>,
    pub(super) ours: Option<&'o Entry>,
    pub(super) theirs: Option<&'o Entry>,
}

/// A slot, and where it is in one list: that of the result.
#[derive(Debug, Clone, Copy, Default)]
struct Placed<'o> {
    slot: Slot<'o>,
    /// It is elsewhere among the others than in the base.
    our_place: bool,
    their_place: bool,
    linked: bool,
    before: usize,
    after: usize,
}

/// The result as a list that entries are put into and taken out of. Number 0 is before the first and after the last.
struct List<'o>(Vec<Placed<'o>>);

impl<'o> List<'o> {
    fn add(&mut self, slot: Slot<'o>) -> usize {
        self.0.push(Placed {
            slot,
            ..Placed::default()
        });
        self.0.len() - 1
    }

    fn put_after(&mut self, number: usize, place: usize) {
        let next = self.0[place].after;
        self.0[number].before = place;
        self.0[number].after = next;
        self.0[number].linked = true;
        self.0[place].after = number;
        self.0[next].before = number;
    }

    fn take_out(&mut self, number: usize) {
        let Placed { before, after, .. } = self.0[number];
        self.0[before].after = after;
        self.0[after].before = before;
    }

    /// The last of the entries after a place that ours alone added there: theirs come after them.
    fn after_added(&self, mut place: usize) -> usize {
        loop {
            let next = self.0[place].after;
            let slot = &self.0[next].slot;
            if next == 0 || slot.base.is_some() || slot.theirs.is_some() {
                return place;
            }
            place = next;
        }
    }
}

/// The entries of three lists, in the order of the result: that of ours, with what theirs added or moved put after what is
/// before it there.
pub(super) fn slots<'o>(base: &'o [Entry], ours: &'o [Entry], theirs: &'o [Entry]) -> Vec<Slot<'o>> {
    let mut list = List(vec![Placed::default()]);
    for entry in base {
        list.add(Slot {
            base: Some(entry),
            ..Slot::default()
        });
    }
    // The numbers of the entries of each side.
    let mut our_numbers = vec![0; ours.len()];
    for pair in pairs(&refs(base), &refs(ours)) {
        our_numbers[pair.new] = pair.old + 1;
        list.0[pair.old + 1].our_place = pair.moved;
    }
    let mut last = 0;
    for (entry, number) in ours.iter().zip(&mut our_numbers) {
        if *number == 0 {
            *number = list.add(Slot::default());
        }
        list.0[*number].slot.ours = Some(entry);
        list.put_after(*number, last);
        last = *number;
    }
    let mut their_numbers = vec![0; theirs.len()];
    for pair in pairs(&refs(base), &refs(theirs)) {
        their_numbers[pair.new] = pair.old + 1;
        list.0[pair.old + 1].their_place = pair.moved;
    }
    both_added(base.len(), ours, &our_numbers, theirs, &mut their_numbers);
    let mut place = 0;
    for (entry, number) in theirs.iter().zip(&mut their_numbers) {
        if *number == 0 {
            *number = list.add(Slot::default());
        }
        list.0[*number].slot.theirs = Some(entry);
    }
    for &number in &their_numbers {
        let it = list.0[number];
        let stays = it.linked && (it.our_place || !it.their_place);
        if !stays {
            if it.linked {
                list.take_out(number);
                if place == number {
                    place = it.before;
                }
            }
            let after = list.after_added(place);
            list.put_after(number, after);
        }
        place = number;
    }
    let mut slots = Vec::with_capacity(list.0.len());
    let mut number = list.0[0].after;
    while number != 0 {
        slots.push(list.0[number].slot);
        number = list.0[number].after;
    }
    slots
}

fn refs(entries: &[Entry]) -> Vec<&Entry> {
    entries.iter().collect()
}

/// Finds what both sides added: the same thing, or something of the same name.
fn both_added(
    base: usize,
    ours: &[Entry],
    our_numbers: &[usize],
    theirs: &[Entry],
    their_numbers: &mut [usize],
) {
    let added = |numbers: &[usize], is_new: &dyn Fn(usize) -> bool| -> Vec<usize> {
        let all = numbers.iter().enumerate();
        all.filter(|(_, number)| is_new(**number))
            .map(|(at, _)| at)
            .collect()
    };
    let our_new = added(our_numbers, &|number| number > base);
    let their_new = added(their_numbers, &|number| number == 0);
    let our_entries: Vec<&Entry> = our_new.iter().map(|at| &ours[*at]).collect();
    let their_entries: Vec<&Entry> = their_new.iter().map(|at| &theirs[*at]).collect();
    for pair in pairs(&our_entries, &their_entries) {
        let (our, their) = (our_entries[pair.old], their_entries[pair.new]);
        let is_one =
            our.told.key == their.told.key || our.names.iter().any(|name| their.names.contains(name));
        if is_one && our.kind != Kind::Stray {
            their_numbers[their_new[pair.new]] = our_numbers[our_new[pair.old]];
        }
    }
}
