//! Every program of the corpus with something broken in it: it is read, or refused with a reason and a place.

use ladder_format::{Options, format_text};
use ladder_notations::{LineColumn, NOTATIONS, Notation, Source, convert};
use proptest::prelude::*;
use proptest::sample::Index;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

/// What can happen to a file.
#[derive(Debug, Clone)]
enum Mutation {
    Delete(Index, usize),
    Repeat(Index, usize),
    Flip(Index, u8),
    Insert(Index, Vec<u8>),
    SwapLines(Index, Index),
    RepeatLine(Index, usize),
    Truncate(Index),
}

impl Mutation {
    fn of(&self, bytes: &mut Vec<u8>) {
        if bytes.is_empty() {
            return;
        }
        let mut lines: Vec<Vec<u8>> = bytes
            .split_inclusive(|c| *c == b'\n')
            .map(<[u8]>::to_vec)
            .collect();
        let range = |at: &Index, length: usize| {
            let at = at.index(bytes.len());
            at..(at + length).min(bytes.len())
        };
        match self {
            Mutation::Delete(at, length) => drop(bytes.drain(range(at, *length))),
            Mutation::Repeat(at, length) => {
                let again = bytes[range(at, *length)].to_vec();
                let at = at.index(bytes.len());
                bytes.splice(at..at, again);
            }
            Mutation::Flip(at, bits) => {
                let at = at.index(bytes.len());
                bytes[at] ^= bits;
            }
            Mutation::Insert(at, more) => {
                let at = at.index(bytes.len());
                bytes.splice(at..at, more.iter().copied());
            }
            Mutation::SwapLines(one, other) => {
                let (one, other) = (one.index(lines.len()), other.index(lines.len()));
                lines.swap(one, other);
                *bytes = lines.concat();
            }
            Mutation::RepeatLine(at, times) => {
                let at = at.index(lines.len());
                lines[at] = lines[at].repeat(*times);
                *bytes = lines.concat();
            }
            Mutation::Truncate(at) => bytes.truncate(at.index(bytes.len())),
        }
    }
}

fn mutation() -> impl Strategy<Value = Mutation> {
    let at = any::<Index>;
    let words = prop::sample::select(vec![
        "\0",
        "#",
        "\n",
        " ",
        "-9",
        "'",
        "\u{feff}",
        "\u{fffd}",
        "END",
        "(",
        ")",
        "|",
        ";",
        "\\",
        "/",
        "+",
        "&",
        "V",
        "PARALLEL",
        "SERIES",
        "99999999999",
        "T#5s",
        "TON",
        "# ladder: fmt off #",
        "]",
        "[",
        "{",
        "\"",
    ]);
    prop_oneof![
        (at(), 1..40usize).prop_map(|(at, length)| Mutation::Delete(at, length)),
        (at(), 1..40usize).prop_map(|(at, length)| Mutation::Repeat(at, length)),
        (at(), 1..=255u8).prop_map(|(at, bits)| Mutation::Flip(at, bits)),
        (at(), words).prop_map(|(at, word)| Mutation::Insert(at, word.as_bytes().to_vec())),
        (at(), at()).prop_map(|(one, other)| Mutation::SwapLines(one, other)),
        (at(), 2..30usize).prop_map(|(at, times)| Mutation::RepeatLine(at, times)),
        at().prop_map(Mutation::Truncate),
    ]
}

/// A program in some notation.
type Sound = (&'static dyn Notation, Vec<u8>);

/// The folder of real programs, where there is one.
fn corpus() -> Option<PathBuf> {
    let folder = std::env::var_os("LADDER_CORPUS").map(PathBuf::from);
    if folder.is_none() {
        eprintln!("skipped: LADDER_CORPUS names no folder of real programs");
    }
    folder
}

fn files(folder: &Path, endings: &[&str]) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("the folder can be read");
    let mut files: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry can be read").path())
        .collect();
    files.retain(|file| {
        let ending = file.extension().and_then(|ending| ending.to_str());
        ending.is_some_and(|ending| endings.contains(&ending))
    });
    files.sort();
    files
}

/// Folders with files of industrial systems, and how those end.
const SYSTEMS: [(&str, &[&str]); 7] = [
    ("plcopen-xml", &["xml"]),
    ("codesys", &["xml"]),
    ("openplc-json", &["ld"]),
    ("rockwell", &["L5X"]),
    ("rslogix500", &["txt"]),
    ("simatic", &["s7dcl", "xml"]),
    ("twincat", &["TcPOU"]),
];

/// Files of industrial systems that are not larger than this, in bytes.
const LARGEST: usize = 40_000;

