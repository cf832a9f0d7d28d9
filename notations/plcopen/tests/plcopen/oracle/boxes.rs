//! Random function block diagrams, whose wires may come back to where they began.

use super::drawing::Dice;

/// What a block needs and makes: its name, whether it has an instance, its inputs and outputs. `B` is power, `N` a number.
struct Kind {
    name: &'static str,
    has_state: bool,
    inputs: &'static [(&'static str, char)],
    output: (&'static str, char),
}

const fn kind(
    name: &'static str,
    has_state: bool,
    inputs: &'static [(&'static str, char)],
    output: (&'static str, char),
) -> Kind {
    Kind {
        name,
        has_state,
        inputs,
        output,
    }
}

const KINDS: &[Kind] = &[
    kind("TON", true, &[("IN", 'B'), ("PT", 'T')], ("Q", 'B')),
    kind("TON", true, &[("IN", 'B'), ("PT", 'T')], ("Q", 'B')),
    kind("TOF", true, &[("IN", 'B'), ("PT", 'T')], ("Q", 'B')),
    kind("SR", true, &[("S1", 'B'), ("R", 'B')], ("Q1", 'B')),
    kind("R_TRIG", true, &[("CLK", 'B')], ("Q", 'B')),
    kind("AND", false, &[("IN1", 'B'), ("IN2", 'B')], ("OUT", 'B')),
    kind("OR", false, &[("IN1", 'B'), ("IN2", 'B')], ("OUT", 'B')),
    kind("NOT", false, &[("IN", 'B')], ("OUT", 'B')),
    kind("GT", false, &[("IN1", 'N'), ("IN2", 'N')], ("OUT", 'B')),
    kind("ADD", false, &[("IN1", 'N'), ("IN2", 'N')], ("OUT", 'N')),
    kind("SUB", false, &[("IN1", 'N'), ("IN2", 'N')], ("OUT", 'N')),
    kind(
        "SEL",
        false,
        &[("G", 'B'), ("IN0", 'N'), ("IN1", 'N')],
        ("OUT", 'N'),
    ),
];

/// An element that others are wired to: its number, the name of an output, and what that is.
type Source = (usize, &'static str, char);

struct Editor<'d> {
    dice: &'d mut Dice,
    body: String,
    count: usize,
    places: usize,
    sources: Vec<Source>,
}

/// A project with one program.
pub(super) fn project(dice: &mut Dice, has_loops: bool) -> String {
    let mut editor = Editor {
        dice,
        body: String::new(),
        count: 0,
        places: 0,
        sources: Vec::new(),
    };
    let blocks: Vec<&Kind> = (0..2 + editor.dice.below(5))
        .map(|_| &KINDS[editor.dice.below(KINDS.len())])
        .collect();
    let shown: Vec<bool> = blocks.iter().map(|_| editor.dice.below(3) == 0).collect();
    let all: Vec<Source> = blocks
        .iter()
        .zip(&shown)
        .enumerate()
        .flat_map(|(number, (block, has_enable))| {
            let out = (number + 1, block.output.0, block.output.1);
            [Some(out), has_enable.then_some((number + 1, "ENO", 'B'))]
        })
        .flatten()
        .collect();
    if has_loops {
        editor.sources.clone_from(&all);
    }
    editor.count = 100;
    let mut instances = String::new();
    for (number, block) in blocks.iter().enumerate() {
        let own = format!("it{number}");
        if block.has_state {
            instances.push_str(&format!("{own} : {}\n", block.name));
        }
        editor.block(number + 1, block, &own, shown[number]);
        if !has_loops {
            let made = all.iter().filter(|(id, ..)| *id == number + 1);
            editor.sources.extend(made);
        }
    }
    for _ in 0..=editor.dice.below(4) {
        editor.output();
    }
    let variables = "a : BOOL\nb : BOOL\nc : BOOL\nu : BOOL\nv : BOOL\nw : BOOL\nn : INT\nm : INT\nk : INT\n";
    let unit = crate::harness::unit(
        "program",
        "Main",
        &format!("{variables}{instances}"),
        &format!("<FBD>{}</FBD>", editor.body),
    );
    crate::harness::project("", &unit, "")
}

