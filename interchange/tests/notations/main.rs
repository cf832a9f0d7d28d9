//! The notations of other systems.

mod cplc_draft;
mod iot;
mod ldmicro;
mod textbook;
