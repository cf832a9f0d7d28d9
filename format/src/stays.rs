//! Which lines stay as they are (LANGUAGE §8 rule 10), before any network is read.

use crate::flat::{FlatLine, Node, Source};
use ladder_syntax::SyntaxKind::{self, COMMENT};
use ladder_syntax::{Item, Line, LineKind, Lines, Many, Network, NodeOrToken, Parse, SyntaxErrorKind};
use std::ops::Range;

/// For each logical line whether it stays to the letter.
pub(crate) struct Stays {
    lines: Vec<bool>,
}

impl Stays {
    /// What is known without looking into the rungs. `off`: `fmt off` is before the first line, and afterwards
    /// whether it does after the last.
    pub(crate) fn find(source: Source<'_>, off: &mut bool) -> Stays {
        let lines = source.lines;
        let mut stays = Stays {
            lines: vec![false; lines.lines().len()],
        };
        stays.switched_off(source, off);
        let unclosed = lines.unclosed_comment();
        if let Some(line) = unclosed.and_then(|place| lines.line_at(place.start())) {
            stays.keep(line..lines.lines().len());
        }
        for (line, stays) in lines.lines().iter().zip(&mut stays.lines) {
            *stays |= line.is_in_conflict();
        }
        stays.split_lines(source);
        stays.broken_sections(source);
        stays.broken_networks(source);
        stays
    }

    /// Whether a line stays.
    pub(crate) fn line(&self, line: usize) -> bool {
        self.lines[line]
    }

    /// Whether one of some lines stays.
    fn any(&self, lines: Range<usize>) -> bool {
        self.lines[lines].contains(&true)
    }

    /// The lines stay.
    pub(crate) fn keep(&mut self, lines: Range<usize>) {
        self.lines[lines].fill(true);
    }

    /// What is between `fmt off` and `fmt on`.
    fn switched_off(&mut self, source: Source<'_>, is_off: &mut bool) {
        let count = self.lines.len();
        let mut off = is_off.then_some(0);
        for line in 0..count {
            match directive_line(source, line) {
                Some(Directive::Off) if off.is_none() => off = Some(line + 1),
                Some(Directive::On) => {
                    if let Some(start) = off.take() {
                        self.keep(start..line);
                    }
                }
                _ => {}
            }
        }
        *is_off = off.is_some();
        if let Some(start) = off {
            self.keep(start..count);
        }
    }

    /// Two things on one physical line, which is an error: a new line end between them would take it away.
    fn split_lines(&mut self, source: Source<'_>) {
        let mut before: Option<Range<usize>> = None;
        for item in &source.lines.structure().items {
            let lines = item_lines(source.lines, *item);
            let start = source.range(lines.start).start;
            if start > 0 && !matches!(source.text.as_bytes()[start - 1], b'\n' | b'\r') {
                if let Some(before) = before {
                    self.keep(before);
                }
                self.keep(lines.clone());
            }
            before = Some(lines);
        }
    }

    fn broken_sections(&mut self, source: Source<'_>) {
        let structure = source.lines.structure();
        for (index, item) in structure.items.iter().enumerate() {
            let &Item::Section(number) = item else { continue };
            let section = &structure.sections[number];
            let lines = section.lines.clone();
            let stays = |line: usize| {
                source.has_error(line)
                    || has_comment_inside(source, line)
                    || directive_line(source, line).is_some()
            };
            if !section.closed || self.any(lines.clone()) || lines.clone().any(stays) {
                self.keep(lines);
            }
            if section.closed {
                continue;
            }
            // A section without END_VAR ends where the drawing begins. What does it must go on doing so: the
            // lines after it, and a network that need not begin with a rail.
            for item in &structure.items[index + 1..] {
                match item {
                    Item::Decoration(line) => self.keep(*line..*line + 1),
                    Item::Network(number) => {
                        let network = &structure.networks[*number];
                        if !begins_at_rail(source.line(network.lines.start)) {
                            self.keep(network.lines.clone());
                        }
                        break;
                    }
                    _ => break,
                }
            }
        }
    }

    fn broken_networks(&mut self, source: Source<'_>) {
        for network in &source.lines.structure().networks {
            let lines = network.lines.clone();
            let cuts =
                |line: usize| source.kind(line) == LineKind::Stray || directive_line(source, line).is_some();
            if self.any(lines.clone())
                || is_broken(source, network)
                || (lines.len() > 1 && lines.clone().any(cuts))
            {
                self.keep(lines);
            }
        }
        self.barred_branches(source);
    }

    /// A branch that is drawn from `|` to `|` below a `\` or above a `/` without a partner is meant to be joined to it: it is
    /// a part of what is uncertain.
    fn barred_branches(&mut self, source: Source<'_>) {
        let networks = &source.lines.structure().networks;
        let mut join = |own: &Network, neighbour: &Network| {
            let is_next_to = own.lines.start == neighbour.lines.end || own.lines.end == neighbour.lines.start;
            if is_next_to
                && self.line(neighbour.lines.start)
                && !self.line(own.lines.start)
                && is_barred(source, own)
                && (is_broken(source, neighbour) || is_barred(source, neighbour))
            {
                self.keep(own.lines.clone());
            }
        };
        for pair in networks.windows(2) {
            join(&pair[1], &pair[0]);
        }
        for pair in networks.windows(2).rev() {
            join(&pair[0], &pair[1]);
        }
    }
}

