//! Operands as expressions of ST.

use super::compiler::Compiler;
use super::names::{Names, identifier};
use super::system;
use crate::own;
use crate::standard::function_of;
use ladder_analysis::program::{BinaryOperator, Expr, ExprKind, Member, Place, SystemTag, UnaryOperator};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::{Value, real_text};
use ladder_analysis::written::facts::{Node, NodeKind, Operator};
use ladder_instructions::Op;
use ladder_syntax::{TextRange, TextSize};

/// What operands are written from: the text of the ladder program, and the names of its tags there.
#[derive(Clone, Copy)]
pub(super) struct Words<'w> {
    pub(super) text: &'w str,
    /// Where the line of the operand starts.
    pub(super) base: TextSize,
    pub(super) names: &'w Names,
    pub(super) compiler: Compiler,
}

/// An expression, and how tightly its parts hold together: a name 9, `OR` 1.
type Piece = Result<(String, u8), String>;

const WHOLE: u8 = 9;

/// Why a network is not written that computes with the bits of integers.
pub(super) const OF_BITS: &str = "what works on bits takes bit strings there: use BYTE, WORD, DWORD or LWORD";

/// Why a network is not written that has powers of integers.
pub(super) const OF_REALS: &str = "powers are of real numbers there: use REAL or LREAL, or multiply";

