//! Functions: those of the standard are instructions, those of the user blocks.

use super::super::scope::{Parameter, ParameterRole, Shape, Type};
use super::super::tree::{Argument, Call, Direction, Expression as Tree, ExpressionKind};
use super::place::converted;
use super::restarted::zero;
use super::value::Value;
use super::{Lowered, Lowering};
use ladder_analysis::values::types::{Scalar, passes};
use ladder_format::program::{Block, Literal, Operand, Operator, Sign};
use std::rc::Rc;

/// How a function of the standard is computed.
#[derive(Debug, Clone, Copy)]
enum Kind {
    /// Of an operator, from left to right.
    Operator(Operator),
    /// Of real numbers.
    Real,
    /// All of one type, which is that of the result. So many arguments before are of a type of their own.
    Alike(usize),
    /// Bits, and a number of places.
    Shift,
    /// Texts and numbers; a text, or a number.
    Text(Scalar),
}

const TEXT: Kind = Kind::Text(Scalar::String(254));

/// The functions of the standard, the instructions that say the same, and the names of their inputs.
const FUNCTIONS: &[(&str, &str, Kind, &[&str])] = &[
    ("AND", "AND", Kind::Operator(Operator::And), &[]),
    ("OR", "OR", Kind::Operator(Operator::Or), &[]),
    ("XOR", "XOR", Kind::Operator(Operator::Xor), &[]),
    ("ADD", "ADD", Kind::Operator(Operator::Plus), &[]),
    ("SUB", "SUB", Kind::Operator(Operator::Minus), &[]),
    ("MUL", "MUL", Kind::Operator(Operator::Times), &[]),
    ("DIV", "DIV", Kind::Operator(Operator::Divide), &[]),
    ("MOD", "MOD", Kind::Operator(Operator::Mod), &[]),
    ("EXPT", "EXP", Kind::Operator(Operator::Power), &[]),
    ("EQ", "EQ", Kind::Operator(Operator::Equal), &[]),
    ("NE", "NE", Kind::Operator(Operator::NotEqual), &[]),
    ("GT", "GT", Kind::Operator(Operator::Greater), &[]),
    ("GE", "GE", Kind::Operator(Operator::GreaterEqual), &[]),
    ("LT", "LT", Kind::Operator(Operator::Less), &[]),
    ("LE", "LE", Kind::Operator(Operator::LessEqual), &[]),
    ("SQRT", "SQRT", Kind::Real, &["IN"]),
    ("LN", "LN", Kind::Real, &["IN"]),
    ("LOG", "LOG", Kind::Real, &["IN"]),
    ("EXP", "EXPE", Kind::Real, &["IN"]),
    ("SIN", "SIN", Kind::Real, &["IN"]),
    ("COS", "COS", Kind::Real, &["IN"]),
    ("TAN", "TAN", Kind::Real, &["IN"]),
    ("ASIN", "ASIN", Kind::Real, &["IN"]),
    ("ACOS", "ACOS", Kind::Real, &["IN"]),
    ("ATAN", "ATAN", Kind::Real, &["IN"]),
    ("DEG", "DEG", Kind::Real, &["IN"]),
    ("RAD", "RAD", Kind::Real, &["IN"]),
    ("ABS", "ABS", Kind::Alike(0), &["IN"]),
    ("MOVE", "MOV", Kind::Alike(0), &["IN"]),
    ("MIN", "MIN", Kind::Alike(0), &["IN1", "IN2"]),
    ("MAX", "MAX", Kind::Alike(0), &["IN1", "IN2"]),
    ("LIMIT", "LIMIT", Kind::Alike(0), &["MN", "IN", "MX"]),
    ("SEL", "SEL", Kind::Alike(1), &["G", "IN0", "IN1"]),
    ("MUX", "MUX", Kind::Alike(1), &["K", "IN0", "IN1", "IN2", "IN3"]),
    ("SHL", "SHL", Kind::Shift, &["IN", "N"]),
    ("SHR", "SHR", Kind::Shift, &["IN", "N"]),
    ("ROL", "ROL", Kind::Shift, &["IN", "N"]),
    ("ROR", "ROR", Kind::Shift, &["IN", "N"]),
    ("LEN", "LEN", Kind::Text(Scalar::Int), &["IN"]),
    ("FIND", "FIND", Kind::Text(Scalar::Int), &["IN1", "IN2"]),
    ("LEFT", "LEFT", TEXT, &["IN", "L"]),
    ("RIGHT", "RIGHT", TEXT, &["IN", "L"]),
    ("MID", "MID", TEXT, &["IN", "L", "P"]),
    ("CONCAT", "CONCAT", TEXT, &["IN1", "IN2"]),
    ("INSERT", "INSERT", TEXT, &["IN1", "IN2", "P"]),
    ("DELETE", "DELETE", TEXT, &["IN", "L", "P"]),
    ("REPLACE", "REPLACE", TEXT, &["IN1", "IN2", "L", "P"]),
];

