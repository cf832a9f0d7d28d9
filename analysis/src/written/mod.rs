//! What is written, as plain values: operands, types, headers of blocks. What names in it mean is for `names` to say.

pub mod constant;
pub mod facts;
pub mod import;
pub(crate) mod refused_name;
pub mod type_spec;
pub mod user_block;
