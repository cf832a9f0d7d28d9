//! From statements to networks: one statement is one network or a few, in its order.

mod call;
mod cases;
mod condition;
mod conversion;
mod enabled;
mod expression;
mod function;
mod literal;
mod loops;
mod part;
mod pieces;
mod place;
mod restarted;
mod statement;
mod timed;
mod unread;
mod value;

use super::body::Body;
use super::dialect::Dialect;
use super::scope::{Scope, Type};
use super::token::Comment;
use super::tree::{Expression, ExpressionKind, LiteralKind, Span, Statement};
use super::uses::Uses;
pub(super) use function::plain_types;
use ladder_analysis::values::types::{Scalar, passes};
use ladder_format::Circuit;
use ladder_format::program::{Block, Declaration, Drawing, Element, Head, Item, Network, Operand, Path};
use ladder_instructions::Shape as Brackets;
use ladder_notation::{Lines, Names, UnreadParts, folded};
pub(super) use part::bits_of;
pub(super) use pieces::{Piece, What, lower_pieces};
pub(super) use place::address;
pub use restarted::Restarted;
use std::collections::{HashMap, HashSet};
pub(super) use unread::leaves;
use value::Value;

/// An instruction of the other system that is called like a function: its name, its operands, the whole text and the origin.
/// It becomes the blocks of networks one after the other.
pub type Instructions<'i> =
    dyn Fn(&str, &[&str], &str, Option<u32>) -> Result<Vec<Circuit<Element>>, String> + 'i;

/// Why something is not read: a sentence without its point.
type Lowered<T> = Result<T, String>;

/// A statement is shown as a comment if it is no longer.
const LONGEST_COMMENT: usize = 72;

/// Where a body is.
pub(super) struct Surroundings<'a> {
    pub(super) text: &'a str,
    pub(super) lines: &'a Lines,
    pub(super) dialect: Dialect,
    /// What the unit is called there.
    pub(super) unit: &'a str,
    pub(super) scope: &'a Scope,
    pub(super) comments: &'a [Comment],
    pub(super) instructions: Option<&'a Instructions<'a>>,
    /// The origins of the elements begin with this number.
    pub(super) first_origin: u32,
    /// Labels have higher numbers than this.
    pub(super) first_label: u32,
}

/// The networks of some statements. Where the body is unread as a whole, no part of it is among the others.
pub(super) fn lower(
    statements: &[Statement],
    around: &Surroundings<'_>,
    restarted: &[Restarted],
    names: &mut Names,
    unread: &mut UnreadParts,
) -> Body {
    let parts = unread.len();
    let mut lowering = Lowering::new(around, Uses::of(statements, around.scope), names, unread);
    lowering.restarted(restarted, statements);
    lowering.all(statements);
    lowering.forget_unused();
    let body = lowering.body;
    if body.unread.is_some() {
        unread.truncate(parts);
    }
    body
}

pub(super) struct Lowering<'a, 'n> {
    around: &'a Surroundings<'a>,
    /// The number of the first origin of the body.
    first_origin: u32,
    uses: Uses<'a>,
    names: &'n mut Names,
    unread: &'n mut UnreadParts,
    body: Body,
    /// Labels that the next network begins with.
    labels: Vec<String>,
    /// Blocks that the next network begins with: what the statement needs first.
    chain: Vec<Element>,
    /// What is above the next network.
    comments: Vec<String>,
    next_comment: usize,
    origin: Option<u32>,
    /// Tags of the reader's own that nothing needs any more, and those that the statement uses.
    free: HashMap<Scalar, Vec<String>>,
    used: Vec<(Scalar, String)>,
    temporaries: u32,
    /// How many labels of each word there are.
    numbers: HashMap<&'static str, u32>,
    loops: Vec<loops::Loop>,
    /// Branches and loops around the statement.
    depth: u32,
    /// Tags in the place of inputs of timers and counters that are written as members, and of what edge detectors remember.
    beside: HashMap<String, String>,
    /// The instances that have a block already, and what that makes of the next one.
    instances: HashSet<String>,
    directives: Vec<String>,
}

/// How far the body was before a statement.
struct State {
    items: usize,
    comments: Vec<String>,
    next_comment: usize,
    entries: usize,
    chain: Vec<Element>,
    used: usize,
    loops: usize,
    labels: Vec<String>,
    unread: usize,
}