/// What a function of the standard takes and returns, as far as its name tells: of its first argument, and of its result.
pub(in super::super) fn plain_types(name: &str) -> (Option<Scalar>, Option<Scalar>) {
    let upper = name.to_ascii_uppercase();
    if let Some((from, to)) = conversion(&upper) {
        return (from, Some(to));
    }
    let row = FUNCTIONS.iter().find(|(own, ..)| *own == upper);
    match (upper.as_str(), row) {
        ("TRUNC" | "ROUND" | "CEIL" | "FLOOR", _) => (Some(Scalar::Real), Some(Scalar::Dint)),
        ("NORM_X", _) => (None, Some(Scalar::Real)),
        (_, Some((_, _, Kind::Real, _))) => (Some(Scalar::Real), Some(Scalar::Real)),
        (_, Some((_, _, Kind::Text(ty), _))) => (None, Some(*ty)),
        _ => (None, None),
    }
}

impl Lowering<'_, '_> {
    /// The value of a function.
    pub(super) fn function(&mut self, call: &Call) -> Lowered<Value> {
        let name = &call.callee.root;
        if !call.callee.steps.is_empty() {
            return Err(format!("`{name}` has methods, which have no counterpart"));
        }
        if let Some(enabled) = self.enabled(call)? {
            return self.enabled_function(&enabled, None);
        }
        if let Some(shape) = self.around.scope.function_named(name) {
            return self.of_user(&Rc::clone(shape), call);
        }
        let upper = name.to_ascii_uppercase();
        if let [one] = &call.arguments[..]
            && let Some(value) = &one.value
        {
            match upper.as_str() {
                "NOT" => {
                    let kind = ExpressionKind::Unary(Sign::Not, Box::new(value.clone()));
                    return self.value(&Tree {
                        span: value.span.clone(),
                        kind,
                    });
                }
                "TRUNC" => {
                    let value = self.value(value)?;
                    return self.whole("TRUNC", value, Scalar::Dint);
                }
                "ROUND" => {
                    let value = self.value(value)?;
                    return self.whole("TYP", value, Scalar::Dint);
                }
                _ => {}
            }
            if let Some((from, to)) = conversion(&upper) {
                return self.converted(from, to, value);
            }
            if let "CEIL" | "FLOOR" = upper.as_str() {
                return self.rounded(&upper, value);
            }
        }
        if let "NORM_X" | "SCALE_X" = upper.as_str() {
            return self.scaled(&upper, call);
        }
        let row = FUNCTIONS.iter().find(|(own, ..)| *own == upper);
        let (_, mnemonic, kind, pins) = row.ok_or_else(|| super::unread::no_counterpart(name))?;
        let mut values = Vec::new();
        for argument in in_order(call, pins)? {
            values.push(self.value(argument)?);
        }
        self.standard(mnemonic, *kind, values)
    }

