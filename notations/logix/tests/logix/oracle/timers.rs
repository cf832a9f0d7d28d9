//! Timers and counters.

use super::interpreter::Controller;

impl Controller {
    pub(super) fn timer(&mut self, name: &str, tag: &str, power: bool) {
        let member = |member: &str| format!("{tag}.{member}");
        let was = self.high(&member("EN"));
        let counts = |controller: &mut Controller| {
            let last = controller
                .counted
                .insert(tag.to_owned(), controller.now)
                .unwrap_or(controller.now);
            let at = controller.get(&format!("{tag}.ACC"));
            controller.set(&format!("{tag}.ACC"), at + (controller.now - last) as f64);
        };
        let done = self.high(&member("DN"));
        match (name, power) {
            ("TON" | "RTO", true) => {
                if !was {
                    self.counted.insert(tag.to_owned(), self.now);
                } else if !done {
                    counts(self);
                }
                let done = done || self.get(&member("ACC")) >= self.get(&member("PRE"));
                self.put(&member("DN"), done);
                self.put(&member("TT"), !done);
            }
            ("TON", false) => {
                self.set(&member("ACC"), 0.0);
                self.put(&member("DN"), false);
                self.put(&member("TT"), false);
            }
            ("RTO", false) => self.put(&member("TT"), false),
            (_, true) => {
                self.set(&member("ACC"), 0.0);
                self.put(&member("DN"), true);
                self.put(&member("TT"), false);
            }
            (_, false) => {
                if was {
                    self.counted.insert(tag.to_owned(), self.now);
                } else if done {
                    counts(self);
                }
                let timing = done && self.get(&member("ACC")) < self.get(&member("PRE"));
                self.put(&member("DN"), timing);
                self.put(&member("TT"), timing);
            }
        }
        self.put(&member("EN"), power);
    }

    pub(super) fn counter(&mut self, name: &str, tag: &str, power: bool) {
        let own = format!("{tag}.{}", if name == "CTU" { "CU" } else { "CD" });
        let at = format!("{tag}.ACC");
        if power && !self.high(&own) {
            let step = if name == "CTU" { 1.0 } else { -1.0 };
            self.set(&at, self.get(&at) + step);
        }
        self.put(&own, power);
        if power {
            let done = self.get(&at) >= self.get(&format!("{tag}.PRE"));
            self.put(&format!("{tag}.DN"), done);
        }
    }
}
