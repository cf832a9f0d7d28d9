//! The tags that match what is being typed.

use super::{Scene, put};
use crate::screen::picker::{Picker, Purpose, Row};
use crate::screen::theme::{Theme, quiet};
use crate::screen::values;
use ladder_format::display_width;
use ladder_simulator::Entry;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Modifier, Style};
use ratatui::widgets::{Block, Clear, Widget};

/// This many tags are shown at once.
const LINES: u16 = 10;

/// Draws the list at the bottom of an area.
pub(super) fn draw(buffer: &mut Buffer, area: Rect, picker: &Picker, scene: Scene) {
    let Scene { plant, theme, .. } = scene;
    let lines = (picker.matches.len().max(1) as u16)
        .min(LINES)
        .min(area.height.saturating_sub(2));
    if lines == 0 {
        return;
    }
    let longest = picker
        .matches
        .iter()
        .map(|row| display_width(&name(row, theme)))
        .max();
    let name_width = longest.unwrap_or(0).clamp(12, 40) as u16;
    let width = (name_width + 40).min(area.width);
    let pane = Rect {
        x: area.x,
        y: area.bottom() - lines - 2,
        width,
        height: lines + 2,
    };
    Clear.render(pane, buffer);
    let title = match picker.purpose {
        Purpose::Watch => " Enter: watch, or no more ",
        Purpose::Find => " Enter: go there ",
    };
    let block = Block::bordered().border_set(theme.border()).title(title);
    let inside = block.inner(pane);
    block.render(pane, buffer);
    if picker.matches.is_empty() {
        put(buffer, inside, 1, 0, "no tag matches", quiet());
        return;
    }
    let first = (picker.chosen + 1).saturating_sub(lines as usize);
    for (line, row) in (0..lines).zip(&picker.matches[first..]) {
        let chosen = first + line as usize == picker.chosen;
        let style = if chosen {
            Style::new().add_modifier(Modifier::REVERSED)
        } else {
            Style::new()
        };
        put(buffer, inside, 0, line, &" ".repeat(inside.width as usize), style);
        let watched = matches!(&row.entry, Entry::Value(point) if plant.watches(point));
        put(buffer, inside, 1, line, if watched { "*" } else { " " }, style);
        let name_pane = Rect {
            width: (name_width + 3).min(inside.width),
            ..inside
        };
        put(buffer, name_pane, 3, line, &name(row, theme), style);
        match &row.entry {
            Entry::Value(point) => {
                put(buffer, inside, name_width + 5, line, &point.ty.to_string(), style);
                let value = values::short(&plant.value(point), point.ty);
                put(buffer, inside, name_width + 15, line, &value, style);
            }
            Entry::Group(group) => {
                put(buffer, inside, name_width + 5, line, &group.ty, style);
                let brief = plant.simulation().brief(group, &group.name);
                let after = name_width + 15.max(6 + group.ty.chars().count() as u16);
                put(buffer, inside, after, line, &brief, style);
            }
        }
    }
}

/// The name of a line, in as far as it is in others, with a sign where it opens.
fn name(row: &Row, theme: Theme) -> String {
    let indent = "  ".repeat(row.depth.into());
    match &row.entry {
        Entry::Value(point) => format!("{indent}{}", point.name),
        Entry::Group(group) => format!("{indent}{} {}", theme.fold(row.is_open), group.name),
    }
}