    fn standard(&mut self, mnemonic: &str, kind: Kind, values: Vec<Value>) -> Lowered<Value> {
        let mut values = values.into_iter();
        let first = values.next().ok_or("a function without arguments is not read")?;
        match kind {
            Kind::Operator(operator) if operator.compares() => {
                let mut chain: Option<Value> = None;
                let mut left = first;
                for right in values {
                    let pair = self.binary(operator, left, right.clone())?;
                    chain = Some(match chain {
                        Some(before) => self.binary(Operator::And, before, pair)?,
                        None => pair,
                    });
                    left = right;
                }
                chain.ok_or_else(|| "a comparison has two sides".to_owned())
            }
            Kind::Operator(operator) => {
                let mut all = first;
                for right in values {
                    all = self.binary(operator, all, right)?;
                }
                Ok(all)
            }
            Kind::Real => {
                let ty = if first.scalar() == Some(Scalar::Real) {
                    Scalar::Real
                } else {
                    Scalar::Lreal
                };
                let value = self.fit(first, ty)?;
                let value = self.atom(value)?;
                self.made_by(mnemonic, ty, vec![value.expression])
            }
            Kind::Shift => {
                let places = values.next().ok_or("a shift has a number of places")?;
                let first = self.atom(first)?;
                let places = self.atom(places)?;
                let ty = first.scalar().filter(|ty| ty.is_bits() || ty.is_integer());
                let ty = ty.ok_or("only bits are shifted")?;
                self.made_by(mnemonic, ty, vec![first.expression, places.expression])
            }
            Kind::Text(ty) => {
                let mut operands = Vec::new();
                for value in std::iter::once(first).chain(values) {
                    operands.push(self.atom(value)?.expression);
                }
                self.made_by(mnemonic, ty, operands)
            }
            Kind::Alike(own) => self.of_alike(mnemonic, own, std::iter::once(first).chain(values).collect()),
        }
    }

    /// The next whole number above or below.
    fn rounded(&mut self, name: &str, tree: &Tree) -> Lowered<Value> {
        let value = self.value(tree)?;
        let value = self.atom(value)?;
        let from = value
            .scalar()
            .filter(|ty| ty.is_real())
            .ok_or("only numbers with a fraction are rounded")?;
        let whole = self.whole("TRUNC", value.clone(), Scalar::Dint)?;
        let whole = self.atom(whole)?;
        let back = self.number(whole.clone(), Scalar::Dint, from)?;
        let one = Value::number(1, Literal::from(1));
        let (is_beyond, next) = if name == "CEIL" {
            (Operator::Less, Operator::Plus)
        } else {
            (Operator::Greater, Operator::Minus)
        };
        let is_beyond = self.binary(is_beyond, back, value)?;
        let next = self.binary(next, whole.clone(), one)?;
        self.of_alike("SEL", 1, vec![is_beyond, whole, next])
    }

    /// `NORM_X(MIN := a, VALUE := x, MAX := b)` is where x is between a and b: 0.0 to 1.0; `SCALE_X` is what is there.
    fn scaled(&mut self, name: &str, call: &Call) -> Lowered<Value> {
        let all = in_order(call, &["MIN", "VALUE", "MAX"])?;
        let [low, value, high] = all[..] else {
            return Err(format!("`{name}` has three inputs"));
        };
        let is_whole = self.value(low)?.scalar().is_some_and(Scalar::is_integer);
        let (low, value, high) = (self.real(low)?, self.real(value)?, self.real(high)?);
        let width = self.binary(Operator::Minus, high, low.clone())?;
        if name == "NORM_X" {
            let above = self.binary(Operator::Minus, value, low)?;
            return self.binary(Operator::Divide, above, width);
        }
        let above = self.binary(Operator::Times, value, width)?;
        let scaled = self.binary(Operator::Plus, above, low)?;
        if is_whole {
            return self.whole("TYP", scaled, Scalar::Dint);
        }
        Ok(scaled)
    }

