//! Random programs as an editor would draw them.

/// Numbers without a pattern.
pub(super) struct Dice(pub(super) u64);

impl Dice {
    pub(super) fn below(&mut self, most: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % most
    }

    fn of<'t>(&mut self, all: &[&'t str]) -> &'t str {
        all[self.below(all.len())]
    }
}

/// Where power or a value comes from: an element, and which of its outputs.
type Wire = (usize, &'static str);

const INPUTS: &[&str] = &["a", "b", "c", "d"];
const COILS: &[&str] = &["u", "v", "w", "x", "y", "z"];
const TIMES: &[&str] = &["t#100ms", "T#300ms", "T#450ms", "T#0.7s", "t#1s"];
const INSTANCES: &[(&str, &str)] = &[
    ("ton0", "TON"),
    ("ton1", "TON"),
    ("tof0", "TOF"),
    ("tp0", "TP"),
    ("ctu0", "CTU"),
    ("ctd0", "CTD"),
    ("ctud0", "CTUD"),
    ("sr0", "SR"),
    ("rs0", "RS"),
    ("rise0", "R_TRIG"),
    ("fall0", "F_TRIG"),
];

/// A project with one program.
pub(super) fn project(dice: &mut Dice) -> String {
    let mut editor = Editor {
        dice,
        out: String::new(),
        count: 0,
        left: INSTANCES.to_vec(),
        y: 0,
        last: Vec::new(),
    };
    let rungs = 1 + editor.dice.below(5);
    for _ in 0..rungs {
        editor.rung();
    }
    let body = editor.out;
    let variable = |(name, ty): (&str, &str)| {
        let ty = match ty {
            "BOOL" | "INT" | "TIME" => format!("<{ty}/>"),
            ty => format!("<derived name=\"{ty}\"/>"),
        };
        format!("<variable name=\"{name}\"><type>{ty}</type></variable>\n")
    };
    let bits = INPUTS.iter().chain(COILS).map(|name| (*name, "BOOL"));
    let numbers = [("n", "INT"), ("m", "INT"), ("k", "INT"), ("e", "TIME")];
    let variables: String = bits
        .chain(numbers)
        .chain(INSTANCES.iter().copied())
        .map(variable)
        .collect();
    let unit = format!(
        "<pou name=\"main\" pouType=\"program\"><interface><localVars>\n{variables}</localVars></interface><body><LD>\n{body}</LD></body></pou>"
    );
    crate::harness::project("", &unit, "")
}

struct Editor<'d> {
    dice: &'d mut Dice,
    out: String,
    count: usize,
    /// The instances that stand nowhere yet.
    left: Vec<(&'static str, &'static str)>,
    y: usize,
    /// Wires of the rung that other branches may begin at.
    last: Vec<Wire>,
}

