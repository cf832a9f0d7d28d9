//! Runs the steps of the generator as the compiler of Beremiz and OpenPLC does: its timers, counters and bistables.

use super::controls;
use super::generator::{Step, Term, Unit};
use std::collections::HashMap;

/// The units of a project.
pub(super) type Units = HashMap<String, Unit>;

/// A program, or an instance of a block: values by name in small letters. TIME is in milliseconds.
#[derive(Debug, Default)]
pub(super) struct Frame {
    unit: String,
    values: HashMap<String, f64>,
    types: HashMap<String, String>,
    inside: HashMap<String, Frame>,
}

impl Frame {
    /// As it is before the first scan.
    pub(super) fn new(units: &Units, unit: &str) -> Result<Frame, String> {
        let mut frame = Frame {
            unit: unit.to_lowercase(),
            ..Frame::default()
        };
        frame.values.insert("eno".to_owned(), 1.0);
        let Some(known) = units.get(&frame.unit) else {
            let base = unit.split_once('_').map_or(unit, |(base, _)| base);
            return match base {
                "TON" | "TOF" | "TP" | "CTU" | "CTD" | "CTUD" | "SR" | "RS" => {
                    base.to_lowercase().clone_into(&mut frame.unit);
                    Ok(frame)
                }
                "R" | "F" => Ok(frame),
                _ if controls::NAMES.contains(&unit) => Ok(frame),
                other => Err(format!("a block {other}")),
            };
        };
        for (name, ty, value) in &known.variables {
            if matches!(
                ty.as_str(),
                "BOOL" | "INT" | "DINT" | "UINT" | "WORD" | "REAL" | "TIME"
            ) {
                frame.values.insert(name.clone(), *value);
                frame.types.insert(name.clone(), ty.clone());
            } else {
                frame.inside.insert(name.clone(), Frame::new(units, ty)?);
            }
        }
        Ok(frame)
    }

    pub(super) fn get(&self, name: &str) -> f64 {
        match name.split_once('.') {
            Some((first, rest)) => self.inside.get(first).map_or(0.0, |inside| inside.get(rest)),
            None => self.values.get(name).copied().unwrap_or_default(),
        }
    }

    pub(super) fn set(&mut self, name: &str, value: f64) {
        let value = match self.types.get(name).map(String::as_str) {
            Some("INT") => f64::from(value as i64 as i16),
            _ => value,
        };
        self.values.insert(name.to_owned(), value);
    }

    /// The variables, but those of instances and those of the steps themselves.
    pub(super) fn names(&self) -> Vec<String> {
        let mut names: Vec<String> = self.types.keys().cloned().collect();
        names.sort();
        names
    }

    /// Whether a variable is of this type.
    pub(super) fn is_of(&self, name: &str, ty: &str) -> bool {
        self.types.get(name).is_some_and(|it| it == ty)
    }

    fn term(&self, term: &Term) -> f64 {
        let truth = |it: bool| f64::from(u8::from(it));
        match term {
            Term::Always => 1.0,
            Term::Literal(value) => *value,
            Term::Read(name) => self.get(name),
            Term::Not(term) => truth(self.term(term) == 0.0),
            Term::And(terms) => truth(terms.iter().all(|term| self.term(term) != 0.0)),
            Term::Or(terms) => truth(terms.iter().any(|term| self.term(term) != 0.0)),
        }
    }

    /// One scan at a time in milliseconds.
    pub(super) fn run(&mut self, units: &Units, now: f64) -> Result<(), String> {
        let steps = &units[&self.unit].steps;
        for step in steps {
            match step {
                Step::Write(to, term) => {
                    let value = self.term(term);
                    self.set(to, value);
                }
                Step::Latch(term, to, value) => {
                    if self.term(term) != 0.0 {
                        self.set(to, f64::from(u8::from(*value)));
                    }
                }
                Step::WriteIf(eno, to, term) => {
                    if self.get(eno) != 0.0 {
                        let value = self.term(term);
                        self.set(to, value);
                    }
                }
                Step::Edge(name, rising, term) => {
                    let value = self.term(term);
                    let clock = if *rising { value } else { 1.0 - value };
                    let state = format!("{name}.m");
                    let was = self.values.insert(state, clock).unwrap_or_default();
                    self.set(name, f64::from(u8::from(clock != 0.0 && was == 0.0)));
                }
                Step::Call(instance, given) => {
                    let given: Vec<(&String, f64)> =
                        given.iter().map(|(pin, term)| (pin, self.term(term))).collect();
                    let inside = self
                        .inside
                        .get_mut(instance)
                        .ok_or("an instance that is not declared")?;
                    for (pin, value) in given {
                        inside.set(pin, value);
                    }
                    if inside.values.get("en").copied().unwrap_or(1.0) == 0.0 {
                        inside.set("eno", 0.0);
                        continue;
                    }
                    inside.set("eno", 1.0);
                    if units.contains_key(&inside.unit) {
                        inside.run(units, now)?;
                    } else {
                        inside.standard(now);
                    }
                }
                Step::Compute(name, terms, to, enable) => {
                    let mut value = None;
                    let terms: Vec<f64> = terms.iter().map(|term| self.term(term)).collect();
                    if let Some((enable, eno)) = enable {
                        let enable = self.term(enable);
                        self.set(eno, enable);
                        if enable == 0.0 {
                            value = Some(0.0);
                        }
                    } else {
                        self.set(&to.replace("_out", "_eno"), 1.0);
                    }
                    let value = match value {
                        Some(value) => value,
                        None => function(name, &terms)?,
                    };
                    self.set(to, value);
                }
            }
        }
        Ok(())
    }