impl Words<'_> {
    fn slice(&self, range: TextRange) -> &str {
        &self.text[range]
    }

    /// An expression of which the types are not needed: indices and values at the start.
    ///
    /// # Errors
    ///
    /// Why it has no counterpart.
    pub(super) fn node(&self, node: &Node) -> Result<String, String> {
        Ok(match &node.kind {
            NodeKind::Name(name) if self.names.is_refused(name) => {
                return Err(format!("the type of `{name}` has no counterpart"));
            }
            NodeKind::Name(name) => self.name(name),
            NodeKind::Address(address) => self.name(address),
            NodeKind::Literal(_) => literal(self.slice(node.range + self.base), None),
            NodeKind::Member(base, word) => match &base.kind {
                NodeKind::Name(name) if name.eq_ignore_ascii_case("SYS") => {
                    return self.system(&word.text);
                }
                // A value of an enumeration, after the name of its type.
                NodeKind::Name(name) if self.names.get(name).is_none() => self
                    .compiler
                    .enumerator(&identifier(name), &identifier(&word.text)),
                _ => format!("{}.{}", self.node(base)?, member(&word.text)),
            },
            NodeKind::Index(..) => self.element(node)?,
            NodeKind::Unary(Operator::Sub, inner) => format!("-{}", self.node(inner)?),
            NodeKind::Unary(_, inner) => format!("NOT {}", self.node(inner)?),
            NodeKind::Binary(operator, left, right) => {
                let sign = match operator {
                    Operator::Power => "**",
                    Operator::Shl | Operator::Shr => return Err("shifts are no operators there".to_owned()),
                    other => other.text(),
                };
                format!("{} {sign} {}", self.node(left)?, self.node(right)?)
            }
            NodeKind::Paren(inner) => format!("({})", self.node(inner)?),
            _ => return Err("such an expression has no counterpart".to_owned()),
        })
    }

    /// An element of an array: its indices are one list or several here, and one list there.
    fn element(&self, node: &Node) -> Result<String, String> {
        let (mut base, mut indices) = (node, Vec::new());
        while let NodeKind::Index(inner, index) = &base.kind {
            indices.push(self.node(index)?);
            base = inner;
        }
        indices.reverse();
        Ok(format!("{}[{}]", self.node(base)?, indices.join(", ")))
    }

    /// A tag of `SYS`, by its word.
    fn system(&self, word: &str) -> Result<String, String> {
        match SystemTag::from_name(word) {
            Some(SystemTag::On) => Ok("TRUE".to_owned()),
            Some(SystemTag::Off) => Ok("FALSE".to_owned()),
            tag => tag
                .and_then(|tag| self.names.get(&system::key(tag)))
                .map(str::to_owned)
                .ok_or_else(|| format!("the standard has no SYS.{word}")),
        }
    }

    /// A value of an enumeration, with the name of its type or without.
    ///
    /// # Errors
    ///
    /// If it is none.
    pub(super) fn enumerator(&self, node: &Node) -> Result<String, String> {
        match &node.kind {
            NodeKind::Member(base, word) => match &base.kind {
                NodeKind::Name(name) => Ok(self
                    .compiler
                    .enumerator(&identifier(name), &identifier(&word.text))),
                _ => Err("such a value has no counterpart".to_owned()),
            },
            _ => self.node(node),
        }
    }

    fn name(&self, name: &str) -> String {
        self.names
            .get(name)
            .map_or_else(|| identifier(name), str::to_owned)
    }

    /// A value as an operand, already in the type that its place asks for.
    ///
    /// # Errors
    ///
    /// Why it has no counterpart.
    pub(super) fn value(&self, expression: &Expr, node: &Node) -> Result<String, String> {
        self.expression(expression, node).map(|(text, _)| text)
    }

    fn expression(&self, expression: &Expr, node: &Node) -> Piece {
        let whole = |text: String| Ok((text, WHOLE));
        match &expression.kind {
            ExprKind::Constant(known) => {
                let text = self.slice(expression.range);
                match found(node, expression.range, self.base).map(|node| &node.kind) {
                    Some(NodeKind::Literal(_)) => {}
                    _ => {
                        let text = value(known, expression.ty)?;
                        return whole(match (self.compiler, expression.ty) {
                            (Compiler::TwinCat, Scalar::Enum(id)) => {
                                self.compiler.enumerator(&identifier(&id.get().name), &text)
                            }
                            _ => text,
                        });
                    }
                }
                // Generators read what is before a `#` as a type.
                if text.contains('#')
                    && !matches!(
                        expression.ty,
                        Scalar::Time | Scalar::Date | Scalar::Tod | Scalar::Dt
                    )
                {
                    return value(known, expression.ty).and_then(whole);
                }
                whole(literal(text, Some((known, expression.ty))))
            }
            ExprKind::Read(place) => {
                let at = found(node, expression.range, self.base);
                let at = at.ok_or("such an expression has no counterpart")?;
                if let (Place::Bit(_, ty, bit), NodeKind::Member(base, _), Compiler::Matiec) =
                    (place, &at.kind, self.compiler)
                {
                    return Ok((own::bit(&self.node(base)?, *ty, *bit), 4));
                }
                self.place(place, at).and_then(whole)
            }
            ExprKind::Pass(inner) => {
                if let ExprKind::Constant(_) = inner.kind {
                    return self.expression(inner, node);
                }
                let (text, holds) = self.expression(inner, node)?;
                let (from, to) = (inner.ty.name(), expression.ty.name());
                if from == to {
                    return Ok((text, holds));
                }
                whole(format!("{from}_TO_{to}({text})"))
            }
            ExprKind::Unary(operator, inner) => {
                let (text, holds) = self.expression(inner, node)?;
                if *operator == UnaryOperator::Not && expression.ty.is_integer() {
                    return Err(OF_BITS.to_owned());
                }
                let text = if holds < 8 || text.starts_with('-') {
                    format!("({text})")
                } else {
                    text
                };
                let sign = match operator {
                    UnaryOperator::Minus => "-",
                    UnaryOperator::Not => "NOT ",
                };
                Ok((format!("{sign}{text}"), 8))
            }
            ExprKind::Binary(operator, left, right) => {
                let is_of_bits = matches!(
                    operator,
                    BinaryOperator::Or | BinaryOperator::Xor | BinaryOperator::And
                );
                if is_of_bits && expression.ty.is_integer() {
                    return Err(OF_BITS.to_owned());
                }
                if *operator == BinaryOperator::Power && expression.ty.is_integer() {
                    return Err(OF_REALS.to_owned());
                }
                let (sign, rank) = match operator {
                    BinaryOperator::Or => ("OR", 1),
                    BinaryOperator::Xor => ("XOR", 2),
                    BinaryOperator::And => ("AND", 3),
                    BinaryOperator::Add => ("+", 6),
                    BinaryOperator::Sub => ("-", 6),
                    BinaryOperator::Mul => ("*", 7),
                    BinaryOperator::Div => ("/", 7),
                    BinaryOperator::Mod => ("MOD", 7),
                    // It goes to the right here, and to the left there.
                    BinaryOperator::Power => {
                        let (left, right) = (self.inside(left, node, 9)?, self.inside(right, node, 9)?);
                        return Ok((format!("{left} ** {right}"), 7));
                    }
                    BinaryOperator::Shl | BinaryOperator::Shr => {
                        return Err("shifts are no operators there".to_owned());
                    }
                };
                self.pair((left, right), node, (sign, rank))
            }
            ExprKind::Compare(op, left, right) => {
                let (sign, rank) = match op {
                    Op::Eq => ("=", 4),
                    Op::Ne => ("<>", 4),
                    Op::Lt => ("<", 5),
                    Op::Le => ("<=", 5),
                    Op::Gt => (">", 5),
                    _ => (">=", 5),
                };
                self.pair((left, right), node, (sign, rank))
            }
            ExprKind::Call(op, arguments) => {
                let (name, _) = function_of(*op).ok_or("a function in it has no counterpart")?;
                let arguments: Result<Vec<String>, String> = arguments
                    .iter()
                    .map(|argument| self.value(argument, node))
                    .collect();
                whole(format!("{name}({})", arguments?.join(", ")))
            }
            ExprKind::Sum(_) => Err("the standard has no SUM".to_owned()),
            ExprKind::Offset(_) => Err("such an expression has no counterpart".to_owned()),
        }
    }

    /// Two parts of an expression with a sign between them.
    fn pair(&self, (left, right): (&Expr, &Expr), node: &Node, (sign, rank): (&str, u8)) -> Piece {
        let left = self.inside(left, node, rank)?;
        let right = self.inside(right, node, rank + 1)?;
        Ok((format!("{left} {sign} {right}"), rank))
    }

    /// A part of an expression, in parentheses where it holds together less than what is around it.
    fn inside(&self, expression: &Expr, node: &Node, rank: u8) -> Result<String, String> {
        let (text, holds) = self.expression(expression, node)?;
        Ok(if holds < rank { format!("({text})") } else { text })
    }

    /// A place that is read or written.
    ///
    /// # Errors
    ///
    /// Why it has no counterpart.
    pub(super) fn place(&self, place: &Place, node: &Node) -> Result<String, String> {
        match (place, &node.kind) {
            (Place::System(tag), _) => self.system(tag.name()),
            (Place::Member(_, member) | Place::ChosenMember(_, member), NodeKind::Member(base, word)) => {
                let name = match member {
                    Member::Changed | Member::Timing => {
                        return Err(format!("timers and counters there have no `{}`", word.text));
                    }
                    other => other.name(),
                };
                Ok(format!("{}.{name}", self.node(base)?))
            }
            (Place::Bit(..), _) if self.compiler == Compiler::Matiec => {
                Err("a bit of a number cannot be written there: use a BOOL".to_owned())
            }
            (Place::Member(..) | Place::ChosenMember(..), _) => {
                Err("a timer or counter is no value there".to_owned())
            }
            _ => self.node(node),
        }
    }
}

