//! What a person sees of a running program: a plain value. Events change it (`update`), drawing only reads it.

use super::columns;
use super::outputs::Outputs;
use super::panes::{Panes, panes};
use super::picker::Picker;
use super::plant::Plant;
use super::prompt::Prompt;
use super::sheet::{Block, Sheet};
use super::speed::Speed;
use ladder_simulator::Point;
use ratatui::layout::Rect;

/// The state of the screen.
#[derive(Debug)]
pub(super) struct View {
    /// The whole terminal.
    pub(super) area: Rect,
    /// The selected block, by its number on the sheet.
    pub(super) selected: usize,
    /// The first line that is shown.
    pub(super) top: usize,
    /// How far what is too wide is scrolled.
    pub(super) left: usize,
    pub(super) running: bool,
    pub(super) speed: Speed,
    /// How many scans a column of a waveform stands for.
    pub(super) scale: Scale,
    pub(super) mode: Mode,
    /// The last message; the next key takes it away.
    pub(super) note: Option<Note>,
    /// The file is not what runs any more.
    pub(super) changed_on_disk: bool,
    /// What `n` looks for.
    pub(super) sought: Option<Point>,
}

/// What keys mean now.
#[derive(Debug)]
pub(super) enum Mode {
    Diagram,
    Help,
    /// Why a tag holds what it holds.
    Why(Reasons),
    /// A value is being typed.
    Prompt(Prompt),
    /// A BOOL is about to be forced.
    Force(Point),
    /// A tag is being looked for.
    Pick(Picker),
    /// Tags are being chosen of which a recorded test expects something.
    Outputs(Outputs),
}

/// An answer that may be longer than the screen is high.
#[derive(Debug)]
pub(super) struct Reasons {
    pub(super) text: String,
    /// The first line that is shown.
    pub(super) top: usize,
}

/// A message in the line above the keys.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Note {
    pub(super) text: String,
    pub(super) kind: NoteKind,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum NoteKind {
    Hint,
    Refused,
}

/// How many scans a column of a waveform stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Scale(usize);

const SCALES: [u64; 10] = [1, 2, 4, 10, 20, 40, 100, 200, 400, 1000];

impl Scale {
    /// About a tenth of a second a column.
    fn of(interval: i64) -> Scale {
        let fits = |scans: &u64| *scans as i64 * interval <= 100_000_000;
        Scale(SCALES.iter().rposition(fits).unwrap_or(0))
    }

    pub(super) fn scans(self) -> u64 {
        SCALES[self.0]
    }

    pub(super) fn longer(self) -> Scale {
        Scale((self.0 + 1).min(SCALES.len() - 1))
    }

    pub(super) fn shorter(self) -> Scale {
        Scale(self.0.saturating_sub(1))
    }
}

impl View {
    /// The screen of a program that begins to run.
    pub(super) fn new(area: Rect, plant: &Plant) -> View {
        let mut view = View {
            area,
            selected: first_to_select(&plant.sheet, panes(area, plant).diagram.width.into()),
            top: 0,
            left: 0,
            running: true,
            speed: Speed::default(),
            scale: Scale::of(plant.simulation().options().interval),
            mode: Mode::Diagram,
            note: None,
            changed_on_disk: false,
            sought: None,
        };
        view.show_selected_from_its_comment(plant);
        view
    }

    /// Another version of the program runs now.
    pub(super) fn take_over(&mut self, plant: &Plant) {
        self.changed_on_disk = false;
        self.mode = Mode::Diagram;
        self.check_again(plant);
    }

    /// Another drawing is shown.
    pub(super) fn check_again(&mut self, plant: &Plant) {
        self.select(self.selected, plant);
    }

    /// Where everything is.
    pub(super) fn panes(&self, plant: &Plant) -> Panes {
        panes(self.area, plant)
    }

    /// Says something until the next key.
    pub(super) fn say(&mut self, text: impl Into<String>) {
        self.note = Some(Note {
            text: text.into(),
            kind: NoteKind::Hint,
        });
    }