    /// A number as a REAL.
    fn real(&mut self, tree: &Tree) -> Lowered<Value> {
        let value = self.value(tree)?;
        match value.scalar() {
            Some(from) if from.is_integer() && !value.is_free => self.number(value, from, Scalar::Real),
            _ => self.fit(value, Scalar::Real),
        }
    }

    /// A function whose arguments have the type of the result.
    fn of_alike(&mut self, mnemonic: &str, own: usize, values: Vec<Value>) -> Lowered<Value> {
        let mut values = values.into_iter();
        let mut operands = Vec::new();
        for value in values.by_ref().take(own) {
            operands.push(self.atom(value)?.expression);
        }
        let mut rest: Vec<Value> = Vec::new();
        for value in values {
            let value = self.as_it_is(value);
            rest.push(self.atom(value)?);
        }
        // Bits are compared as the numbers that they are.
        let mut bits = None;
        if let "MIN" | "MAX" | "LIMIT" = mnemonic
            && rest
                .iter()
                .all(|value| value.is_free || value.scalar().is_some_and(Scalar::is_bits))
        {
            let own = rest
                .iter()
                .filter(|value| !value.is_free)
                .filter_map(Value::scalar);
            bits = own.max_by_key(|ty| ty.width());
            for value in &mut rest {
                *value = self.number_of_bits(value.clone())?;
            }
        }
        let mut common: Option<Value> = None;
        for value in &rest {
            common = Some(match common {
                Some(before) => {
                    let (left, right, ty) = self.alike(before, value.clone())?;
                    let is_free = left.is_free && right.is_free;
                    Value {
                        is_free,
                        range: super::value::join(left.range, right.range),
                        ..Value::of(left.expression, Type::Scalar(ty))
                    }
                }
                None => value.clone(),
            });
        }
        let common = common.ok_or("a function without arguments is not read")?;
        let ty = common
            .scalar()
            .ok_or("values of such a type are not chosen here")?;
        for value in rest {
            let value = self.fit(value, ty)?;
            operands.push(self.atom(value)?.expression);
        }
        let made = self.made_by(mnemonic, ty, operands)?;
        if let Some(bits) = bits {
            return self.made_by("MOV", bits, vec![made.expression]);
        }
        let range = if common.is_free { common.range } else { made.range };
        Ok(Value {
            is_free: common.is_free,
            range,
            hull: range,
            ..made
        })
    }

    /// `INT_TO_REAL(a)`
    fn converted(&mut self, from: Option<Scalar>, to: Scalar, tree: &Tree) -> Lowered<Value> {
        let value = self.value(tree)?;
        // A literal has the type that the name says.
        let value = match from {
            Some(from) if value.is_free => self.fit(value, from)?,
            _ => value,
        };
        let from = match value.scalar() {
            Some(from) if value.is_free => {
                if value.is_real() {
                    Scalar::Lreal
                } else {
                    from
                }
            }
            Some(from) => from,
            None => {
                let Type::Enumeration(_) = value.ty else {
                    return Err("a value of such a type is not converted here".to_owned());
                };
                return self.made_by("TYP", to, vec![value.bare().clone()]);
            }
        };
        if from == to || (from.is_string() && to.is_string()) {
            return Ok(value);
        }
        let is_number = |ty: Scalar| ty.is_number() || ty.is_bits();
        if to == Scalar::Bool && (from.is_integer() || from.is_bits()) {
            let zero = self.value(&Tree {
                span: tree.span.clone(),
                kind: ExpressionKind::Literal(super::super::tree::LiteralKind::Integer, "0".to_owned()),
            })?;
            return self.binary(Operator::NotEqual, value, zero);
        }
        if is_number(from) && is_number(to) && !(from.is_bits() && to.is_real()) {
            return self.number(value, from, to);
        }
        if from.is_real() && to.is_string() || from.is_date() || to.is_date() && from != Scalar::Dt {
            return Err(format!("{from} as {to} is not converted here: systems differ"));
        }
        let value = self.atom(value)?;
        let from = value.scalar().unwrap_or(from);
        if passes(from, to) && from.is_bits() == to.is_bits() {
            return Ok(Value::of(value.expression, Type::Scalar(to)));
        }
        self.made_by("TYP", to, vec![value.expression])
    }

