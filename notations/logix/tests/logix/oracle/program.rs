//! Random programs as neutral text.

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

/// A program of two routines.
pub(super) struct Program {
    /// Name, type and value.
    pub(super) tags: Vec<(String, String, String)>,
    pub(super) main: Vec<String>,
    pub(super) sub: Vec<String>,
}

const BITS: &[&str] = &[
    "a", "b", "c", "x", "y", "z", "n.3", "t1.DN", "t2.TT", "c1.DN", "c1.CU", "k.EN",
];
const COILS: &[&str] = &["x", "y", "z", "n.3", "n.0"];
const NUMBERS: &[&str] = &["n", "m", "i", "t1.ACC", "c1.ACC", "arr[1]", "arr[3]"];
const TARGETS: &[&str] = &["n", "m", "i", "s", "arr[1]", "arr[2]"];

impl Program {
    pub(super) fn new(dice: &mut Dice) -> Program {
        let mut maker = Maker {
            dice,
            storages: 0,
            labels: 0,
        };
        let mut main = Vec::new();
        let count = 2 + maker.dice.below(5);
        for _ in 0..count {
            maker.some(&mut main);
        }
        let mut sub = vec!["SBR(p)XIC(a)OTE(x);".to_owned()];
        for _ in 0..=maker.dice.below(2) {
            sub.push(maker.rung());
        }
        sub.push(format!("{}RET(m);", maker.condition(1)));
        let tag = |name: &str, ty: &str, value: &str| (name.to_owned(), ty.to_owned(), value.to_owned());
        let mut tags = vec![
            tag("i", "INT", "7"),
            tag("n", "DINT", "5"),
            tag("m", "DINT", "-3"),
            tag("p", "DINT", ""),
            tag("s", "SINT", ""),
            tag("r", "REAL", "1.5"),
            tag("q", "REAL", ""),
            tag("arr", "DINT[6]", ""),
            tag("fifo", "DINT[4]", ""),
            tag("bits", "DINT[2]", ""),
            tag("steps", "DINT[4]", ""),
            tag("t1", "TIMER", ""),
            tag("t2", "TIMER", ""),
            tag("t3", "TIMER", ""),
            tag("c1", "COUNTER", ""),
            tag("k", "CONTROL", ""),
            tag("l", "CONTROL", ""),
            tag("h", "CONTROL", ""),
        ];
        for bit in ["a", "b", "c", "x", "y", "z"] {
            tags.push(tag(bit, "BOOL", ""));
        }
        for storage in 0..maker.storages {
            tags.push(tag(&format!("s{storage}"), "BOOL", ""));
        }
        Program { tags, main, sub }
    }
}

struct Maker<'d> {
    dice: &'d mut Dice,
    storages: usize,
    labels: usize,
}

