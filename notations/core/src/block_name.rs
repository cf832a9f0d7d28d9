//! The name of a block of another system as the name of one here.

use ladder_syntax::{Name, is_identifier};
use std::collections::HashSet;

/// No name has more bytes: it is drawn wherever it is used.
const LONGEST: usize = 100;

/// The nearest name that a block can have, without its `$`: letters, digits and single `_` between them stay, a run of anything else
/// becomes one `_`. `first` is put before a name that doesn't begin with a letter.
pub fn block_name(name: &str, first: &str) -> String {
    let mut near = String::with_capacity(name.len());
    for c in name.chars() {
        if c != '_' && is_identifier(&format!("_{c}")) {
            near.push(c);
        } else if !near.is_empty() && !near.ends_with('_') {
            near.push('_');
        }
    }
    if !is_identifier(&near) {
        near.insert_str(0, first);
    }
    while near.len() > LONGEST || near.ends_with('_') {
        near.pop();
    }
    near
}

/// The names that blocks took.
#[derive(Debug, Default)]
pub struct BlockNames(HashSet<Name>);

impl BlockNames {
    /// The nearest name that no other block took; see [`block_name`].
    pub fn free(&mut self, name: &str, first: &str) -> String {
        let near = block_name(name, first);
        let mut free = near.clone();
        let mut number = 2;
        while !self.0.insert(Name::new(&free)) {
            free = format!("{near}x{number}");
            number += 1;
        }
        free
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ladder_syntax::is_block_name;

    #[test]
    fn names_stay_or_are_near() {
        let long = "x".repeat(99) + "_y";
        for (name, near) in [
            ("FB_Motor", "FB_Motor"),
            ("scale_to_real", "scale_to_real"),
            ("Förderer_2", "Förderer_2"),
            ("__scale", "scale"),
            ("a__b_", "a_b"),
            ("Motor (left)", "Motor_left"),
            ("3_way", "B3_way"),
            ("\u{301}", "B\u{301}"),
            ("%$", "B"),
            ("", "B"),
            (&long, &long[..99]),
        ] {
            assert_eq!(block_name(name, "B"), near);
            assert!(is_block_name(near), "{near}");
        }
    }

    #[test]
    fn no_two_blocks_have_one_name() {
        let mut taken = BlockNames::default();
        let names = ["Motor", "MOTOR", "motor_", "ÄB", "äb"];
        assert_eq!(
            names.map(|name| taken.free(name, "B")),
            ["Motor", "MOTORx2", "motorx3", "ÄB", "äbx2"]
        );
    }
}
