//! How fast programs of other systems become ladder text, in bytes of the foreign file a second, next to how fast its
//! lines can be read at all; and how fast ladder text becomes a program of theirs, next to how fast it is analysed.

use divan::Bencher;
use divan::counter::BytesCount;
use ladder_analysis::analyze;
use ladder_format::Options;
use ladder_notations::{Source, by_name, convert};
use ladder_syntax::parse;
use std::sync::Arc;

fn main() {
    divan::main();
}

const RUNGS: usize = 10_000;

/// A notation's name, and what writes a program in it.
type Program = (&'static str, fn() -> String);

/// A program of 10,000 rungs in each notation.
const PROGRAMS: [Program; 6] = [
    ("ldmicro", ldmicro),
    ("ldmicro-text", ldmicro_text),
    ("iot", iot),
    ("l5x", l5x),
    ("textbook", textbook),
    ("cplc-draft", cplc_draft),
];

fn named(name: &str) -> String {
    let (_, program) = PROGRAMS
        .iter()
        .find(|(own, _)| *own == name)
        .expect("it is there");
    program()
}

/// From the file to ladder text.
#[divan::bench(args = ["ldmicro", "ldmicro-text", "iot", "l5x", "textbook", "cplc-draft"], sample_count = 10)]
fn import(bencher: Bencher<'_, '_>, name: &str) {
    let text = named(name);
    let notation = by_name(name).expect("the notation is registered");
    let source = Source::alone("bench", text.as_bytes());
    bencher.counter(BytesCount::of_str(&text)).bench(|| {
        convert(notation, &source, &Options::default())
            .expect("it can be read")
            .written
            .text
            .len()
    });
}

/// Files as large as projects become: 10 MB of PLCopen XML in 20 programs and in one, and a routine of 3,000 rungs for Logix.
const PROJECTS: [Project; 3] = [
    ("plcopen", "plcopen", || plcopen(20, 150)),
    ("plcopen-alone", "plcopen", || plcopen(1, 3_000)),
    ("l5x", "l5x", || routine(3_000)),
];

/// What it is called here, its notation, and what writes it.
type Project = (&'static str, &'static str, fn() -> String);

fn project(name: &str) -> (&'static str, String) {
    let mut projects = PROJECTS.iter();
    let (_, notation, project) = projects.find(|(own, ..)| *own == name).expect("it is there");
    (notation, project())
}

/// A project, to ladder text.
#[divan::bench(args = ["plcopen", "plcopen-alone", "l5x"], sample_count = 10)]
fn projects(bencher: Bencher<'_, '_>, name: &str) {
    let (notation, text) = project(name);
    let notation = by_name(notation).expect("the notation is registered");
    let source = Source::alone("bench", text.as_bytes());
    bencher.counter(BytesCount::of_str(&text)).bench(|| {
        let converted = convert(notation, &source, &Options::default()).expect("it can be read");
        assert_eq!(converted.report.tally().refused, 0, "all of it is read");
        converted.written.text.len()
    });
}

/// Its XML alone, as the reader's parser reads it.
#[divan::bench(args = ["plcopen", "plcopen-alone", "l5x"], sample_count = 10)]
fn xml_of_projects(bencher: Bencher<'_, '_>, name: &str) {
    let (_, text) = project(name);
    bencher.counter(BytesCount::of_str(&text)).bench(|| {
        let document = roxmltree::Document::parse(&text).expect("it is XML");
        document.descendants().count()
    });
}

/// From ladder text of 3,000 rungs to the file.
#[divan::bench(args = ["st", "plcopen", "l5x", "simatic", "c"], sample_count = 3)]
fn export(bencher: Bencher<'_, '_>, name: &str) {
    let text = ladder();
    let analysis = analyze(&Arc::new(parse(&text)), "bench.clad");
    let notation = by_name(name).expect("the notation is registered");
    bencher.counter(BytesCount::of_str(&text)).bench(|| {
        let writing = notation.write(&analysis).expect("it has no errors");
        assert_eq!(writing.report.tally().refused, 0, "all of it is written");
        writing.bytes.len()
    });
}

/// The same text, analysed.
#[divan::bench(sample_count = 3)]
fn analysis_of_export(bencher: Bencher<'_, '_>) {
    let text = ladder();
    let counter = BytesCount::of_str(&text);
    bencher.counter(counter).bench(|| {
        let analysis = analyze(&Arc::new(parse(&text)), "bench.clad");
        analysis.program().is_some()
    });
}

/// Its lines, split into words.
#[divan::bench(args = ["ldmicro", "ldmicro-text", "iot", "l5x", "textbook", "cplc-draft"])]
fn words_of_lines(bencher: Bencher<'_, '_>, name: &str) {
    let text = named(name);
    bencher.counter(BytesCount::of_str(&text)).bench(|| {
        text.lines()
            .flat_map(str::split_whitespace)
            .map(str::len)
            .sum::<usize>()
    });
}

fn l5x() -> String {
    routine(RUNGS)
}

/// 3,000 rungs of ladder text: seal-ins, timers, and sums.
fn ladder() -> String {
    let mut text = "VAR\n".to_owned();
    for n in 0..3_000 {
        text.push_str(&format!(
            "    a{n}, b{n}, y{n} : BOOL;\n    t{n} : TON;\n    n{n} : INT;\n"
        ));
    }
    text.push_str("END_VAR\n");
    for n in 0..3_000 {
        text.push_str(&match n % 3 {
            0 => format!("+--\\--[ ]( a{n} )--\\--[/]( b{n} )--( )( y{n} )--+\n|  /--[ ]( y{n} )--/                         |\n\n"),
            1 => format!("+--[ ]( b{n} )--[TON]( t{n}, T#5s )--( )( y{n} )--+\n\n"),
            _ => format!("+--[ ]( a{n} )--[ADD]( n{n}, n{n}, 1 )--[GT]( n{n}, 10 )--( )( y{n} )--+\n\n"),
        });
    }
    text
}

/// Programs of rungs, each with a branch, a timer, a coil, and a sum.
fn plcopen(programs: usize, rungs: usize) -> String {
    let place = |x: usize, y: usize| format!("<position x=\"{x}\" y=\"{y}\"/>");
    let mut text =
        "<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\"><types><dataTypes/><pous>\n".to_owned();
    for program in 0..programs {
        text.push_str(&format!(
            "<pou name=\"P{program}\" pouType=\"program\"><interface><localVars>\n"
        ));
        for n in 0..rungs {
            text.push_str(&format!(
                "<variable name=\"a{n}\"><type><BOOL/></type></variable><variable name=\"q{n}\"><type><BOOL/></type></variable>\
                 <variable name=\"t{n}\"><type><derived name=\"TON\"/></type></variable><variable name=\"n{n}\"><type><INT/></type></variable>\n"
            ));
        }
        text.push_str("</localVars></interface><body><LD>\n");
        for n in 0..rungs {
            let (id, y) = (n * 10 + 1, n * 100);
            let wired = |to: usize| {
                format!(
                    "<connectionPointIn><relPosition x=\"0\" y=\"15\"/><connection refLocalId=\"{to}\"/></connectionPointIn>"
                )
            };
            let out = "<connectionPointOut><relPosition x=\"21\" y=\"15\"/></connectionPointOut>";
            text.push_str(&format!(
                "<leftPowerRail localId=\"{id}\" width=\"3\" height=\"40\">{}<connectionPointOut formalParameter=\"\"/></leftPowerRail>\n",
                place(0, y)
            ));
            for (at, name) in [(1, format!("a{n}")), (2, format!("q{n}"))] {
                text.push_str(&format!(
                    "<contact localId=\"{}\" width=\"21\" height=\"15\" negated=\"false\">{}{}{out}<variable>{name}</variable></contact>\n",
                    id + at,
                    place(60, y + 40 * at),
                    wired(id)
                ));
            }
            text.push_str(&format!(
                "<inVariable localId=\"{}\" width=\"40\" height=\"25\">{}<connectionPointOut/><expression>T#5s</expression></inVariable>\n\
                 <block localId=\"{}\" typeName=\"TON\" instanceName=\"t{n}\" width=\"60\" height=\"60\">{}<inputVariables>\
                 <variable formalParameter=\"IN\"><connectionPointIn><connection refLocalId=\"{}\"/><connection refLocalId=\"{}\"/>\
                 </connectionPointIn></variable><variable formalParameter=\"PT\">{}</variable></inputVariables><inOutVariables/>\
                 <outputVariables><variable formalParameter=\"Q\">{out}</variable><variable formalParameter=\"ET\">{out}</variable>\
                 </outputVariables></block>\n<coil localId=\"{}\" width=\"21\" height=\"15\">{}<connectionPointIn><connection refLocalId=\"{}\" \
                 formalParameter=\"Q\"/></connectionPointIn>{out}<variable>q{n}</variable></coil>\n",
                id + 3,
                place(80, y + 60),
                id + 4,
                place(120, y),
                id + 1,
                id + 2,
                wired(id + 3),
                id + 5,
                place(300, y),
                id + 4,
            ));
            for (at, value) in [(6, format!("n{n}")), (7, "1".to_owned())] {
                text.push_str(&format!(
                    "<inVariable localId=\"{}\" width=\"40\" height=\"25\">{}<connectionPointOut/><expression>{value}</expression></inVariable>\n",
                    id + at,
                    place(400, y + 20 * (at - 6)),
                ));
            }
            text.push_str(&format!(
                "<block localId=\"{}\" typeName=\"ADD\" width=\"60\" height=\"60\">{}<inputVariables><variable formalParameter=\"IN1\">{}</variable>\
                 <variable formalParameter=\"IN2\">{}</variable></inputVariables><inOutVariables/><outputVariables>\
                 <variable formalParameter=\"OUT\">{out}</variable></outputVariables></block>\n<outVariable localId=\"{}\" width=\"40\" height=\"25\">\
                 {}<connectionPointIn><connection refLocalId=\"{}\" formalParameter=\"OUT\"/></connectionPointIn><expression>n{n}</expression></outVariable>\n",
                id + 8,
                place(460, y),
                wired(id + 6),
                wired(id + 7),
                id + 9,
                place(560, y),
                id + 8,
            ));
        }
        text.push_str("</LD></body></pou>\n");
    }
    text + "</pous></types><instances><configurations/></instances></project>\n"
}

/// A routine for Logix.
fn routine(rungs: usize) -> String {
    let mut text = "<RSLogix5000Content><Controller Name=\"C\"><Tags>\n".to_owned();
    for n in 0..rungs {
        text.push_str(&format!(
            "<Tag Name=\"a{n}\" TagType=\"Base\" DataType=\"BOOL\"/><Tag Name=\"t{n}\" TagType=\"Base\" \
             DataType=\"TIMER\"/>\n"
        ));
    }
    text.push_str("</Tags><Programs><Program Name=\"P\" MainRoutineName=\"M\"><Routines><Routine Name=\"M\" Type=\"RLL\">");
    text.push_str("<RLLContent>\n");
    for n in 0..rungs {
        let other = (n + 1) % rungs;
        text.push_str(&format!(
            "<Rung Number=\"{n}\" Type=\"N\"><Text><![CDATA[[XIC(a{n}) ,XIC(a{other}) \
             ]XIO(t{other}.DN)TON(t{n},500,0)[GRT(t{n}.ACC,100) OTE(a{n}) ,ADD(t{other}.ACC,1,t{other}.PRE) \
             ];]]></Text></Rung>\n"
        ));
    }
    text + "</RLLContent></Routine></Routines></Program></Programs></Controller></RSLogix5000Content>\n"
}

fn ldmicro() -> String {
    let mut text = "LDmicro0.1\nCYCLE=10000\n\nIO LIST\nEND\n\nPROGRAM\n".to_owned();
    for n in 0..RUNGS {
        text.push_str(&format!(
            "RUNG\n    PARALLEL\n        CONTACTS Xa{n} 0\n        CONTACTS Yrun{n} 0\n    END\n    CONTACTS Xstop 1\n    \
             TON Tdelay{n} 500000\n    COIL Yrun{n} 0 0 0\nEND\n"
        ));
    }
    text
}

fn ldmicro_text() -> String {
    let mut text = "LDmicro export text\nno MCU assigned, 4.000000 MHz crystal, 10.0 ms cycle time\n\nLADDER DIAGRAM:\n\n".to_owned();
    let blank = format!("   ||{:51}||\n", "");
    text.push_str(&blank);
    for n in 0..RUNGS {
        text.push_str(&format!("   ||{:^17}{:^17}{:^17}||\n", "Xa", "Ta", "Ya"));
        let wire = "-------] [--------[TON 500.0 ms]---------( )-------";
        text.push_str(&format!("{:>2} ||{wire}||\n", n % 99 + 1));
        text.push_str(&blank);
    }
    text.push_str(&format!("   ||{:-<51}||\n", "------[END]"));
    text
}

fn iot() -> String {
    rows(|n| format!("NO I{n} | NO Q{n} ; NC I1 ; TON T{n} 3 100 ; OUT Q{n} | ADD MI01 MI01 1\n"))
}

fn textbook() -> String {
    rows(|n| {
        format!(
            "start (open contact I{n}.0 V open contact Q{n}) & closed contact I{n}.0 & active coil Q{n} end\n"
        )
    })
}

/// A row for each rung.
fn rows(row: impl Fn(usize) -> String) -> String {
    (0..RUNGS).map(row).collect()
}

fn cplc_draft() -> String {
    let mut text = "IN = {DI start, DI stop}\nOUT = {DO run}\nVAR = {INT n}\n".to_owned();
    for _ in 0..RUNGS {
        text.push_str(
            "\n+---\\---[ ]<start>---\\---[/]<stop>---( )<run>---+\n    |                |\n    /---[ ]<run>-----/\n",
        );
    }
    text
}