impl<'a, 'n> Lowering<'a, 'n> {
    fn new(
        around: &'a Surroundings<'a>,
        uses: Uses<'a>,
        names: &'n mut Names,
        unread: &'n mut UnreadParts,
    ) -> Lowering<'a, 'n> {
        Lowering {
            around,
            first_origin: around.first_origin,
            uses,
            names,
            unread,
            body: Body {
                last_label: around.first_label,
                ..Body::default()
            },
            labels: Vec::new(),
            chain: Vec::new(),
            comments: Vec::new(),
            next_comment: 0,
            origin: None,
            free: HashMap::new(),
            used: Vec::new(),
            temporaries: 0,
            numbers: HashMap::new(),
            loops: Vec::new(),
            depth: 0,
            beside: HashMap::new(),
            instances: HashSet::new(),
            directives: Vec::new(),
        }
    }
}

impl Lowering<'_, '_> {
    /// The statements of a text, with the comments around them.
    fn all(&mut self, statements: &[Statement]) {
        self.skip_comments_before(statements.first().map_or(0, |first| first.span.start));
        self.statements(statements);
        if !self.labels.is_empty() {
            self.network(Vec::new());
        }
        self.trailing_comments(statements.last().map_or(0, |last| last.span.end));
    }

    /// A block after what the statement has done so far.
    fn act(&mut self, block: Block) {
        self.chain.push(Element::of(block, self.origin));
    }

    fn element(&self, block: Block) -> Circuit<Element> {
        Circuit::Element(Element::of(block, self.origin))
    }

    /// Ends a network: labels, what the statement needs first, and this.
    fn network(&mut self, then: Vec<Circuit<Element>>) {
        let labels = std::mem::take(&mut self.labels);
        let mut parts: Vec<_> = labels
            .iter()
            .map(|label| self.element(Block::label(label)))
            .collect();
        parts.extend(std::mem::take(&mut self.chain).into_iter().map(Circuit::Element));
        parts.extend(then);
        if parts.is_empty() {
            return;
        }
        let comments = std::mem::take(&mut self.comments);
        let drawing = Drawing::Circuit(Circuit::Series(parts));
        // What belongs together is together: a comment begins the next part.
        if !comments.is_empty() || !self.directives.is_empty() || self.body.items.is_empty() {
            self.body.items.push(Item::Blank);
        }
        self.body
            .items
            .extend(self.directives.drain(..).map(Item::Directive));
        self.body.items.push(Item::Network(Network { comments, drawing }));
    }

    /// Ends a network if there is anything that the statement has done.
    fn flush(&mut self) {
        if !self.chain.is_empty() {
            self.network(Vec::new());
        }
    }

    /// The label of a place that the next network is at.
    fn label(&mut self, label: &str) {
        self.labels.push(label.to_owned());
    }

    /// A label that the body does not have.
    fn new_label(&mut self, word: &'static str) -> String {
        let first = self.around.first_label;
        let number = self.numbers.entry(word).or_insert(first);
        *number += 1;
        self.body.last_label = self.body.last_label.max(*number);
        format!("{word}{number}")
    }

    fn jump(&self, label: &str) -> Circuit<Element> {
        self.element(Block::jump(label))
    }

    /// A tag of the reader's own. It is used again once the statement is done.
    fn temporary(&mut self, ty: Scalar) -> Path {
        let name = self.free.get_mut(&ty).and_then(Vec::pop);
        let name = name.unwrap_or_else(|| self.held(ty));
        self.used.push((ty, name.clone()));
        Path::tag(name)
    }

    /// A tag of the reader's own that nothing else uses.
    fn held(&mut self, ty: Scalar) -> String {
        self.temporaries += 1;
        let name = self.names.fresh(&format!("st{}", self.temporaries));
        self.body
            .tags
            .push(Declaration::new(name.clone(), ty.to_string()));
        name
    }

    /// A tag of the reader's own that holds all of a structure, an array or an enumeration.
    fn compound(&mut self, ty: &Type) -> Lowered<Path> {
        let text = ty.text().ok_or("a value of such a type is not held here")?;
        self.temporaries += 1;
        let name = self.names.fresh(&format!("st{}", self.temporaries));
        self.body.tags.push(Declaration::new(name.clone(), text));
        Ok(Path::tag(name))
    }

    /// The statement is done: what it used is free.
    fn release(&mut self, from: usize) {
        for (ty, name) in self.used.drain(from..) {
            self.free.entry(ty).or_default().push(name);
        }
    }

