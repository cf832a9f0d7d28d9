//! Reads the wiring of plain boolean networks from their text: contacts and coils with one operand each.

use super::DrawnPart;

/// The networks of a text that holds nothing but rungs, with the text of each block. A rung with a `\` and the rung
/// below it belong together; rail, comment and blank lines count for nothing.
pub fn networks(text: &str) -> Vec<(Vec<Vec<DrawnPart>>, Vec<String>)> {
    let mut networks: Vec<(Vec<Vec<DrawnPart>>, Vec<String>)> = Vec::new();
    let mut goes_on = false;
    for line in text.lines() {
        let mut blocks = Vec::new();
        let (_, known) = networks
            .last()
            .filter(|_| goes_on)
            .map_or((0, 0), |last| (0, last.1.len()));
        let parts = rung(line, known, &mut blocks);
        if parts.is_empty() {
            continue;
        }
        let continues = parts.contains(&DrawnPart::Down);
        match networks.last_mut().filter(|_| goes_on) {
            Some((rungs, all)) => {
                rungs.push(parts);
                all.extend(blocks);
            }
            None => networks.push((vec![parts], blocks)),
        }
        goes_on = continues;
    }
    networks
}

/// The parts of one line, whose first block has a number; the texts of its blocks are added to a list. Empty for a
/// line that means nothing.
pub fn rung(line: &str, first_block: usize, blocks: &mut Vec<String>) -> Vec<DrawnPart> {
    let line = without_loose_comments(line);
    let mut parts = Vec::new();
    let mut rest = line.as_str();
    while let Some(first) = rest.chars().next() {
        let length = match first {
            '-' => {
                parts.push(DrawnPart::Wire);
                1
            }
            '+' => {
                parts.push(DrawnPart::Rail);
                1
            }
            '\\' => {
                parts.push(DrawnPart::Down);
                1
            }
            '/' => {
                parts.push(DrawnPart::Up);
                1
            }
            '#' => {
                parts.push(DrawnPart::Wire);
                1 + rest[1..].find('#').map_or(rest.len() - 1, |end| end + 1)
            }
            '[' | '(' | '<' => {
                let length = block_length(rest);
                parts.push(DrawnPart::Block(first_block + blocks.len()));
                blocks.push(rest[..length].to_owned());
                length
            }
            _ => {
                // White space and `|`.
                if !parts.is_empty() && parts.last() != Some(&DrawnPart::Gap) {
                    parts.push(DrawnPart::Gap);
                }
                first.len_utf8()
            }
        };
        rest = &rest[length..];
    }
    if parts.last() == Some(&DrawnPart::Gap) {
        parts.pop();
    }
    parts
}

/// A block and its operand list.
fn block_length(text: &str) -> usize {
    let head = text.find([']', ')', '>']).expect("the first part is closed") + 1;
    let operands = text[head..].trim_start();
    if !operands.starts_with('(') {
        return head;
    }
    let opened = text.len() - operands.len();
    opened + operands.find(')').expect("the operands are closed") + 1
}

/// Comments that do not touch the drawing on both sides are white space.
fn without_loose_comments(line: &str) -> String {
    let mut out = String::new();
    let mut rest = line;
    while let Some(start) = rest.find('#') {
        let end = start
            + 1
            + rest[start + 1..]
                .find('#')
                .map_or(rest.len() - start - 1, |end| end + 1);
        let touches = |c: Option<char>| c.is_some_and(|c| !c.is_whitespace() && c != '|');
        let joins = touches(rest[..start].chars().next_back()) && touches(rest[end..].chars().next());
        out.push_str(&rest[..start]);
        out.push_str(if joins { &rest[start..end] } else { " " });
        rest = &rest[end..];
    }
    out.push_str(rest);
    out
}
