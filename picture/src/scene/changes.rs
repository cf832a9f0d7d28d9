//! What has changed from one scan to the next, for a page that changes only that.

/// The values that a page has.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Changes {
    shown: Option<Vec<String>>,
}

impl Changes {
    /// The places whose values are other ones than before, with these; at first all.
    pub fn to(&mut self, values: Vec<String>) -> Vec<(usize, String)> {
        let before = |at: usize| self.shown.as_ref().and_then(|shown| shown.get(at));
        let changed = values.iter().enumerate();
        let changed = changed.filter(|(at, value)| before(*at) != Some(*value));
        let changed = changed.map(|(at, value)| (at, value.clone())).collect();
        self.shown = Some(values);
        changed
    }
}
