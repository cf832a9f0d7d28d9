//! What lies at the addresses of other systems.

use ladder_analysis::values::types::Scalar;
use std::collections::HashSet;

/// Whether one value of a type is as wide as what is at an address of ladder text, such as `%MW4`.
pub fn is_as_wide(address: &str, ty: Scalar) -> bool {
    let width = match address.as_bytes().get(2) {
        Some(b'X') => 1,
        Some(b'B') => 8,
        Some(b'W') => 16,
        Some(b'D') => 32,
        _ => 64,
    };
    !ty.is_string() && ty.width() == width
}

/// The addresses that are there more than once, in capital letters; `%Q*` is not an address yet.
pub fn several<'a>(addresses: impl Iterator<Item = &'a str>) -> HashSet<String> {
    let mut seen = HashSet::new();
    addresses
        .map(str::to_ascii_uppercase)
        .filter(|address| !address.ends_with('*') && !seen.insert(address.clone()))
        .collect()
}
