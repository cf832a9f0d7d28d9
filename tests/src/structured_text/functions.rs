//! Operators and the standard's functions.

use super::value::{Type, Value};
use std::cmp::Ordering;

type Result = std::result::Result<Value, String>;

/// `a op b`
pub(super) fn binary(operator: &str, a: Value, b: Value) -> Result {
    use Value as V;
    let wrong = |a: &Value, b: &Value| Err(format!("{a:?} {operator} {b:?}"));
    if let "=" | "<>" | "<" | ">" | "<=" | ">=" = operator {
        let order = order(&a, &b)?;
        return Ok(V::Bool(match operator {
            "=" => order == Some(Ordering::Equal),
            "<>" => order != Some(Ordering::Equal),
            "<" => order == Some(Ordering::Less),
            ">" => order == Some(Ordering::Greater),
            "<=" => order.is_some_and(Ordering::is_le),
            _ => order.is_some_and(Ordering::is_ge),
        }));
    }
    match (a, b) {
        (V::Bool(a), V::Bool(b)) => Ok(V::Bool(match operator {
            "AND" => a & b,
            "OR" => a | b,
            "XOR" => a ^ b,
            _ => return wrong(&V::Bool(a), &V::Bool(b)),
        })),
        (V::Int(a, one), V::Int(b, other)) => {
            let ty = one.clone().or_else(|| other.clone());
            if one.is_some() && other.is_some() && one != other {
                return Err(format!("{one:?} {operator} {other:?}"));
            }
            let is_bits = matches!(ty, Some(Type::Int(_, _, true)));
            let unsigned = matches!(ty, Some(Type::Int(64, false, _)));
            let number = match operator {
                "AND" | "OR" | "XOR" if !is_bits && ty.is_some() => {
                    return Err(format!("{operator} of {ty:?}"));
                }
                "+" | "-" | "*" | "/" | "MOD" if is_bits => return Err(format!("{operator} of {ty:?}")),
                "AND" => a & b,
                "OR" => a | b,
                "XOR" => a ^ b,
                "+" => a.wrapping_add(b),
                "-" => a.wrapping_sub(b),
                "*" => a.wrapping_mul(b),
                _ if b == 0 => return Err("a division by zero".into()),
                "/" if unsigned => (a as u64 / b as u64) as i64,
                "MOD" if unsigned => (a as u64 % b as u64) as i64,
                "/" => a.checked_div(b).ok_or("a quotient that is too large")?,
                _ => a.checked_rem(b).ok_or("a quotient that is too large")?,
            };
            Ok(V::Int(number, ty))
        }
        (V::Real(a, one), V::Real(b, other)) => real(operator, a, one, b, other),
        (V::Real(a, one), V::Int(b, None)) => real(operator, a, one, b as f64, None),
        (V::Int(a, None), V::Real(b, other)) => real(operator, a as f64, None, b, other),
        (V::Time(a), V::Time(b)) if operator == "+" => Ok(V::Time(a.wrapping_add(b))),
        (V::Time(a), V::Time(b)) if operator == "-" => Ok(V::Time(a.wrapping_sub(b))),
        (V::Time(a), V::Int(b, _)) if operator == "*" => Ok(V::Time(a.wrapping_mul(b))),
        (V::Time(a), V::Int(b, _)) if operator == "/" => a
            .checked_div(b)
            .map(V::Time)
            .ok_or_else(|| "a division by zero".into()),
        (V::Clock(a, "DT"), V::Time(b)) if operator == "+" => Ok(V::Clock(a.wrapping_add(b), "DT")),
        (V::Clock(a, "DT"), V::Time(b)) if operator == "-" => Ok(V::Clock(a.wrapping_sub(b), "DT")),
        (V::Clock(a, one), V::Clock(b, other)) if operator == "-" && one == other => {
            Ok(V::Time(a.wrapping_sub(b)))
        }
        (a, b) => wrong(&a, &b),
    }
}

fn real(operator: &str, a: f64, one: Option<bool>, b: f64, other: Option<bool>) -> Result {
    if one.is_some() && other.is_some() && one != other {
        return Err(format!("REAL {operator} LREAL"));
    }
    let ty = one.or(other);
    let round = |real: f64| {
        if ty == Some(true) {
            f64::from(real as f32)
        } else {
            real
        }
    };
    let (a, b) = (round(a), round(b));
    let value = match operator {
        "+" => a + b,
        "-" => a - b,
        "*" => a * b,
        "/" if b == 0.0 => return Err("a division by zero".into()),
        "/" => a / b,
        _ => return Err(format!("{operator} of reals")),
    };
    Ok(Value::Real(round(value), ty))
}

