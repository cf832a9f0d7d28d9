//! An interpreter of neutral text: a controller that executes rungs from left to right, each instruction as its manual
//! describes it. It shares nothing with the reader.

use super::formula::{self, Number};
use super::parts::{Part, parse};
use std::collections::{BTreeMap, HashMap};

/// What a rung does next.
#[derive(Debug, Clone, PartialEq)]
enum Flow {
    Next,
    Jump(String),
    Leave,
    End,
}

pub(super) struct Controller {
    /// Elementary tags, elements and members.
    memory: BTreeMap<String, f64>,
    /// The type of each tag.
    types: HashMap<String, String>,
    pub(super) sizes: HashMap<String, usize>,
    routines: HashMap<String, Vec<Vec<Part>>>,
    pub(super) now: i64,
    /// When each timer was counted last.
    pub(super) counted: HashMap<String, i64>,
    returned: Vec<f64>,
    handed: Vec<f64>,
}

const TIMER: &[&str] = &["PRE", "ACC", "EN", "TT", "DN"];
const COUNTER: &[&str] = &["PRE", "ACC", "CU", "CD", "DN", "OV", "UN"];
const CONTROL: &[&str] = &["LEN", "POS", "EN", "EU", "DN", "EM", "UL"];

impl Controller {
    pub(super) fn new(tags: &[(String, String, String)], routines: &[(&str, &[String])]) -> Controller {
        let mut controller = Controller {
            memory: BTreeMap::new(),
            types: HashMap::new(),
            sizes: HashMap::new(),
            routines: HashMap::new(),
            now: -10,
            counted: HashMap::new(),
            returned: Vec::new(),
            handed: Vec::new(),
        };
        for (name, ty, value) in tags {
            let (ty, size) = match ty.split_once('[') {
                Some((ty, size)) => (ty, size.trim_end_matches(']').parse().expect("a size")),
                None => (ty.as_str(), 0),
            };
            controller.types.insert(name.clone(), ty.to_owned());
            let members: &[&str] = match ty {
                "TIMER" => TIMER,
                "COUNTER" => COUNTER,
                "CONTROL" => CONTROL,
                _ => &[],
            };
            for member in members {
                controller.memory.insert(format!("{name}.{member}"), 0.0);
            }
            for index in 0..size {
                controller.memory.insert(format!("{name}[{index}]"), 0.0);
            }
            controller.sizes.insert(name.clone(), size);
            if members.is_empty() && size == 0 {
                controller
                    .memory
                    .insert(name.clone(), value.parse().unwrap_or(0.0));
            }
        }
        for (name, rungs) in routines {
            let rungs = rungs.iter().map(|rung| parse(rung)).collect();
            controller.routines.insert((*name).to_owned(), rungs);
        }
        controller
    }

    pub(super) fn names(&self) -> Vec<String> {
        self.memory.keys().cloned().collect()
    }

    pub(super) fn type_of(&self, name: &str) -> &str {
        let root = name.split(['[', '.']).next().unwrap_or_default();
        &self.types[root]
    }

    /// A bit of a word: the word, and which.
    fn bit_of(name: &str) -> Option<(&str, u32)> {
        let (word, bit) = name.rsplit_once('.')?;
        Some((word, bit.parse().ok()?))
    }

    pub(super) fn get(&self, name: &str) -> f64 {
        if let Some((word, bit)) = Self::bit_of(name) {
            return f64::from(u8::from((self.memory[word] as i64 >> bit) & 1 == 1));
        }
        *self
            .memory
            .get(name)
            .unwrap_or_else(|| panic!("{name} is nowhere"))
    }

    /// Writes a number, cut or rounded to the type of the tag.
    pub(super) fn set(&mut self, name: &str, value: f64) {
        if let Some((word, bit)) = Self::bit_of(name) {
            let before = self.memory[word] as i64;
            let after = if value == 0.0 {
                before & !(1 << bit)
            } else {
                before | 1 << bit
            };
            return self.set(word, after as f64);
        }
        let value = match self.type_of(name) {
            "REAL" => f64::from(value as f32),
            ty => {
                let whole = value.round_ties_even() as i64;
                match ty {
                    "SINT" => f64::from(whole as i8),
                    "INT" => f64::from(whole as i16),
                    "BOOL" => f64::from(u8::from(whole != 0)),
                    _ => f64::from(whole as i32),
                }
            }
        };
        *self
            .memory
            .get_mut(name)
            .unwrap_or_else(|| panic!("{name} is nowhere")) = value;
    }

