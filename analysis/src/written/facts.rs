//! What a network says by itself: its blocks with their operands, before any name is looked up.
//!
//! Facts of a line depend on that line's green node alone; ranges count from the start of the line, so that
//! they stay true when lines above change.

use crate::values::literal::{self, Literal, LiteralProblem};
use ladder_instructions::Shape;
use ladder_syntax::ast::{
    AstNode, Block, BlockShape, Expression, HeadName, IndexExpression, NodeView, Operand, OperandList,
    Subscript, TokenView,
};
use ladder_syntax::rowan::GreenNodeData;
use ladder_syntax::{SyntaxKind, TextRange};
use smol_str::SmolStr;

/// A block on a rung as it is written.
#[derive(Debug, Clone, PartialEq)]
pub struct BlockFacts {
    /// The rung in its network, from 0.
    pub rung: usize,
    /// The part on its rung (an index into the wiring's parts).
    pub part: usize,
    /// The brackets of its first part.
    pub shape: Shape,
    /// What its first part names.
    pub head: Head,
    /// The whole block.
    pub range: TextRange,
    /// The first part with its brackets.
    pub head_range: TextRange,
    /// The operand list with its parentheses, if there is one.
    pub list_range: Option<TextRange>,
    /// The operands in the order in which they are.
    pub operands: Box<[OperandFacts]>,
}

impl BlockFacts {
    /// The name that its first operand is, and where that is: the label of a jump, the function of a call.
    pub(crate) fn first_name(&self) -> Option<(&SmolStr, TextRange)> {
        let operand = &self.operands.first()?.value;
        match &operand.kind {
            NodeKind::Name(name) => Some((name, operand.range)),
            _ => None,
        }
    }
}

/// What a block's first part names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Head {
    /// Nothing, or a mnemonic as it is written.
    Mnemonic(SmolStr),
    /// A user-defined block, with its `$`. Boxed, so that the usual mnemonic takes no word more than its text.
    User(Box<SmolStr>),
}

impl Head {
    /// As it is written, without brackets.
    pub fn text(&self) -> &str {
        match self {
            Head::Mnemonic(text) => text,
            Head::User(text) => text,
        }
    }
}

/// An operand as it is written.
#[derive(Debug, Clone, PartialEq)]
pub struct OperandFacts {
    /// What is before the value, if it is given by name: most are given by place.
    named: Option<Box<NamedOperand>>,
    /// The value.
    pub value: Node,
    /// The operand with its name.
    pub range: TextRange,
}

/// The name of an operand, and what joins it to the value.
#[derive(Debug, Clone, PartialEq)]
struct NamedOperand {
    name: Option<Word>,
    is_arrow: bool,
    arrow: Option<TextRange>,
}

impl OperandFacts {
    /// The name before `:=` or `=>`.
    pub fn name(&self) -> Option<&Word> {
        self.named.as_ref()?.name.as_ref()
    }

    /// Whether it is written with `=>`.
    pub fn has_arrow(&self) -> bool {
        self.named.as_ref().is_some_and(|named| named.is_arrow)
    }

    /// Where `:=` or `=>` is.
    pub fn arrow_range(&self) -> Option<TextRange> {
        self.named.as_ref()?.arrow
    }
}

/// A word and its place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Word {
    /// As written.
    pub text: SmolStr,
    /// Where.
    pub range: TextRange,
}

/// An expression as it is written.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// What it is.
    pub kind: NodeKind,
    /// Where it is.
    pub range: TextRange,
}

impl Node {
    /// The value that it is, if it is a literal.
    pub fn literal(&self) -> Option<&Literal> {
        match &self.kind {
            NodeKind::Literal(literal) => literal.as_ref().as_ref().ok(),
            _ => None,
        }
    }

    /// The name or address that it is.
    pub(crate) fn name(&self) -> Option<&SmolStr> {
        match &self.kind {
            NodeKind::Name(name) | NodeKind::Address(name) => Some(name),
            _ => None,
        }
    }

    /// The name or address that a path begins with.
    pub(crate) fn root_name(&self) -> Option<&SmolStr> {
        match &self.kind {
            NodeKind::Member(base, _)
            | NodeKind::Index(base, _)
            | NodeKind::Range(base, ..)
            | NodeKind::Paren(base) => base.root_name(),
            _ => self.name(),
        }
    }

    /// Every index or bound of a range in it that is written out as a number.
    pub(crate) fn each_index(&self, give: &mut impl FnMut(i64)) {
        let mut number = |node: &Node| {
            if let Some(Literal::Int(n)) = node.literal() {
                give(i64::try_from(*n).unwrap_or(i64::MAX));
            }
        };
        match &self.kind {
            NodeKind::Index(_, index) => number(index),
            NodeKind::Range(_, first, last) => {
                number(first);
                number(last);
            }
            _ => {}
        }
    }
}