/// All programs of the corpus.
fn sound() -> &'static [Sound] {
    static SOUND: OnceLock<Vec<Sound>> = OnceLock::new();
    SOUND.get_or_init(|| {
        let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/corpus");
        let mut folders = vec![own.join("ldmicro/elements")];
        let mut programs = Vec::new();
        if let Some(corpus) = corpus() {
            folders.push(corpus.join("ldmicro/programs"));
            for (folder, endings) in SYSTEMS {
                let files = files(&corpus.join(folder), endings);
                let whole = files.iter().filter_map(|file| std::fs::read(file).ok());
                programs.extend(whole.filter(|bytes| bytes.len() < LARGEST));
            }
        }
        for file in folders.iter().flat_map(|folder| files(folder, &["ld"])) {
            programs.extend(std::fs::read(&file));
            programs.extend(std::fs::read(file.with_extension("export.txt")));
        }
        let whole = |name: &str| std::fs::read_to_string(own.join(name)).expect("the corpus is whole");
        programs.extend(
            whole("iot/element-programs.txt")
                .split("= ")
                .filter(|part| !part.trim().is_empty())
                .map(|part| format!("= {part}").into_bytes()),
        );
        for case in ["count_not_at_start", "latches_and_bits", "rung_out_of_a_timer"] {
            programs.push(whole(&format!("rockwell/cases/{case}/prog.L5X")).into_bytes());
        }
        programs.push(SLC.as_bytes().to_vec());
        programs.push(L5K.as_bytes().to_vec());
        let textbook = whole("textbook/constructed-examples.txt");
        programs.extend(textbook.lines().map(|line| line.as_bytes().to_vec()));
        programs.push(textbook.into_bytes());
        programs.push(DRAFT.as_bytes().to_vec());
        let seeds = ["ascii", "openplc", "plcopen", "simatic", "simatic_xml", "twincat"]
            .map(|name| own.join("../../fuzz/seeds/notations").join(name));
        programs.extend(seeds.map(|seed| std::fs::read(seed).expect("the seeds are whole")));
        let recognised = |bytes: Vec<u8>| {
            let notation = NOTATIONS
                .iter()
                .copied()
                .find(|notation| notation.recognises(&bytes))?;
            Some((notation, bytes))
        };
        programs.into_iter().filter_map(recognised).collect()
    })
}

const DRAFT: &str = "// A mixer.\nIN  = { DI start, AI[4] level }\nOUT = { DO run }\nVAR = { INT n, FLOAT w, BOOL[4] step }\n\n\
+---\\---[ ]<start>---\\---[/](stop)---[TON]<late><reset><time><500>---( )<run>---+\n    |                |\n    \
/---[ ]<run>-----/\n+---[GEQ]<full><n><5>---[ADD]<sum><n><1><n>---(S)<late>---+\n";

const SLC: &str = "; two rungs\nSOR BST XIC I:0/0 NXB XIC N7:[N7:1]/3 BND TON T4:0 1.0 5 0 EOR\nXIC B3/18 COP #N7:0 #N9:2 4\n";

const L5K: &str = "CONTROLLER C\nDATATYPE M\nSINT Z (Hidden := 1);\nBIT On Z : 0;\nEND_DATATYPE\nTAG\nt : TIMER := \
    [0,5,0];\na OF b.3;\nm : M[2] := [[1],[0]];\nEND_TAG\nPROGRAM P (MAIN := \"M\")\nROUTINE M\nRC: \"x\";\nN: \
    XIC(a)[TON(t,?,?) ,OTE(m[1].On) ];\nEND_ROUTINE\nEND_PROGRAM\nEND_CONTROLLER\n";

/// What must hold for any bytes, as far as one notation goes.
fn holds(notation: &dyn Notation, bytes: &[u8]) {
    let lines = bytes.split(|byte| *byte == b'\n').count() as u32;
    let lies_in =
        |place: LineColumn| assert!((1..=lines + 1).contains(&place.line), "{place} of {lines} lines");
    let source = Source::alone("test", bytes);
    let options = Options::default();
    let converted = match convert(notation, &source, &options) {
        Ok(converted) => converted,
        Err(error) => {
            assert!(error.message.len() > 10, "{error}");
            if let Some(place) = error.place {
                lies_in(place);
            }
            return;
        }
    };
    let text = &converted.written.text;
    let parse = ladder_syntax::parse(text);
    let errors = parse.errors();
    assert!(errors.is_empty(), "{errors:?}\n{text}");
    assert_eq!(format_text(text, &options), *text);
    converted
        .report
        .entries
        .iter()
        .for_each(|entry| lies_in(entry.place));
    converted.findings.iter().for_each(|found| lies_in(found.place));
    let analysis = ladder_analysis::analyze(&parse.into(), "test.clad");
    // What has no errors runs.
    if let Some(program) = analysis.program() {
        let options = ladder_simulator::Options {
            watchdog: 10_000,
            ..ladder_simulator::Options::default()
        };
        if let Ok(mut simulation) = ladder_simulator::Simulation::new(Arc::clone(program), options) {
            let _ = simulation.scan() && simulation.scan();
        }
    }
    // What is written back can be read, if it can be written.
    if let Ok(writing) = notation.write(&analysis) {
        let source = Source::alone("test", &writing.bytes);
        if let Err(error) = convert(notation, &source, &options) {
            panic!("{error}\n{}\nof\n{text}", String::from_utf8_lossy(&writing.bytes));
        }
    }
}

proptest! {
    #[test]
    fn broken_programs_are_read_or_refused(which: Index, mutations in prop::collection::vec(mutation(), 1..4)) {
        let (notation, bytes) = which.get(sound());
        let mut bytes = bytes.clone();
        for mutation in &mutations {
            mutation.of(&mut bytes);
        }
        holds(*notation, &bytes);
        // What another notation takes it for, it reads or refuses too.
        for other in NOTATIONS.iter().filter(|other| other.recognises(&bytes)) {
            holds(*other, &bytes);
        }
    }
}

#[test]
fn the_programs_themselves_hold() {
    let mut counted: Vec<(&str, usize)> = Vec::new();
    for (notation, bytes) in sound() {
        holds(*notation, bytes);
        match counted.iter_mut().find(|(name, _)| *name == notation.name()) {
            Some((_, count)) => *count += 1,
            None => counted.push((notation.name(), 1)),
        }
    }
    println!("{counted:?}");
    assert!(counted.len() >= 7, "{counted:?}");
}
