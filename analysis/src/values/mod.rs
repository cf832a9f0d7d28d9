//! Types, literals and the values that programs hold (LANGUAGE §3, §4).

pub(crate) mod address_bits;
pub mod callable;
pub mod compound;
pub mod literal;
pub mod types;
pub mod value;