impl Editor<'_> {
    /// No two elements have the same.
    fn place(&mut self) -> String {
        self.places += 1;
        let (x, y) = (100 * self.dice.below(12) + self.places, 20 * self.dice.below(8));
        format!("<position x=\"{x}\" y=\"{y}\"/>")
    }

    fn value(&mut self, text: &str) -> (usize, &'static str) {
        self.count += 1;
        let place = self.place();
        self.body.push_str(&format!(
            "<inVariable localId=\"{}\">{place}<connectionPointOut/><expression>{text}</expression></inVariable>\n",
            self.count
        ));
        (self.count, "")
    }

    fn source(&mut self, ty: char, depth: usize) -> (usize, &'static str) {
        if ty == 'T' {
            let time = ["T#100ms", "T#300ms"][self.dice.below(2)];
            return self.value(time);
        }
        let fit: Vec<Source> = self
            .sources
            .iter()
            .filter(|(.., of)| *of == ty)
            .copied()
            .collect();
        if !fit.is_empty() && self.dice.below(5) < 3 {
            let (id, output, _) = fit[self.dice.below(fit.len())];
            if ty == 'B' && depth < 2 && self.dice.below(4) == 0 {
                return self.contact((id, output));
            }
            return (id, output);
        }
        let tags = if ty == 'B' {
            ["a", "b", "c", "a", "u", "v", "w"]
        } else {
            ["n", "m", "k", "1", "2", "-3", "n"]
        };
        let tag = tags[self.dice.below(tags.len())];
        self.value(tag)
    }

    fn contact(&mut self, from: (usize, &'static str)) -> (usize, &'static str) {
        self.count += 1;
        let id = self.count;
        let place = self.place();
        let tag = ["a", "b", "u", "v"][self.dice.below(4)];
        self.body.push_str(&format!(
            "<contact localId=\"{id}\">{place}{}<connectionPointOut/><variable>{tag}</variable></contact>\n",
            point(from)
        ));
        self.sources.push((id, "", 'B'));
        (id, "")
    }

    fn block(&mut self, id: usize, kind: &Kind, instance: &str, has_enable: bool) {
        let mut pins = String::new();
        let mut outs = String::new();
        if has_enable {
            // A timer that stands still is another one here.
            let wired = !kind.has_state && self.dice.below(2) == 0;
            let from = if wired {
                point(self.source('B', 0))
            } else {
                "<connectionPointIn/>".to_owned()
            };
            pins.push_str(&format!("<variable formalParameter=\"EN\">{from}</variable>"));
            outs.push_str("<variable formalParameter=\"ENO\"><connectionPointOut/></variable>");
        }
        for (number, (pin, ty)) in kind.inputs.iter().enumerate() {
            let negated = *ty == 'B' && self.dice.below(6) == 0;
            // The type of what is made of itself alone is not known.
            let from = if *ty == 'N' && number + 1 == kind.inputs.len() {
                self.value(["n", "m", "k"][number % 3])
            } else {
                self.source(*ty, 0)
            };
            pins.push_str(&format!(
                "<variable formalParameter=\"{pin}\" negated=\"{negated}\">{}</variable>",
                point(from)
            ));
        }
        outs.push_str(&format!(
            "<variable formalParameter=\"{}\"><connectionPointOut/></variable>",
            kind.output.0
        ));
        let named = if kind.has_state {
            format!(" instanceName=\"{instance}\"")
        } else {
            String::new()
        };
        let place = self.place();
        self.body.push_str(&format!(
            "<block localId=\"{id}\" typeName=\"{}\"{named}>{place}<inputVariables>{pins}</inputVariables><inOutVariables/><outputVariables>{outs}</outputVariables></block>\n",
            kind.name
        ));
    }

    fn output(&mut self) {
        let ty = if self.dice.below(2) == 0 { 'B' } else { 'N' };
        let from = self.source(ty, 2);
        let tag = match (ty, self.dice.below(6)) {
            // Nobody filled it in.
            (_, 0) if from.0 < 100 => " ",
            ('B', tag) => ["u", "v", "w"][tag % 3],
            (_, tag) => ["n", "m", "k"][tag % 3],
        };
        self.count += 1;
        let place = self.place();
        self.body.push_str(&format!(
            "<outVariable localId=\"{}\">{place}{}<expression>{tag}</expression></outVariable>\n",
            self.count,
            point(from)
        ));
    }
}

fn point((id, output): (usize, &str)) -> String {
    let named = match output {
        "" => String::new(),
        output => format!(" formalParameter=\"{output}\""),
    };
    format!("<connectionPointIn><connection refLocalId=\"{id}\"{named}/></connectionPointIn>")
}
