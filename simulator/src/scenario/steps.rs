//! How long the steps of a scenario are, in scans: all alike, or as its rows `time` say.

/// The steps of a scenario.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Steps {
    /// So many, of so many scans each.
    Even {
        /// How many.
        count: usize,
        /// How many scans each has.
        scans: u64,
    },
    /// As rows `time` say.
    Uneven {
        /// Before how many scans each begins, and at last how many there are together.
        begins: Vec<u64>,
        /// How many scans one has of which nothing else is reported.
        usual: u64,
    },
}

impl Steps {
    /// Steps of these lengths, in scans.
    pub(super) fn of_lengths(lengths: impl Iterator<Item = u64>, usual: u64) -> Steps {
        let mut begins = vec![0u64];
        let mut end = 0u64;
        begins.extend(lengths.map(|length| {
            end = end.saturating_add(length);
            end
        }));
        Steps::Uneven { begins, usual }
    }

    /// How many there are.
    pub(super) const fn count(&self) -> usize {
        match self {
            Steps::Even { count, .. } => *count,
            Steps::Uneven { begins, .. } => begins.len() - 1,
        }
    }

    /// Before which scan a step begins; of the one after the last, how many scans there are.
    pub(super) fn begin(&self, step: usize) -> u64 {
        match self {
            Steps::Even { scans, .. } => scans.saturating_mul(step as u64),
            Steps::Uneven { begins, .. } => begins[step.min(begins.len() - 1)],
        }
    }

    /// How many scans a step has, where that is not as many as steps usually have.
    pub(super) fn unusual(&self, step: usize) -> Option<u64> {
        let Steps::Uneven { usual, .. } = self else {
            return None;
        };
        let scans = self.begin(step + 1) - self.begin(step);
        (scans != *usual).then_some(scans)
    }

    /// The step that a scan belongs to; the last one for those after it.
    pub(super) fn at(&self, scan: u64) -> usize {
        let step = match self {
            Steps::Even { scans, .. } => usize::try_from(scan / scans).unwrap_or(usize::MAX),
            Steps::Uneven { begins, .. } => begins.partition_point(|begin| *begin <= scan) - 1,
        };
        step.min(self.count().saturating_sub(1))
    }
}

#[cfg(test)]
mod tests {
    use super::Steps;

    #[test]
    fn steps_of_lengths_are_found_by_their_scans() {
        let uneven = Steps::of_lengths([1, 300, 2].into_iter(), 1);
        assert_eq!((uneven.count(), uneven.begin(2), uneven.begin(3)), (3, 301, 303));
        let found = [0, 1, 300, 301, 302, 303, 9999].map(|scan| uneven.at(scan));
        assert_eq!(found, [0, 1, 1, 2, 2, 2, 2]);
        let even = Steps::Even { count: 3, scans: 10 };
        assert_eq!([0, 9, 10, 29, 30].map(|scan| even.at(scan)), [0, 0, 1, 2, 2]);
        assert_eq!(even.begin(3), 30);
    }
}
