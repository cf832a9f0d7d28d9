//! `[format]`: how diagrams are laid out.

use super::reader::{Reader, Table};
use super::table::{SPACING, WIDTH};
use ladder_format::Options;

pub(super) fn read(mut table: Table, reader: &mut Reader) -> Options {
    let mut options = Options::default();
    if let Some(width) = reader.whole(&mut table, &WIDTH) {
        options.width = width as u32;
    }
    if let Some(spacing) = reader.whole(&mut table, &SPACING) {
        options.spacing = spacing as u32;
    }
    table.finish(reader);
    options
}