    pub(super) fn high(&self, name: &str) -> bool {
        self.get(name) != 0.0
    }

    pub(super) fn put(&mut self, name: &str, high: bool) {
        self.set(name, f64::from(u8::from(high)));
    }

    pub(super) fn operand(&self, text: &str) -> Number {
        if let Ok(value) = text.parse::<f64>() {
            return Number {
                value,
                is_real: text.contains('.'),
            };
        }
        Number {
            value: self.get(text),
            is_real: self.type_of(text) == "REAL",
        }
    }

    pub(super) fn whole(&self, text: &str) -> i64 {
        self.operand(text).value as i64
    }

    /// Each rung once, with dead rails.
    pub(super) fn prescan(&mut self) {
        let routines: Vec<_> = self.routines.values().cloned().collect();
        for rung in routines.iter().flatten() {
            self.prescan_of(rung);
        }
    }

    fn prescan_of(&mut self, parts: &[Part]) {
        for part in parts {
            let (name, o) = match part {
                Part::Branch(legs) => {
                    for leg in legs {
                        self.prescan_of(leg);
                    }
                    continue;
                }
                Part::It(name, operands) => (name.as_str(), operands),
            };
            let mut puts = |members: &[(&str, &str, f64)]| {
                for (tag, member, value) in members {
                    let name = if member.is_empty() {
                        (*tag).to_owned()
                    } else {
                        format!("{tag}.{member}")
                    };
                    self.set(&name, *value);
                }
            };
            match name {
                "OTE" => puts(&[(&o[0], "", 0.0)]),
                "ONS" => puts(&[(&o[0], "", 1.0)]),
                "OSR" => puts(&[(&o[0], "", 1.0), (&o[1], "", 0.0)]),
                "OSF" => puts(&[(&o[0], "", 0.0), (&o[1], "", 0.0)]),
                "TON" | "TOF" | "RTO" => {
                    let preset: f64 = o[1].parse().expect("a number");
                    let at = if name == "TOF" { preset } else { 0.0 };
                    puts(&[(&o[0], "PRE", preset), (&o[0], "ACC", at)]);
                }
                "CTU" => puts(&[(&o[0], "PRE", 3.0), (&o[0], "CU", 1.0)]),
                "CTD" => puts(&[(&o[0], "PRE", 3.0), (&o[0], "CD", 1.0)]),
                "BSL" | "BSR" => puts(&[(&o[1], "LEN", 64.0)]),
                "FFL" | "LFL" => puts(&[(&o[2], "LEN", 4.0), (&o[2], "EN", 1.0)]),
                "FFU" | "LFU" => puts(&[(&o[2], "LEN", 4.0), (&o[2], "EU", 1.0)]),
                "SQO" => puts(&[(&o[3], "LEN", 3.0), (&o[3], "EN", 1.0)]),
                "SQL" => puts(&[(&o[2], "LEN", 3.0), (&o[2], "EN", 1.0)]),
                _ => {}
            }
        }
    }

    pub(super) fn scan(&mut self, milliseconds: i64) {
        self.now += milliseconds;
        self.routine("Main");
    }

    fn routine(&mut self, name: &str) -> Flow {
        let rungs = self.routines[name].clone();
        let (mut at, mut live) = (0, true);
        while let Some(rung) = rungs.get(at) {
            at += 1;
            let zone = rung
                .iter()
                .any(|part| matches!(part, Part::It(name, _) if name == "MCR"));
            let (power, flow) = self.series(rung, live || zone);
            if zone {
                live = power;
            }
            match flow {
                Flow::Next => {}
                Flow::Jump(label) => {
                    let is_it = |rung: &Vec<Part>| matches!(rung.first(), Some(Part::It(name, o)) if name == "LBL" && o[0] == label);
                    at = rungs.iter().position(is_it).expect("the label is there");
                }
                Flow::Leave => return Flow::Leave,
                Flow::End => return Flow::End,
            }
        }
        Flow::Leave
    }

    fn series(&mut self, parts: &[Part], mut power: bool) -> (bool, Flow) {
        for part in parts {
            match part {
                Part::Branch(legs) => {
                    let mut any = false;
                    for leg in legs {
                        let (own, flow) = self.series(leg, power);
                        if flow != Flow::Next {
                            return (power, flow);
                        }
                        any |= own;
                    }
                    power = any;
                }
                Part::It(name, operands) => {
                    let (own, flow) = self.run(name, operands, power);
                    power = own;
                    if flow != Flow::Next {
                        return (power, flow);
                    }
                }
            }
        }
        (power, Flow::Next)
    }

