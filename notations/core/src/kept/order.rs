//! What is changed of a list, and where that is in a list that says the same in other words.

use similar::{Algorithm, DiffOp, capture_diff_slices};
use std::collections::HashMap;
use std::ops::Range;

/// A stretch of three lists that are about the same.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Region {
    /// Of the original.
    pub(super) own: Range<usize>,
    /// Of what is written of it.
    pub(super) old: Range<usize>,
    /// Of what is written of it now.
    pub(super) new: Range<usize>,
}

/// The smallest stretches of which each begins and ends where those of the other lists do. The original is compared by what it says, the other
/// two by how they are written.
pub(super) fn regions([own, old]: &[Vec<String>; 2], [before, after]: &[Vec<String>; 2]) -> Vec<Region> {
    let to_own = boundaries(old, own);
    let to_new = boundaries(before, after);
    let mut regions: Vec<Region> = Vec::new();
    let mut begin = (0, 0, 0);
    for at in 0..=old.len() {
        let (Some(own_ends), Some(new_ends)) = (to_own.get(&at), to_new.get(&at)) else {
            continue;
        };
        // At one place of the second list others may have something besides: that is a stretch of its own.
        for (own_end, new_end) in [(own_ends.0, new_ends.0), (own_ends.1, new_ends.1)] {
            let end = (own_end, at, new_end);
            if end != begin {
                regions.push(Region {
                    own: begin.0..end.0,
                    old: begin.1..end.1,
                    new: begin.2..end.2,
                });
                begin = end;
            }
        }
    }
    regions
}

/// The parts of a list with what is changed between two others: the original is compared by what its parts say.
pub fn merge_lists<'t>(
    own: &[&'t str],
    before: &[&'t str],
    after: &[&'t str],
    says: impl Fn(&str) -> String,
) -> Vec<&'t str> {
    let told = |parts: &[&str]| -> Vec<String> { parts.iter().map(|part| says(part)).collect() };
    let told = [told(own), told(before), told(after)];
    let [told_own, told_before, told_after] = told;
    let found = regions(
        &[told_own, told_before.clone()],
        &[told_before.clone(), told_after.clone()],
    );
    let mut out = Vec::new();
    for region in found {
        if told_before[region.old.clone()] == told_after[region.new.clone()] {
            out.extend_from_slice(&own[region.own]);
        } else {
            out.extend_from_slice(&after[region.new]);
        }
    }
    out
}

/// For each place of a list which has one in another list: the first and the last that it is there.
fn boundaries(list: &[String], other: &[String]) -> HashMap<usize, (usize, usize)> {
    let mut places: HashMap<usize, (usize, usize)> = HashMap::new();
    let mut note = |at: usize, there: usize| {
        let place = places.entry(at).or_insert((there, there));
        place.0 = place.0.min(there);
        place.1 = place.1.max(there);
    };
    note(0, 0);
    note(list.len(), other.len());
    for op in capture_diff_slices(Algorithm::Myers, list, other) {
        let (own, there) = (op.old_range(), op.new_range());
        note(own.start, there.start);
        note(own.end, there.end);
        let is_by_one = matches!(op, DiffOp::Equal { .. }) || own.len() == there.len();
        if is_by_one {
            own.clone()
                .zip(there.clone())
                .for_each(|(at, there)| note(at, there));
        }
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(own: &str, old: &str, before: &str, after: &str, expected: &str) {
        let list = |text: &str| -> Vec<String> { text.chars().map(String::from).collect() };
        let found = regions(&[list(own), list(old)], &[list(before), list(after)]);
        let told = found.iter().map(|Region { own: at, old, new }| {
            format!(
                "{}={}={}",
                &own[at.clone()],
                &before[old.clone()],
                &after[new.clone()]
            )
        });
        assert_eq!(told.collect::<Vec<_>>().join(" "), expected);
    }

    #[test]
    fn what_is_alike_is_told_one_by_one() {
        check("abc", "abc", "ABC", "ABC", "a=A=A b=B=B c=C=C");
        check("abc", "abc", "ABC", "AXC", "a=A=A b=B=X c=C=C");
    }

    #[test]
    fn what_is_added_or_gone_has_a_place() {
        check("abc", "abc", "ABC", "AXBC", "a=A=A ==X b=B=B c=C=C");
        check("abc", "abc", "ABC", "AC", "a=A=A b=B= c=C=C");
        check("", "", "", "X", "==X");
        check("abc", "abc", "ABC", "ABCX", "a=A=A b=B=B c=C=C ==X");
    }

    #[test]
    fn what_one_alone_has_is_apart() {
        // The original has `n`, which was not read; the others have `M`, which it has not.
        check("anb", "ab", "AB", "AX", "a=A=A n== b=B=X");
        check("ab", "mab", "MAB", "MAX", "=M=M a=A=A b=B=X");
        check("xb", "yzb", "YZB", "YWB", "x=YZ=YW b=B=B");
    }
}
