//! Generated programs to each notation and back: nothing is remarked on, the networks are the same, and they do the same
//! in every scan under the profile of the notation.

use ladder_analysis::analyze;
use ladder_format::program::{
    Declaration, Drawing, Element, Item, Network, ProgramSketch, Section, SectionKind,
};
use ladder_format::{Circuit, Options};
use ladder_interchange::notation::{Notation, Source, by_name, convert};
use ladder_invariants::generator::Dice;
use ladder_invariants::trace::{Stimulus, beside};
use ladder_syntax::parse;
use std::sync::Arc;

/// What a notation can say.
struct Says {
    notation: &'static str,
    /// A directive such as `profile ldmicro`.
    profile: Option<&'static str>,
    inputs: &'static [&'static str],
    outputs: &'static [&'static str],
    /// Other tags, each with its type.
    others: &'static [(&'static str, &'static str)],
    /// Blocks that decide; `{}` is a bit that is read, `{n}` a number, `{#}` a number of the generator's own.
    conditions: &'static [&'static str],
    /// Blocks that stand last; `{y}` is a bit that is written, `{m}` a number.
    actions: &'static [&'static str],
    /// Blocks with a tag of their own: its letter, its type, the block.
    states: &'static [(&'static str, &'static str, &'static str)],
    /// Bits that are read and written.
    bits: &'static [&'static str],
    numbers: &'static [&'static str],
    /// Blocks that are there in every program: LDmicro complains of variables that nothing gives a value.
    always: &'static [&'static str],
}

const LDMICRO: Says = Says {
    notation: "ldmicro",
    profile: Some("profile ldmicro"),
    inputs: &["Xa", "Xb", "Xc"],
    outputs: &["Ya", "Yb"],
    others: &[("Ra", "BOOL"), ("Rb", "BOOL"), ("m", "INT"), ("n", "INT")],
    conditions: &[
        "[ ]( {} )",
        "[/]( {} )",
        "[ ]( {} )",
        "[OSR]",
        "[OSF]",
        "[EQ]( {n}, {#} )",
        "[GE]( {n}, {n} )",
        "[NE]( {#}, {n} )",
        "[LT]( {n}, {#} )",
        "[ ]( SYS.ON )",
        "[ ]( SYS.OFF )",
    ],
    actions: &[
        "( )( {y} )",
        "(/)( {y} )",
        "(S)( {y} )",
        "(R)( {y} )",
        "[MOV]( {m}, {#} )",
        "[ADD]( {m}, {n}, {#} )",
        "[SUB]( {m}, {n}, {n} )",
        "[MUL]( {m}, {n}, {#} )",
        "[DIV]( {m}, {n}, 3 )",
        "<MCR>",
    ],
    states: &[
        ("T", "TON", "[TON]( {t}, T#{#}0ms )"),
        ("T", "TOF", "[TOF]( {t}, T#{#}0ms )"),
        ("T", "RTO", "[RTO]( {t}, T#{#}0ms )"),
        ("C", "CTU", "[CTU]( {t}, {#} )"),
        ("C", "CTD", "[CTD]( {t}, {#} )"),
    ],
    bits: &["Xa", "Xb", "Xc", "Ya", "Yb", "Ra", "Rb"],
    numbers: &["m", "n"],
    always: &["[MOV]( m, 3 )", "[MOV]( n, 5 )"],
};

const LDMICRO_TEXT: Says = Says {
    notation: "ldmicro-text",
    ..LDMICRO
};

const IOT: Says = Says {
    notation: "iot",
    profile: Some("profile iot"),
    inputs: &["I1", "I2", "I3"],
    outputs: &["Q1", "Q2"],
    others: &[
        ("MI01", "DINT"),
        ("MI02", "DINT"),
        ("MF01", "REAL"),
        ("C9", "CTU"),
    ],
    conditions: &[
        "[ ]( {} )",
        "[/]( {} )",
        "[ ]( {n} )",
        "[EQ]( {n}, {#} )",
        "[GE]( {n}, {n} )",
        "[NE]( {n}, {#} )",
        "[GT]( MF01, 1.5 )",
        "[LE]( C9.AC, {#} )",
        "[ ]( C9.DN )",
        "( )( {y} )",
        "[MOV]( {m}, {#} )",
    ],
    actions: &[
        "( )( {y} )",
        "(/)( {y} )",
        "(S)( {y} )",
        "(R)( {y} )",
        "(M)( {y} )",
        "[MOV]( {m}, {#} )",
        "[ADD]( {m}, {n}, {#} )",
        "[SUB]( {m}, {n}, I2 )",
        "[MUL]( MF01, {n}, 2.5 )",
        "[DIV]( {m}, {n}, 3 )",
        "[AND]( {m}, {n}, {#} )",
        "[XOR]( {m}, {n}, I1 )",
        "[OR]( {y}, I1, I3 )",
        "[ADD]( {m}, MF01, 0.5 )",
        "(RES)( C9 )",
        "[NOT]( {m}, {n} )",
    ],
    states: &[
        ("T", "TON", "[TON]( {t}, {#}, B := T#10ms )"),
        ("T", "TOF", "[TOF]( {t}, {#}, B := T#20ms )"),
        ("C", "CTU", "[CTU]( {t}, {#} )"),
        ("C", "CTD", "[CTD]( {t}, {#}, AC := 9 )"),
    ],
    bits: &["I1", "I2", "I3", "Q1", "Q2"],
    numbers: &["MI01", "MI02"],
    always: &[],
};

