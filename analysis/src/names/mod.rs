//! The names of a file: the tags of its scopes, where they are declared and used, and their types.
//!
//! ```text
//! sections --declare--> tags of each scope --uses--> with the places that use them, and those that nobody declares
//!          --shared---> tags of other scopes and files
//!          --infer----> the types of undeclared ones
//! ```

pub(crate) mod at_address;
mod block_definition;
pub mod cold;
pub mod context;
pub(crate) mod declare;
pub mod declaring;
pub(crate) mod infer;
#[cfg(test)]
mod infer_tests;
mod instances;
pub mod join;
pub(crate) mod joined;
mod kept;
pub(crate) mod limits;
pub mod named_types;
pub(crate) mod operand_value;
mod path_limits;
pub(crate) mod path_type;
pub(crate) mod problem;
pub mod scope;
pub(crate) mod shared;
pub(crate) mod skeleton;
mod tag_facts;
mod type_by_form;
pub mod type_section;
mod unread_body;
pub(crate) mod unread_uses;
pub(crate) mod uses;
mod values_asked;