impl Editor<'_> {
    fn element(&mut self, kind: &str, attributes: &str, x: usize, inside: &str) -> usize {
        self.count += 1;
        let (id, y) = (self.count, self.y);
        self.out.push_str(&format!(
            "<{kind} localId=\"{id}\"{attributes}><position x=\"{x}\" y=\"{y}\"/>{inside}</{kind}>\n"
        ));
        id
    }

    fn point(from: &[Wire]) -> String {
        let wires: String = from
            .iter()
            .map(|(id, output)| match *output {
                "" => format!("<connection refLocalId=\"{id}\"/>"),
                output => format!("<connection refLocalId=\"{id}\" formalParameter=\"{output}\"/>"),
            })
            .collect();
        format!("<connectionPointIn>{wires}</connectionPointIn>")
    }

    fn rung(&mut self) {
        self.y += 100;
        let rail = self.element(
            "leftPowerRail",
            "",
            0,
            "<connectionPointOut formalParameter=\"\"/>",
        );
        self.last = vec![(rail, "")];
        let mut x = 50;
        if self.dice.below(8) == 0 {
            return self.compute(&[(rail, "")]);
        }
        let power = self.network(vec![(rail, "")], &mut x, 2);
        let row = self.y;
        let mut from = power;
        for _ in 0..=self.dice.below(3) {
            let coil = self.coil(&from, x);
            match self.dice.below(3) {
                0 => {
                    from = vec![(coil, "")];
                    x += 70;
                }
                1 => self.y += 40,
                _ => {
                    self.y += 40;
                    if self.dice.below(2) == 0 {
                        let contact = self.contact(&from, x);
                        from = vec![(contact, "")];
                        x += 70;
                    }
                }
            }
        }
        if self.dice.below(6) == 0 {
            let begin = self.last[self.dice.below(self.last.len())];
            self.y += 40;
            self.compute(&[begin]);
        }
        self.y = self.y.max(row) + 60;
    }

    /// Series and branches; comes back with where its power leaves.
    fn network(&mut self, from: Vec<Wire>, x: &mut usize, depth: usize) -> Vec<Wire> {
        let mut from = from;
        for _ in 0..=self.dice.below(3) {
            let top = self.y;
            from = match self.dice.below(8) {
                0..=2 if depth > 0 => {
                    let (mut left, mut right) = (*x, *x);
                    let mut out = self.network(from.clone(), &mut left, depth - 1);
                    self.y += 40;
                    if self.dice.below(5) == 0 {
                        from = vec![self.last[self.dice.below(self.last.len())]];
                    }
                    let low = self.network(from, &mut right, depth - 1);
                    *x = left.max(right);
                    out.extend(
                        low.into_iter()
                            .filter(|wire| !out.contains(wire))
                            .collect::<Vec<_>>(),
                    );
                    let bottom = self.y;
                    self.y = top;
                    let out = match self.dice.below(3) {
                        0 => vec![(self.contact(&out, *x), "")],
                        _ => out,
                    };
                    self.y = if self.dice.below(2) == 0 { top } else { bottom };
                    *x += 70;
                    out
                }
                3 if !self.left.is_empty() => {
                    let out = self.block(&from, *x);
                    *x += 120;
                    vec![out]
                }
                4 if self.dice.below(3) == 0 => {
                    let out = self.compare(&from, *x);
                    *x += 120;
                    vec![out]
                }
                _ => {
                    let contact = self.contact(&from, *x);
                    *x += 70;
                    vec![(contact, "")]
                }
            };
            self.last.push(from[0]);
        }
        from
    }

    fn contact(&mut self, from: &[Wire], x: usize) -> usize {
        let modifier = match self.dice.below(12) {
            0..=2 => " negated=\"true\"",
            3 => " edge=\"rising\"",
            4 => " edge=\"falling\"",
            _ => " negated=\"false\"",
        };
        let tag = match self.dice.below(12) {
            0..=6 => self.dice.of(INPUTS),
            7..=10 => self.dice.of(COILS),
            _ => self.dice.of(&["ton0.Q", "tof0.Q", "ctu0.Q", "sr0.Q1", "tp0.Q"]),
        };
        let inside = format!(
            "{}<connectionPointOut/><variable>{tag}</variable>",
            Self::point(from)
        );
        self.element("contact", modifier, x, &inside)
    }

    fn coil(&mut self, from: &[Wire], x: usize) -> usize {
        let modifier = match self.dice.below(14) {
            0 | 1 => " storage=\"set\"",
            2 | 3 => " storage=\"reset\"",
            4 => " negated=\"true\"",
            5 => " edge=\"rising\"",
            6 => " edge=\"falling\"",
            _ => " storage=\"none\"",
        };
        let tag = self.dice.of(COILS);
        let inside = format!(
            "{}<connectionPointOut/><variable>{tag}</variable>",
            Self::point(from)
        );
        self.element("coil", modifier, x, &inside)
    }

    fn value(&mut self, text: &str, x: usize) -> Wire {
        let inside = format!("<connectionPointOut/><expression>{text}</expression>");
        (self.element("inVariable", "", x, &inside), "")
    }

    fn output(&mut self, from: Wire, text: &str, x: usize) {
        let inside = format!("{}<expression>{text}</expression>", Self::point(&[from]));
        self.element("outVariable", "", x, &inside);
    }

    fn pin(&mut self, name: &str, from: &[Wire]) -> String {
        let modifier = match self.dice.below(14) {
            0 if name != "PT" && name != "PV" => " negated=\"true\"",
            1 if name != "PT" && name != "PV" => " edge=\"rising\"",
            _ => "",
        };
        format!(
            "<variable formalParameter=\"{name}\"{modifier}>{}</variable>",
            Self::point(from)
        )
    }

    /// A bit at a pin: a variable, or a rung of its own.
    fn bit(&mut self, x: usize) -> Vec<Wire> {
        if self.dice.below(2) == 0 {
            let tag = self.dice.of(INPUTS);
            return vec![self.value(tag, x)];
        }
        let rail = self.element(
            "leftPowerRail",
            "",
            0,
            "<connectionPointOut formalParameter=\"\"/>",
        );
        vec![(self.contact(&[(rail, "")], x), "")]
    }

    /// A block in the wire.
    fn block(&mut self, from: &[Wire], x: usize) -> Wire {
        let (instance, ty) = self.left.remove(self.dice.below(self.left.len()));
        let row = self.y;
        let mut pins = String::new();
        let limit = match ty {
            "TON" | "TOF" | "TP" => {
                let time = self.dice.of(TIMES);
                vec![("PT", vec![self.value(time, x)])]
            }
            "CTU" | "CTD" | "CTUD" => {
                let number = self.dice.of(&["1", "2", "3", "INT#4"]);
                vec![("PV", vec![self.value(number, x)])]
            }
            _ => Vec::new(),
        };
        let others: &[&str] = match ty {
            "CTU" => &["R"],
            "CTD" => &["LD"],
            "CTUD" => &["CD", "R", "LD"],
            "SR" => &["R"],
            "RS" => &["R1"],
            _ => &[],
        };
        let first = match ty {
            "TON" | "TOF" | "TP" => "IN",
            "CTU" | "CTUD" => "CU",
            "CTD" => "CD",
            "SR" => "S1",
            "RS" => "S",
            _ => "CLK",
        };
        pins.push_str(&self.pin(first, from));
        for pin in others {
            if self.dice.below(4) > 0 {
                self.y += 40;
                let bit = self.bit(x - 40);
                pins.push_str(&self.pin(pin, &bit));
            }
        }
        for (pin, from) in limit {
            pins.push_str(&self.pin(pin, &from));
        }
        let outputs: &[&'static str] = match ty {
            "TON" | "TOF" | "TP" => &["Q", "ET"],
            "CTU" | "CTD" => &["Q", "CV"],
            "CTUD" => &["QU", "QD", "CV"],
            "SR" | "RS" => &["Q1"],
            _ => &["Q"],
        };
        self.y = row + [0, 0, 20, 60][self.dice.below(4)];
        let out =
            |name: &str| format!("<variable formalParameter=\"{name}\"><connectionPointOut/></variable>");
        let outs: String = outputs.iter().map(|name| out(name)).collect();
        let attributes = format!(" typeName=\"{ty}\" instanceName=\"{instance}\"");
        let inside = format!(
            "<inputVariables>{pins}</inputVariables><inOutVariables/><outputVariables>{outs}</outputVariables>"
        );
        let id = self.element("block", &attributes, x, &inside);
        let last = outputs[outputs.len() - 1];
        if matches!(last, "ET" | "CV") && self.dice.below(2) == 0 {
            self.y += 20;
            let to = if last == "ET" {
                "e"
            } else {
                self.dice.of(&["n", "m"])
            };
            self.output((id, last), to, x + 60);
        }
        self.y = row;
        (
            id,
            outputs[self.dice.below(outputs.len().saturating_sub(1).max(1))],
        )
    }

    /// A comparison with EN in the wire, or at its result.
    fn compare(&mut self, from: &[Wire], x: usize) -> Wire {
        let name = self.dice.of(&["GT", "GE", "LT", "LE", "EQ", "NE"]);
        let one = self.number(x);
        let other = self.number(x);
        let id = self.function(name, Some(from), &[("IN1", one), ("IN2", other)], x + 30);
        (id, if self.dice.below(3) == 0 { "ENO" } else { "OUT" })
    }

    fn number(&mut self, x: usize) -> Wire {
        let text = self.dice.of(&["n", "m", "k", "1", "2", "ctu0.CV"]);
        self.value(text, x)
    }

    fn function(&mut self, name: &str, enable: Option<&[Wire]>, inputs: &[(&str, Wire)], x: usize) -> usize {
        let mut pins = String::new();
        let mut outs = String::new();
        if let Some(enable) = enable {
            pins.push_str(&format!(
                "<variable formalParameter=\"EN\">{}</variable>",
                Self::point(enable)
            ));
            outs.push_str("<variable formalParameter=\"ENO\"><connectionPointOut/></variable>");
        }
        for (name, from) in inputs {
            pins.push_str(&format!(
                "<variable formalParameter=\"{name}\">{}</variable>",
                Self::point(&[*from])
            ));
        }
        outs.push_str("<variable formalParameter=\"OUT\"><connectionPointOut/></variable>");
        let inside = format!(
            "<inputVariables>{pins}</inputVariables><inOutVariables/><outputVariables>{outs}</outputVariables>"
        );
        self.element("block", &format!(" typeName=\"{name}\""), x, &inside)
    }

    /// A function whose result a variable takes.
    fn compute(&mut self, from: &[Wire]) {
        let name = self.dice.of(&["ADD", "SUB", "MOVE", "MAX", "SEL", "LIMIT"]);
        let mut inputs = vec![("IN1", self.number(200)), ("IN2", self.number(200))];
        match name {
            "MOVE" => inputs = vec![("IN", inputs[0].1)],
            "SEL" => {
                let tag = self.dice.of(INPUTS);
                inputs = vec![
                    ("G", self.value(tag, 200)),
                    ("IN0", inputs[0].1),
                    ("IN1", inputs[1].1),
                ];
            }
            "LIMIT" => {
                inputs = vec![
                    ("MN", self.value("-3", 200)),
                    ("IN", inputs[0].1),
                    ("MX", self.value("5", 200)),
                ];
            }
            _ => {}
        }
        let enable: Option<Vec<Wire>> = (self.dice.below(3) > 0).then(|| {
            let contact = self.contact(from, 150);
            vec![(contact, "")]
        });
        let id = self.function(name, enable.as_deref(), &inputs, 300);
        let mut result = (id, "OUT");
        if self.dice.below(4) == 0 {
            let one = self.value("1", 400);
            result = (
                self.function("ADD", None, &[("IN1", result), ("IN2", one)], 450),
                "OUT",
            );
        }
        let to = self.dice.of(&["n", "m", "k"]);
        self.output(result, to, 500);
        if enable.is_some() && self.dice.below(3) == 0 {
            self.y += 40;
            self.coil(&[(id, "ENO")], 500);
        }
    }
}
