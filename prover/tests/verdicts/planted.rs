//! Judges that are wrong: each takes one thing for another, and is found.

use super::ask;
use super::case::Case;
use super::generate::{INSTANCE, PARTS, case};
use super::judge::{Sees, Tally};

/// An undeclared tag is what it is at the start.
fn undeclared_is_constant(seen: &mut Case, _: &mut Case) {
    for declaration in std::mem::take(&mut seen.undeclared) {
        seen.declared.push(("VAR", declaration));
    }
}

/// The parts of declared inputs are what they are at the start.
fn parts_are_constant(seen: &mut Case, _: &mut Case) {
    for (section, _) in &mut seen.declared {
        if *section == PARTS {
            *section = "VAR";
        }
    }
}

/// No other file writes anything.
fn alone(seen: &mut Case, _: &mut Case) {
    for other in &mut seen.others {
        other.networks.clear();
    }
}

/// The order of networks does not matter.
fn sorted(seen: &mut Case, _: &mut Case) {
    seen.networks.sort();
}

/// Loops and instances come last.
fn instances_last(seen: &mut Case, _: &mut Case) {
    seen.networks
        .sort_by_key(|network| network.contains(INSTANCE) || network.contains("<FOR>"));
}

/// An unread part is nothing.
fn parts_write_nothing(seen: &mut Case, _: &mut Case) {
    let parts = std::mem::take(&mut seen.parts);
    seen.networks
        .retain(|network| parts.iter().all(|(part, _)| part != network));
}

/// Whether a wrong judge is found among so many programs.
fn is_found(sees: Sees) -> bool {
    (0..400).any(|seed| !ask(&case(seed), seed, sees, &mut Tally::default()).is_empty())
}

#[test]
fn an_undeclared_number_taken_as_a_constant_is_found() {
    assert!(is_found(undeclared_is_constant));
}

#[test]
fn a_part_of_an_input_taken_as_a_constant_is_found() {
    assert!(is_found(parts_are_constant));
}

#[test]
fn a_global_of_another_file_taken_as_a_constant_is_found() {
    assert!(is_found(alone));
}

#[test]
fn a_moved_network_taken_as_harmless_is_found() {
    assert!(is_found(sorted));
}

#[test]
fn another_order_of_loops_and_instances_is_found() {
    assert!(is_found(instances_last));
}

#[test]
fn an_unread_part_taken_as_nothing_is_found() {
    assert!(is_found(parts_write_nothing));
}
