//! The cross-reference on the last pages: each tag, and the networks and lines that write and read it.

use super::super::style::Look;
use super::declarations::Group;
use super::flow::{APART, CLOSE, place, text};
use super::pages::{Pages, Strip};
use super::table::Table;
use ladder_analysis::context::Context;
use ladder_analysis::{AccessKind, TagEntry, TagPlace, cross_reference};

/// The columns of the table.
const COLUMNS: [&str; 5] = ["Tag", "Type", "Kind", "Written", "Read"];

/// Adds it to the pages.
pub(super) fn fill(pages: &mut Pages, context: &Context) {
    let entries = cross_reference(context);
    if entries.is_empty() {
        return;
    }
    let group = Group {
        rows: entries.iter().map(row).collect(),
        ..Group::default()
    };
    let groups = [group];
    let table = Table::with_columns(COLUMNS, &groups, pages.columns());
    let wide = pages.pixels();
    pages.turn();
    place(pages, text(pages, Look::Name, "Cross-reference", APART));
    let legend = "NETWORK/LINE; S sets, R resets, * reads and writes";
    place(pages, text(pages, Look::Comment, legend, 0.0));
    place(pages, Strip::of(table.header(), wide, CLOSE));
    for row in groups[0].rows.iter().flat_map(|row| table.row(row)) {
        let row = Strip::of(row, wide, 0.0);
        if !pages.has_room(&[&row]) {
            pages.turn();
            pages.place(Strip::of(table.header(), wide, 0.0));
        }
        pages.place(row);
    }
}

fn row(entry: &TagEntry) -> [String; 5] {
    let name = match &entry.block {
        Some(block) => format!("{block}.{}", entry.name),
        None => entry.name.clone(),
    };
    [
        name,
        entry.ty.clone(),
        entry.kind.word().to_owned(),
        places(entry.writers()),
        places(entry.readers()),
    ]
}

fn places<'p>(places: impl Iterator<Item = &'p TagPlace>) -> String {
    let places: Vec<String> = places
        .map(|place| {
            let mark = match place.access {
                AccessKind::Read | AccessKind::Write => "",
                AccessKind::Set => " S",
                AccessKind::Reset => " R",
                AccessKind::ReadWrite => "*",
            };
            format!("{}/{}{mark}", place.network, place.line)
        })
        .collect();
    places.join(", ")
}