const TEXTBOOK: Says = Says {
    notation: "textbook",
    profile: None,
    inputs: &["I0", "I1", "I2"],
    outputs: &["Q0", "Q1"],
    others: &[("M0", "BOOL"), ("M1", "BOOL")],
    conditions: &["[ ]( {} )", "[/]( {} )"],
    actions: &["( )( {y} )", "(/)( {y} )"],
    states: &[],
    bits: &["I0", "I1", "I2", "M0", "M1"],
    numbers: &[],
    always: &[],
};

const CPLC_DRAFT: Says = Says {
    notation: "cplc-draft",
    profile: None,
    inputs: &["start", "stop", "level"],
    outputs: &["run", "lamp"],
    others: &[("held", "BOOL"), ("n", "DINT")],
    conditions: &[
        "[ ]( {} )",
        "[/]( {} )",
        "[OSR]",
        "[OSF]",
        "[EQ]( {n}, {#} )",
        "[GE]( {n}, {#} )",
        "[LT]( {#}, {n} )",
    ],
    actions: &[
        "( )( {y} )",
        "(S)( {y} )",
        "(R)( {y} )",
        "[ADD]( {n}, {n}, {#} )",
        "[SUB]( {n}, {n}, {#} )",
    ],
    states: &[
        ("t", "TON", "[TON]( {t}, {#}0 )"),
        ("c", "CTU", "[CTU]( {t}, {#} )"),
    ],
    bits: &["start", "stop", "level", "run", "lamp", "held"],
    numbers: &["n"],
    always: &[],
};

impl Says {
    fn program(&self, dice: &mut Dice) -> String {
        let mut maker = Maker {
            says: self,
            states: Vec::new(),
            elements: 0,
        };
        let mut networks = Vec::new();
        for _ in 0..=dice.below(6) {
            networks.push(Item::Blank);
            // What stands above the first network may be said of the whole program.
            let comments = if networks.len() > 1 && dice.one_in(4) {
                vec!["What this one does".to_owned()]
            } else {
                Vec::new()
            };
            maker.elements = 0;
            let drawing = Drawing::Circuit(maker.rung(dice));
            networks.push(Item::Network(Network { comments, drawing }));
        }
        for pattern in self.always {
            let parts = vec![maker.block(dice, self.conditions[0]), maker.block(dice, pattern)];
            networks.extend([
                Item::Blank,
                Item::Network(Network {
                    comments: Vec::new(),
                    drawing: Drawing::Circuit(Circuit::Series(parts)),
                }),
            ]);
        }
        let section = |kind, tags: Vec<(String, String)>| {
            let mut section = Section::new(kind);
            section.declarations = tags
                .into_iter()
                .map(|(name, ty)| Declaration::new(name, ty))
                .collect();
            Item::Section(section)
        };
        let bits = |names: &[&str]| {
            names
                .iter()
                .map(|name| (name.to_string(), "BOOL".to_owned()))
                .collect()
        };
        let others = self
            .others
            .iter()
            .map(|(name, ty)| (name.to_string(), ty.to_string()));
        let mut items: Vec<Item> = Vec::new();
        items.extend(self.profile.map(|profile| Item::Directive(profile.to_owned())));
        items.extend([
            section(SectionKind::VarInput, bits(self.inputs)),
            section(SectionKind::VarOutput, bits(self.outputs)),
            section(SectionKind::Var, others.chain(maker.states).collect()),
        ]);
        items.extend(networks);
        ProgramSketch { items }.write(&Options::default()).text
    }
}

struct Maker<'s> {
    says: &'s Says,
    states: Vec<(String, String)>,
    /// Of this rung: wide ones are refused by some.
    elements: usize,
}

