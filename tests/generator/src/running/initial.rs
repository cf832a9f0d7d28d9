//! What tags start with: an initial value takes the place of the declared one as a whole, and what it leaves out has its type's own.

use super::Value;
use crate::generator::typed::{Declared, Initial, Ty, Typed};

/// What a tag or member starts with.
pub(super) fn initial(program: &Typed, declared: &Declared) -> Value {
    match &declared.initial {
        Some(initial) => given(program, &declared.ty, initial),
        None => own(program, &declared.ty),
    }
}

/// The value of a type, for what says none of its own.
fn own(program: &Typed, ty: &Ty) -> Value {
    match ty {
        Ty::Bool | Ty::Int => Value::One(0),
        Ty::Range(low, _) => Value::One(*low),
        Ty::Phase => {
            let first = &program.phase.values[0].0;
            phase(program, program.phase.initial.as_ref().unwrap_or(first))
        }
        Ty::Structure(number) => {
            let members = program.structures[*number].members.iter();
            Value::Many(members.map(|member| initial(program, member)).collect())
        }
        Ty::Alias(number) => initial(program, &program.aliases[*number]),
        Ty::Array(dimensions, element) => Value::Many(vec![own(program, element); count(dimensions)]),
        Ty::Ton => Value::Ton(None, 0, false),
        Ty::Ctu => Value::Ctu(0, false, false),
        Ty::Acc => Value::Acc(0, false, 0, false),
    }
}

fn given(program: &Typed, ty: &Ty, value: &Initial) -> Value {
    match (program.unnamed(ty), value) {
        (_, Initial::Number(number)) => Value::One(*number),
        (_, Initial::Value(name)) => phase(program, name),
        (Ty::Structure(number), Initial::Members(values)) => {
            let members = program.structures[*number].members.iter().map(|member| {
                let value = values.iter().find(|(name, _)| *name == member.name);
                match value {
                    Some((_, value)) => given(program, &member.ty, value),
                    None => initial(program, member),
                }
            });
            Value::Many(members.collect())
        }
        (Ty::Array(dimensions, element), Initial::Elements(values)) => {
            let mut elements = Vec::new();
            for (times, value) in values {
                let value = match value {
                    Some(value) => given(program, element, value),
                    None => own(program, element),
                };
                elements.extend(std::iter::repeat_n(value, *times as usize));
            }
            elements.resize(count(dimensions), own(program, element));
            Value::Many(elements)
        }
        (ty, _) => own(program, ty),
    }
}

fn phase(program: &Typed, name: &str) -> Value {
    let value = program.phase.values.iter().find(|(value, _)| value == name);
    Value::One(value.expect("a value of the enumeration").1)
}

fn count(dimensions: &[(i64, i64)]) -> usize {
    let counts = dimensions.iter().map(|(first, last)| last - first + 1);
    counts.product::<i64>() as usize
}
