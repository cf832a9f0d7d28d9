//! Projects with something broken in them: each is read, or refused with a reason and a place; nothing is left out in
//! silence.

use crate::corpus::{files, own};
use crate::harness::{project, short, unit};
use ladder_format::{Options, format_text};
use ladder_notation::{Lines, Outcome, Source, convert};
use ladder_notation_plcopen::Plcopen;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use std::collections::HashSet;

/// What can happen to a file.
#[derive(Debug, Clone)]
enum Mutation {
    /// A stretch of bytes is gone.
    Delete(Index, usize),
    /// A word is put in.
    Insert(Index, &'static str),
    /// An attribute or text is another.
    Replace(Index, &'static str),
    /// An element is there twice.
    Twice(Index),
    /// An element is gone.
    Without(Index),
    /// A wire ends at another element.
    Rewire(Index, u8),
}

const WORDS: &[&str] = &[
    "",
    "#",
    "\n",
    " ",
    "-9",
    "'",
    "(",
    ")",
    "[",
    "]",
    "|",
    ";",
    "+",
    "&amp;",
    "a b",
    "NOT",
    "a.b",
    "a[1",
    "%IX0.0",
    "T#5s",
    "TON",
    "AND",
    "16#",
    "# ladder: fmt off #",
    "EN",
    "\u{feff}",
    "9999999999999999999999",
    "1",
    "2",
    "TRUE",
    "Main",
    "Motor",
    "é",
    "EXECUTE",
    "*)",
    "$",
    "\"",
    "x := 1",
    "a.3.4",
    "R_TRIG",
    "BOOL#1",
    ",",
    "..",
];

fn mutation() -> impl Strategy<Value = Mutation> {
    let at = any::<Index>;
    prop_oneof![
        1 => (at(), 1..30usize).prop_map(|(at, length)| Mutation::Delete(at, length)),
        1 => (at(), select(WORDS)).prop_map(|(at, word)| Mutation::Insert(at, word)),
        6 => (at(), select(WORDS)).prop_map(|(at, word)| Mutation::Replace(at, word)),
        2 => at().prop_map(Mutation::Twice),
        3 => at().prop_map(Mutation::Without),
        6 => (at(), any::<u8>()).prop_map(|(at, to)| Mutation::Rewire(at, to)),
    ]
}

/// The ranges of a text that are between these two signs.
fn between(text: &str, open: &str, close: &str) -> Vec<std::ops::Range<usize>> {
    let starts = text.match_indices(open).map(|(at, _)| at + open.len());
    starts
        .filter_map(|start| Some(start..start + text[start..].find(close)?))
        .collect()
}

/// The elements of bodies that end where they begin: `<contact ..>..</contact>`.
fn elements(text: &str) -> Vec<std::ops::Range<usize>> {
    let mut all = Vec::new();
    for name in [
        "contact",
        "coil",
        "block",
        "inVariable",
        "outVariable",
        "jump",
        "connection",
        "variable",
        "pou",
        "leftPowerRail",
    ] {
        for (start, _) in text.match_indices(&format!("<{name} ")) {
            let own = text[start..].find('>').map(|end| start + end + 1);
            let Some(own) = own else { continue };
            let end = if text[..own].ends_with("/>") {
                Some(own)
            } else {
                let close = format!("</{name}>");
                text[own..].find(&close).map(|end| own + end + close.len())
            };
            all.extend(end.map(|end| start..end));
        }
    }
    all
}

impl Mutation {
    fn of(&self, text: &mut String) {
        let whole = |text: &str, mut at: usize| {
            while !text.is_char_boundary(at) {
                at -= 1;
            }
            at
        };
        match self {
            Mutation::Delete(at, length) if !text.is_empty() => {
                let at = at.index(text.len());
                let range = whole(text, at)..whole(text, (at + length).min(text.len()));
                text.replace_range(range, "");
            }
            Mutation::Insert(at, word) if !text.is_empty() => {
                let at = whole(text, at.index(text.len()));
                text.insert_str(at, word);
            }
            Mutation::Replace(at, word) => {
                let mut ranges = between(text, "=\"", "\"");
                ranges.extend(between(text, "<variable>", "<"));
                ranges.extend(between(text, "<expression>", "<"));
                if !ranges.is_empty() {
                    text.replace_range(at.get(&ranges).clone(), word);
                }
            }
            Mutation::Twice(at) => {
                let ranges = elements(text);
                if !ranges.is_empty() {
                    let range = at.get(&ranges).clone();
                    let again = text[range.clone()].to_owned();
                    text.insert_str(range.end, &again);
                }
            }
            Mutation::Without(at) => {
                let ranges = elements(text);
                if !ranges.is_empty() {
                    text.replace_range(at.get(&ranges).clone(), "");
                }
            }
            Mutation::Rewire(at, to) => {
                let ranges = between(text, "refLocalId=\"", "\"");
                if !ranges.is_empty() {
                    text.replace_range(at.get(&ranges).clone(), &to.wrapping_rem(24).to_string());
                }
            }
            _ => {}
        }
    }
}

/// The projects before anything happens to them.
fn sound() -> Vec<String> {
    let own = files(&own(), "xml").into_iter();
    let mut all: Vec<String> = own
        .map(|file| std::fs::read_to_string(file).expect("it can be read"))
        .collect();
    let motor = unit(
        "functionBlock",
        "Motor",
        "inputVars start : BOOL\ninOutVars n : INT\noutputVars run : BOOL\ndelay : TON\nT2 : R_TRIG",
        &format!("<LD>{}</LD>", short(TIMERS)),
    );
    let sum = unit(
        "function",
        "Sum",
        "inputVars x : INT\ninputVars y : INT",
        &format!(
            "<FBD>{}</FBD>",
            short("inVariable 1 x\ninVariable 2 y\nblock 3 ADD IN1=1 IN2=2 / OUT\noutVariable 4 from=3 Sum")
        ),
    );
    let sum = sum.replace("<interface>", "<interface><returnType><INT/></returnType>");
    let main = unit(
        "program",
        "Main",
        "a : BOOL\nb : BOOL\nn : INT\nq : BOOL\nM1 : Motor\nw : WORD",
        &format!("<LD>{}</LD>", short(MAIN)),
    );
    let instances = "<configuration name=\"c\"><resource name=\"r\"><task name=\"t\" interval=\"T#20ms\" priority=\"1\"><pouInstance name=\"i\" typeName=\"Main\"/></task><globalVars><variable name=\"g\"><type><INT/></type></variable></globalVars></resource></configuration>";
    let types = "<dataType name=\"Phase\"><baseType><enum><values><value name=\"IDLE\"/><value name=\"RUN\" value=\"2\"/></values></enum></baseType></dataType><dataType name=\"Rec\"><baseType><struct><variable name=\"x\"><type><INT/></type><initialValue><simpleValue value=\"3\"/></initialValue></variable></struct></baseType></dataType>";
    all.push(project(types, &(motor + &sum + &main), instances));
    all.push(crate::ten::PROJECT.to_owned());
    all
}

const TIMERS: &str = "leftPowerRail 1
contact 2 from=1 start
inVariable 3 T#2s
block 4 TON delay IN=2 PT=3 / Q ET
coil 5 from=4.Q run
block 6 R_TRIG T2 CLK=2 / Q
coil 7 from=6.Q storage=set run
contact 8 from=6.Q delay.Q
coil 9 from=8,2 run
return 10 from=8";

const MAIN: &str = "leftPowerRail 1
contact 2 from=1 a
contact 3 from=1 negated=true b
contact 4 from=2,3 edge=rising q
coil 5 from=4 q
coil 6 from=5,3 storage=reset a
inVariable 7 n
block 8 Motor M1 start=4 n=7 / run
coil 9 from=8.run q
block 10 Sum x=7 y=7 / OUT
outVariable 11 from=10 n
block 12 AND IN1=2 IN2!negated=4 / OUT
block 13 OR IN1=12 IN2=3 / OUT!negated
coil 14 from=13 q
jump 15 from=2 label=end
block 16 GT EN=2 IN1=7 IN2=7 / ENO OUT
coil 17 from=16.OUT q
inVariable 18 (n + 1) * 2
outVariable 19 from=18 n
label 20 label=end
connector 21 from=4 name=c
continuation 22 name=c
coil 23 from=22 q";

fn holds(text: &str) {
    let source = Source::alone("test", text.as_bytes());
    let options = Options::default();
    let converted = match convert(&Plcopen, &source, &options) {
        Ok(converted) => converted,
        Err(error) => return assert!(error.message.len() > 10, "{error}"),
    };
    let written = &converted.written.text;
    let errors = ladder_syntax::parse(written).errors();
    assert!(errors.is_empty(), "{errors:?}\n{written}\nof\n{text}");
    assert_eq!(format_text(written, &options), *written);
    // Every element of a body is told, and what is said to be the same is in the text.
    let told: HashSet<_> = converted.report.entries.iter().map(|entry| entry.place).collect();
    let drawn: HashSet<_> = converted
        .written
        .places
        .iter()
        .map(|(_, origin)| converted.places[*origin as usize])
        .collect();
    let refused = converted.report.entries.iter().any(|entry| {
        // What is unread as a whole is told once.
        let whole = ["unit ", "body of "];
        entry.element == "drawing" || whole.iter().any(|word| entry.element.starts_with(word))
    });
    let lines = Lines::of(text);
    let document = roxmltree::Document::parse(text).expect("it was read");
    for node in document
        .descendants()
        .filter(|node| node.attribute("localId").is_some())
    {
        let is_in_body = node
            .parent()
            .is_some_and(|parent| matches!(parent.tag_name().name(), "LD" | "FBD"));
        let is_read = is_in_body
            && node
                .ancestors()
                .any(|around| around.has_tag_name(("http://www.plcopen.org/xml/tc6_0201", "pous")));
        let place = lines.place(text, node.range().start);
        assert!(
            !is_read || refused || told.contains(&place),
            "{place} is not told: {written}\nof\n{text}"
        );
    }
    for entry in &converted.report.entries {
        let acts = ["coil ", "jump ", "return"]
            .iter()
            .any(|word| entry.element.starts_with(word));
        let is_same = entry.outcome == Outcome::Translated;
        assert!(
            !acts || !is_same || drawn.contains(&entry.place),
            "{} {} stands nowhere:\n{written}\nof\n{text}",
            entry.place,
            entry.element
        );
    }
}

#[test]
fn the_projects_themselves_hold() {
    for text in sound() {
        holds(&text);
    }
}

proptest! {
    #[test]
    fn broken_projects_are_read_or_refused(which: Index, mutations in prop::collection::vec(mutation(), 1..6)) {
        let mut text = which.get(&sound()).clone();
        for mutation in &mutations {
            mutation.of(&mut text);
        }
        holds(&text);
    }
}
