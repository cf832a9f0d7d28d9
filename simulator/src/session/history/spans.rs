//! Kept scans by the span: what many of them did together, so that a search for the last change of something need not go
//! back over each of those that did nothing to it.

use super::super::banks::Banks;
use super::super::touched::{Cells, SPAN, Touched};
use super::{Entry, Forces};
use std::collections::VecDeque;

/// What the scans of a span did together.
#[derive(Debug)]
pub(in crate::session) struct Span {
    /// Its first scan.
    first: i64,
    /// What may have changed in any of its scans.
    pub(in crate::session) touched: Cells,
    /// What leads from its end to its beginning.
    pub(in crate::session) bytes: Vec<u8>,
    /// How many bytes its scans take by themselves.
    pub(in crate::session) of_scans: usize,
    /// The forces before it, if they changed in it.
    pub(in crate::session) forces: Option<Forces>,
}

impl Span {
    fn size(&self) -> usize {
        size_of::<Span>() + self.bytes.len() + self.touched.size()
    }
}

/// The spans of which all scans are kept, but for some after which something was stepped back.
#[derive(Debug, Default)]
pub(in crate::session) struct Spans {
    kept: VecDeque<Span>,
    size: usize,
    /// The banks at the beginning of the span that has begun; none if that was not seen.
    start: Option<Banks>,
}

impl Spans {
    /// How many bytes they take.
    pub(in crate::session) fn size(&self) -> usize {
        self.size
    }

    /// The span that ends with the scan before this one.
    pub(in crate::session) fn before(&self, scan: i64) -> Option<&Span> {
        let found = self.kept.binary_search_by_key(&(scan - SPAN), |span| span.first);
        found.ok().map(|at| &self.kept[at])
    }

    /// The scans before this one are done. If that is the end of a span it becomes one, where all of it is kept: `entries`
    /// are the kept scans, the newest last.
    pub(in crate::session) fn is_at(
        &mut self,
        scan: i64,
        banks: &Banks,
        touched: &mut Touched,
        entries: &VecDeque<Entry>,
    ) {
        if scan % SPAN != 0 {
            return;
        }
        if entries.len() < SPAN as usize {
            self.start = None;
            return;
        }
        let Some(start) = &mut self.start else {
            self.start = Some(banks.clone());
            return;
        };
        let cells = touched.in_this_span();
        let mut bytes = Vec::new();
        start.follow_banks(banks, touched, &mut bytes);
        let of_span = || entries.range(entries.len() - SPAN as usize..);
        let forces = of_span().find_map(|entry| entry.forces.as_ref());
        let span = Span {
            first: scan - SPAN,
            touched: cells,
            bytes,
            of_scans: of_span().map(Entry::bytes).sum(),
            forces: forces.map(|change| change.0.clone()),
        };
        self.size += span.size();
        self.kept.push_back(span);
    }

    /// Scans before this one are no longer kept.
    pub(in crate::session) fn forget_before(&mut self, scan: i64) {
        while let Some(oldest) = self.kept.front()
            && oldest.first < scan
        {
            self.size -= oldest.size();
            self.kept.pop_front();
        }
    }

    /// This scan and those after it have not happened.
    pub(in crate::session) fn forget_from(&mut self, scan: i64) {
        self.start = None;
        while let Some(newest) = self.kept.back()
            && newest.first + SPAN > scan
        {
            self.size -= newest.size();
            self.kept.pop_back();
        }
    }
}
