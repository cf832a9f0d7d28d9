//! Blocks and values that a person has written as ladder text already, as those of a sketch.

use super::block::{Block, Invalid, Operand};
use super::expression::{Expression, Operator, Sign};
use super::path::{Path, Step};
use ladder_instructions::Shape;
use ladder_syntax::ast::{self, AstNode, BlockShape, HeadName, NodeView, Subscript};
use ladder_syntax::{SyntaxKind, parse};

impl Block {
    /// The block that a text is: `[TON]( t, 5s )`.
    ///
    /// # Errors
    ///
    /// If it is not one, or one that the table of instructions does not have.
    pub fn read(text: &str) -> Result<Block, Invalid> {
        let why = || Invalid(format!("`{text}` is not a block that can be written here"));
        let line = format!("+--{}--+", text.trim());
        let parse = parse(&line);
        let [line] = parse.lines().iter().collect::<Vec<_>>()[..] else {
            return Err(why());
        };
        if !line.errors.is_empty() {
            return Err(why());
        }
        let tree = line.tree();
        let mut blocks = NodeView::root(&tree).children().filter_map(ast::Block::cast);
        match (blocks.next(), blocks.next()) {
            (Some(block), None) if usize::from(block.range().len()) == text.trim().len() => {
                block_of(block).ok_or_else(why)?
            }
            _ => Err(why()),
        }
    }
}

/// A block of a tree. None: it lacks something.
pub(super) fn block_of(block: ast::Block<'_>) -> Option<Result<Block, Invalid>> {
    let operands: Option<Vec<Operand>> = block.operands().map(operand).collect();
    let operands = operands?;
    let shape = match block.shape() {
        BlockShape::Logical => Shape::Logical,
        BlockShape::Coil => Shape::Coil,
        BlockShape::Function => Shape::Function,
    };
    Some(match block.head()?.name() {
        HeadName::User(name) => Block::user_in(shape, name.text().trim_start_matches('$'), operands),
        HeadName::Mnemonic(mnemonic) => Block::spelled(shape, mnemonic.text(), operands),
        HeadName::Blank => Block::spelled(shape, "", operands),
    })
}

fn operand(operand: ast::Operand<'_>) -> Option<Operand> {
    Some(match operand {
        ast::Operand::Positional(value) => Operand::Value(expression(value)?),
        ast::Operand::Named(named) => {
            let (name, value) = (named.name()?.text().to_owned(), expression(named.value()?)?);
            match named.arrow()?.kind() {
                SyntaxKind::ARROW => Operand::Taken(name, value),
                _ => Operand::Given(name, value),
            }
        }
    })
}

impl Expression {
    /// The value or formula that a text is.
    ///
    /// # Errors
    ///
    /// If it is none that an operand can have.
    pub fn read(text: &str) -> Result<Expression, Invalid> {
        let block = Block::read(&format!("[CALC]( y, {text} )"));
        match block.as_ref().map(Block::operands) {
            Ok([_, Operand::Value(value)]) => Ok(value.clone()),
            _ => Err(Invalid(format!(
                "`{text}` is not a value that can be written here"
            ))),
        }
    }
}

fn boxed(value: Option<ast::Expression<'_>>) -> Option<Box<Expression>> {
    Some(Box::new(expression(value?)?))
}

