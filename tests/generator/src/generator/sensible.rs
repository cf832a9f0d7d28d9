//! Programs as a careful person writes them: every tag is declared and used, every output has one coil, nothing
//! contradicts itself.

use super::dice::Dice;
use super::drawing::{Item, Network, Pen};
use std::fmt::Write;

/// Makes a program.
pub(super) fn program(dice: &mut Dice) -> String {
    let mut writer = Writer {
        pen: Pen {
            longest: 1 + dice.below(6),
            line_end: "\n",
            decorated: false,
            aligned: true,
        },
        definition: String::new(),
        sections: Default::default(),
        networks: String::new(),
        functions: String::new(),
        count: 0,
        labels: 0,
    };
    if dice.one_in(2) {
        writer.begin_definition(dice);
    }
    let tasks = 1 + dice.below(6);
    for _ in 0..tasks {
        writer.task(dice);
    }
    if dice.one_in(3) {
        writer.function(dice);
    }
    writer.text()
}

struct Writer {
    pen: Pen,
    definition: String,
    /// Declarations, section by section.
    sections: [String; 5],
    networks: String,
    functions: String,
    count: usize,
    labels: usize,
}

const INPUT: usize = 0;
const OUTPUT: usize = 1;
const INTERNAL: usize = 2;
const RETAIN: usize = 3;
const CONSTANT: usize = 4;

const HEADERS: [&str; 5] = ["VAR_INPUT", "VAR_OUTPUT", "VAR", "VAR RETAIN", "VAR CONSTANT"];
const INPUTS: [&str; 6] = ["button", "switch", "sensor", "key", "gate", "limit"];
const OUTPUTS: [&str; 5] = ["lamp", "motor", "valve", "horn", "pump"];

impl Writer {
    /// A new tag.
    fn tag(&mut self, section: usize, stem: &str, ty: &str) -> String {
        self.count += 1;
        let name = format!("{stem}_{}", self.count);
        // Writing to a String does not fail.
        let _ = writeln!(self.sections[section], "    {name} : {ty};");
        name
    }

    fn input(&mut self, dice: &mut Dice) -> String {
        let stem = dice.of(&INPUTS);
        self.tag(INPUT, stem, "BOOL")
    }

    fn coil(&mut self, dice: &mut Dice) -> String {
        let stem = dice.of(&OUTPUTS);
        let name = self.tag(OUTPUT, stem, "BOOL");
        format!("{}( {name} )", dice.of(&["( )", "( )", "(/)"]))
    }

    fn comment(&mut self, words: &str) {
        let _ = writeln!(self.networks, "\n# {words} #");
    }

    /// Draws what is between the rails.
    fn draw(&mut self, dice: &mut Dice, conditions: &[Condition], acts: &[String]) {
        let mut network: Network = vec![vec![Item::Rail]];
        sketch(conditions, &mut network, 0);
        network[0].extend(acts.iter().cloned().map(Item::Block));
        network[0].push(Item::Rail);
        self.pen.draw(dice, &network, &mut self.networks);
    }

    /// Contacts in series, with branches, each on a tag of its own.
    fn conditions(&mut self, dice: &mut Dice, depth: usize) -> Vec<Condition> {
        let count = 1 + dice.below(3);
        (0..count)
            .map(|_| {
                if depth == 0 || !dice.one_in(3) {
                    let name = self.input(dice);
                    return Condition::Contact(format!("{}( {name} )", dice.of(&["[ ]", "[ ]", "[/]"])));
                }
                let upper = self.conditions(dice, 0);
                let lower = self.conditions(dice, depth - 1);
                Condition::Branches(upper, lower)
            })
            .collect()
    }

    /// One thing that the program does.
    fn task(&mut self, dice: &mut Dice) {
        match dice.below(11) {
            0 => self.start_and_stop(dice),
            1 => self.delay(dice),
            2 => self.count_parts(dice),
            3 => self.latch(dice),
            4 => self.compare(dice),
            5 => self.compute(dice),
            6 => self.skip(dice),
            7 => self.shift(dice),
            8 => self.total(dice),
            9 if !self.definition.is_empty() => self.use_definition(dice),
            _ => {
                let conditions = self.conditions(dice, 3);
                let coil = self.coil(dice);
                self.draw(dice, &conditions, &[coil]);
            }
        }
        self.networks.push('\n');
    }