    /// Says why something was not done.
    pub(super) fn refuse(&mut self, text: impl Into<String>) {
        self.note = Some(Note {
            text: text.into(),
            kind: NoteKind::Refused,
        });
    }

    /// Selects a block and brings it into sight.
    pub(super) fn select(&mut self, block: usize, plant: &Plant) {
        self.selected = block.min(plant.sheet.blocks.len().saturating_sub(1));
        self.show_selected(plant);
    }

    /// Scrolls as little as brings the selected block into sight.
    pub(super) fn show_selected(&mut self, plant: &Plant) {
        let pane = self.panes(plant).diagram;
        let Some(block) = plant.sheet.blocks.get(self.selected) else {
            return;
        };
        self.show_line(block.line, pane.height as usize, &plant.sheet);
        let line = plant.sheet.line(block.line);
        let start = plant.sheet.line_start(block.line);
        let columns = columns::column(line, block.start - start)..columns::column(line, block.end - start);
        let folding = plant.sheet.folding(pane.width.into());
        self.left = folding.left_for(plant.sheet.band(block.line), self.left, &columns);
    }

    /// Brings a line into sight, with a line or two around it.
    pub(super) fn show_line(&mut self, line: usize, height: usize, sheet: &Sheet) {
        let around = 2.min(height.saturating_sub(1) / 2);
        let lowest = sheet.height().saturating_sub(height.max(1));
        if line < self.top + around {
            self.top = line.saturating_sub(around);
        } else if line + around >= self.top + height {
            self.top = (line + around + 1).saturating_sub(height);
        }
        self.top = self.top.min(lowest);
    }

    /// The program from its first rung on, with the comment above it: what comes before are declarations.
    fn show_selected_from_its_comment(&mut self, plant: &Plant) {
        let sheet = &plant.sheet;
        let height = self.panes(plant).diagram.height as usize;
        if sheet.height() <= height || sheet.blocks.is_empty() {
            self.top = 0;
            self.show_selected(plant);
            return;
        }
        let mut first = sheet.first_line_of_network(0);
        while first > 0 && sheet.line(first - 1).trim_start().starts_with('#') {
            first -= 1;
        }
        self.top = first.min(sheet.height().saturating_sub(height));
        self.show_selected(plant);
    }

    /// Scrolls by lines.
    pub(super) fn scroll(&mut self, lines: isize, plant: &Plant) {
        let height = self.panes(plant).diagram.height as usize;
        let lowest = plant.sheet.height().saturating_sub(height);
        self.top = self.top.saturating_add_signed(lines).min(lowest);
    }

    /// Scrolls by columns.
    pub(super) fn scroll_sideways(&mut self, columns: isize, plant: &Plant) {
        let pane = self.panes(plant).diagram;
        let shown = self.top..(self.top + pane.height as usize).min(plant.sheet.height());
        let folding = plant.sheet.folding(pane.width.into());
        let most = shown
            .map(|line| plant.sheet.window(line, folding, 0).most_left())
            .max();
        let most = most.unwrap_or(0);
        self.left = self.left.saturating_add_signed(columns).min(most);
    }
}

/// The first contact of an input, for that is what one wants to switch; else the first block. What cannot be seen in the
/// pane before it is scrolled sideways is passed by: a program begins at its left, where its conditions are.
fn first_to_select(sheet: &Sheet, pane: usize) -> usize {
    let folding = sheet.folding(pane);
    let is_in_sight = |block: &Block| {
        let line = sheet.line(block.line);
        let start = sheet.line_start(block.line);
        let columns = columns::column(line, block.start - start)..columns::column(line, block.end - start);
        folding.left_for(sheet.band(block.line), 0, &columns) == 0
    };
    let is_of_input = |block: &Block| {
        let operand = block.operands.first();
        operand.is_some_and(|operand| Plant::is_input(&operand.point))
    };
    let blocks = || sheet.blocks.iter();
    blocks()
        .position(|block| is_of_input(block) && is_in_sight(block))
        .or_else(|| blocks().position(is_in_sight))
        .unwrap_or(0)
}
