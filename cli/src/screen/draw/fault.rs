//! The last fault, with its place.

use super::{Scene, put};
use crate::screen::fault::text;
use ladder_format::display_width;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

pub(super) fn draw(buffer: &mut Buffer, pane: Rect, scene: Scene) {
    let Some(text) = text(scene.plant) else { return };
    let style = scene.theme.alarm();
    let mut rest = text.as_str();
    for line in 0..pane.height {
        let fits = if display_width(rest) <= u32::from(pane.width) {
            rest.len()
        } else {
            // At a blank, if there is one in the line.
            let cut = rest
                .char_indices()
                .nth(pane.width as usize)
                .map_or(rest.len(), |(at, _)| at);
            rest[..cut].rfind(' ').filter(|&at| at > 0).unwrap_or(cut)
        };
        put(buffer, pane, 0, line, &" ".repeat(pane.width as usize), style);
        put(buffer, pane, 0, line, &rest[..fits], style);
        rest = &rest[fits..];
    }
}
