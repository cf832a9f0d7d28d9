//! Typed views of the tree: each wraps a node and gives names to its parts. A part that a half-written text
//! lacks is `None`.

use crate::{SyntaxKind, SyntaxNode, SyntaxToken};
use rowan::TextRange;

/// A typed view of a node.
pub trait AstNode: Sized {
    /// The view, if the node is of a kind that it fits.
    fn cast(node: SyntaxNode) -> Option<Self>;
    /// The node.
    fn syntax(&self) -> &SyntaxNode;
    /// The node's range.
    fn range(&self) -> TextRange {
        self.syntax().text_range()
    }
}

macro_rules! ast_node {
    ($(#[$doc:meta])* $name:ident = $($kind:ident)|+) => {
        $(#[$doc])*
        #[derive(Debug, Clone, PartialEq, Eq, Hash)]
        pub struct $name(SyntaxNode);

        impl AstNode for $name {
            fn cast(node: SyntaxNode) -> Option<Self> {
                matches!(node.kind(), $(SyntaxKind::$kind)|+).then_some($name(node))
            }
            fn syntax(&self) -> &SyntaxNode {
                &self.0
            }
        }
    };
}

ast_node!(
    /// A block on a rung.
    Block = LOGICAL_BLOCK | COIL_BLOCK | FUNCTION_BLOCK
);
ast_node!(
    /// The first part of a block, with its brackets.
    BlockHead = BLOCK_HEAD
);
ast_node!(
    /// The parentheses with the operands.
    OperandList = OPERAND_LIST
);
ast_node!(
    /// `R := reset` or `FOUND => hit`.
    NamedOperand = NAMED_OPERAND
);
ast_node!(
    /// One declaration.
    Declaration = DECLARATION
);
ast_node!(
    /// The first line of a section.
    SectionHeader = SECTION_HEADER
);
ast_node!(
    /// The first line of a block definition.
    BlockHeader = BLOCK_HEADER
);
ast_node!(
    /// A declared type.
    TypeRef = TYPE_REF
);

/// The brackets of a block's first part.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BlockShape {
    /// `[..]`
    Logical,
    /// `(..)`
    Coil,
    /// `<..>`
    Function,
}

/// What a block's first part names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum HeadName {
    /// Nothing: `[ ]`, `( )`.
    Blank,
    /// `TON`, `/`.
    Mnemonic(SyntaxToken),
    /// `$Name` of a user-defined block.
    User(SyntaxToken),
}

impl Block {
    /// The brackets.
    pub fn shape(&self) -> BlockShape {
        match self.0.kind() {
            SyntaxKind::LOGICAL_BLOCK => BlockShape::Logical,
            SyntaxKind::COIL_BLOCK => BlockShape::Coil,
            _ => BlockShape::Function,
        }
    }

    /// The first part.
    pub fn head(&self) -> Option<BlockHead> {
        child(&self.0)
    }

    /// The operand list.
    pub fn operand_list(&self) -> Option<OperandList> {
        child(&self.0)
    }

    /// The operands in the order in which they stand.
    pub fn operands(&self) -> impl Iterator<Item = Operand> + use<> {
        self.operand_list().into_iter().flat_map(|list| list.operands())
    }
}

impl BlockHead {
    /// What it names.
    pub fn name(&self) -> HeadName {
        tokens(&self.0)
            .find_map(|token| match token.kind() {
                SyntaxKind::MNEMONIC => Some(HeadName::Mnemonic(token)),
                SyntaxKind::BLOCK_NAME => Some(HeadName::User(token)),
                _ => None,
            })
            .unwrap_or(HeadName::Blank)
    }

    /// The shape of its brackets.
    pub fn shape(&self) -> BlockShape {
        match self.0.first_token().map(|t| t.kind()) {
            Some(SyntaxKind::L_PAREN) => BlockShape::Coil,
            Some(SyntaxKind::L_ANGLE) => BlockShape::Function,
            _ => BlockShape::Logical,
        }
    }
}