/// The forms of an expression. What is seldom met is boxed: a program holds one of these for each operand.
#[derive(Debug, Clone, PartialEq)]
pub enum NodeKind {
    /// A name.
    Name(SmolStr),
    /// A direct address.
    Address(SmolStr),
    /// A literal, or why it is none.
    Literal(Box<Result<Literal, LiteralProblem>>),
    /// `base.member`
    Member(Box<Node>, Box<Word>),
    /// `base[index]`
    Index(Box<Node>, Box<Node>),
    /// `base[first..last]`
    Range(Box<Node>, Box<Node>, Box<Node>),
    /// `-a`, `NOT a`
    Unary(Operator, Box<Node>),
    /// `a + b`
    Binary(Operator, Box<Node>, Box<Node>),
    /// `( a )`
    Paren(Box<Node>),
    /// `SQRT( a )`
    Call(Box<Word>, Box<[Node]>),
    /// `[1, 2, 3]`
    Array(Box<[Node]>),
    /// `(speed := 20.0)` in an initial value.
    Members(Box<[(Word, Node)]>),
    /// `4(0)` in an initial value.
    Repeat(Box<Node>, Box<[Node]>),
    /// Parentheses after something that is not a function's name: `a[1]( 2 )`. It reads well and means nothing.
    NoFunction,
    /// Nothing, or nothing that can be read; the parser said so.
    Missing,
}

/// Operators of expressions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Operator {
    Or,
    Xor,
    And,
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Shl,
    Shr,
    Add,
    Sub,
    Mul,
    Div,
    Mod,
    Power,
    Not,
}

impl Operator {
    /// As it is written.
    pub const fn text(self) -> &'static str {
        match self {
            Operator::Or => "OR",
            Operator::Xor => "XOR",
            Operator::And => "AND",
            Operator::Equal => "=",
            Operator::NotEqual => "<>",
            Operator::Less => "<",
            Operator::LessEqual => "<=",
            Operator::Greater => ">",
            Operator::GreaterEqual => ">=",
            Operator::Shl => "SHL",
            Operator::Shr => "SHR",
            Operator::Add => "+",
            Operator::Sub => "-",
            Operator::Mul => "*",
            Operator::Div => "/",
            Operator::Mod => "MOD",
            Operator::Power => "^",
            Operator::Not => "NOT",
        }
    }
}

/// The blocks of a rung, from left to right, from its line's node. `parts` are the indices of the block parts on it.
pub fn blocks(
    line: &GreenNodeData,
    rung: usize,
    parts: impl Iterator<Item = usize>,
) -> impl Iterator<Item = BlockFacts> {
    NodeView::root(line)
        .children()
        .filter_map(Block::cast)
        .zip(parts)
        .filter_map(move |(block, part)| block_facts(&block, rung, part))
}

fn block_facts(block: &Block<'_>, rung: usize, part: usize) -> Option<BlockFacts> {
    let head = block.head()?;
    let shape = match block.shape() {
        BlockShape::Logical => Shape::Logical,
        BlockShape::Coil => Shape::Coil,
        BlockShape::Function => Shape::Function,
    };
    let name = match head.name() {
        HeadName::Blank => Head::Mnemonic(SmolStr::default()),
        HeadName::Mnemonic(token) => Head::Mnemonic(token.text().into()),
        HeadName::User(token) => Head::User(Box::new(token.text().into())),
    };
    let list = block.operand_list();
    Some(BlockFacts {
        rung,
        part,
        shape,
        head: name,
        range: block.range(),
        head_range: head.range(),
        list_range: list.as_ref().map(AstNode::range),
        operands: list.as_ref().map(operands).unwrap_or_default(),
    })
}

fn operands(list: &OperandList<'_>) -> Box<[OperandFacts]> {
    // Just so many as there are: nothing is to be moved after.
    let mut operands = Vec::with_capacity(list.operands().count());
    operands.extend(list.operands().map(|operand| operand_facts(&operand)));
    operands.into_boxed_slice()
}

fn operand_facts(operand: &Operand<'_>) -> OperandFacts {
    let range = operand.range();
    let value = match operand.value() {
        Some(value) => node(&value),
        None => Node {
            kind: NodeKind::Missing,
            range: TextRange::empty(range.end()),
        },
    };
    match operand {
        Operand::Positional(_) => OperandFacts {
            named: None,
            value,
            range,
        },
        Operand::Named(named) => {
            let arrow = named.arrow();
            OperandFacts {
                named: Some(Box::new(NamedOperand {
                    name: named.name().map(|token| word(token)),
                    is_arrow: arrow
                        .as_ref()
                        .is_some_and(|token| token.kind() == SyntaxKind::ARROW),
                    arrow: arrow.map(TokenView::text_range),
                })),
                value,
                range,
            }
        }
    }
}