/// How two values compare; not at all if one is not a number.
fn order(a: &Value, b: &Value) -> std::result::Result<Option<Ordering>, String> {
    use Value as V;
    let wrong = || Err(format!("{a:?} compared with {b:?}"));
    match (a, b) {
        (V::Bool(a), V::Bool(b)) => Ok(Some(a.cmp(b))),
        (V::Int(a, one), V::Int(b, other)) => {
            if one.is_some() && other.is_some() && one != other {
                return wrong();
            }
            Ok(Some(match one.as_ref().or(other.as_ref()) {
                Some(Type::Int(64, false, _)) => (*a as u64).cmp(&(*b as u64)),
                _ => a.cmp(b),
            }))
        }
        (V::Real(a, one), V::Real(b, other)) => {
            if one.is_some() && other.is_some() && one != other {
                return wrong();
            }
            let single = one.or(*other) == Some(true);
            let round = |real: f64| if single { f64::from(real as f32) } else { real };
            Ok(round(*a).partial_cmp(&round(*b)))
        }
        (V::Real(a, _), V::Int(b, None)) => Ok(a.partial_cmp(&(*b as f64))),
        (V::Time(a), V::Time(b)) => Ok(Some(a.cmp(b))),
        (V::Clock(a, one), V::Clock(b, other)) if one == other => Ok(Some(a.cmp(b))),
        (V::Text(a), V::Text(b)) => Ok(Some(a.cmp(b))),
        (V::Named(a), V::Named(b)) => Ok(Some(a.cmp(b))),
        _ => wrong(),
    }
}

/// `NOT a`, `-a`
pub(super) fn unary(operator: &str, a: Value) -> Result {
    match (operator, a) {
        ("NOT", Value::Bool(a)) => Ok(Value::Bool(!a)),
        // It gets its width where it is assigned.
        ("NOT", Value::Int(a, None)) => Ok(Value::Int(!a, None)),
        ("NOT", Value::Int(a, Some(ty @ Type::Int(_, _, true)))) => Ok(Value::Int(ty.wrap(!a), Some(ty))),
        ("-", Value::Int(a, ty)) => Ok(Value::Int(a.wrapping_neg(), ty)),
        ("-", Value::Real(a, ty)) => Ok(Value::Real(-a, ty)),
        (_, a) => Err(format!("{operator} {a:?}")),
    }
}

/// A function of the standard.
pub(super) fn call(name: &str, all: Vec<Value>) -> Result {
    use Value as V;
    if let Some((from, to)) = name.split_once("_TO_") {
        let [value] = <[Value; 1]>::try_from(all).map_err(|_| "one operand")?;
        return convert(from, to, value);
    }
    let number = |value: &Value| match value {
        V::Int(number, _) => Ok(*number),
        other => Err(format!("{other:?} is no number")),
    };
    let less = |a: &Value, b: &Value| Ok::<bool, String>(order(a, b)? == Some(Ordering::Less));
    let text = |value: &Value| match value {
        V::Text(text) => Ok(text.clone()),
        other => Err(format!("{other:?} is no text")),
    };
    match (name, all.as_slice()) {
        ("ABS", [V::Int(a, ty)]) => Ok(V::Int(a.wrapping_abs(), ty.clone())),
        ("ABS", [V::Real(a, ty)]) => Ok(V::Real(a.abs(), *ty)),
        (
            "SQRT" | "LN" | "LOG" | "EXP" | "SIN" | "COS" | "TAN" | "ASIN" | "ACOS" | "ATAN",
            [V::Real(a, ty)],
        ) => {
            let a = *a;
            let value = match name {
                "SQRT" => a.sqrt(),
                "LN" => a.ln(),
                "LOG" => a.log10(),
                "EXP" => a.exp(),
                "SIN" => a.sin(),
                "COS" => a.cos(),
                "TAN" => a.tan(),
                "ASIN" => a.asin(),
                "ACOS" => a.acos(),
                _ => a.atan(),
            };
            if value.is_nan() && !a.is_nan() && name != "SIN" && name != "COS" {
                return Err(format!("{name} of {a}"));
            }
            Ok(V::Real(
                if *ty == Some(true) {
                    f64::from(value as f32)
                } else {
                    value
                },
                *ty,
            ))
        }
        ("EXPT", [V::Real(a, ty), V::Real(b, _)]) => {
            let value = a.powf(*b);
            Ok(V::Real(
                if *ty == Some(true) {
                    f64::from(value as f32)
                } else {
                    value
                },
                *ty,
            ))
        }
        ("MIN", [a, b]) => Ok(if less(b, a)? { like(b, a) } else { like(a, b) }),
        ("MAX", [a, b]) => Ok(if less(a, b)? { like(b, a) } else { like(a, b) }),
        ("LIMIT", [low, a, high]) => {
            let a = if less(a, low)? { like(low, a) } else { a.clone() };
            Ok(if less(high, &a)? { like(high, &a) } else { a })
        }
        ("SEL", [V::Bool(g), a, b]) => Ok(if *g { like(b, a) } else { like(a, b) }),
        ("MUX", [k, values @ ..]) => {
            let k = usize::try_from(number(k)?).map_err(|_| "MUX of too few")?;
            Ok(values.get(k).ok_or("MUX of too few")?.clone())
        }
        ("SHL" | "SHR" | "ROL" | "ROR", [V::Int(a, Some(ty @ Type::Int(bits, _, true))), n]) => {
            let (n, bits) = (number(n)?, *bits);
            if !(0..i64::from(bits)).contains(&n) {
                return Err(format!("{name} by {n}"));
            }
            let (a, n) = (*a as u64, n as u32);
            let value = match name {
                "SHL" => a << n,
                "SHR" => a >> n,
                _ if n == 0 => a,
                "ROL" => a << n | a >> (bits - n),
                _ => a >> n | a << (bits - n),
            };
            Ok(V::Int(ty.wrap(value as i64), Some(ty.clone())))
        }
        ("LEN", [a]) => Ok(V::Int(text(a)?.len() as i64, Type::named("INT"))),
        ("FIND", [a, b]) => {
            let (a, b) = (text(a)?, text(b)?);
            let found = a.windows(b.len().max(1)).position(|part| part == b.as_slice());
            Ok(V::Int(found.map_or(0, |at| at as i64 + 1), Type::named("INT")))
        }
        ("CONCAT", all) => {
            let all: std::result::Result<Vec<_>, String> = all.iter().map(text).collect();
            Ok(V::Text(all?.concat()))
        }
        ("LEFT", [a, n]) => part(&text(a)?, number(n)?, 1),
        ("RIGHT", [a, n]) => {
            let a = text(a)?;
            part(&a, number(n)?, a.len() as i64 - number(n)? + 1)
        }
        ("MID", [a, n, at]) => part(&text(a)?, number(n)?, number(at)?),
        ("INSERT", [a, b, at]) => {
            let (mut a, at) = (text(a)?, number(at)? as usize);
            if at > a.len() {
                return Err("INSERT after the end".into());
            }
            a.splice(at..at, text(b)?);
            Ok(V::Text(a))
        }
        ("DELETE", [a, n, at]) => replaced(text(a)?, &[], number(n)?, number(at)?),
        ("REPLACE", [a, b, n, at]) => replaced(text(a)?, &text(b)?, number(n)?, number(at)?),
        (_, all) => Err(format!("{name} of {all:?}")),
    }
}

