//! Conditions, addresses and values.

use super::super::address::{Address, Span, Tag};
use super::super::bank::{BANKS, Bank};
use super::super::model::{
    Bits, Comparison, Condition, Constant, Contact, ContactKind, Operand, Pointer, Relation,
};
use super::problems::{Problems, Unread, expression};
use ruff_python_ast::{CmpOp, Expr, ExprCall, ExprSubscript, Keyword, Number, Operator, UnaryOp};

/// A range of timers or counters has a contact each, so it may have no more than this many.
const MOST_IN_RANGE: usize = 32;

/// A condition of more contacts is not read: its drawing grows with the square of them.
const MOST_CONTACTS: usize = 500;

/// What is after `if`, or in a pin's lambda.
pub(super) fn condition(problems: &mut Problems<'_>, expr: &Expr) -> Result<Condition, Unread> {
    let condition = part(problems, expr)?;
    if contacts(&condition) > MOST_CONTACTS {
        let message = format!(
            "a condition of more than {MOST_CONTACTS} contacts is not read: put parts of it into control relays"
        );
        return Err(problems.note(expr, message));
    }
    Ok(condition)
}

/// How many contacts and comparisons a condition has.
fn contacts(condition: &Condition) -> usize {
    match condition {
        Condition::All(parts) | Condition::Any(parts) => parts.iter().map(contacts).sum(),
        Condition::Contact(_) | Condition::Compare(_) => 1,
    }
}

fn part(problems: &mut Problems<'_>, expr: &Expr) -> Result<Condition, Unread> {
    match expr {
        Expr::BooleanLiteral(literal) if literal.value => Ok(Condition::ALWAYS),
        Expr::BooleanLiteral(_) => Err(problems.note(
            expr,
            "`False` is not a condition: a rung is under `if True:` or a real one",
        )),
        Expr::Attribute(_) | Expr::Subscript(_) => contact(problems, expr, expr, ContactKind::Open),
        Expr::Compare(compare) => {
            let [op] = &compare.ops[..] else {
                let message = "chained comparisons are not in the DSL: write all(a < b, b < c)";
                return Err(problems.note(expr, message));
            };
            let Some(relation) = relation(*op) else {
                let message = format!(
                    "`{}` is not in the DSL: compare with == != < <= > >=",
                    op.as_str()
                );
                return Err(problems.note(expr, message));
            };
            let left = operand(problems, &compare.left)?;
            let right = operand(problems, &compare.comparators[0])?;
            Ok(Condition::Compare(Comparison {
                place: problems.place(expr),
                left,
                relation,
                right,
            }))
        }
        Expr::Call(call) => called(problems, expr, call),
        Expr::BoolOp(operation) => {
            let (word, instead) = match operation.op {
                ruff_python_ast::BoolOp::And => ("and", "all(a, b)"),
                ruff_python_ast::BoolOp::Or => ("or", "any(a, b)"),
            };
            Err(problems.note(expr, format!("`{word}` is not in the DSL: write {instead}")))
        }
        Expr::UnaryOp(operation) if operation.op == UnaryOp::Not => Err(problems.note(
            expr,
            "`not` is not in the DSL: write nc(a) for a normally closed contact",
        )),
        other => {
            let what = expression(other);
            Err(problems.note(other, format!("{what} is not a condition of the DSL")))
        }
    }
}

const fn relation(op: CmpOp) -> Option<Relation> {
    match op {
        CmpOp::Eq => Some(Relation::Eq),
        CmpOp::NotEq => Some(Relation::Ne),
        CmpOp::Lt => Some(Relation::Lt),
        CmpOp::LtE => Some(Relation::Le),
        CmpOp::Gt => Some(Relation::Gt),
        CmpOp::GtE => Some(Relation::Ge),
        CmpOp::Is | CmpOp::IsNot | CmpOp::In | CmpOp::NotIn => None,
    }
}

/// `all(..)`, `any(..)`, `nc(..)`, `re(..)`, `fe(..)`
fn called(problems: &mut Problems<'_>, expr: &Expr, call: &ExprCall) -> Result<Condition, Unread> {
    let word = match &*call.func {
        Expr::Name(name) => name.id.as_str(),
        _ => "",
    };
    let kind = match word {
        "nc" => Some(ContactKind::Closed),
        "re" => Some(ContactKind::Rising),
        "fe" => Some(ContactKind::Falling),
        "all" | "any" => None,
        _ => {
            let shown = shown(problems.source(&*call.func));
            let message = format!("`{shown}` is not a condition of the DSL: it has all, any, nc, re and fe");
            return Err(problems.note(expr, message));
        }
    };
    let is_address = |keyword: &Keyword| keyword.arg.as_ref().is_some_and(|name| name == "address");
    let named = match (kind, &call.arguments.keywords[..]) {
        (_, []) => None,
        (Some(_), [keyword]) if is_address(keyword) => Some(&keyword.value),
        (Some(_), [keyword, ..]) => {
            return Err(problems.note(
                keyword,
                format!("the one argument of `{word}` is called `address`"),
            ));
        }
        (None, [keyword, ..]) => {
            return Err(problems.note(keyword, format!("`{word}` has no named arguments")));
        }
    };
    match (kind, &call.arguments.args[..], named) {
        (Some(kind), [], Some(address)) | (Some(kind), [address], None) => {
            contact(problems, expr, address, kind)
        }
        (Some(_), ..) => Err(problems.note(expr, format!("`{word}` takes one address"))),
        (None, [], _) => Err(problems.note(expr, format!("`{word}` takes one condition or more"))),
        (None, arguments, _) => {
            // Each error in it is reported.
            let parts: Vec<_> = arguments
                .iter()
                .map(|argument| part(problems, argument))
                .collect();
            let parts = parts.into_iter().collect::<Result<_, _>>()?;
            Ok(match word {
                "any" => Condition::Any(parts),
                _ => Condition::All(parts),
            })
        }
    }
}