fn expression(of: ast::Expression<'_>) -> Option<Expression> {
    Some(match of {
        ast::Expression::Name(name) => Path::tag(name.text()).into(),
        ast::Expression::Address(address) => Path::tag(address.text()).into(),
        ast::Expression::Literal(literal) => Expression::literal(literal.text()).ok()?,
        ast::Expression::Member(member) => {
            let name = member.member()?.text();
            let step = match name.parse() {
                Ok(bit) => Step::Bit(bit),
                Err(_) => Step::Member(name.to_owned()),
            };
            path(member.base()?)?.with(step).into()
        }
        ast::Expression::Index(index) => path(index.base()?)?.with(subscripts(index)?).into(),
        ast::Expression::Unary(unary) => {
            let sign = match unary.operator()?.kind() {
                SyntaxKind::MINUS => Sign::Minus,
                _ => Sign::Not,
            };
            Expression::Unary(sign, boxed(unary.operand())?)
        }
        ast::Expression::Binary(binary) => {
            let operator = Operator::of(&binary.operator()?.text().to_ascii_uppercase())?;
            Expression::Binary(operator, boxed(binary.left())?, boxed(binary.right())?)
        }
        ast::Expression::Paren(paren) => Expression::Group(boxed(paren.inner())?),
        ast::Expression::Call(call) => {
            let ast::Expression::Name(name) = call.callee()? else {
                return None;
            };
            let arguments: Option<Vec<Expression>> = call.arguments().map(expression).collect();
            Expression::Call(name.text().to_owned(), arguments?)
        }
        ast::Expression::Array(_) | ast::Expression::Struct(_) | ast::Expression::Error(_) => return None,
    })
}

fn path(of: ast::Expression<'_>) -> Option<Path> {
    match expression(of)? {
        Expression::Path(path) => Some(path),
        _ => None,
    }
}

fn subscripts(index: ast::IndexExpression<'_>) -> Option<Step> {
    let (mut indices, mut range) = (Vec::new(), None);
    for subscript in index.subscripts() {
        match subscript {
            Subscript::Index(index) if range.is_none() => indices.push(expression(index)?),
            Subscript::Range(bounds) if range.is_none() => {
                range = Some(Box::new((
                    expression(bounds.first()?)?,
                    expression(bounds.last()?)?,
                )));
            }
            _ => return None,
        }
    }
    Some(match range {
        Some(range) => Step::Range(indices, range),
        None => Step::Index(indices),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_is_written_as_it_was_read() {
        for text in [
            "[ ]( start )",
            "[/]( %IX0.3 )",
            "[NOT]",
            "[NOT]( y, a )",
            "(S)( cells[i + 1, 2].level.3 )",
            "[TON]( t, T#5s, R := reset )",
            "[CALC]( y, (a OR b) AND NOT c + -2 ^ 3 )",
            "[CALC]( y, a - (b - c) * (-1.5) )",
            "[CALC]( y, (a < b) = (c < d) )",
            "[FILL]( data[0..9], MIN(a, 16#FF) )",
            "[FILL]( grid[i, 0..9], 1 )",
            "[FMT]( 'it$'s $N', value )",
            "[$Rinse]( first, go := a, done => b )",
            "[$Rinse]",
            "($Flash)( lamp )",
            "<JMP>( there )",
            "<RET>",
        ] {
            let read = Block::read(text).map(|block| block.to_string());
            assert_eq!(read.as_deref(), Ok(text));
        }
    }

    #[test]
    fn what_cannot_be_written_cannot_be_made() {
        for text in [
            "[ ]( a, b )",
            "[TON]( t",
            "[NIX]( a )",
            "[ ]( a )--[ ]( b )",
            "a",
            "[MOV]( y, [1, 2] )",
        ] {
            assert!(Block::read(text).is_err(), "{text}");
        }
        let tag = |name: &str| Expression::from(Path::tag(name));
        let op = ladder_instructions::Op::Mov;
        assert_eq!(
            Block::of(op, [tag("y"), tag("Local:1:I")]).map_err(String::from),
            Err("`Local:1:I` is not a name that a tag can have here".to_owned())
        );
        assert!(Block::of(op, [tag("y")]).is_err());
        assert!(Block::of(op, [tag("y"), tag("And")]).is_err());
        assert!(Block::of(op, [tag("y"), tag("PI")]).is_ok());
        assert!(Block::of(op, [tag("y"), Path::system("SCAN").into()]).is_ok());
        assert!(Expression::literal("5 s").is_err());
        let deep = (0..200).fold(tag("a"), |inner, _| inner.negated());
        assert!(Block::of(op, [tag("y"), deep]).is_err());
        let long = (0..300).fold(tag("a"), |sum, _| sum.with(Operator::Plus, Path::tag("b")));
        assert!(Block::of(op, [tag("y"), long]).is_ok());
    }
}
