//! The inputs with the keys that switch them.

use super::{Scene, heading, put};
use crate::screen::inputs;
use ladder_analysis::values::types::Scalar;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

pub(super) fn draw(buffer: &mut Buffer, pane: Rect, scene: Scene) {
    let Scene { plant, theme, .. } = scene;
    if pane.height == 0 {
        return;
    }
    let flow = inputs::flow(plant, pane.width);
    let more = match flow.more {
        0 => String::new(),
        more => format!("{more} more: / finds them"),
    };
    let title = match plant.watching() {
        None => "Inputs: press the number",
        Some(_) => "Inputs",
    };
    heading(buffer, pane, title, &more, theme);
    for entry in &flow.entries {
        let point = &inputs::numbered(plant)[entry.index];
        let line = entry.line + 1;
        let high = plant.is_high(point);
        let forced = plant.is_forced(point);
        let state = match (forced, high) {
            (true, _) => theme.forced(),
            (false, true) => theme.live(),
            (false, false) => Style::new(),
        };
        let key = (entry.index + 1).to_string();
        let mut column = put(buffer, pane, entry.column, line, &key, theme.key());
        if point.ty == Scalar::Bool {
            column = put(buffer, pane, column, line, " ", Style::new());
            column = put(buffer, pane, column, line, &theme.dot(high).to_string(), state);
        }
        column = put(buffer, pane, column, line, " ", Style::new());
        column = put(buffer, pane, column, line, &entry.text, state);
        if forced {
            put(buffer, pane, column, line, "F", state);
        }
    }
}
