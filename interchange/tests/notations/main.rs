//! The notations of other systems.

mod broken;
mod click_csv;
mod cplc_draft;
mod hostile;
mod iot;
mod ldmicro;
mod ldmicro_fork;
mod ldmicro_fork_lines;
mod ldmicro_text;
mod textbook;
