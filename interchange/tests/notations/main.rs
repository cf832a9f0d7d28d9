//! The notations of other systems.

mod click_csv;
mod cplc_draft;
mod iot;
mod ldmicro;
mod ldmicro_text;
mod textbook;