    fn start_and_stop(&mut self, dice: &mut Dice) {
        self.comment("Start and stop");
        let (start, stop) = (self.input(dice), self.input(dice));
        let run = self.tag(OUTPUT, "run", "BOOL");
        let contact = |kind: &str, name: &str| Condition::Contact(format!("{kind}( {name} )"));
        let conditions = [
            Condition::Branches(vec![contact("[ ]", &start)], vec![contact("[ ]", &run)]),
            contact("[/]", &stop),
        ];
        self.draw(dice, &conditions, &[format!("( )( {run} )")]);
    }

    fn delay(&mut self, dice: &mut Dice) {
        self.comment("A delay");
        let kind = dice.of(&["TON", "TOF", "TP", "RTO", "RTOF"]);
        let timer = self.tag(INTERNAL, "timer", kind);
        let conditions = self.conditions(dice, 1);
        let preset = dice.of(&["T#30ms", "50ms", "T#0.1s"]);
        let reset = match kind {
            "RTO" | "RTOF" => format!(", R := {}", self.input(dice)),
            _ => String::new(),
        };
        let coil = self.coil(dice);
        self.draw(
            dice,
            &conditions,
            &[format!("[{kind}]( {timer}, {preset}{reset} )"), coil],
        );
    }

    fn count_parts(&mut self, dice: &mut Dice) {
        let (part, reset) = (self.input(dice), self.input(dice));
        let counter = self.tag(INTERNAL, "counter", "CTU");
        let coil = self.coil(dice);
        let most = 1 + dice.below(4);
        let part = Condition::Contact(format!("[ ]( {part} )"));
        self.draw(
            dice,
            &[part],
            &[format!("[CTU]( {counter}, {most}, R := {reset} )"), coil],
        );
    }

    fn latch(&mut self, dice: &mut Dice) {
        let bit = self.tag(INTERNAL, "latched", "BOOL");
        for kind in ["(S)", "(R)"] {
            let conditions = self.conditions(dice, 1);
            self.draw(dice, &conditions, &[format!("{kind}( {bit} )")]);
        }
        let coil = self.coil(dice);
        let name = self.input(dice);
        let conditions = [
            Condition::Contact(format!("[ ]( {bit} )")),
            Condition::Contact(format!("[/]( {name} )")),
        ];
        self.draw(dice, &conditions, &[coil]);
    }

    fn compare(&mut self, dice: &mut Dice) {
        let (ty, bound) = dice.of(&[("INT", "3"), ("DINT", "-1"), ("REAL", "2.5"), ("TIME", "T#20ms")]);
        let value = self.tag(INPUT, "value", ty);
        let limit = self.tag(CONSTANT, "LIMIT", &format!("{ty} := {bound}"));
        let operator = dice.of(&["GT", "GE", "LT", "LE"]);
        let conditions = [Condition::Contact(format!("[{operator}]( {value}, {limit} )"))];
        let coil = self.coil(dice);
        self.draw(dice, &conditions, &[coil]);
    }

    fn compute(&mut self, dice: &mut Dice) {
        let (a, b) = (self.tag(INPUT, "level", "INT"), self.tag(INPUT, "offset", "INT"));
        let result = self.tag(INTERNAL, "result", "DINT");
        let block = match dice.below(4) {
            0 => format!("[ADD]( {result}, {a}, {b}, 7 )"),
            1 => format!("[MUL]( {result}, {a}, {b} )"),
            2 => format!("[LIMIT]( {result}, -5, {a}, {b} )"),
            _ => format!("[CALC]( {result}, ({a} + 2) * {b} - 1 )"),
        };
        self.draw(dice, &[], &[block]);
        let conditions = [Condition::Contact(format!("[GE]( {result}, 4 )"))];
        let coil = self.coil(dice);
        self.draw(dice, &conditions, &[coil]);
    }

    fn skip(&mut self, dice: &mut Dice) {
        self.labels += 1;
        let label = format!("after_{}", self.labels);
        let conditions = self.conditions(dice, 1);
        self.draw(dice, &conditions, &[format!("<JMP>( {label} )")]);
        let conditions = self.conditions(dice, 2);
        let coil = self.coil(dice);
        self.draw(dice, &conditions, &[coil]);
        let mut conditions = vec![Condition::Contact(format!("<LBL>( {label} )"))];
        conditions.extend(self.conditions(dice, 1));
        let coil = self.coil(dice);
        self.draw(dice, &conditions, &[coil]);
    }