impl OperandList {
    /// The operands in the order in which they stand.
    pub fn operands(&self) -> impl Iterator<Item = Operand> + use<> {
        self.0.children().filter_map(Operand::cast)
    }
}

/// One operand of a block.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Operand {
    /// By place.
    Positional(Expression),
    /// By name.
    Named(NamedOperand),
}

impl Operand {
    fn cast(node: SyntaxNode) -> Option<Operand> {
        if node.kind() == SyntaxKind::NAMED_OPERAND {
            return Some(Operand::Named(NamedOperand(node)));
        }
        Expression::cast(node).map(Operand::Positional)
    }

    /// The operand's range, name included.
    pub fn range(&self) -> TextRange {
        match self {
            Operand::Positional(e) => e.range(),
            Operand::Named(n) => n.range(),
        }
    }

    /// The value, without a name.
    pub fn value(&self) -> Option<Expression> {
        match self {
            Operand::Positional(e) => Some(e.clone()),
            Operand::Named(n) => n.value(),
        }
    }
}

impl NamedOperand {
    /// The name before `:=` or `=>`, if it is one.
    pub fn name(&self) -> Option<SyntaxToken> {
        match expression_before(&self.0, |kind| {
            matches!(kind, SyntaxKind::ASSIGN | SyntaxKind::ARROW)
        }) {
            Some(Expression::Name(name)) => Some(name),
            _ => None,
        }
    }

    /// `:=` or `=>`.
    pub fn arrow(&self) -> Option<SyntaxToken> {
        tokens(&self.0).find(|t| matches!(t.kind(), SyntaxKind::ASSIGN | SyntaxKind::ARROW))
    }

    /// The value behind it.
    pub fn value(&self) -> Option<Expression> {
        expression_behind(&self.0, |kind| {
            matches!(kind, SyntaxKind::ASSIGN | SyntaxKind::ARROW)
        })
    }
}

/// An expression. Which expressions an operand may be is for the analysis to say.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Expression {
    /// A name.
    Name(SyntaxToken),
    /// `%IX0.0`
    Address(SyntaxToken),
    /// A literal or string.
    Literal(SyntaxToken),
    /// `base.member`
    Member(MemberExpression),
    /// `base[index]`
    Index(IndexExpression),
    /// `-a`, `NOT a`
    Unary(UnaryExpression),
    /// `a + b`
    Binary(BinaryExpression),
    /// `( a )`
    Paren(ParenExpression),
    /// `SQRT(a)`
    Call(CallExpression),
    /// `[1, 2]`
    Array(ArrayExpression),
    /// What could not be read.
    Error(SyntaxNode),
}

ast_node!(
    /// `t1.Q`, `word.3`
    MemberExpression = MEMBER_EXPR
);
ast_node!(
    /// `a[i]`, `a[3..9]`
    IndexExpression = INDEX_EXPR
);
ast_node!(
    /// `3..9`
    RangeExpression = RANGE_EXPR
);
ast_node!(
    /// `-a`, `NOT a`
    UnaryExpression = UNARY_EXPR
);
ast_node!(
    /// `a + b`
    BinaryExpression = BINARY_EXPR
);
ast_node!(
    /// `( a )`
    ParenExpression = PAREN_EXPR
);
ast_node!(
    /// `SQRT(a)`; `4(0)` in an initial value.
    CallExpression = CALL_EXPR
);
ast_node!(
    /// `[1, 2]`
    ArrayExpression = ARRAY_EXPR
);