/// A member; a bit is its number.
fn member(name: &str) -> String {
    if name.bytes().all(|c| c.is_ascii_digit()) {
        return name.to_owned();
    }
    identifier(name)
}

/// The part of an expression at a place of the text.
pub(super) fn found(node: &Node, range: TextRange, base: TextSize) -> Option<&Node> {
    let own = node.range + base;
    if own == range && !matches!(node.kind, NodeKind::Paren(_)) {
        return Some(node);
    }
    if !own.contains_range(range) {
        return None;
    }
    match &node.kind {
        NodeKind::Member(inner, _) | NodeKind::Unary(_, inner) | NodeKind::Paren(inner) => {
            found(inner, range, base)
        }
        NodeKind::Index(left, right) | NodeKind::Binary(_, left, right) => {
            found(left, range, base).or_else(|| found(right, range, base))
        }
        NodeKind::Range(one, two, three) => [one, two, three]
            .into_iter()
            .find_map(|inner| found(inner, range, base)),
        NodeKind::Call(_, inner) | NodeKind::Array(inner) | NodeKind::Repeat(_, inner) => {
            inner.iter().find_map(|inner| found(inner, range, base))
        }
        _ => None,
    }
}

/// A literal as the standard has it, in the type of its place where that is known.
pub(super) fn literal(text: &str, known: Option<(&Value, Scalar)>) -> String {
    let is_digits = text.bytes().all(|c| c.is_ascii_digit() || c == b'_');
    match known {
        Some((Value::Int(nanoseconds), Scalar::Time)) if is_digits => time(*nanoseconds),
        _ if text.starts_with('\'') && !text.is_ascii() => ascii(text),
        Some((_, Scalar::Real | Scalar::Lreal)) if is_digits => format!("{text}.0"),
        _ => {
            let is_span = text.starts_with(|c: char| c.is_ascii_digit())
                && !text.contains('#')
                && text.ends_with(|c: char| c.is_ascii_alphabetic());
            if is_span {
                format!("T#{text}")
            } else {
                text.to_owned()
            }
        }
    }
}

