//! What changes have done to a text, as one edit in bytes: so that code that knows the text before need look no further than
//! to the lines around it.

use std::ops::Range;

/// A stretch of a text was replaced by another.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct ByteEdit {
    /// What was replaced, in the text before.
    pub old: Range<usize>,
    /// How many bytes are there now.
    pub new_len: usize,
}

impl ByteEdit {
    /// This edit and one after it, as one.
    fn then(self, next: &ByteEdit) -> ByteEdit {
        let end = (self.old.start + self.new_len).max(next.old.end);
        let start = self.old.start.min(next.old.start);
        // What lies after this edit is so far from its end in the text before as well.
        let old_end = self.old.end + (end - self.old.start - self.new_len);
        ByteEdit {
            old: start..old_end,
            new_len: end - next.old.len() + next.new_len - start,
        }
    }
}

/// What leads from one state of a text to a later one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Since {
    /// Nothing: the text is the same.
    Same,
    /// One edit, or several that together are one.
    Edited(ByteEdit),
    /// That is not known, or the whole text was replaced.
    Unknown,
}

/// What has become of a text since something was made of it. States of a text go by growing numbers.
#[derive(Debug, Default)]
pub(crate) struct EditLog {
    /// The number of each later state, and what led to it; none if the whole text was replaced.
    entries: Vec<(u64, Option<ByteEdit>)>,
}

impl EditLog {
    /// A state is reached by these changes from the one before it. None: the whole text is another.
    pub(crate) fn push(&mut self, state: u64, edits: Option<Vec<ByteEdit>>) {
        match edits {
            Some(edits) => self
                .entries
                .extend(edits.into_iter().map(|edit| (state, Some(edit)))),
            None => self.entries.push((state, None)),
        }
    }

    /// What leads to a state.
    pub(crate) fn until(&self, state: u64) -> Since {
        let mut all = Since::Same;
        for (_, edit) in self.entries.iter().take_while(|(at, _)| *at <= state) {
            let Some(edit) = edit else { return Since::Unknown };
            all = Since::Edited(match all {
                Since::Edited(all) => all.then(edit),
                _ => edit.clone(),
            });
        }
        all
    }

    /// Something was made of this state.
    pub(crate) fn begin_at(&mut self, state: u64) {
        self.entries.retain(|(at, _)| *at > state);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn all_edits_together_lead_where_they_lead_one_by_one(
            edits in prop::collection::vec((0..40_usize, 0..9_usize, "[a-z]{0,6}"), 1..8),
        ) {
            let original = "0123456789ABCDEFGHIJ".to_owned();
            let (mut text, mut log) = (original.clone(), EditLog::default());
            for (state, (at, len, new)) in (1..).zip(&edits) {
                let start = *at.min(&text.len());
                let old = start..(start + len).min(text.len());
                text.replace_range(old.clone(), new);
                log.push(state, Some(vec![ByteEdit { old, new_len: new.len() }]));
            }
            let Since::Edited(all) = log.until(edits.len() as u64) else {
                panic!("the edits are known");
            };
            let mut again = original;
            again.replace_range(all.old.clone(), &text[all.old.start..all.old.start + all.new_len]);
            prop_assert_eq!(again, text);
        }
    }

    #[test]
    fn what_is_replaced_whole_is_not_followed() {
        let mut log = EditLog::default();
        let edit = ByteEdit {
            old: 1..2,
            new_len: 0,
        };
        log.push(3, Some(vec![edit.clone()]));
        log.push(5, None);
        log.push(7, Some(Vec::new()));
        assert_eq!(log.until(2), Since::Same);
        assert_eq!(log.until(4), Since::Edited(edit));
        assert_eq!(log.until(5), Since::Unknown);
        log.begin_at(5);
        assert_eq!(log.until(7), Since::Same);
    }
}