impl Expression {
    /// The view of an expression node.
    pub fn cast(node: SyntaxNode) -> Option<Expression> {
        Some(match node.kind() {
            SyntaxKind::NAME_EXPR => Expression::Name(node.first_token()?),
            SyntaxKind::ADDRESS_EXPR => Expression::Address(node.first_token()?),
            SyntaxKind::LITERAL_EXPR => Expression::Literal(node.first_token()?),
            SyntaxKind::MEMBER_EXPR => Expression::Member(MemberExpression(node)),
            SyntaxKind::INDEX_EXPR => Expression::Index(IndexExpression(node)),
            SyntaxKind::UNARY_EXPR => Expression::Unary(UnaryExpression(node)),
            SyntaxKind::BINARY_EXPR => Expression::Binary(BinaryExpression(node)),
            SyntaxKind::PAREN_EXPR => Expression::Paren(ParenExpression(node)),
            SyntaxKind::CALL_EXPR => Expression::Call(CallExpression(node)),
            SyntaxKind::ARRAY_EXPR => Expression::Array(ArrayExpression(node)),
            SyntaxKind::ERROR_NODE => Expression::Error(node),
            _ => return None,
        })
    }

    /// Its range.
    pub fn range(&self) -> TextRange {
        match self {
            Expression::Name(t) | Expression::Address(t) | Expression::Literal(t) => t.text_range(),
            Expression::Member(n) => n.range(),
            Expression::Index(n) => n.range(),
            Expression::Unary(n) => n.range(),
            Expression::Binary(n) => n.range(),
            Expression::Paren(n) => n.range(),
            Expression::Call(n) => n.range(),
            Expression::Array(n) => n.range(),
            Expression::Error(n) => n.text_range(),
        }
    }
}

impl MemberExpression {
    /// What stands before the point.
    pub fn base(&self) -> Option<Expression> {
        child_expression(&self.0, 0)
    }

    /// The word or bit number behind the point.
    pub fn member(&self) -> Option<SyntaxToken> {
        tokens(&self.0).find(|t| matches!(t.kind(), SyntaxKind::IDENT | SyntaxKind::LITERAL))
    }
}

impl IndexExpression {
    /// What stands before the bracket.
    pub fn base(&self) -> Option<Expression> {
        child_expression(&self.0, 0)
    }

    /// The index, if it is a single one.
    pub fn index(&self) -> Option<Expression> {
        child_expression(&self.0, 1)
    }

    /// The range, if it is one.
    pub fn range_expression(&self) -> Option<RangeExpression> {
        child(&self.0)
    }
}

impl RangeExpression {
    /// The first element's index.
    pub fn first(&self) -> Option<Expression> {
        expression_before(&self.0, |kind| kind == SyntaxKind::DOT_DOT)
    }

    /// The last element's index.
    pub fn last(&self) -> Option<Expression> {
        expression_behind(&self.0, |kind| kind == SyntaxKind::DOT_DOT)
    }
}

impl UnaryExpression {
    /// `-` or `NOT`.
    pub fn operator(&self) -> Option<SyntaxToken> {
        tokens(&self.0).find(|t| !t.kind().is_trivia())
    }

    /// What it works on.
    pub fn operand(&self) -> Option<Expression> {
        child_expression(&self.0, 0)
    }
}

impl BinaryExpression {
    /// The left side.
    pub fn left(&self) -> Option<Expression> {
        expression_before(&self.0, |kind| !kind.is_trivia())
    }

    /// The operator.
    pub fn operator(&self) -> Option<SyntaxToken> {
        tokens(&self.0).find(|t| !t.kind().is_trivia())
    }

    /// The right side.
    pub fn right(&self) -> Option<Expression> {
        expression_behind(&self.0, |kind| !kind.is_trivia())
    }
}

impl ParenExpression {
    /// What stands in the parentheses.
    pub fn inner(&self) -> Option<Expression> {
        child_expression(&self.0, 0)
    }
}

impl CallExpression {
    /// The function's name (or the count of a repeated initial value).
    pub fn callee(&self) -> Option<Expression> {
        child_expression(&self.0, 0)
    }

    /// The arguments.
    pub fn arguments(&self) -> impl Iterator<Item = Expression> + use<> {
        self.0.children().filter_map(Expression::cast).skip(1)
    }
}

impl ArrayExpression {
    /// The values.
    pub fn values(&self) -> impl Iterator<Item = Expression> + use<> {
        self.0.children().filter_map(Expression::cast)
    }
}

