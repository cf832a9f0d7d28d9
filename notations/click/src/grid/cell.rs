//! One cell of the condition grid, and one row of them.

use ladder_notation::LineColumn;

/// How many condition cells a row has: the columns A to AE.
pub(in super::super) const COLUMNS: usize = 31;

/// A text of the file and where it begins.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Text {
    pub(super) text: String,
    pub(super) place: LineColumn,
}

/// What fills a cell from its left edge to its right one.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) enum Body {
    /// Nothing.
    #[default]
    Empty,
    /// Wire.
    Wire,
    /// A contact or a comparison.
    Contact(Text),
}

/// A cell.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct Cell {
    pub(super) body: Body,
    /// Whether wire goes down along its left edge, to the left edge of the cell below.
    pub(super) down: bool,
}

impl Cell {
    /// From its text in the file.
    pub(super) fn read(text: &str, place: LineColumn) -> Cell {
        let body = match text {
            "" | "|" => Body::Empty,
            "-" | "T" => Body::Wire,
            contact => Body::Contact(Text {
                text: below(contact).unwrap_or(contact).to_owned(),
                place,
            }),
        };
        let down = matches!(text, "|" | "T") || below(text).is_some();
        Cell { body, down }
    }

    /// Its text in the file.
    pub(super) fn text(&self) -> String {
        match (&self.body, self.down) {
            (Body::Empty, false) => String::new(),
            (Body::Empty, true) => "|".to_owned(),
            (Body::Wire, false) => "-".to_owned(),
            (Body::Wire, true) => "T".to_owned(),
            (Body::Contact(contact), false) => contact.text.clone(),
            (Body::Contact(contact), true) => format!("T:{}", contact.text),
        }
    }
}

/// The contact of a cell whose left edge has wire that goes down: `T:X001`, `|:X001`.
fn below(text: &str) -> Option<&str> {
    text.strip_prefix("T:").or_else(|| text.strip_prefix("|:"))
}

/// A row of a rung.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Row {
    pub(super) place: LineColumn,
    /// [`COLUMNS`] of them.
    pub(super) cells: Vec<Cell>,
    /// What is in column AF, if there is anything.
    pub(super) output: Option<Text>,
}

impl Row {
    /// Without anything in it.
    pub(super) fn empty() -> Row {
        Row {
            place: LineColumn::START,
            cells: vec![Cell::default(); COLUMNS],
            output: None,
        }
    }
}

/// A rung, with the comments above it.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct GridRung {
    pub(super) comments: Vec<Text>,
    pub(super) rows: Vec<Row>,
}

/// A whole file.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct Grid {
    pub(super) rungs: Vec<GridRung>,
    /// The comments below the last rung.
    pub(super) end: Vec<Text>,
}