/// The lines of an item.
pub(crate) fn item_lines(lines: &Lines<FlatLine>, item: Item) -> Range<usize> {
    let structure = lines.structure();
    match item {
        Item::Network(number) => structure.networks[number].lines.clone(),
        Item::Section(number) => structure.sections[number].lines.clone(),
        Item::BlockHeader(number) => {
            let line = structure.blocks[number].lines.start;
            line..line + 1
        }
        Item::BlockEnd(line) | Item::Decoration(line) | Item::Stray(line) => line..line + 1,
    }
}

/// Whether a network has an error that makes its drawing uncertain.
fn is_broken(source: Source<'_>, network: &Network) -> bool {
    let mut downs_above = 0;
    for rung in source.rungs(network) {
        let line = &source.lines.lines()[rung];
        let uncertain = line.errors.iter().any(|error| {
            matches!(
                error.kind,
                SyntaxErrorKind::UnclosedBlock { .. }
                    | SyntaxErrorKind::UnexpectedCharacter { .. }
                    | SyntaxErrorKind::UnclosedComment
                    | SyntaxErrorKind::UnclosedString
                    | SyntaxErrorKind::TooMany(Many::Parts)
            )
        });
        if uncertain || line.ups != downs_above {
            return true;
        }
        downs_above = line.downs;
    }
    downs_above != 0
}

/// Whether a network is one rung without connectors that begins and ends with `|`, where it does not begin at the left.
fn is_barred(source: Source<'_>, network: &Network) -> bool {
    if network.lines.len() > 1 {
        return false;
    }
    let rung = network.lines.start;
    let line = &source.lines.lines()[rung];
    if line.ups + line.downs > 0 {
        return false;
    }
    let drawn = || {
        let parts = source.line(rung).children();
        parts.filter(|part| !part.kind().is_trivia())
    };
    let ends = drawn().last().is_some_and(|part| part.kind() == SyntaxKind::RAIL);
    let bar = drawn().take_while(|part| part.kind() == SyntaxKind::RAIL).last();
    ends && bar.is_some_and(|bar| bar.start() > source.range(rung).start)
        && drawn().all(|part| part.kind() != SyntaxKind::RAIL_CONNECTOR)
}

/// Whether a rung's first drawing is the left rail's `+`, comments aside.
fn begins_at_rail(rung: Node<'_>) -> bool {
    let first = rung
        .children()
        .map(Node::kind)
        .find(|kind| !kind.is_trivia() && *kind != SyntaxKind::RAIL);
    first == Some(SyntaxKind::RAIL_CONNECTOR)
}

/// Whether a comment is before the last token of a line of a section that is not one.
fn has_comment_inside(source: Source<'_>, line: usize) -> bool {
    if matches!(source.kind(line), LineKind::Comment | LineKind::Blank) {
        return false;
    }
    let mut comment = false;
    for child in source.line(line).children() {
        if child.kind() == COMMENT {
            comment = true;
        } else if child.is_node() && holds_comment(child) || comment && !child.kind().is_trivia() {
            return true;
        }
    }
    false
}

fn holds_comment(node: Node<'_>) -> bool {
    node.children()
        .any(|child| child.kind() == COMMENT || child.is_node() && holds_comment(child))
}

/// `fmt off` or `fmt on`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Directive {
    Off,
    On,
}

/// The directive that a comment is.
pub(crate) fn directive(comment: &str) -> Option<Directive> {
    let inside = comment.strip_prefix('#')?.strip_suffix('#')?;
    let rest = inside.trim_matches(BLANKS).strip_prefix("ladder:")?;
    let mut words = rest.split(BLANKS).filter(|word| !word.is_empty());
    match (words.next(), words.next(), words.next()) {
        (Some("fmt"), Some("off"), None) => Some(Directive::Off),
        (Some("fmt"), Some("on"), None) => Some(Directive::On),
        _ => None,
    }
}

const BLANKS: [char; 2] = [' ', '\t'];

/// Whether `fmt off` holds at the beginning of a logical line (LANGUAGE §8 rule 10).
pub fn is_switched_off(parse: &Parse, line: usize) -> bool {
    let lines = parse.lines();
    let directive_on = |line: &Line| {
        let may_hold = matches!(line.kind, LineKind::Comment | LineKind::Rail) && line.text().contains("fmt");
        let syntax = may_hold.then(|| line.syntax())?;
        let tokens = syntax.children_with_tokens().filter_map(NodeOrToken::into_token);
        let mut comments = tokens.filter(|token| token.kind() == COMMENT);
        let first = comments.next()?;
        if comments.next().is_some() {
            return None;
        }
        directive(first.text())
    };
    let above = lines.iter().take(line);
    above.filter_map(directive_on).last() == Some(Directive::Off)
}

/// The directive that is alone on a line.
fn directive_line(source: Source<'_>, line: usize) -> Option<Directive> {
    if !matches!(source.kind(line), LineKind::Comment | LineKind::Rail) {
        return None;
    }
    let mut comments = source
        .line(line)
        .children()
        .filter(|child| child.kind() == COMMENT);
    let first = comments.next()?;
    if comments.next().is_some() {
        return None;
    }
    directive(&source.text[first.range()])
}