/// A text with the bytes of what is not in ASCII, which compilers do not take.
fn ascii(text: &str) -> String {
    let byte = |byte: u8| match byte {
        byte if byte.is_ascii() => char::from(byte).to_string(),
        byte => format!("${byte:02X}"),
    };
    text.bytes().map(byte).collect()
}

/// A value that a tag begins with.
///
/// # Errors
///
/// Why it has no counterpart.
pub(super) fn value(value: &Value, ty: Scalar) -> Result<String, String> {
    Ok(match (value, ty) {
        (Value::Bool(on), _) => if *on { "TRUE" } else { "FALSE" }.to_owned(),
        (Value::Int(nanoseconds), Scalar::Time) => time(*nanoseconds),
        (Value::Int(_), Scalar::Date | Scalar::Tod | Scalar::Dt) => {
            return Err("dates and times of day at the start are not written".to_owned());
        }
        (Value::Int(number), Scalar::Enum(id)) => {
            let known = id.get();
            known
                .name_of(*number)
                .map_or_else(|| number.to_string(), |name| identifier(name))
        }
        (Value::Int(number), Scalar::Lword | Scalar::Ulint) => (*number as u64).to_string(),
        (Value::Int(number), _) => number.to_string(),
        (Value::Real(number), _) => real_text(*number, ty),
        (Value::Text(bytes), _) => {
            let mut out = String::from("'");
            for byte in &**bytes {
                match byte {
                    b'$' | b'\'' => out.extend(['$', char::from(*byte)]),
                    b' '..=b'~' => out.push(char::from(*byte)),
                    // Compilers take signs of ASCII alone.
                    byte => out.push_str(&format!("${byte:02X}")),
                }
            }
            out + "'"
        }
    })
}

/// A duration.
pub(super) fn time(nanoseconds: i64) -> String {
    let sign = if nanoseconds < 0 { "-" } else { "" };
    let size = nanoseconds.unsigned_abs();
    let units = [(1_000_000_000, "s"), (1_000_000, "ms"), (1_000, "us"), (1, "ns")];
    let unit = units.iter().find(|(unit, _)| size.is_multiple_of(*unit));
    let (unit, name) = unit.copied().unwrap_or((1, "ns"));
    format!("T#{sign}{}{name}", size / unit)
}
