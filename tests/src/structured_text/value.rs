//! Values and elementary types.

/// An elementary type.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Type {
    /// One bit.
    Bool,
    /// A whole number or bit string: bits, whether it has a sign, whether it is a bit string.
    Int(u32, bool, bool),
    /// REAL, or LREAL.
    Real(bool),
    /// TIME.
    Time,
    /// DATE, TOD or DT.
    Clock(&'static str),
    /// STRING of at most so many bytes.
    Text(usize),
    /// An enumeration.
    Named(String),
}

/// A value. Whole numbers of no type are literals: they take that of their place.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// BOOL.
    Bool(bool),
    /// Whole numbers and bit strings.
    Int(i64, Option<Type>),
    /// Reals; whether it is a REAL, or a literal.
    Real(f64, Option<bool>),
    /// TIME in nanoseconds.
    Time(i64),
    /// DATE, TOD or DT in nanoseconds.
    Clock(i64, &'static str),
    /// STRING.
    Text(Vec<u8>),
    /// A value of an enumeration, by its name in capitals.
    Named(String),
}

impl Type {
    /// The type of a name in capitals.
    pub fn named(name: &str) -> Option<Type> {
        Some(match name {
            "BOOL" => Type::Bool,
            "BYTE" => Type::Int(8, false, true),
            "WORD" => Type::Int(16, false, true),
            "DWORD" => Type::Int(32, false, true),
            "LWORD" => Type::Int(64, false, true),
            "SINT" => Type::Int(8, true, false),
            "INT" => Type::Int(16, true, false),
            "DINT" => Type::Int(32, true, false),
            "LINT" => Type::Int(64, true, false),
            "USINT" => Type::Int(8, false, false),
            "UINT" => Type::Int(16, false, false),
            "UDINT" => Type::Int(32, false, false),
            "ULINT" => Type::Int(64, false, false),
            "REAL" => Type::Real(true),
            "LREAL" => Type::Real(false),
            "TIME" => Type::Time,
            "DATE" => Type::Clock("DATE"),
            "TOD" => Type::Clock("TOD"),
            "DT" => Type::Clock("DT"),
            "STRING" => Type::Text(80),
            _ => return None,
        })
    }

    /// What a variable of the type starts with.
    pub fn zero(&self) -> Value {
        match self {
            Type::Bool => Value::Bool(false),
            Type::Int(..) => Value::Int(0, Some(self.clone())),
            Type::Real(single) => Value::Real(0.0, Some(*single)),
            Type::Time => Value::Time(0),
            Type::Clock(of) => Value::Clock(0, of),
            Type::Text(_) => Value::Text(Vec::new()),
            Type::Named(_) => Value::Named(String::new()),
        }
    }

    /// A number in the width of the type.
    pub fn wrap(&self, number: i64) -> i64 {
        match *self {
            Type::Int(bits, signed, _) if bits < 64 => {
                let shift = 64 - bits;
                if signed {
                    number << shift >> shift
                } else {
                    ((number as u64) << shift >> shift) as i64
                }
            }
            _ => number,
        }
    }

    /// A value as a variable of the type holds it.
    ///
    /// # Errors
    /// It is of another type.
    pub fn hold(&self, value: Value) -> Result<Value, String> {
        match (self, value) {
            (Type::Int(..), Value::Int(number, ty)) if ty.as_ref().is_none_or(|ty| ty == self) => {
                Ok(Value::Int(self.wrap(number), Some(self.clone())))
            }
            (Type::Real(single), Value::Int(number, None)) => Ok(Value::Real(number as f64, Some(*single))),
            (Type::Real(single), Value::Real(real, ty)) if ty.is_none_or(|ty| ty == *single) => Ok(
                Value::Real(if *single { f64::from(real as f32) } else { real }, Some(*single)),
            ),
            (Type::Text(most), Value::Text(mut text)) => {
                text.truncate(*most);
                Ok(Value::Text(text))
            }
            (Type::Bool, value @ Value::Bool(_))
            | (Type::Time, value @ Value::Time(_))
            | (Type::Named(_), value @ Value::Named(_)) => Ok(value),
            (Type::Clock(of), value @ Value::Clock(_, own)) if *of == own => Ok(value),
            (_, value) => Err(format!("{value:?} is no {self:?}")),
        }
    }
}