    /// A number or bits as a number of another type, or bits.
    fn number(&mut self, value: Value, from: Scalar, to: Scalar) -> Lowered<Value> {
        let widens = from.is_integer() && to.is_integer() && passes(from, to);
        if widens && self.around.dialect.is_exact() && !value.is_free {
            // Nothing is cut within an expression anyway.
            return Ok(value);
        }
        if value.is_free {
            let value = self.fit(value, to)?;
            return Ok(Value {
                is_free: to.is_integer(),
                ..value
            });
        }
        if widens || (to.is_real() && from.is_real()) {
            let value = self.atom(value)?;
            let from = value.scalar().unwrap_or(from);
            let mnemonic = if passes(from, to) { "MOV" } else { "TYP" };
            return self.made_by(mnemonic, to, vec![value.expression]);
        }
        if to.is_real() {
            let value = self.atom(value)?;
            return self.made_by("TYP", to, vec![value.expression]);
        }
        self.fit(value, to)
    }

    /// A function of the user is a block that has run before its value is needed.
    fn of_user(&mut self, shape: &Rc<Shape>, call: &Call) -> Lowered<Value> {
        let Some((output, ty)) = &shape.returns else {
            return Err(format!("`{}` returns nothing", call.callee.root));
        };
        let scalar = ty.scalar();
        if ty.keeps_state() || ty.text().is_none() {
            return Err("a function that returns such a value is not read".to_owned());
        }
        let mut operands = self.operands(&shape.parameters, call)?;
        operands.extend(left_out(&shape.parameters, &operands));
        let result = match scalar {
            Some(scalar) => self.temporary(scalar),
            None => self.compound(ty)?,
        };
        operands.push(Operand::Taken(output.clone(), (&result).into()));
        let block = Block::user(shape.name.clone(), operands)?;
        self.act(block);
        Ok(Value::of(result, ty.clone()))
    }

    /// The operands of a user's block, by name.
    pub(super) fn operands(&mut self, parameters: &[Parameter], call: &Call) -> Lowered<Vec<Operand>> {
        let mut operands = Vec::new();
        let mut places = parameters.iter();
        for Argument {
            name,
            direction,
            value,
        } in &call.arguments
        {
            let parameter = match name {
                Some(name) => parameters.iter().find(|own| own.name.eq_ignore_ascii_case(name)),
                None => places.next(),
            };
            let parameter = parameter.ok_or_else(|| {
                let name = name.as_deref().unwrap_or("so many operands");
                format!("`{}` does not have {name}", call.callee.root)
            })?;
            let Some(value) = value else { continue };
            if parameter.ty == Type::Unknown {
                return Err(of_unknown_type(&parameter.name));
            }
            let spelled = parameter.spelled.clone();
            match (parameter.role, direction, &value.kind) {
                (ParameterRole::Input, Direction::In, _) => {
                    let value = self.argument(value, &parameter.ty)?;
                    operands.push(Operand::Given(spelled, value.expression));
                }
                (ParameterRole::InOut, Direction::In, ExpressionKind::Place(place)) => {
                    let (path, ty) = self.path(place)?;
                    if ty != parameter.ty {
                        return Err(format!("`{path}` is of another type than `{}`", parameter.name));
                    }
                    operands.push(Operand::Given(spelled, path.into()));
                }
                (ParameterRole::Output, Direction::Out | Direction::In, ExpressionKind::Place(place)) => {
                    let (path, ty) = self.path(place)?;
                    if ty != parameter.ty {
                        return Err(format!("`{path}` is of another type than `{}`", parameter.name));
                    }
                    operands.push(Operand::Taken(spelled, path.into()));
                }
                _ => return Err(format!("`{}` is not handed over so", parameter.name)),
            }
        }
        Ok(operands)
    }

