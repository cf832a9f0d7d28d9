//! The keys at the bottom. They can be clicked.

use super::{Scene, put};
use crate::screen::keys::{self, Action, Hint};
use ladder_format::display_width;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

/// A terminal of this width has room for wider gaps.
const WIDE: u16 = 90;

pub(super) fn draw(buffer: &mut Buffer, pane: Rect, scene: Scene) {
    let mut column = 1;
    for (key, does, _) in keys::hints(scene.view.running, scene.plant.watching().is_some()) {
        let end = put(buffer, pane, column, 0, key, scene.theme.key());
        put(buffer, pane, end, 0, &format!(" {does}"), Style::new());
        column += width(key, does, pane.width);
    }
}

/// What a click on a column does.
pub(in crate::screen) fn at(wanted: u16, hints: Vec<Hint>, pane_width: u16) -> Option<Action> {
    let mut column = 1;
    for (key, does, action) in hints {
        let next = column + width(key, does, pane_width);
        if (column..next).contains(&wanted) {
            return Some(action);
        }
        column = next;
    }
    None
}

/// With the blanks that follow.
fn width(key: &str, does: &str, pane_width: u16) -> u16 {
    let gap = if pane_width < WIDE { 2 } else { 4 };
    (display_width(key) + display_width(does)) as u16 + gap
}
