//! The elements that an array has in common with the array that it was: those with the same indices.

use ladder_analysis::program::Tag;
use ladder_analysis::values::types::Type;

/// Elements that follow each other in both arrays, counted from the first of each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Run {
    pub(crate) from: u32,
    pub(crate) to: u32,
    pub(crate) count: u32,
}

/// The first and last index of each dimension of a tag; none of one that is not an array.
pub(crate) fn dimensions(tag: &Tag) -> Vec<(i64, i64)> {
    match (&tag.column, tag.ty) {
        (Some(column), Type::Array { .. }) if column.dimensions.len() > 1 => column.dimensions.to_vec(),
        (_, Type::Array { first, last, .. }) => vec![(first, last)],
        _ => Vec::new(),
    }
}

/// The elements with the same indices of two arrays. Those of different numbers of dimensions have none.
pub(crate) fn overlap(from: &[(i64, i64)], to: &[(i64, i64)]) -> Vec<Run> {
    if from.len() != to.len() {
        return Vec::new();
    }
    let mut runs = vec![Run {
        from: 0,
        to: 0,
        count: 1,
    }];
    for (was, is) in from.iter().zip(to) {
        let [was_count, is_count] = [was, is].map(|(first, last)| (last - first + 1) as u32);
        let (first, last) = (was.0.max(is.0), was.1.min(is.1));
        let common = (last - first + 1).max(0) as u32;
        let outer = std::mem::take(&mut runs);
        // Rows that are in both as they are stay in one piece.
        let is_whole = was == is;
        for run in outer {
            let at = |n: u32, count: u32, of: i64| n * count + (first - of) as u32;
            let rows = if is_whole { 1 } else { run.count };
            let each = if is_whole { run.count * common } else { common };
            runs.extend((0..rows).map(|row| Run {
                from: at(run.from + row, was_count, was.0),
                to: at(run.to + row, is_count, is.0),
                count: each,
            }));
        }
        runs.retain(|run| run.count > 0);
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pairs(from: &[(i64, i64)], to: &[(i64, i64)]) -> Vec<(u32, u32)> {
        let runs = overlap(from, to).into_iter();
        runs.flat_map(|run| (0..run.count).map(move |n| (run.from + n, run.to + n)))
            .collect()
    }

    #[test]
    fn the_same_indices() {
        assert_eq!(pairs(&[], &[]), [(0, 0)]);
        assert_eq!(pairs(&[(1, 3)], &[(2, 5)]), [(1, 0), (2, 1)]);
        assert_eq!(pairs(&[(1, 2)], &[(5, 6)]), []);
        // Rows of three become rows of two.
        let rows = pairs(&[(1, 2), (1, 3)], &[(1, 2), (1, 2)]);
        assert_eq!(rows, [(0, 0), (1, 1), (3, 2), (4, 3)]);
        assert_eq!(pairs(&[(1, 2), (1, 2)], &[(2, 3), (1, 2)]), [(2, 0), (3, 1)]);
        assert_eq!(overlap(&[(1, 2), (1, 3)], &[(1, 2), (1, 3)]).len(), 1);
        assert_eq!(pairs(&[(1, 2)], &[(1, 2), (1, 2)]), []);
    }
}
