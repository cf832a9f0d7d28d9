//! What the form of a name says of a tag that has no declaration.

use crate::program::Role;
use crate::values::types::Scalar;

/// The type and role that a name without a declaration says by its form (LANGUAGE §4): `I1`, `MF3`, `%QX1.7`.
pub fn type_by_form(name: &str) -> Option<(Scalar, Role)> {
    if let Some(address) = name.strip_prefix('%') {
        return type_by_address(address);
    }
    let upper = name.to_ascii_uppercase();
    let letters = upper.trim_end_matches(|c: char| c.is_ascii_digit());
    if letters.len() == upper.len() {
        return None;
    }
    match letters {
        "I" => Some((Scalar::Bool, Role::Input)),
        "Q" => Some((Scalar::Bool, Role::Output)),
        "M" => Some((Scalar::Bool, Role::Internal)),
        "MI" => Some((Scalar::Dint, Role::Internal)),
        "MF" => Some((Scalar::Lreal, Role::Internal)),
        _ => None,
    }
}

/// `IX0.3`: the area, the size, then numbers with points between.
fn type_by_address(address: &str) -> Option<(Scalar, Role)> {
    let upper = address.to_ascii_uppercase();
    let mut letters = upper.chars();
    let role = match letters.next()? {
        'I' => Role::Input,
        'Q' => Role::Output,
        'M' => Role::Internal,
        _ => return None,
    };
    let scalar = match letters.next()? {
        'X' => Scalar::Bool,
        'B' => Scalar::Byte,
        'W' => Scalar::Word,
        'D' => Scalar::Dword,
        'L' => Scalar::Lword,
        _ => return None,
    };
    let numbers = &upper[2..];
    let well_formed = !numbers.is_empty()
        && numbers
            .split('.')
            .all(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()));
    well_formed.then_some((scalar, role))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forms() {
        for (name, expected) in [
            ("I1", Some((Scalar::Bool, Role::Input))),
            ("q12", Some((Scalar::Bool, Role::Output))),
            ("MI3", Some((Scalar::Dint, Role::Internal))),
            ("MF0", Some((Scalar::Lreal, Role::Internal))),
            ("I", None),
            ("I1a", None),
            ("%IX0.3", Some((Scalar::Bool, Role::Input))),
            ("%MW10", Some((Scalar::Word, Role::Internal))),
            ("%IX", None),
            ("%ZX1", None),
        ] {
            assert_eq!(type_by_form(name), expected, "{name}");
        }
    }
}