fn contact(
    problems: &mut Problems<'_>,
    whole: &Expr,
    address: &Expr,
    kind: ContactKind,
) -> Result<Condition, Unread> {
    let bits = bits(problems, address)?;
    if let Bits::Many(span) = &bits {
        if matches!(kind, ContactKind::Rising | ContactKind::Falling) {
            return Err(problems.note(whole, "an edge is that of one address, not of a range"));
        }
        if matches!(span.bank, Bank::T | Bank::Ct) && span.len() > MOST_IN_RANGE {
            let message = format!("a range of more than {MOST_IN_RANGE} timers or counters is not read");
            return Err(problems.note(whole, message));
        }
    }
    Ok(Condition::Contact(Contact {
        place: problems.place(whole),
        kind,
        bits,
    }))
}

/// An address or a range.
pub(super) fn bits(problems: &mut Problems<'_>, expr: &Expr) -> Result<Bits, Unread> {
    match expr {
        Expr::Subscript(subscript) if matches!(&*subscript.slice, Expr::Slice(_)) => {
            span(problems, expr).map(Bits::Many)
        }
        expr => tag(problems, expr).map(Bits::One),
    }
}

/// An address: `ds[1]`, `ds.Level`.
pub(super) fn tag(problems: &mut Problems<'_>, expr: &Expr) -> Result<Tag, Unread> {
    match operand(problems, expr)? {
        Operand::Tag(tag) => Ok(tag),
        Operand::Pointer(_) => {
            Err(problems.note(expr, "a pointer is for copy() alone: an address is needed here"))
        }
        Operand::Constant(_) => {
            Err(problems.note(expr, "an address is needed here, such as c[1] or c.Start"))
        }
    }
}

/// A range: `ds[1:5]`. As in Python its end is not part of it.
pub(super) fn span(problems: &mut Problems<'_>, expr: &Expr) -> Result<Span, Unread> {
    let Expr::Subscript(subscript) = expr else {
        return Err(problems.note(expr, "a range is needed here, such as ds[1:5]"));
    };
    let Expr::Slice(slice) = &*subscript.slice else {
        return Err(problems.note(expr, "a range is needed here, such as ds[1:5]"));
    };
    let bank = bank(problems, &subscript.value)?;
    let (Some(lower), Some(upper)) = (&slice.lower, &slice.upper) else {
        if let (Some(lower), None, Some(step)) = (&slice.lower, &slice.upper, &slice.step)
            && is_minus_one(step)
        {
            let first = number(problems, lower)?;
            return Ok(Span { bank, first, last: 0 });
        }
        return Err(problems.note(expr, "a range has a first address and an end, as in ds[1:5]"));
    };
    let (first, end) = (number(problems, lower)?, number(problems, upper)?);
    match &slice.step {
        None if first < end => Ok(Span {
            bank,
            first,
            last: end - 1,
        }),
        Some(step) if is_minus_one(step) && first > end => Ok(Span {
            bank,
            first,
            last: end + 1,
        }),
        Some(step) if !is_minus_one(step) => Err(problems.note(
            &**step,
            "a range of the DSL has no step: its addresses are consecutive",
        )),
        _ => Err(problems.note(
            expr,
            "this range is empty: as in Python its end is not part of it",
        )),
    }
}

fn is_minus_one(expr: &Expr) -> bool {
    match expr {
        Expr::UnaryOp(operation) if operation.op == UnaryOp::USub => match &*operation.operand {
            Expr::NumberLiteral(literal) => {
                matches!(&literal.value, Number::Int(int) if int.as_u16() == Some(1))
            }
            _ => false,
        },
        _ => false,
    }
}

fn bank(problems: &mut Problems<'_>, expr: &Expr) -> Result<Bank, Unread> {
    let Expr::Name(name) = expr else {
        let what = expression(expr);
        return Err(problems.note(
            expr,
            format!("{what} is not an address of the DSL: addresses are c[1] or c.Start"),
        ));
    };
    if let Some(bank) = Bank::of_dsl(&name.id) {
        return Ok(bank);
    }
    let banks: Vec<&str> = BANKS.iter().map(|row| row.dsl).collect();
    let message = format!(
        "there is no bank `{}`: the banks are {}",
        shown(&name.id),
        banks.join(" ")
    );
    Err(problems.note(expr, message))
}