    fn shift(&mut self, dice: &mut Dice) {
        self.comment("A belt");
        let belt = self.tag(INTERNAL, "belt", "ARRAY[1..5] OF BOOL");
        let (step, part) = (self.input(dice), self.input(dice));
        let step = Condition::Contact(format!("[ ]( {step} )"));
        self.draw(dice, &[step], &[format!("[SHIFT]( {belt}[1..5], {part} )")]);
        let conditions = [Condition::Contact(format!("[ ]( {belt}[5] )"))];
        let coil = self.coil(dice);
        self.draw(dice, &conditions, &[coil]);
    }

    fn total(&mut self, dice: &mut Dice) {
        let total = self.tag(RETAIN, "total", "DINT");
        let part = self.input(dice);
        let part = Condition::Contact(format!("[P]( {part} )"));
        self.draw(dice, &[part], &[format!("[ADD]( {total}, {total}, 1 )")]);
        let conditions = [Condition::Contact(format!("[GT]( {total}, 3 )"))];
        let coil = self.coil(dice);
        self.draw(dice, &conditions, &[coil]);
    }

    /// A block that a program can use.
    fn begin_definition(&mut self, dice: &mut Dice) {
        let wait = dice.of(&["T#20ms", "30ms"]);
        let kind = dice.of(&["TON", "TOF", "TP"]);
        self.definition = format!(
            "FUNCTION_BLOCK [$Steady]\nVAR_INPUT\n    raw : BOOL;\n    wait : TIME := {wait};\nEND_VAR\n\
             VAR_OUTPUT\n    clean : BOOL;\nEND_VAR\nVAR\n    delay : {kind};\nEND_VAR\n\n\
             +--[ ]( EN )--[ ]( raw )--[{kind}]( delay, wait )--( )( clean )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\n"
        );
    }

    fn use_definition(&mut self, dice: &mut Dice) {
        let raw = self.input(dice);
        let clean = self.tag(OUTPUT, "clean", "BOOL");
        let coil = self.coil(dice);
        let conditions = self.conditions(dice, 1);
        let call = if dice.one_in(2) {
            format!("[$Steady]( {raw}, T#10ms, {clean} )")
        } else {
            format!("[$Steady]( raw := {raw}, clean => {clean} )")
        };
        self.draw(dice, &conditions, &[call, coil]);
    }

    /// A function with some tasks, at the end of the file.
    fn function(&mut self, dice: &mut Dice) {
        let conditions = self.conditions(dice, 1);
        self.draw(dice, &conditions, &["<CALL>( part )".to_owned()]);
        let main = std::mem::take(&mut self.networks);
        let mut first = vec![Condition::Contact("<FUN>( part )".to_owned())];
        first.extend(self.conditions(dice, 1));
        let coil = self.coil(dice);
        self.draw(dice, &first, &[coil]);
        for _ in 0..dice.below(3) {
            self.task(dice);
        }
        self.functions = std::mem::replace(&mut self.networks, main);
    }

    fn text(self) -> String {
        let mut text = self.definition;
        for (header, tags) in HEADERS.iter().zip(&self.sections) {
            if !tags.is_empty() {
                let _ = writeln!(text, "{header}\n{tags}END_VAR\n");
            }
        }
        text + &self.networks + "\n" + &self.functions
    }
}

/// What power must pass.
enum Condition {
    Contact(String),
    /// One above the other; what is above is on one line.
    Branches(Vec<Condition>, Vec<Condition>),
}

/// Draws conditions in series onto a rung, and what hangs below it onto those below.
fn sketch(conditions: &[Condition], network: &mut Network, rung: usize) {
    for condition in conditions {
        match condition {
            Condition::Contact(words) => network[rung].push(Item::Block(words.clone())),
            Condition::Branches(upper, lower) => {
                if network.len() == rung + 1 {
                    network.push(Vec::new());
                } else {
                    network[rung + 1].push(Item::Gap);
                }
                network[rung].push(Item::Down);
                network[rung + 1].push(Item::Up);
                sketch(upper, network, rung);
                sketch(lower, network, rung + 1);
                network[rung].push(Item::Down);
                network[rung + 1].push(Item::Up);
            }
        }
    }
}
