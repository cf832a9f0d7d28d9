//! The adapter lives on, whatever happens.

use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::adapter::Adapter;
use crate::messages::Request;

impl Adapter {
    /// Answers a request, whatever happens.
    pub fn handle(&mut self, request: &Request) {
        let outcome = catch_unwind(AssertUnwindSafe(|| self.answer(request)));
        let outcome = outcome
            .unwrap_or_else(|_| Err("the adapter has met an error of its own; please report it".into()));
        self.answered(request, outcome);
    }

    /// Goes on with a run, whatever happens.
    pub fn run_on(&mut self) {
        if catch_unwind(AssertUnwindSafe(|| self.go_on())).is_err() {
            self.give_up();
        }
        self.send_events();
    }
}