    /// An argument as one operand of a type.
    pub(super) fn argument(&mut self, tree: &Tree, ty: &Type) -> Lowered<Value> {
        let value = self.value(tree)?;
        match ty.scalar() {
            Some(scalar) => self.settled(value, scalar),
            None if value.ty == *ty => {
                let Some(from) = value.bare().path().filter(|_| value.is_in_instance) else {
                    return Ok(value);
                };
                let held = self.compound(ty)?;
                self.copied(&held, from, ty)?;
                Ok(Value::of(held, ty.clone()))
            }
            None => Err("an argument is of another type".to_owned()),
        }
    }
}

/// Why a parameter is not handed over: it is not declared.
pub(super) fn of_unknown_type(name: &str) -> String {
    format!("the type of `{name}` is not known here")
}

/// Inputs that a call leaves out and that have no value of their own: they have that of their type.
fn left_out(parameters: &[Parameter], operands: &[Operand]) -> Vec<Operand> {
    let is_given = |parameter: &Parameter| {
        operands
            .iter()
            .any(|operand| matches!(operand, Operand::Given(name, _) if *name == parameter.spelled))
    };
    let open = parameters
        .iter()
        .filter(|it| it.role == ParameterRole::Input && !it.has_default && !is_given(it));
    open.filter_map(|it| match &it.ty {
        Type::Scalar(scalar) => Some(Operand::Given(it.spelled.clone(), zero(*scalar).into())),
        _ => None,
    })
    .collect()
}

/// What a conversion makes of what: `INT_TO_REAL`, `TO_REAL`, `REAL_TRUNC_INT`
fn conversion(name: &str) -> Option<(Option<Scalar>, Scalar)> {
    if let Some(to) = name.strip_prefix("TO_") {
        return Some((None, converted(to)?));
    }
    let (from, to) = name.split_once("_TO_")?;
    Some((Some(converted(from)?), converted(to)?))
}

/// The arguments in the order of the inputs.
fn in_order<'c>(call: &'c Call, pins: &[&str]) -> Lowered<Vec<&'c Tree>> {
    let is_named = call.arguments.iter().any(|argument| argument.name.is_some());
    if !is_named || pins.is_empty() {
        let values = call
            .arguments
            .iter()
            .map(|argument| argument.value.as_ref().ok_or("a value is missing"));
        return values.collect::<Result<Vec<_>, _>>().map_err(str::to_owned);
    }
    let others = || format!("`{}` has other inputs", call.callee.root);
    let mut values: Vec<Option<&Tree>> = vec![None; call.arguments.len()];
    for (number, Argument { name, value, .. }) in call.arguments.iter().enumerate() {
        let at = match name {
            Some(name) => place_of(name, pins),
            None => Some(number),
        };
        let place = at.and_then(|at| values.get_mut(at)).filter(|it| it.is_none());
        *place.ok_or_else(others)? = value.as_ref();
    }
    values.into_iter().collect::<Option<_>>().ok_or_else(others)
}

/// The place of an input among those of a function, by its name or the one that CODESYS has for it.
fn place_of(name: &str, pins: &[&str]) -> Option<usize> {
    let upper = name.to_ascii_uppercase();
    let also = match upper.as_str() {
        "SIZE" | "LEN" => "L".to_owned(),
        "POS" => "P".to_owned(),
        _ => upper.replacen("STR", "IN", 1),
    };
    if let Some(at) = pins.iter().position(|pin| *pin == upper || *pin == also) {
        return Some(at);
    }
    // `MAX(IN1 := a, IN2 := b, IN3 := c)`
    let number = |name: &str| name.strip_prefix("IN")?.parse::<usize>().ok();
    let last = number(pins.last()?)?;
    (pins.len() - 1 + number(&also)?).checked_sub(last)
}