    fn run(&mut self, name: &str, o: &[String], power: bool) -> (bool, Flow) {
        let go = |power: bool| (power, Flow::Next);
        match name {
            "XIC" if o[0].contains(".[") => {
                let (word, index) = o[0].split_once(".[").expect("a bit");
                let bit = format!("{word}.{}", index.trim_end_matches(']'));
                go(power && self.high(&bit))
            }
            "XIC" => go(power && self.high(&o[0])),
            "XIO" => go(power && !self.high(&o[0])),
            "OTE" => {
                self.put(&o[0], power);
                go(power)
            }
            "OTL" | "OTU" => {
                if power {
                    self.put(&o[0], name == "OTL");
                }
                go(power)
            }
            "ONS" => {
                let before = self.high(&o[0]);
                self.put(&o[0], power);
                go(power && !before)
            }
            "OSR" => {
                let before = self.high(&o[0]);
                self.put(&o[1], power && !before);
                self.put(&o[0], power);
                go(power)
            }
            "OSF" => {
                let before = self.high(&o[0]);
                self.put(&o[1], !power && before);
                self.put(&o[0], power);
                go(power)
            }
            "EQU" | "NEQ" | "LES" | "LEQ" | "GRT" | "GEQ" => {
                let (a, b) = (self.operand(&o[0]).value, self.operand(&o[1]).value);
                go(power && compare(name, a, b))
            }
            "LIM" => {
                let [low, test, high] = [0, 1, 2].map(|at| self.operand(&o[at]).value);
                let inside = if low <= high {
                    low <= test && test <= high
                } else {
                    test <= high || test >= low
                };
                go(power && inside)
            }
            "MEQ" => {
                let [source, mask, other] = [0, 1, 2].map(|at| self.whole(&o[at]));
                go(power && source & mask == other & mask)
            }
            "CMP" => {
                let (left, right) = o[0].split_once('>').expect("a comparison");
                let (a, b) = (formula::value(self, left), formula::value(self, right));
                go(power && a.value > b.value)
            }
            "SQI" => {
                let at = self.whole(&format!("{}.POS", o[3]));
                let step = self.whole(&format!("steps[{at}]"));
                let (mask, source) = (self.whole(&o[1]), self.whole(&o[2]));
                go(power && source & mask == step & mask)
            }
            "TON" | "TOF" | "RTO" => {
                self.timer(name, &o[0], power);
                go(power)
            }
            "CTU" | "CTD" => {
                self.counter(name, &o[0], power);
                go(power)
            }
            "RES" => {
                if power {
                    let members: &[&str] = match self.type_of(&o[0]) {
                        "TIMER" => &TIMER[1..],
                        "COUNTER" => &COUNTER[1..],
                        _ => &CONTROL[1..],
                    };
                    for member in members {
                        self.set(&format!("{}.{member}", o[0]), 0.0);
                    }
                }
                go(power)
            }
            "BSL" | "BSR" => {
                self.shift(name, &o[1], &o[2], power);
                go(power)
            }
            "FFL" | "LFL" | "FFU" | "LFU" => {
                self.stack(name, o, power);
                go(power)
            }
            "SQO" | "SQL" => {
                self.sequence(name, o, power);
                go(power)
            }
            "SBR" => {
                for (name, value) in o.iter().zip(self.handed.clone()) {
                    self.set(name, value);
                }
                go(power)
            }
            "RET" if power => {
                self.returned = o.iter().map(|text| self.operand(text).value).collect();
                (power, Flow::Leave)
            }
            "TND" if power => (power, Flow::End),
            "JMP" if power => (power, Flow::Jump(o[0].clone())),
            "JSR" => {
                if power {
                    self.handed = vec![self.operand(&o[2]).value];
                    self.returned.clear();
                    self.routine(&o[0]);
                    if let Some(value) = self.returned.first().copied() {
                        self.set(&o[3], value);
                    }
                }
                go(power)
            }
            "RET" | "TND" | "JMP" | "LBL" | "MCR" => go(power),
            _ => {
                if power {
                    self.compute(name, o);
                }
                go(power)
            }
        }
    }
}

#[allow(clippy::float_cmp)]
fn compare(name: &str, a: f64, b: f64) -> bool {
    match name {
        "EQU" => a == b,
        "NEQ" => a != b,
        "LES" => a < b,
        "LEQ" => a <= b,
        "GRT" => a > b,
        _ => a >= b,
    }
}