impl Declaration {
    /// The declared names.
    pub fn names(&self) -> impl Iterator<Item = SyntaxToken> + use<> {
        self.0
            .children()
            .filter(|n| n.kind() == SyntaxKind::NAME_LIST)
            .flat_map(|list| tokens(&list))
            .filter(|t| t.kind() == SyntaxKind::IDENT)
    }

    /// The address behind AT.
    pub fn address(&self) -> Option<SyntaxToken> {
        let clause = self.0.children().find(|n| n.kind() == SyntaxKind::AT_CLAUSE)?;
        tokens(&clause).find(|t| t.kind() == SyntaxKind::ADDRESS)
    }

    /// The type.
    pub fn type_ref(&self) -> Option<TypeRef> {
        child(&self.0)
    }

    /// The value behind `:=`.
    pub fn initial_value(&self) -> Option<Expression> {
        let value = self
            .0
            .children()
            .find(|n| n.kind() == SyntaxKind::INITIAL_VALUE)?;
        child_expression(&value, 0)
    }
}

impl TypeRef {
    /// The name of the type, or of the elements' type for an array.
    pub fn name(&self) -> Option<SyntaxToken> {
        tokens(&self.0)
            .filter(|t| matches!(t.kind(), SyntaxKind::KEYWORD | SyntaxKind::IDENT))
            .find(|t| !["ARRAY", "OF"].iter().any(|w| w.eq_ignore_ascii_case(t.text())))
    }

    /// Whether it is an array.
    pub fn is_array(&self) -> bool {
        self.0
            .first_token()
            .is_some_and(|t| t.text().eq_ignore_ascii_case("ARRAY"))
    }

    /// The numbers in it with their signs: an array's bounds, then (or only) a string's length.
    pub fn numbers(&self) -> Vec<(bool, SyntaxToken)> {
        let mut numbers = Vec::new();
        let mut negative = false;
        for token in tokens(&self.0) {
            match token.kind() {
                SyntaxKind::MINUS => negative = true,
                SyntaxKind::LITERAL => numbers.push((std::mem::take(&mut negative), token)),
                _ => {}
            }
        }
        numbers
    }
}

impl SectionHeader {
    /// `VAR`, `VAR_INPUT`, ...
    pub fn section(&self) -> Option<SyntaxToken> {
        tokens(&self.0).find(|t| t.kind() == SyntaxKind::KEYWORD)
    }

    /// `RETAIN`, `CONSTANT`
    pub fn qualifiers(&self) -> impl Iterator<Item = SyntaxToken> + use<> {
        tokens(&self.0)
            .filter(|t| t.kind() == SyntaxKind::KEYWORD)
            .skip(1)
    }
}

impl BlockHeader {
    /// The head that shows the block's shape.
    pub fn head(&self) -> Option<BlockHead> {
        child(&self.0)
    }
}

fn child<N: AstNode>(node: &SyntaxNode) -> Option<N> {
    node.children().find_map(N::cast)
}

fn child_expression(node: &SyntaxNode, nth: usize) -> Option<Expression> {
    node.children().filter_map(Expression::cast).nth(nth)
}

/// The expression that stands before the first token of a kind; none if the token is first.
fn expression_before(node: &SyntaxNode, kind: impl Fn(SyntaxKind) -> bool) -> Option<Expression> {
    let end = tokens(node).find(|t| kind(t.kind()))?.text_range().start();
    child_expression(node, 0).filter(|e| e.range().end() <= end)
}

/// The expression that stands behind the first token of a kind.
fn expression_behind(node: &SyntaxNode, kind: impl Fn(SyntaxKind) -> bool) -> Option<Expression> {
    let start = tokens(node).find(|t| kind(t.kind()))?.text_range().end();
    node.children()
        .filter(|n| n.text_range().start() >= start)
        .find_map(Expression::cast)
}

fn tokens(node: &SyntaxNode) -> impl Iterator<Item = SyntaxToken> + use<> {
    node.children_with_tokens()
        .filter_map(rowan::NodeOrToken::into_token)
}