/// A literal takes the type of what is next to it.
fn like(value: &Value, other: &Value) -> Value {
    match (value, other) {
        (Value::Int(number, None), Value::Int(_, ty)) => Value::Int(*number, ty.clone()),
        (Value::Real(number, None), Value::Real(_, ty)) => Value::Real(*number, *ty),
        _ => value.clone(),
    }
}

fn part(text: &[u8], count: i64, position: i64) -> Result {
    let start = usize::try_from(position - 1).map_err(|_| "a position before the start")?;
    let end = start + usize::try_from(count).map_err(|_| "fewer than none")?;
    text.get(start..end)
        .map(|part| Value::Text(part.to_vec()))
        .ok_or_else(|| "after the end of a text".into())
}

fn replaced(mut text: Vec<u8>, new: &[u8], count: i64, position: i64) -> Result {
    part(&text, count, position)?;
    let start = position as usize - 1;
    text.splice(start..start + count as usize, new.iter().copied());
    Ok(Value::Text(text))
}

fn convert(from: &str, to: &str, value: Value) -> Result {
    use Value as V;
    let (source, target) = (Type::named(from).ok_or(from)?, Type::named(to).ok_or(to)?);
    // What is given has the type that the function's name says.
    let value = source.hold(value)?;
    Ok(match (value, &target) {
        (V::Bool(high), Type::Int(..)) => V::Int(i64::from(high), Some(target)),
        (V::Int(number, _), Type::Int(..)) => V::Int(target.wrap(number), Some(target)),
        (V::Int(number, ty), Type::Real(single)) => {
            let real = match ty {
                Some(Type::Int(64, false, _)) => number as u64 as f64,
                _ => number as f64,
            };
            V::Real(if *single { f64::from(real as f32) } else { real }, Some(*single))
        }
        (V::Real(real, _), Type::Real(single)) => {
            V::Real(if *single { f64::from(real as f32) } else { real }, Some(*single))
        }
        (V::Real(real, _), Type::Int(64, true, false)) => {
            if real.is_nan() || real.abs() >= 9.223e18 {
                return Err(format!("{real} as a LINT"));
            }
            V::Int(real.round_ties_even() as i64, Some(target))
        }
        (V::Clock(time, "DT"), Type::Clock("DATE")) => {
            V::Clock(time.div_euclid(86_400_000_000_000) * 86_400_000_000_000, "DATE")
        }
        (V::Clock(time, "DT"), Type::Clock("TOD")) => V::Clock(time.rem_euclid(86_400_000_000_000), "TOD"),
        (value, _) => return Err(format!("{value:?} from {from} to {to}")),
    })
}
