//! RSLogix 500: rungs as text, one after the other, with addresses instead of tags: `N7:0/3`, `T4:0.ACC`, `I:1/0`.

use crate::mnemonic::operands_in_ascii;
use crate::model::{Family, Program, Project, Routine, Rung, Tag};
use crate::operand::{Expr, Path, Step, parse};
use ladder_drawings::neutral::{self, Instruction, instructions};
use ladder_notation::ReadError;
use std::collections::BTreeMap;

/// How many elements a file of the controller has at most.
const MOST_ELEMENTS: u32 = 256;

/// Whether a text is such rungs: its first one begins with `SOR`, `BST`, or an instruction and an address after a blank.
pub(crate) fn recognises(text: &str) -> bool {
    let lines = text.lines().map(str::trim).take(200);
    let mut rungs = lines.filter(|line| !line.is_empty() && !line.starts_with(';'));
    let Some(first) = rungs.next() else { return false };
    let mut words = first.split_whitespace();
    let Some(word) = words.next() else { return false };
    let is_start = |word: &str, next: Option<&str>| match word {
        "BST" => next.is_some_and(crate::mnemonic::is_known),
        "XIC" | "XIO" => next.is_some_and(|next| !next.contains('(')),
        _ => false,
    };
    match word {
        "SOR" => true,
        word => is_start(word, words.next()),
    }
}

/// Reads the rungs of a text. A rung is a line, or reaches from `SOR` to `EOR`; lines that begin with `;` are comments.
///
/// # Errors
///
/// If none of them begins with an instruction of RSLogix 500.
pub(crate) fn read(text: &str) -> Result<Project, ReadError> {
    let mut rungs: Vec<Rung> = Vec::new();
    let mut comment: Vec<&str> = Vec::new();
    // A rung whose `EOR` did not come yet.
    let mut open: Option<(usize, usize)> = None;
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        let begin = at;
        at += line.len();
        let trimmed = line.trim();
        if open.is_none() {
            if trimmed.is_empty() {
                continue;
            }
            if let Some(told) = trimmed.strip_prefix(';') {
                comment.push(told.trim());
                continue;
            }
        }
        let start = begin + (line.len() - line.trim_start().len());
        let end = begin + line.trim_end().len();
        let (first, _) = open.unwrap_or((start, end));
        let whole = &text[first..end.max(first)];
        if whole.starts_with("SOR") && !whole.trim_end_matches(';').trim_end().ends_with("EOR") {
            open = Some((first, end));
            continue;
        }
        open = None;
        rungs.push(rung(text, first, end, &mut comment));
    }
    if let Some((first, end)) = open {
        rungs.push(rung(text, first, end, &mut comment));
    }
    if !rungs.iter().any(is_rung) {
        let why =
            "there is no rung of RSLogix 500 in the text; one begins with `SOR`, `BST` or an instruction";
        return Err(ReadError::whole(why));
    }
    let routine = Routine {
        name: "Main".to_owned(),
        rungs,
        ..Routine::default()
    };
    let mut project = Project {
        family: Family::Slc,
        programs: vec![Program {
            name: "Main".to_owned(),
            main: Some("Main".to_owned()),
            routines: vec![routine],
            ..Program::default()
        }],
        ..Project::default()
    };
    project.tags = files(&project);
    Ok(project)
}

/// Whether a text begins as a rung does.
fn is_rung(rung: &Rung) -> bool {
    let mut words = rung.text.split(|c: char| !c.is_ascii_alphanumeric());
    words
        .next()
        .is_some_and(|word| matches!(word, "SOR" | "BST") || crate::mnemonic::is_known(word))
}

fn rung(text: &str, first: usize, end: usize, comment: &mut Vec<&str>) -> Rung {
    let told = std::mem::take(comment).join("\n");
    Rung {
        at: first,
        text: text[first..end].to_owned(),
        comment: (!told.is_empty()).then_some(told),
        ..Rung::default()
    }
}

/// The files of the controller as arrays, each as long as the program shows.
fn files(project: &Project) -> Vec<Tag> {
    let mut sizes: BTreeMap<String, u32> = BTreeMap::new();
    let rungs = project
        .programs
        .iter()
        .flat_map(|program| &program.routines)
        .flat_map(|routine| &routine.rungs);
    for rung in rungs {
        if let Ok(parts) = neutral::parse(&rung.text, &operands_in_ascii) {
            instructions(&parts, &mut |it: &Instruction<'_>| {
                let numbers = it.operands.iter().filter_map(|text| text.parse::<u32>().ok());
                let length = numbers.max().unwrap_or(0);
                for text in &it.operands {
                    if let Ok(expr) = operand(text) {
                        let length = if text.starts_with('#') { length } else { 0 };
                        reached(&expr, length, &mut sizes);
                    }
                }
            });
        }
    }
    let tags = sizes.into_iter().filter_map(|(name, size)| {
        let letters: String = name.chars().take_while(char::is_ascii_alphabetic).collect();
        Some(Tag {
            ty: type_of(&letters)?.to_owned(),
            dimensions: vec![size.min(MOST_ELEMENTS)],
            name,
            ..Tag::default()
        })
    });
    tags.collect()
}

