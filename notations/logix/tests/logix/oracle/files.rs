//! Shift registers, stacks, sequencers.

use super::interpreter::Controller;

impl Controller {
    pub(super) fn shift(&mut self, name: &str, control: &str, bit: &str, power: bool) {
        let rises = power && !self.high(&format!("{control}.EN"));
        if rises {
            let [low, high] = ["bits[0]", "bits[1]"].map(|name| self.whole(name) as i32 as u32);
            let all = u64::from(high) << 32 | u64::from(low);
            let enters = u64::from(self.high(bit));
            let (after, leaves) = match name {
                "BSL" => (all << 1 | enters, all >> 63 == 1),
                _ => (all >> 1 | enters << 63, all & 1 == 1),
            };
            self.set("bits[0]", f64::from(after as u32 as i32));
            self.set("bits[1]", f64::from((after >> 32) as u32 as i32));
            self.put(&format!("{control}.UL"), leaves);
        }
        self.put(&format!("{control}.EN"), power);
        self.put(&format!("{control}.DN"), power);
        self.set(&format!("{control}.POS"), if power { 64.0 } else { 0.0 });
    }

    pub(super) fn stack(&mut self, name: &str, o: &[String], power: bool) {
        let control = &o[2];
        let loads = name.ends_with('L');
        let own = format!("{control}.{}", if loads { "EN" } else { "EU" });
        let rises = power && !self.high(&own);
        self.put(&own, power);
        let position = format!("{control}.POS");
        let (at, most) = (
            self.get(&position) as usize,
            self.get(&format!("{control}.LEN")) as usize,
        );
        if rises && loads && at < most {
            self.set(&format!("fifo[{at}]"), self.operand(&o[0]).value);
            self.set(&position, (at + 1) as f64);
        } else if rises && !loads && at > 0 {
            let first = if name == "FFU" { 0 } else { at - 1 };
            let value = self.get(&format!("fifo[{first}]"));
            if name == "FFU" {
                for index in 1..most {
                    let next = self.get(&format!("fifo[{index}]"));
                    self.set(&format!("fifo[{}]", index - 1), next);
                }
                self.set(&format!("fifo[{}]", most - 1), 0.0);
            }
            self.set(&o[1], value);
            self.set(&position, (at - 1) as f64);
        }
        let at = self.get(&position);
        self.put(&format!("{control}.DN"), at >= most as f64);
        self.put(&format!("{control}.EM"), at <= 0.0);
    }

    pub(super) fn sequence(&mut self, name: &str, o: &[String], power: bool) {
        let control = &o[o.len() - 3];
        let own = format!("{control}.EN");
        let position = format!("{control}.POS");
        let most = self.get(&format!("{control}.LEN"));
        let rises = power && !self.high(&own);
        if rises {
            let next = self.get(&position) + 1.0;
            self.set(&position, if next > most { 1.0 } else { next });
        }
        let step = format!("steps[{}]", self.whole(&position));
        if name == "SQL" && rises {
            self.set(&step, self.operand(&o[1]).value);
        }
        if name == "SQO" && power {
            let mask = self.whole(&o[1]);
            let after = (self.whole(&o[2]) & !mask) | (self.whole(&step) & mask);
            self.set(&o[2], after as f64);
        }
        self.put(&own, power);
        let done = power && self.get(&position) >= most;
        self.put(&format!("{control}.DN"), done);
    }
}