/// A number of an address. Whether it exists is asked later, with the rules.
fn number(problems: &mut Problems<'_>, expr: &Expr) -> Result<u16, Unread> {
    let found = match expr {
        Expr::NumberLiteral(literal) => match &literal.value {
            Number::Int(int) => int.as_u16().filter(|number| *number < u16::MAX),
            _ => None,
        },
        _ => None,
    };
    found.ok_or_else(|| problems.note(expr, "the number of an address is needed here, from 0 to 65534"))
}

/// A value, or where one goes.
pub(super) fn operand(problems: &mut Problems<'_>, expr: &Expr) -> Result<Operand, Unread> {
    match expr {
        Expr::Attribute(attribute) => {
            let bank = bank(problems, &attribute.value)?;
            let name = attribute.attr.as_str();
            let upper = Address::parse(name).filter(|address| address.bank == bank && address.is_upper());
            Ok(Operand::Tag(
                upper.map_or_else(|| Tag::nickname(bank, name), Tag::from),
            ))
        }
        Expr::Subscript(subscript) => indexed(problems, expr, subscript),
        other => constant(problems, other).map(Operand::Constant),
    }
}

/// `ds[1]`, and the pointer `ds[ds.Step]`
fn indexed(problems: &mut Problems<'_>, whole: &Expr, subscript: &ExprSubscript) -> Result<Operand, Unread> {
    let bank = bank(problems, &subscript.value)?;
    let pointer = |problems: &mut Problems<'_>, by: &Expr, offset| {
        let by = tag(problems, by)?;
        Ok(Operand::Pointer(Pointer { bank, by, offset }))
    };
    match &*subscript.slice {
        Expr::NumberLiteral(_) => {
            let number = number(problems, &subscript.slice)?;
            Ok(Operand::Tag(Tag::number(bank, number)))
        }
        by @ (Expr::Attribute(_) | Expr::Subscript(_)) => pointer(problems, by, 0),
        Expr::BinOp(sum) if matches!(sum.op, Operator::Add | Operator::Sub) => {
            let offset = i32::from(number(problems, &sum.right)?);
            let offset = if sum.op == Operator::Add { offset } else { -offset };
            pointer(problems, &sum.left, offset)
        }
        Expr::Slice(_) => Err(problems.note(whole, "one address is needed here, not a range")),
        other => {
            let what = expression(other);
            let message = format!("{what} is not an address: write a number, or ds[..] as a pointer");
            Err(problems.note(other, message))
        }
    }
}

fn constant(problems: &mut Problems<'_>, expr: &Expr) -> Result<Constant, Unread> {
    match expr {
        Expr::BooleanLiteral(literal) => Ok(Constant::Bit(literal.value)),
        Expr::NumberLiteral(literal) => plain_number(problems, expr, &literal.value),
        Expr::UnaryOp(operation) if operation.op == UnaryOp::USub => {
            let Expr::NumberLiteral(literal) = &*operation.operand else {
                return Err(problems.note(expr, "a sign is before a number only"));
            };
            match plain_number(problems, expr, &literal.value)? {
                Constant::Int(number) => Ok(Constant::Int(-number)),
                Constant::Float(number) => Ok(Constant::Float(-number)),
                _ => Err(problems.note(expr, "a hexadecimal number has no sign")),
            }
        }
        Expr::StringLiteral(literal) => Ok(Constant::Text(literal.value.to_str().to_owned())),
        other => {
            let what = expression(other);
            Err(problems.note(
                other,
                format!("{what} is not a value of the DSL: it has numbers, texts and addresses"),
            ))
        }
    }
}

fn plain_number(problems: &mut Problems<'_>, expr: &Expr, value: &Number) -> Result<Constant, Unread> {
    let is_hex = problems
        .source(expr)
        .trim_start_matches(['-', ' '])
        .starts_with(['0'])
        && {
            let source = problems.source(expr).trim_start_matches(['-', ' ']);
            source
                .get(1..2)
                .is_some_and(|letter| letter.eq_ignore_ascii_case("x"))
        };
    match value {
        Number::Int(int) if is_hex => {
            let number = int.as_u32();
            number
                .map(Constant::Hex)
                .ok_or_else(|| problems.note(expr, "a hexadecimal number has up to eight digits"))
        }
        Number::Int(int) => {
            let number = int.as_i64();
            number
                .map(Constant::Int)
                .ok_or_else(|| problems.note(expr, "this number is too large for Click"))
        }
        Number::Float(number) if number.is_finite() => Ok(Constant::Float(*number)),
        _ => Err(problems.note(expr, "Click has no such number")),
    }
}

/// The beginning of a text of the file, for a message.
pub(super) fn shown(text: &str) -> String {
    let line: String = text.chars().take_while(|c| *c != '\n').take(40).collect();
    if line.len() < text.len() {
        format!("{line}..")
    } else {
        line
    }
}
