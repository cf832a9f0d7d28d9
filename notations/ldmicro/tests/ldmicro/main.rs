//! Programs of LDmicro, of its fork, and the text that it exports.

mod fork;
mod fork_lines;
mod fork_programs;
mod heads;
mod programs;
mod text;