impl Maker<'_> {
    fn rung(&mut self, dice: &mut Dice) -> Circuit<Element> {
        // It begins with a contact, as the textbook wants it.
        let mut parts = vec![self.block(dice, self.says.conditions[0])];
        for _ in 0..dice.below(3) {
            parts.push(self.condition(dice, 2));
        }
        if !self.says.states.is_empty() && dice.one_in(3) {
            parts.push(self.state(dice));
        }
        let mut ends = Vec::new();
        for _ in 0..=dice.below(2) {
            let end = dice.of(self.says.actions);
            let end = self.block(dice, end);
            ends.push(if dice.one_in(3) {
                Circuit::Series(vec![self.condition(dice, 0), end])
            } else {
                end
            });
        }
        parts.push(match ends.len() {
            1 => ends.remove(0),
            _ => Circuit::Parallel(ends),
        });
        flat(parts)
    }

    fn condition(&mut self, dice: &mut Dice, depth: usize) -> Circuit<Element> {
        if depth == 0 || self.elements > 8 || dice.one_in(2) {
            let block = dice.of(self.says.conditions);
            return self.block(dice, block);
        }
        let mut branches = Vec::new();
        for _ in 0..2 + dice.below(2) {
            let mut parts = vec![self.block(dice, self.says.conditions[0])];
            for _ in 0..dice.below(2) {
                parts.push(self.condition(dice, depth - 1));
            }
            branches.push(flat(parts));
        }
        Circuit::Parallel(branches)
    }

    fn block(&mut self, dice: &mut Dice, pattern: &str) -> Circuit<Element> {
        self.elements += 1;
        let says = self.says;
        let mut out = String::new();
        let mut rest = pattern;
        while let Some(at) = rest.find('{') {
            out.push_str(&rest[..at]);
            let end = rest.find('}').unwrap_or(rest.len() - 1);
            let written: Vec<&str> = says
                .bits
                .iter()
                .copied()
                .filter(|bit| !says.inputs.contains(bit))
                .collect();
            match &rest[at + 1..end] {
                "" => out.push_str(dice.of(says.bits)),
                "y" if written.is_empty() || dice.one_in(2) => out.push_str(dice.of(says.outputs)),
                "y" => out.push_str(dice.of(&written)),
                "n" | "m" => out.push_str(dice.of(says.numbers)),
                _ => out.push_str(&dice.between(2, 9).to_string()),
            }
            rest = &rest[end + 1..];
        }
        out.push_str(rest);
        Circuit::Element(Element::block(out, None))
    }

    fn state(&mut self, dice: &mut Dice) -> Circuit<Element> {
        let (letter, ty, pattern) = dice.of(self.says.states);
        let name = format!("{letter}{}", self.states.len() + 1);
        self.states.push((name.clone(), ty.to_owned()));
        let pattern = pattern.replace("{t}", &name);
        self.block(dice, &pattern)
    }
}

/// Parts in series, with what stands in series among them.
fn flat(parts: Vec<Circuit<Element>>) -> Circuit<Element> {
    let mut out = Vec::new();
    for part in parts {
        match part {
            Circuit::Series(inside) => out.extend(inside),
            other => out.push(other),
        }
    }
    match out.len() {
        1 => out.remove(0),
        _ => Circuit::Series(out),
    }
}

/// The networks of a text, without its declarations.
fn networks(text: &str) -> String {
    let start = text.rfind("END_VAR").unwrap_or(0);
    let words = |line: &str| {
        let words: Vec<&str> = line.split('-').filter(|word| !word.is_empty()).collect();
        words.join("-").trim_end_matches([' ', '|', '+']).to_owned()
    };
    text[start..].lines().map(words).collect::<Vec<_>>().join("\n")
}

fn check(says: &Says) {
    let notation: &dyn Notation = by_name(says.notation).expect("the notation is registered");
    for seed in 0..60 {
        let mut dice = Dice::new(seed);
        let text = says.program(&mut dice);
        let analysis = analyze(&Arc::new(parse(&text)), "test.clad");
        let errors: Vec<&str> = analysis.errors().map(|error| error.message.as_str()).collect();
        assert!(errors.is_empty(), "{errors:?}\n{text}");
        let writing = notation
            .write(&analysis)
            .unwrap_or_else(|error| panic!("{error}\n{text}"));
        let remarks: Vec<_> = writing.report.remarks().collect();
        assert!(remarks.is_empty(), "{remarks:?}\n{text}");
        let shown = String::from_utf8_lossy(&writing.bytes);
        assert!(notation.recognises(&writing.bytes), "{shown}");
        let source = Source::alone("test", &writing.bytes);
        let back = convert(notation, &source, &Options::default());
        let back = back.unwrap_or_else(|error| panic!("{error}\n{shown}\nof\n{text}"));
        let remarks: Vec<_> = back.report.remarks().collect();
        assert!(
            remarks.is_empty() && back.findings.is_empty(),
            "{remarks:?} {:?}\n{shown}",
            back.findings
        );
        let ladder = back.written.text;
        assert_eq!(networks(&ladder), networks(&text), "{shown}");
        let different = beside(&ladder, &text, Stimulus { seed, scans: 60 });
        assert_eq!(different, None, "{ladder}\nof\n{shown}\nof\n{text}");
    }
}

#[test]
fn ldmicro() {
    check(&LDMICRO);
}

#[test]
fn ldmicro_text() {
    check(&LDMICRO_TEXT);
}

#[test]
fn iot() {
    check(&IOT);
}

#[test]
fn textbook() {
    check(&TEXTBOOK);
}

#[test]
fn cplc_draft() {
    check(&CPLC_DRAFT);
}
