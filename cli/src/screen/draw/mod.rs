//! The screen as it is drawn. Everything here only reads.

mod bar;
mod diagram;
mod fault;
mod help;
pub(super) mod hints;
mod info;
mod inputs_bar;
mod menu;
mod outputs_list;
mod watch_list;
mod why;

use super::plant::Plant;
use super::theme::{Theme, heading as heading_style, quiet};
use super::view::{Mode, View};
use ratatui::Frame;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

/// What is drawn.
#[derive(Clone, Copy)]
pub(super) struct Scene<'a> {
    pub(super) view: &'a View,
    pub(super) plant: &'a Plant,
    pub(super) theme: Theme,
}

/// Draws the whole screen.
pub(super) fn screen(frame: &mut Frame, scene: Scene) {
    let panes = scene.view.panes(scene.plant);
    let buffer = frame.buffer_mut();
    bar::draw(buffer, panes.bar, scene);
    diagram::draw(buffer, panes.gutter, panes.diagram, scene);
    inputs_bar::draw(buffer, panes.inputs, scene);
    watch_list::draw(buffer, panes.watch, scene);
    fault::draw(buffer, panes.fault, scene);
    let typing_at = info::draw(buffer, panes.info, scene);
    hints::draw(buffer, panes.hints, scene);
    let above = Rect {
        height: panes.info.y.saturating_sub(scene.view.area.y),
        ..scene.view.area
    };
    match &scene.view.mode {
        Mode::Help => help::draw(buffer, scene),
        Mode::Why(reasons) => why::draw(buffer, reasons, scene),
        Mode::Pick(picker) => menu::draw(buffer, above, picker, scene),
        Mode::Outputs(outputs) => outputs_list::draw(buffer, above, outputs, scene),
        Mode::Diagram | Mode::Prompt(_) | Mode::Force(_) => {}
    }
    if let Some(position) = typing_at {
        frame.set_cursor_position(position);
    }
}

/// Writes text into one line of a pane, as far as it fits. Returns the column after it.
fn put(buffer: &mut Buffer, pane: Rect, column: u16, line: u16, text: &str, style: Style) -> u16 {
    if line >= pane.height || column >= pane.width {
        return column;
    }
    let room = pane.width - column;
    let (x, _) = buffer.set_stringn(pane.x + column, pane.y + line, text, room as usize, style);
    x - pane.x
}

/// A heading: a line across the pane with a title in it, and something at its right end.
fn heading(buffer: &mut Buffer, pane: Rect, title: &str, right: &str, theme: Theme) {
    let style = quiet();
    let rule = theme.rule().repeat(pane.width as usize);
    put(buffer, pane, 0, 0, &rule, style);
    put(buffer, pane, 1, 0, &format!(" {title} "), heading_style());
    let width = ladder_format::display_width(right) as u16 + 2;
    let title_end = ladder_format::display_width(title) as u16 + 4;
    if !right.is_empty() && width + 1 + title_end < pane.width {
        put(
            buffer,
            pane,
            pane.width - width - 1,
            0,
            &format!(" {right} "),
            style,
        );
    }
}
