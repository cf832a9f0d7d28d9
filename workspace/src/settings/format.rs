//! `[format]`: how diagrams are laid out.

use super::reader::{Reader, Table};
use ladder_format::Options;

pub(super) fn read<'t>(mut table: Table<'t>, reader: &mut Reader<'t>) -> Options {
    let mut options = Options::default();
    if let Some(width) = table
        .take("width")
        .and_then(|given| reader.number(&given, 40, 10_000))
    {
        options.width = width as u32;
    }
    if let Some(spacing) = table
        .take("spacing")
        .and_then(|given| reader.number(&given, 1, 40))
    {
        options.spacing = spacing as u32;
    }
    table.finish(reader);
    options
}