    fn state(&self) -> State {
        State {
            items: self.body.items.len(),
            comments: self.comments.clone(),
            next_comment: self.next_comment,
            entries: self.body.entries.len(),
            chain: self.chain.clone(),
            used: self.used.len(),
            loops: self.loops.len(),
            labels: self.labels.clone(),
            unread: self.unread.len(),
        }
    }

    /// Forgets what a statement has made.
    fn restore(&mut self, state: State) {
        self.body.items.truncate(state.items);
        self.comments = state.comments;
        self.next_comment = state.next_comment;
        self.body.entries.truncate(state.entries);
        self.release(state.used);
        self.loops.truncate(state.loops);
        self.labels = state.labels;
        self.chain = state.chain;
        self.directives.clear();
        self.unread.truncate(state.unread);
    }

    /// Leaves out the tags of the reader's own that no network has.
    fn forget_unused(&mut self) {
        self.body.used = used(&mut self.body.items);
        let used = &self.body.used;
        self.body
            .tags
            .retain(|tag| tag.names.iter().any(|name| used.contains(name)));
    }

    fn is_temporary(&self, path: &Path) -> bool {
        path.steps.is_empty() && self.used.iter().any(|(_, name)| *name == path.root)
    }

    /// Makes a value that is what the last block made go into another place at once.
    fn retarget(&mut self, value: &Value, to: &Path) -> bool {
        let Some(path) = value.expression.path().filter(|path| self.is_temporary(path)) else {
            return false;
        };
        let Some(block) = self.chain.last().and_then(Element::as_block) else {
            return false;
        };
        let is_it = |operand: &Operand| operand.value().path() == Some(path);
        let mut operands = block.operands().to_vec();
        let made = match block.head() {
            Head::Instruction(op)
                if operands.first().is_some_and(is_it) && !operands[1..].iter().any(is_it) =>
            {
                operands[0] = to.into();
                Block::of(*op, operands)
            }
            Head::User(Brackets::Logical, name) => {
                let Some(Operand::Taken(_, last)) = operands.last_mut().filter(|last| is_it(last)) else {
                    return false;
                };
                *last = to.into();
                Block::user(name.clone(), operands)
            }
            _ => return false,
        };
        let Ok(made) = made else { return false };
        self.chain.pop();
        self.act(made);
        true
    }

    /// What the comments before a place say is above the next network.
    fn take_comments(&mut self, before: usize) {
        while let Some(comment) = self.around.comments.get(self.next_comment) {
            if comment.span.start >= before {
                break;
            }
            let told = comment_of(&comment.text);
            self.comments.extend(Some(told).filter(|told| !told.is_empty()));
            self.next_comment += 1;
        }
    }

    fn skip_comments_before(&mut self, start: usize) {
        let comments = self.around.comments;
        self.next_comment = comments.partition_point(|comment| comment.span.end <= start);
        // Those between the declarations and the first statement belong to it.
        while let Some(last) = self.next_comment.checked_sub(1) {
            let gap = &self.around.text[comments[last].span.end..];
            let next = comments
                .get(self.next_comment)
                .map_or(start, |next| next.span.start.min(start));
            if !gap[..next.saturating_sub(comments[last].span.end)]
                .trim()
                .is_empty()
            {
                break;
            }
            self.next_comment = last;
        }
    }

    /// Comments after a place on the same line.
    fn comments_on_line(&mut self, end: usize) {
        let rest = &self.around.text[end..];
        let line = rest.find('\n').unwrap_or(rest.len());
        let code = rest[..line]
            .find(|c: char| c.is_alphanumeric() || c == '(' || c == '/')
            .unwrap_or(line);
        let is_comment = rest[code..].starts_with("(*")
            || rest[code..].starts_with("//")
            || rest[code..].starts_with("/*");
        if is_comment {
            self.take_comments(end + code + 1);
        }
    }

    fn trailing_comments(&mut self, end: usize) {
        self.take_comments(end);
        self.comments_on_line(end);
        self.body
            .items
            .extend(std::mem::take(&mut self.comments).into_iter().map(Item::Comment));
    }

    /// The text of something, as a comment if it is short.
    fn shown(&self, span: &Span) -> Option<String> {
        let text = self.around.text.get(span.clone())?.trim();
        let is_short = !text.contains(['\n', '\r']) && text.chars().count() <= LONGEST_COMMENT;
        is_short.then(|| comment_of(text))
    }
}

