//! Both programs, run as a person runs them: in a folder, with arguments, looking at the exit status, stdout and
//! stderr.

mod bad_input;
mod check;
mod check_formats;
mod check_stdin;
mod click;
mod click_field;
mod convert;
mod escapes;
mod explain;
mod fixed_drawings;
mod fmt;
mod foreign;
mod foreign_at_hand;
mod harness;
mod help;
mod lsp;
mod lsp_ending;
mod lsp_recording;
mod new;
mod outside;
mod pages;
mod render;
#[cfg(feature = "pdf")]
mod render_pdf;
mod replacing;
mod retain;
mod scenario_formats;
mod scenarios;
mod settings;
mod several_files;
mod sim;
mod sim_formats;
mod tags;
mod tree;
mod watch;
