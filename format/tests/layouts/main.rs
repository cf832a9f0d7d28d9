//! Drawings before and after they are aligned.

mod circuits;
mod languages_drawings;
mod large;
mod layout;
mod line_ends;
mod locality;
mod operands;
mod options;
mod parts;
mod programs;
mod sketches;
