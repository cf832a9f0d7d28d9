//! Mistakes that are found while tags are declared and operands resolved: their sentences and fixes, one file for each
//! rule. Nothing here depends on `rules`, which look at what came out.

pub(crate) mod bad_declaration;
pub(crate) mod bad_operand;
pub(crate) mod constant_write;
pub(crate) mod duplicate_function;
pub(crate) mod literals;
pub(crate) mod of_names;
pub(crate) mod one_address;
pub(crate) mod type_mismatch;
pub(crate) mod unknown_function;
pub(crate) mod unknown_label;
pub(crate) mod unknown_member;