impl Maker<'_> {
    /// A rung, or several that belong together.
    fn some(&mut self, out: &mut Vec<String>) {
        match self.dice.below(12) {
            0 => {
                out.push(format!("{}MCR();", self.condition(1)));
                for _ in 0..=self.dice.below(2) {
                    out.push(self.rung());
                }
                out.push("MCR();".to_owned());
            }
            1 => {
                let label = format!("L{}", self.labels);
                self.labels += 1;
                out.push(format!("{}JMP({label});", self.condition(1)));
                for _ in 0..=self.dice.below(2) {
                    out.push(self.rung());
                }
                out.push(format!("LBL({label}){}", self.rung()));
            }
            2 => out.push(format!("{}JSR(Sub,1,n,arr[0]);", self.condition(1))),
            3 if self.dice.below(4) == 0 => out.push(format!("{}TND();", self.condition(2))),
            _ => out.push(self.rung()),
        }
    }

    fn rung(&mut self) -> String {
        let mut out = self.condition(2);
        match self.dice.below(4) {
            0 => {
                let (one, other) = (self.leg(), self.leg());
                out.push_str(&format!("[{one},{other}]"));
            }
            1 => {
                out.push_str(&self.action());
                out.push_str(&self.condition(1));
                out.push_str(&self.action());
            }
            _ => out.push_str(&self.action()),
        }
        out.push(';');
        out
    }

    fn leg(&mut self) -> String {
        let condition = if self.dice.below(2) == 0 {
            self.condition(1)
        } else {
            String::new()
        };
        format!("{condition}{} ", self.action())
    }

    fn condition(&mut self, depth: usize) -> String {
        let mut out = String::new();
        for _ in 0..=self.dice.below(2) {
            if depth > 0 && self.dice.below(3) == 0 {
                let (one, other) = (self.condition(depth - 1), self.condition(depth - 1));
                out.push_str(&format!("[{one} ,{other} ]"));
            } else {
                out.push_str(&self.decides());
            }
        }
        out
    }

    fn storage(&mut self) -> String {
        self.storages += 1;
        format!("s{}", self.storages - 1)
    }

    fn number(&mut self) -> String {
        match self.dice.below(3) {
            0 => (self.dice.below(12) as i64 - 3).to_string(),
            _ => self.dice.of(NUMBERS).to_owned(),
        }
    }

    fn decides(&mut self) -> String {
        let (bit, one, other) = (self.dice.of(BITS), self.dice.of(NUMBERS), self.number());
        match self.dice.below(14) {
            0..=4 => format!("XIC({bit})"),
            5..=6 => format!("XIO({bit})"),
            7 => format!("ONS({})", self.storage()),
            8 => format!(
                "{}({one},{other})",
                self.dice.of(&["EQU", "NEQ", "LES", "LEQ", "GRT", "GEQ"])
            ),
            9 => format!("LIM({},{one},{other})", self.number()),
            10 => format!("MEQ({one},15,{other})"),
            11 => format!("CMP({one} + 2 > {other} * 3)"),
            12 => format!("XIC(n.[{}])", self.dice.below(5)),
            _ => "SQI(steps[0],255,n,h,?,?)".to_owned(),
        }
    }

    fn action(&mut self) -> String {
        let (coil, one, other, to) = (
            self.dice.of(COILS),
            self.number(),
            self.number(),
            self.dice.of(TARGETS),
        );
        match self.dice.below(30) {
            0..=3 => format!("OTE({coil})"),
            4 => format!("OTL({coil})"),
            5 => format!("OTU({coil})"),
            6 => format!("OSR({},{coil})", self.storage()),
            7 => format!("OSF({},{coil})", self.storage()),
            8 => "TON(t1,50,0)".to_owned(),
            9 => "TOF(t2,40,0)".to_owned(),
            10 => "RTO(t3,70,0)".to_owned(),
            11 => "CTU(c1,3,0)".to_owned(),
            12 => "CTD(c1,3,0)".to_owned(),
            13 => format!("RES({})", self.dice.of(&["t1", "t3", "c1", "k", "l"])),
            14 => format!("MOV({one},{to})"),
            15 => format!(
                "{}({one},{other},{to})",
                self.dice.of(&["ADD", "SUB", "MUL", "AND", "OR", "XOR"])
            ),
            16 => format!("DIV({one},{other},{to})"),
            17 => format!("MOD({one},{},{to})", 2 + self.dice.below(5)),
            18 => format!("{}({one},{to})", self.dice.of(&["NOT", "NEG"])),
            19 => format!("CPT({to},({one} + {other}) * 3 - n)"),
            20 => format!("MVM({one},240,{to})"),
            21 => format!(
                "BTD({one},{},{to},{},{})",
                self.dice.below(4),
                self.dice.below(6),
                1 + self.dice.below(4)
            ),
            22 => format!("CLR({to})"),
            23 => format!("COP(arr[0],arr[{}],2)", 2 + self.dice.below(4)),
            24 => format!("FLL({one},arr[2],3)").replace("FLL(i,", "FLL(n,"),
            25 => format!(
                "{}(bits[0],k,{},64)",
                self.dice.of(&["BSL", "BSR"]),
                self.dice.of(&["a", "x"])
            ),
            26 => format!("{}(n,fifo[0],l,4,0)", self.dice.of(&["FFL", "LFL"])),
            27 => format!("{}(fifo[0],arr[4],l,4,0)", self.dice.of(&["FFU", "LFU"])),
            28 => format!("{}(steps[0],{}h,3,0)", self.dice.of(&["SQO", "SQL"]), "n,"),
            _ => format!(
                "{}(r,{},q)",
                self.dice.of(&["ADD", "MUL", "SUB"]),
                self.dice.of(&["2", "0.5", "r", "n"])
            ),
        }
        .replace("SQO(steps[0],n,h", "SQO(steps[0],255,arr[5],h")
    }
}