fn word(token: TokenView<'_>) -> Word {
    Word {
        text: token.text().into(),
        range: token.text_range(),
    }
}

/// Lowers an expression. Recursion is bounded by the parser's limits on depth and terms.
pub fn node(expression: &Expression<'_>) -> Node {
    let range = expression.range();
    let kind = match expression {
        Expression::Name(token) => NodeKind::Name(token.text().into()),
        Expression::Address(token) => NodeKind::Address(token.text().into()),
        Expression::Literal(token) => NodeKind::Literal(Box::new(literal::literal(token.text()))),
        Expression::Member(member) => match (member.base(), member.member()) {
            (Some(base), Some(token)) => NodeKind::Member(Box::new(node(&base)), Box::new(word(token))),
            _ => NodeKind::Missing,
        },
        Expression::Index(index) => return index_node(index, range),
        Expression::Unary(unary) => match (unary.operator(), unary.operand()) {
            (Some(token), Some(operand)) => {
                let operator = if token.kind() == SyntaxKind::MINUS {
                    Operator::Sub
                } else {
                    Operator::Not
                };
                NodeKind::Unary(operator, Box::new(node(&operand)))
            }
            _ => NodeKind::Missing,
        },
        Expression::Binary(binary) => {
            match (
                binary.operator().and_then(|t| operator(t)),
                binary.left(),
                binary.right(),
            ) {
                (Some(operator), Some(left), Some(right)) => {
                    NodeKind::Binary(operator, Box::new(node(&left)), Box::new(node(&right)))
                }
                _ => NodeKind::Missing,
            }
        }
        Expression::Paren(paren) => match paren.inner() {
            Some(inner) => NodeKind::Paren(Box::new(node(&inner))),
            None => NodeKind::Missing,
        },
        Expression::Call(call) => {
            let arguments = call.arguments().map(|a| node(&a)).collect();
            match call.callee() {
                Some(Expression::Name(token)) => NodeKind::Call(Box::new(word(token)), arguments),
                Some(count @ Expression::Literal(_)) => NodeKind::Repeat(Box::new(node(&count)), arguments),
                Some(_) => NodeKind::NoFunction,
                None => NodeKind::Missing,
            }
        }
        Expression::Array(array) => NodeKind::Array(array.values().map(|v| node(&v)).collect()),
        Expression::Struct(values) => NodeKind::Members(
            values
                .members()
                .filter_map(|member| Some((word(member.name()?), node(&member.value()?))))
                .collect(),
        ),
        Expression::Error(_) => NodeKind::Missing,
    };
    Node { kind, range }
}

/// `a[i, j]` is `a[i][j]`.
fn index_node(index: &IndexExpression<'_>, range: TextRange) -> Node {
    let missing = || Node {
        kind: NodeKind::Missing,
        range,
    };
    let Some(base) = index.base() else {
        return missing();
    };
    let mut found = node(&base);
    let mut is_indexed = false;
    for subscript in index.subscripts() {
        let base = Box::new(found);
        let (kind, end) = match subscript {
            Subscript::Index(at) => (NodeKind::Index(base, Box::new(node(&at))), at.range().end()),
            Subscript::Range(bounds) => match (bounds.first(), bounds.last()) {
                (Some(first), Some(last)) => {
                    let (first, last) = (Box::new(node(&first)), Box::new(node(&last)));
                    (NodeKind::Range(base, first, last), bounds.range().end())
                }
                _ => return missing(),
            },
        };
        found = Node {
            kind,
            range: TextRange::new(range.start(), end),
        };
        is_indexed = true;
    }
    if is_indexed {
        Node { range, ..found }
    } else {
        missing()
    }
}

fn operator(token: TokenView<'_>) -> Option<Operator> {
    Some(match token.kind() {
        SyntaxKind::EQUAL => Operator::Equal,
        SyntaxKind::NOT_EQUAL => Operator::NotEqual,
        SyntaxKind::LESS => Operator::Less,
        SyntaxKind::LESS_EQUAL => Operator::LessEqual,
        SyntaxKind::GREATER => Operator::Greater,
        SyntaxKind::GREATER_EQUAL => Operator::GreaterEqual,
        SyntaxKind::PLUS => Operator::Add,
        SyntaxKind::MINUS => Operator::Sub,
        SyntaxKind::STAR => Operator::Mul,
        SyntaxKind::SLASH => Operator::Div,
        SyntaxKind::CARET => Operator::Power,
        SyntaxKind::WORD_OPERATOR => match token.text().to_ascii_uppercase().as_str() {
            "OR" => Operator::Or,
            "XOR" => Operator::Xor,
            "AND" => Operator::And,
            "SHL" => Operator::Shl,
            "SHR" => Operator::Shr,
            "MOD" => Operator::Mod,
            _ => return None,
        },
        _ => return None,
    })
}
