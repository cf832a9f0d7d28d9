//! Which lines stay as they are (LANGUAGE §8 rule 10), before any network is read.

use crate::pieces::kind_of_raw;
use ladder_syntax::SyntaxKind::{self, COMMENT};
use ladder_syntax::rowan::NodeOrToken;
use ladder_syntax::{Item, Line, LineKind, Network, Parse, SyntaxErrorKind};
use std::ops::Range;

/// For each logical line whether it stays to the letter.
pub(crate) struct Stays {
    lines: Vec<bool>,
}

impl Stays {
    /// What is known without looking into the rungs.
    pub(crate) fn find(parse: &Parse, text: &str) -> Stays {
        let mut stays = Stays {
            lines: vec![false; parse.lines().len()],
        };
        stays.switched_off(parse);
        if let Some(line) = unclosed_comment_line(parse) {
            stays.keep(line..parse.lines().len());
        }
        stays.split_lines(parse, text);
        stays.broken_sections(parse);
        stays.broken_networks(parse);
        stays
    }

    /// Whether a line stays.
    pub(crate) fn line(&self, line: usize) -> bool {
        self.lines[line]
    }

    /// Whether one of some lines stays.
    pub(crate) fn any(&self, lines: Range<usize>) -> bool {
        self.lines[lines].contains(&true)
    }

    /// The lines stay.
    pub(crate) fn keep(&mut self, lines: Range<usize>) {
        self.lines[lines].fill(true);
    }

    /// What stands between `fmt off` and `fmt on`.
    fn switched_off(&mut self, parse: &Parse) {
        let mut off = None;
        for (index, line) in parse.lines().iter().enumerate() {
            match directive_line(line) {
                Some(Directive::Off) if off.is_none() => off = Some(index + 1),
                Some(Directive::On) => {
                    if let Some(start) = off.take() {
                        self.keep(start..index);
                    }
                }
                _ => {}
            }
        }
        if let Some(start) = off {
            self.keep(start..parse.lines().len());
        }
    }

    /// Two things on one physical line, which is a mistake: a new line end between them would take it away.
    fn split_lines(&mut self, parse: &Parse, text: &str) {
        let mut before: Option<Range<usize>> = None;
        for item in &parse.structure().items {
            let lines = item_lines(parse, *item);
            let start = usize::from(parse.line_start(lines.start));
            if start > 0 && !text[..start].ends_with(['\n', '\r']) {
                if let Some(before) = before {
                    self.keep(before);
                }
                self.keep(lines.clone());
            }
            before = Some(lines);
        }
    }

    fn broken_sections(&mut self, parse: &Parse) {
        let items = &parse.structure().items;
        for (index, item) in items.iter().enumerate() {
            let &Item::Section(number) = item else { continue };
            let section = &parse.structure().sections[number];
            let lines = &parse.lines()[section.lines.clone()];
            if self.any(section.lines.clone())
                || !section.closed
                || lines
                    .iter()
                    .any(|line| !line.errors.is_empty() || has_comment_inside(line))
                || section
                    .lines
                    .clone()
                    .any(|line| directive_line(&parse.lines()[line]).is_some())
            {
                self.keep(section.lines.clone());
            }
            if section.closed {
                continue;
            }
            // A section without END_VAR ends where the drawing begins. What does it must go on doing so: the
            // lines behind it, and a network that need not begin with a rail.
            for item in &items[index + 1..] {
                match item {
                    Item::Decoration(line) => self.keep(*line..*line + 1),
                    Item::Network(number) => {
                        let network = &parse.structure().networks[*number];
                        if !begins_at_rail(&parse.lines()[network.lines.start]) {
                            self.keep(network.lines.clone());
                        }
                        break;
                    }
                    _ => break,
                }
            }
        }
    }

    fn broken_networks(&mut self, parse: &Parse) {
        for network in &parse.structure().networks {
            let cut = || {
                let mut lines = parse.lines()[network.lines.clone()].iter();
                network.lines.len() > 1
                    && lines.any(|line| line.kind == LineKind::Stray || directive_line(line).is_some())
            };
            if self.any(network.lines.clone()) || is_broken(parse, network) || cut() {
                self.keep(network.lines.clone());
            }
        }
    }
}

/// The lines of an item.
pub(crate) fn item_lines(parse: &Parse, item: Item) -> Range<usize> {
    let structure = parse.structure();
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

/// Whether a network has a mistake that makes its drawing uncertain.
fn is_broken(parse: &Parse, network: &Network) -> bool {
    let mut downs_above = 0;
    for rung in network.rungs(parse.lines()) {
        let line = &parse.lines()[rung];
        let uncertain = line.errors.iter().any(|error| {
            matches!(
                error.kind,
                SyntaxErrorKind::UnclosedBlock { .. }
                    | SyntaxErrorKind::UnexpectedCharacter { .. }
                    | SyntaxErrorKind::UnclosedComment
                    | SyntaxErrorKind::UnclosedString
            )
        });
        if uncertain || line.ups != downs_above {
            return true;
        }
        downs_above = line.downs;
    }
    downs_above != 0
}

/// Whether a rung's first drawing is the left rail's `+`, comments aside.
fn begins_at_rail(rung: &Line) -> bool {
    let first = rung
        .green()
        .children()
        .map(|child| match child {
            NodeOrToken::Node(node) => kind_of_raw(node.kind()),
            NodeOrToken::Token(token) => kind_of_raw(token.kind()),
        })
        .find(|kind| !kind.is_trivia() && *kind != SyntaxKind::RAIL);
    first == Some(SyntaxKind::RAIL_CONNECTOR)
}

/// Whether a comment stands before the last token of a line of a section that is not one.
fn has_comment_inside(line: &Line) -> bool {
    if matches!(line.kind, LineKind::Comment | LineKind::Blank) {
        return false;
    }
    let mut comment = false;
    for token in tokens(line) {
        if token == COMMENT {
            comment = true;
        } else if comment && !token.is_trivia() {
            return true;
        }
    }
    false
}

/// The kinds of all tokens of a line.
fn tokens(line: &Line) -> impl Iterator<Item = SyntaxKind> + use<> {
    line.syntax()
        .descendants_with_tokens()
        .filter_map(NodeOrToken::into_token)
        .map(|token| token.kind())
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

/// The directive that stands alone on a line.
fn directive_line(line: &Line) -> Option<Directive> {
    if !matches!(line.kind, LineKind::Comment | LineKind::Rail) {
        return None;
    }
    let mut comments = line
        .green()
        .children()
        .filter_map(NodeOrToken::into_token)
        .filter(|token| kind_of_raw(token.kind()) == COMMENT);
    let first = comments.next()?;
    if comments.next().is_some() {
        return None;
    }
    directive(first.text())
}

/// The line of the place at which `unclosed-comment` is reported: the first comment that holds a line which
/// looks like drawing, else the one that is never closed.
fn unclosed_comment_line(parse: &Parse) -> Option<usize> {
    let last = parse.lines().last()?;
    if !last
        .errors
        .iter()
        .any(|e| e.kind == SyntaxErrorKind::UnclosedComment)
    {
        return None;
    }
    let holds_drawing = |line: &Line| {
        line.syntax()
            .descendants_with_tokens()
            .filter_map(NodeOrToken::into_token)
            .filter(|token| token.kind() == COMMENT)
            .any(|token| {
                let mut lines = token.text().split(['\n', '\r']).skip(1);
                lines.any(|line| line.starts_with(['+', '|', '/']))
            })
    };
    let first = parse.lines().iter().position(holds_drawing);
    Some(first.unwrap_or(parse.lines().len() - 1))
}