/// The tags that are in networks.
fn used(items: &mut [Item]) -> HashSet<String> {
    let mut used = HashSet::new();
    for item in items {
        let Item::Network(Network {
            drawing: Drawing::Circuit(circuit),
            ..
        }) = item
        else {
            continue;
        };
        circuit.for_each_mut(&mut |element| {
            if let Some(block) = element.as_block() {
                block.paths(|path| {
                    used.insert(path.root.clone());
                });
            }
        });
    }
    used
}

/// The number that digits are, where they are no more than digits and their base.
pub(super) fn plain_number(text: &str) -> Option<i128> {
    literal::number_of(text)
}

/// A tree of numbers as an expression of ladder text.
fn formula(tree: &Expression, scope: &Scope) -> Option<ladder_format::program::Expression> {
    use ladder_format::program::Expression as Formula;
    Some(match &tree.kind {
        ExpressionKind::Literal(kind @ (LiteralKind::Integer | LiteralKind::Real), text) => {
            literal::literal(*kind, text, scope).ok()?.expression
        }
        ExpressionKind::Group(inner) => Formula::Group(Box::new(formula(inner, scope)?)),
        ExpressionKind::Unary(sign, inner) => Formula::Unary(*sign, Box::new(formula(inner, scope)?)),
        ExpressionKind::Binary(operator, left, right) => {
            formula(left, scope)?.with(*operator, formula(right, scope)?)
        }
        _ => return None,
    })
}

/// A constant as ladder text writes it.
pub(super) fn constant(tree: &Expression, ty: Scalar, scope: &Scope) -> Lowered<String> {
    let (kind, text) = match &tree.kind {
        ExpressionKind::Literal(kind, text) => (*kind, text.clone()),
        ExpressionKind::Group(inner) => return constant(inner, ty, scope),
        ExpressionKind::Place(place) if place.steps.is_empty() => {
            let truth = ["TRUE", "FALSE"]
                .into_iter()
                .find(|own| own.eq_ignore_ascii_case(&place.root));
            if let Some(truth) = truth.filter(|_| ty == Scalar::Bool) {
                return Ok(truth.to_owned());
            }
            let known = scope.known(&place.root).filter(|known| known.is_constant);
            let known = known.ok_or_else(|| format!("`{}` is not a constant", place.root))?;
            return Ok(known.path.to_string());
        }
        _ => {
            let number = formula(tree, scope).and_then(|formula| folded(&formula, &|_| None));
            let number = number.ok_or("an initial value that is computed is not read")?;
            let is_whole = literal::number_of(number.as_str()).is_some();
            let kind = if is_whole {
                LiteralKind::Integer
            } else {
                LiteralKind::Real
            };
            (kind, number.as_str().to_owned())
        }
    };
    let value = literal::literal(kind, &text, scope)?;
    let own = value.scalar();
    let (number, last) = value.range;
    if ty == Scalar::Bool && value.is_free && number == last {
        return Ok(if number == 0 { "FALSE" } else { "TRUE" }.to_owned());
    }
    // A pattern of bits is the number that it is in the type.
    if let Some((low, high)) = ty.bounds()
        && value.is_free
        && number == last
        && !(low..=high).contains(&number)
        && number < 1 << ty.width()
    {
        return Ok((number - (1 << ty.width())).to_string());
    }
    let fits = value.is_free || own == Some(ty) || own.is_some_and(|own| passes(own, ty));
    if fits {
        Ok(value.expression.to_string())
    } else {
        Err("an initial value is of another type".to_owned())
    }
}

/// A text of the other system as a comment, which cannot hold `#`: `T#5s` is `5s`, `16#FF` is `16|FF`, `#x` is `x`.
pub(super) fn comment_of(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find('#') {
        let before = &rest[..at];
        let word = before
            .rfind(|c: char| !c.is_alphanumeric() && c != '_')
            .map_or(0, |last| {
                last + before[last..].chars().next().map_or(1, char::len_utf8)
            });
        let prefix = &before[word..];
        out.push_str(&before[..word]);
        if prefix.starts_with(|c: char| c.is_ascii_digit()) {
            out.push_str(prefix);
            out.push('|');
        } else if super::scope::elementary(prefix).is_none()
            && !prefix.eq_ignore_ascii_case("T")
            && !prefix.is_empty()
        {
            out.push_str(prefix);
            out.push('.');
        }
        rest = &rest[at + 1..];
    }
    out + rest
}
