//! What must come out of each project of the corpus: parts of the drawing, contacts, coils, blocks.

use super::graph::{Graph, Kind, Storage};
use super::model::{Body, Project};
use super::read;
use std::collections::HashSet;
use std::path::Path;

#[derive(Default)]
struct Counts {
    rungs: usize,
    contacts: usize,
    negated: usize,
    coils: usize,
    set: usize,
    reset: usize,
    inverse: usize,
    blocks: usize,
}

impl Counts {
    fn of(project: &Project) -> Counts {
        let mut counts = Counts::default();
        for unit in &project.units {
            for body in std::iter::once(&unit.body).chain(unit.parts.iter().map(|part| &part.body)) {
                if let Body::Graph(graph) = body {
                    counts.add(graph);
                }
            }
        }
        counts
    }

    fn add(&mut self, graph: &Graph) {
        let parts = graph.parts();
        let mut rungs = HashSet::new();
        for (node, part) in graph.nodes.iter().zip(parts) {
            if !matches!(
                node.kind,
                Kind::LeftRail | Kind::RightRail | Kind::Comment(_) | Kind::Label(_)
            ) {
                rungs.insert(part);
            }
            match &node.kind {
                Kind::Contact(_, modifier) => {
                    self.contacts += 1;
                    self.negated += usize::from(modifier.negated);
                }
                Kind::Coil(_, modifier, storage) => {
                    self.coils += 1;
                    self.inverse += usize::from(modifier.negated);
                    self.set += usize::from(*storage == Storage::Set);
                    self.reset += usize::from(*storage == Storage::Reset);
                }
                Kind::Block { .. } => self.blocks += 1,
                _ => {}
            }
        }
        self.rungs += rungs.len();
    }

    fn shown(&self) -> String {
        let some = |count: usize, letter: &str| match count {
            0 => String::new(),
            count => format!(" {count}{letter}"),
        };
        let Counts {
            rungs,
            contacts,
            negated,
            coils,
            set,
            reset,
            inverse,
            blocks,
        } = self;
        format!(
            "{rungs}/{contacts}{}/{coils}{}{}{} {blocks}",
            some(*negated, "n"),
            some(*set, "S"),
            some(*reset, "R"),
            some(*inverse, "N")
        )
    }
}

#[test]
fn counts_of_the_corpus() {
    let Some(corpus) = std::env::var_os("LADDER_CORPUS") else {
        eprintln!("skipped: LADDER_CORPUS names no folder of real programs");
        return;
    };
    let mut wrong = String::new();
    for (name, expected) in EXPECTED {
        let text = std::fs::read_to_string(Path::new(&corpus).join(name)).expect("the project can be read");
        let project = read::project(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
        let counts = Counts::of(&project).shown();
        if counts != *expected {
            wrong.push_str(&format!("{name}: {counts}, not {expected}\n"));
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// Rungs / contacts, of these negated / coils, of these set, reset, negated; blocks. Those of FBD count too, those between the steps of a chart do not.
const EXPECTED: &[(&str, &str)] = &[
    ("plcopen-xml/beremiz.first_steps.xml", "8/1/0 10"),
    ("plcopen-xml/beremiz.svghmi_basic.xml", "4/2 1n/2 1S 1R 7"),
    ("plcopen-xml/beremiz.traffic_light.xml", "4/2 1n/2 1S 1R 6"),
    (
        "plcopen-xml/controllino.stairs_light_control.xml",
        "2/7 2n/3 1S 1R 1",
    ),
    ("plcopen-xml/epaminondaslage.primeiroprograma.xml", "1/1/1 0"),
    ("plcopen-xml/felipeasg.arithmetic_1.xml", "1/0/0 2"),
    ("plcopen-xml/felipeasg.contact_seil.xml", "1/3/1 3"),
    ("plcopen-xml/gracesrm.aqua.xml", "70/198 44n/87 2S 2R 25"),
    ("plcopen-xml/gracesrm.esp8266celsius.xml", "1/0/0 1"),
    ("plcopen-xml/gracesrm.openswat.xml", "23/41 1n/23 16"),
    ("plcopen-xml/gracesrm.vc999v3.xml", "6/11 3n/7 5"),
    ("plcopen-xml/grfics.attack.xml", "39/0/0 56"),
    ("plcopen-xml/grfics.simplified_te.xml", "44/0/0 66"),
    ("plcopen-xml/hollysys.addition.xml", "2/1/0 1"),
    ("plcopen-xml/iec-checker.example.xml", "2/4 2n/1 3"),
    ("plcopen-xml/ours.multicoil-probe.xml", "3/4/6 2S 1R 1N 0"),
    ("plcopen-xml/virajdesai.and_nand.xml", "2/4 2n/2 0"),
    ("plcopen-xml/virajdesai.coil_contact.xml", "1/1/4 0"),
    ("plcopen-xml/virajdesai.no_nc.xml", "2/2 1n/2 0"),
    ("plcopen-xml/virajdesai.or_nor.xml", "3/5 3n/3 0"),
    ("plcopen-xml/virajdesai.xor_xnor.xml", "2/8 4n/2 0"),
    ("plcopen-xml/kato.practice01.xml", "3/3/3 0"),
    ("plcopen-xml/kato.practice02.xml", "1/1 1n/1 0"),
    ("plcopen-xml/kato.practice03.xml", "1/2 1n/1 0"),
    ("plcopen-xml/kato.practice04.xml", "1/2 2n/1 0"),
    ("plcopen-xml/kato.practice05.xml", "1/2/1 0"),
    ("plcopen-xml/kato.practice06.xml", "1/2 2n/1 0"),
    ("plcopen-xml/kato.practice07.xml", "1/3/1 0"),
    ("plcopen-xml/kato.practice10.xml", "1/3 1n/1 0"),
    ("plcopen-xml/kato.practice11.xml", "1/4 1n/1 0"),
    ("plcopen-xml/kato.practice14.xml", "3/8 2n/3 0"),
    ("plcopen-xml/kato.practice15.xml", "2/7 2n/2 0"),
    ("plcopen-xml/kato.session01.xml", "3/5 1n/3 0"),
    ("codesys/openplc-editor.codesys-execute.xml", "3/2/2 3"),
];
