//! What the ladder text says in comments.

use ladder_notation::comments;
use ladder_syntax::{Item, Parse, TextRange, TextSize};
use std::collections::BTreeMap;

/// Text inside `(* *)`.
pub(crate) fn comment(text: &str) -> String {
    let text: String = text
        .chars()
        .map(|c| if c.is_control() { ' ' } else { c })
        .collect();
    format!("(* {} *)", text.trim().replace("(*", "( *").replace("*)", "* )"))
}

/// The comments of a network: those above it, and those on its lines. A blank line comes first where the ladder text has one.
pub(crate) fn of_network(parse: &Parse, text: &str, range: TextRange) -> Vec<String> {
    let first = line_at(parse, range.start());
    let mut above = Vec::new();
    let mut is_apart = false;
    for line in (0..first).rev() {
        let all = comments::on_line(parse, line);
        let end = parse.line_start(line + 1);
        let own = &text[usize::from(parse.line_start(line))..usize::from(end)];
        let own = own.trim_start_matches('\u{feff}').trim();
        if own.starts_with('#') && own.ends_with('#') {
            above.push(all);
        } else if own.is_empty() || own == "|" || own.starts_with("| ") {
            is_apart = true;
            if !own.trim_matches(['|', ' ', '\t']).is_empty() {
                break;
            }
        } else if !own.trim_matches(['|', ' ', '\t']).is_empty() {
            break;
        }
    }
    above.reverse();
    let mut told: Vec<String> = above.concat();
    let mut line = first;
    while line < parse.lines().len() && parse.line_start(line) < range.end() {
        told.extend(comments::on_line(parse, line));
        line += 1;
    }
    let lines = told
        .iter()
        .flat_map(|one| comments::told(one).map(str::to_owned).collect::<Vec<_>>());
    let mut lines: Vec<String> = lines.map(|line| comment(&line)).collect();
    if is_apart || !lines.is_empty() {
        lines.insert(0, String::new());
    }
    lines
}

/// What the comments on a line say.
fn on_line(parse: &Parse, line: usize) -> String {
    let all = comments::on_line(parse, line);
    let words: Vec<&str> = all.iter().flat_map(|one| comments::told(one)).collect();
    words.join(" ")
}

/// What the comments say that stand on the line of a place.
pub(crate) fn of_line(parse: &Parse, at: TextSize) -> Option<String> {
    Some(on_line(parse, line_at(parse, at))).filter(|told| !told.is_empty())
}

/// The comments above a declaration that is the first on its line.
pub(crate) fn above(parse: &Parse, text: &str, at: TextSize) -> Vec<String> {
    let line = line_at(parse, at);
    let before = text.get(usize::from(parse.line_start(line))..usize::from(at));
    let mut all = Vec::new();
    for line in (0..line)
        .rev()
        .take_while(|_| before.is_some_and(|before| before.trim().is_empty()))
    {
        let own = &text[usize::from(parse.line_start(line))..usize::from(parse.line_start(line + 1))];
        let own = own.trim();
        if !(own.starts_with('#') && own.ends_with('#')) {
            break;
        }
        all.push(on_line(parse, line));
    }
    all.retain(|told| !told.is_empty());
    all.reverse();
    all
}

/// What comments say that belong to no network and no declaration.
#[derive(Debug, Default)]
pub(crate) struct Outside {
    /// Above the first section of the file.
    pub(crate) head: Vec<String>,
    /// Above and in block definitions, by their numbers in the file.
    pub(crate) of_blocks: BTreeMap<usize, Vec<String>>,
    /// After the last network.
    pub(crate) last: Vec<String>,
}

impl Outside {
    pub(crate) fn of(parse: &Parse) -> Outside {
        let mut outside = Outside::default();
        let (mut above, mut block) = (Vec::new(), None);
        for item in &parse.structure().items {
            match *item {
                Item::Decoration(line) => {
                    above.extend(Some(on_line(parse, line)).filter(|told| !told.is_empty()));
                }
                Item::BlockHeader(number) => {
                    outside.of_blocks.entry(number).or_default().append(&mut above);
                    block = Some(number);
                }
                Item::BlockEnd(_) => {
                    if let Some(number) = block.take() {
                        outside.of_blocks.entry(number).or_default().append(&mut above);
                    }
                }
                Item::Section(_) => match block {
                    Some(number) => outside.of_blocks.entry(number).or_default().append(&mut above),
                    None => outside.head.append(&mut above),
                },
                Item::Network(_) | Item::Stray(_) => above.clear(),
            }
        }
        outside.last = above;
        outside
    }
}

/// The line that holds a place.
fn line_at(parse: &Parse, at: TextSize) -> usize {
    let (mut low, mut high) = (0, parse.lines().len());
    while low + 1 < high {
        let middle = low.midpoint(high);
        if parse.line_start(middle) <= at {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}
