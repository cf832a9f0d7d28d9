//! What an entry says, as a text that is equal where layout, spelling and comments alone differ.

use ladder_analysis::networks::network::{BoundBlock, Meaning};
use ladder_analysis::networks::{BlockAt, NetworkAt};
use ladder_analysis::program::Step;
use ladder_analysis::written::facts::{Head, Node, NodeKind, OperandFacts};
use ladder_syntax::SyntaxKind::{BOM, COMMENT, NEWLINE, RAIL, STRING, WHITESPACE, WIRE};
use ladder_syntax::{Name, Parse};
use std::fmt::Write;
use std::ops::Range;

/// What an entry says.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Canonical {
    /// All of it.
    pub(crate) key: String,
    /// Its parts: what two entries have in common makes them alike.
    pub(crate) words: Vec<String>,
}

/// What a network says: the order of its evaluation, and its blocks. One that has an error in its text: its words, for its
/// wiring and operands do not hold all of them.
pub(crate) fn network(parse: &Parse, network: NetworkAt<'_>) -> Canonical {
    if network.broken || network.blocks().any(|block| block.faulty) {
        return lines(parse, network.lines());
    }
    let mut told = Canonical::default();
    for step in &network.order.steps {
        // Writing to a String does not fail.
        let _ = match *step {
            Step::Start { rail } => write!(told.key, "{} ", if rail { '+' } else { '~' }),
            Step::Block { block, en } => write!(told.key, "{block}<{en} "),
            Step::Join { upper, lower } => write!(told.key, "{upper}|{lower} "),
        };
    }
    for block in network.blocks() {
        let from = told.words.len();
        add_block(&block, &mut told.words);
        for word in &told.words[from..] {
            told.key.push_str(word);
            told.key.push(' ');
        }
        told.key.push(';');
    }
    told
}

/// What a block says.
pub(crate) fn block(block: BlockAt<'_>) -> String {
    let mut words = Vec::new();
    add_block(&block, &mut words);
    words.join(" ")
}

fn add_block(block: &BoundBlock, words: &mut Vec<String>) {
    let head = match block.meaning {
        // Whichever of its spellings is written.
        Meaning::Instruction(row) => format!("{:?}", row.op),
        Meaning::User(_) | Meaning::UnknownUser | Meaning::Unknown => {
            let name = match &block.facts.head {
                Head::Mnemonic(text) => text,
                Head::User(text) => &**text,
            };
            format!("{:?} {}", block.facts.shape, Name::new(name).as_str())
        }
    };
    let mut operands = block.facts.operands.iter().map(operand);
    // A contact and its tag are one word: neither of them makes two networks alike by itself.
    words.push(match operands.next() {
        Some(first) => format!("{head}({first}"),
        None => head,
    });
    words.extend(operands);
}

fn operand(operand: &OperandFacts) -> String {
    let mut text = String::new();
    if let Some(name) = operand.name() {
        text.push_str(Name::new(&name.text).as_str());
        text.push_str(":=");
    }
    expression(&operand.value, &mut text);
    text
}

/// Depth is bounded by the parser's limits.
fn expression(node: &Node, out: &mut String) {
    let list = |name: &str, nodes: &[Node], out: &mut String| {
        out.push_str(name);
        for node in nodes {
            expression(node, out);
            out.push(',');
        }
        out.push(')');
    };
    match &node.kind {
        NodeKind::Name(name) | NodeKind::Address(name) => out.push_str(Name::new(name).as_str()),
        NodeKind::Literal(literal) => {
            let _ = match &**literal {
                Ok(literal) => write!(out, "{literal:?}"),
                Err(problem) => write!(out, "{problem:?}"),
            };
        }
        NodeKind::Member(base, word) => {
            expression(base, out);
            out.push('.');
            out.push_str(Name::new(&word.text).as_str());
        }
        NodeKind::Index(base, index) => {
            expression(base, out);
            list("[", std::slice::from_ref(&**index), out);
        }
        NodeKind::Range(base, first, last) => {
            expression(base, out);
            out.push('[');
            expression(first, out);
            out.push_str("..");
            expression(last, out);
            out.push(']');
        }
        NodeKind::Unary(operator, inner) => list(operator.text(), std::slice::from_ref(&**inner), out),
        NodeKind::Binary(operator, left, right) => {
            out.push('(');
            expression(left, out);
            let _ = write!(out, " {} ", operator.text());
            expression(right, out);
            out.push(')');
        }
        NodeKind::Paren(inner) => expression(inner, out),
        NodeKind::Call(name, arguments) => {
            let name = format!("{}(", Name::new(&name.text).as_str());
            list(&name, arguments, out);
        }
        NodeKind::Array(values) => list("array(", values, out),
        NodeKind::Members(members) => {
            for (name, value) in members {
                out.push_str(Name::new(&name.text).as_str());
                out.push_str(":=");
                expression(value, out);
                out.push(',');
            }
        }
        NodeKind::Repeat(count, values) => {
            expression(count, out);
            list("(", values, out);
        }
        NodeKind::NoFunction => out.push_str("?()"),
        NodeKind::Missing => out.push('?'),
    }
}

/// What some lines say: their words, without blanks, comments, rails, the length of wires and the
/// case of letters outside of strings.
pub(crate) fn lines(parse: &Parse, lines: Range<usize>) -> Canonical {
    let mut told = Canonical::default();
    for line in parse.lines().range(lines) {
        let tokens = line.syntax();
        let tokens = tokens.descendants_with_tokens();
        for token in tokens.filter_map(ladder_syntax::NodeOrToken::into_token) {
            let word = match token.kind() {
                WHITESPACE | NEWLINE | BOM | COMMENT | RAIL => continue,
                STRING => token.text().to_owned(),
                WIRE => "-".to_owned(),
                _ => Name::new(token.text()).as_str().to_owned(),
            };
            told.key.push_str(&word);
            told.key.push(' ');
            told.words.push(word);
        }
    }
    told
}

/// The comments on some lines, one after the other, without the blanks around and in them.
pub(crate) fn comments(parse: &Parse, lines: Range<usize>) -> String {
    let mut told = String::new();
    for line in parse.lines().range(lines) {
        if !line.text().contains('#') {
            continue;
        }
        let tokens = line.syntax();
        let tokens = tokens.descendants_with_tokens();
        let tokens = tokens.filter_map(ladder_syntax::NodeOrToken::into_token);
        for token in tokens.filter(|token| token.kind() == COMMENT) {
            for word in token.text().split_whitespace() {
                told.push_str(word);
                told.push(' ');
            }
        }
    }
    told
}
