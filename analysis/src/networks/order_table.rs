//! Orders of evaluation that networks of one form share.
//!
//! The order follows from the kinds of the parts and from what touches, not from lengths and names. Most networks of a
//! program have one of a few forms, so that they need neither be walked nor kept one by one.

use crate::networks::order::{Order, order};
use ladder_syntax::wiring::{Rung, Wiring};
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// The longest form that is looked up, in parts. Longer ones seldom come twice.
const LONGEST: usize = 96;

/// So many forms are kept.
const MOST_FORMS: usize = 1024;

/// The orders of the forms that were met.
#[derive(Debug, Default)]
pub(crate) struct OrderTable {
    orders: FxHashMap<Box<[u8]>, Arc<Order>>,
    /// The form that is being looked up.
    form: Vec<u8>,
}

impl OrderTable {
    /// The order of evaluation of a network.
    pub(crate) fn of(&mut self, wiring: &Wiring) -> Arc<Order> {
        let parts: usize = wiring.rungs.iter().map(|rung| rung.parts.len() + 1).sum();
        if parts > LONGEST {
            return Arc::new(order(wiring));
        }
        self.form.clear();
        for rung in &wiring.rungs {
            write_form(rung, &mut self.form);
        }
        if let Some(known) = self.orders.get(&*self.form) {
            return Arc::clone(known);
        }
        let order = Arc::new(order(wiring));
        if self.orders.len() < MOST_FORMS {
            self.orders
                .insert(self.form.as_slice().into(), Arc::clone(&order));
        }
        order
    }
}

/// Where a rung ends: no part is written so.
const END: u8 = u8::MAX;

/// Writes all of a rung that decides about the order: for each part its kind, whether a segment begins with it, and
/// whether that begins at the rail. The pairs of connectors follow from the kinds.
fn write_form(rung: &Rung, form: &mut Vec<u8>) {
    let mut last = None;
    for part in &rung.parts {
        let begins = part.segment.filter(|_| part.segment != last);
        let segment = match (part.segment, begins) {
            (None, _) => 0,
            (Some(_), None) => 1,
            (Some(_), Some(new)) if rung.segments[new as usize].powered => 3,
            (Some(_), Some(_)) => 2,
        };
        last = part.segment.or(last);
        form.push((part.kind as u8) << 2 | segment);
    }
    form.push(END);
}