/// Notes how long the arrays of an operand are at least.
fn reached(expr: &Expr, length: u32, sizes: &mut BTreeMap<String, u32>) {
    match expr {
        Expr::Path(path) => {
            if let Some(Step::Index(index)) = path.steps.first() {
                let last = match index.first() {
                    Some(Expr::Int(index)) => {
                        u32::try_from(*index).unwrap_or(0).saturating_add(length.max(1))
                    }
                    _ => MOST_ELEMENTS,
                };
                let size = sizes.entry(path.root.clone()).or_default();
                *size = last.max(*size);
                for index in index {
                    reached(index, 0, sizes);
                }
            }
            if let Some(Step::ComputedBit(index)) = path.steps.last() {
                reached(index, 0, sizes);
            }
        }
        _ => expr.parts().for_each(|part| reached(part, 0, sizes)),
    }
}

fn type_of(letters: &str) -> Option<&'static str> {
    Some(match letters {
        "N" | "B" | "A" | "D" => "INT",
        "F" => "REAL",
        "L" => "DINT",
        "T" => "TIMER",
        "C" => "COUNTER",
        "R" => "CONTROL",
        "ST" => "STRING",
        _ => return None,
    })
}

/// An address, a symbol, a number or a formula.
pub(crate) fn operand(text: &str) -> Result<Expr, String> {
    match address(text) {
        Some(path) => Ok(Expr::Path(path)),
        // 12h is a mask in RSLogix 500.
        None => match text
            .strip_suffix(['h', 'H'])
            .map(|hex| i64::from_str_radix(hex, 16))
        {
            Some(Ok(number)) if text.starts_with(|c: char| c.is_ascii_digit()) => Ok(Expr::Int(number)),
            _ => parse(text),
        },
    }
}

fn address(text: &str) -> Option<Path> {
    let text = text.trim_start_matches(['#', '$']);
    let letters: String = text.chars().take_while(char::is_ascii_alphabetic).collect();
    let upper = letters.to_ascii_uppercase();
    let after = &text[letters.len()..];
    let digits = after.find(|c: char| !c.is_ascii_digit()).unwrap_or(after.len());
    let (number, rest) = after.split_at(digits);
    let is_io = matches!(upper.as_str(), "I" | "O" | "S");
    if !is_io && type_of(&upper).is_none() {
        return None;
    }
    let file = format!("{upper}{number}");
    if is_io && number.parse() == Ok(i32::from(upper == "I")) {
        // `I1:0` is `I:0`.
        return address(&format!("{upper}{rest}"));
    }
    if let Some(bit) = rest.strip_prefix('/').filter(|_| upper == "B") {
        let bit: u32 = bit.parse().ok()?;
        return Some(Path {
            root: file,
            steps: vec![
                Step::Index(vec![Expr::Int((bit / 16).into())]),
                Step::Bit(bit % 16),
            ],
        });
    }
    let rest = rest.strip_prefix(':')?;
    if is_io {
        let (word, bit) = rest.split_once('/').unwrap_or((rest, ""));
        let word = word.strip_suffix(".0").unwrap_or(word);
        if word.is_empty() || !word.bytes().all(|b| b.is_ascii_digit() || b == b'.') {
            return None;
        }
        return Some(match bit.parse() {
            Ok(bit) if upper == "S" => Path {
                root: format!("S:{word}"),
                steps: vec![Step::Bit(bit)],
            },
            _ if bit.is_empty() => Path::tag(format!("{upper}:{word}")),
            Ok(bit) => Path::tag(format!("{upper}:{word}/{bit}")),
            Err(_) => return None,
        });
    }
    let (index, rest) = match rest.strip_prefix('[') {
        Some(inner) => {
            let (inner, rest) = inner.split_once(']')?;
            (Expr::Path(address(inner)?), rest)
        }
        None => {
            let end = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
            let (index, rest) = rest.split_at(end);
            (Expr::Int(index.parse().ok()?), rest)
        }
    };
    let mut steps = vec![Step::Index(vec![index])];
    let part = rest.strip_prefix(['.', '/']);
    match part {
        None if rest.is_empty() => {}
        None => return None,
        Some(part) => match (part.strip_prefix('['), part.parse()) {
            (Some(inner), _) => {
                let index = address(inner.strip_suffix(']')?)?;
                steps.push(Step::ComputedBit(Box::new(Expr::Path(index))));
            }
            (None, Ok(bit)) => steps.push(Step::Bit(bit)),
            (None, Err(_)) => steps.push(Step::Member(part.to_ascii_uppercase())),
        },
    }
    Some(Path { root: file, steps })
}