    fn rises(&mut self, pin: &str) -> bool {
        let now = self.get(pin);
        let was = self
            .values
            .insert(format!("{pin} before"), now)
            .unwrap_or_default();
        now != 0.0 && was == 0.0
    }

    fn standard(&mut self, now: f64) {
        let truth = |it: bool| f64::from(u8::from(it));
        let high = |frame: &Frame, pin: &str| frame.get(pin) != 0.0;
        match self.unit.as_str() {
            "r_trig" => {
                let rises = self.rises("clk");
                self.set("q", truth(rises));
            }
            "f_trig" => {
                let inverted = 1.0 - self.get("clk");
                self.set("nclk", inverted);
                let falls = self.rises("nclk");
                self.set("q", truth(falls));
            }
            "sr" => {
                let q = high(self, "s1") || (!high(self, "r") && high(self, "q1"));
                self.set("q1", truth(q));
            }
            "rs" => {
                let q = !high(self, "r1") && (high(self, "s") || high(self, "q1"));
                self.set("q1", truth(q));
            }
            "ctu" | "ctd" | "ctud" => self.counter(),
            name if controls::NAMES.iter().any(|own| own.eq_ignore_ascii_case(name)) => {
                controls::run(name, &mut self.values);
            }
            _ => self.timer(now),
        }
    }

    fn counter(&mut self) {
        let truth = |it: bool| f64::from(u8::from(it));
        let (up, down) = (self.rises("cu"), self.rises("cd"));
        let (mut count, limit) = (self.get("cv"), self.get("pv"));
        if self.get("r") != 0.0 {
            count = 0.0;
        } else if self.get("ld") != 0.0 {
            count = limit;
        } else if up != down {
            if up && count < limit {
                count += 1.0;
            } else if down && count > 0.0 {
                count -= 1.0;
            }
        }
        self.set("cv", count);
        let is_down = self.unit == "ctd";
        self.set("q", truth(if is_down { count <= 0.0 } else { count >= limit }));
        self.set("qu", truth(count >= limit));
        self.set("qd", truth(count <= 0.0));
    }

    fn timer(&mut self, now: f64) {
        let truth = |it: bool| f64::from(u8::from(it));
        let (input, was, limit) = (self.get("in") != 0.0, self.get("was") != 0.0, self.get("pt"));
        let mut state = self.get("state");
        let is_over = self.get("start") + limit <= now;
        let passed = if is_over { limit } else { now - self.get("start") };
        let begins = if self.unit == "tof" {
            was && !input
        } else {
            !was && input
        };
        if state == 0.0 && begins {
            state = 1.0;
            self.set("start", now);
            self.set("q", truth(self.unit != "ton"));
        } else if self.unit != "tp" && input == (self.unit == "tof") {
            state = 0.0;
            self.set("et", 0.0);
            self.set("q", 0.0);
        } else if state as i8 == 1 {
            self.set("et", passed);
            if is_over {
                state = 2.0;
                self.set("q", truth(self.unit == "ton"));
            }
        }
        if self.unit == "tp" && state as i8 == 2 && !input {
            state = 0.0;
            self.set("et", 0.0);
        }
        if self.unit == "tof" {
            self.set("q", truth(input || state as i8 == 1));
        }
        self.set("state", state);
        self.set("was", truth(input));
    }
}

fn function(name: &str, terms: &[f64]) -> Result<f64, String> {
    let truth = |it: bool| f64::from(u8::from(it));
    let pairs = |holds: fn(f64, f64) -> bool| truth(terms.windows(2).all(|pair| holds(pair[0], pair[1])));
    let fold = |with: fn(f64, f64) -> f64| terms.iter().copied().reduce(with).unwrap_or_default();
    Ok(match name {
        "ADD" => fold(|a, b| a + b),
        "SUB" => fold(|a, b| a - b),
        "MUL" => fold(|a, b| a * b),
        "MOVE" => fold(|a, _| a),
        "MAX" => fold(f64::max),
        "MIN" => fold(f64::min),
        "AND" => truth(terms.iter().all(|term| *term != 0.0)),
        "OR" => truth(terms.iter().any(|term| *term != 0.0)),
        "XOR" => fold(|a, b| f64::from(u8::from((a != 0.0) != (b != 0.0)))),
        "NOT" => truth(terms.first() == Some(&0.0)),
        "GT" => pairs(|a, b| a > b),
        "GE" => pairs(|a, b| a >= b),
        "LT" => pairs(|a, b| a < b),
        "LE" => pairs(|a, b| a <= b),
        "EQ" => pairs(|a, b| a.total_cmp(&b).is_eq()),
        "NE" => pairs(|a, b| a.total_cmp(&b).is_ne()),
        "SEL" if terms.len() == 3 => terms[1 + usize::from(terms[0] != 0.0)],
        "LIMIT" if terms.len() == 3 => terms[1].min(terms[2]).max(terms[0]),
        other => return Err(format!("a function {other}")),
    })
}
