//! The tags of which a recorded test may expect something.

use super::{Scene, put};
use crate::screen::outputs::Outputs;
use ladder_format::display_width;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Modifier, Style};
use ratatui::widgets::{Block, Clear, Widget};

/// This many tags are shown at once.
const LINES: u16 = 12;

/// Draws the list at the bottom of an area.
pub(super) fn draw(buffer: &mut Buffer, area: Rect, outputs: &Outputs, scene: Scene) {
    let lines = (outputs.tags.len() as u16)
        .min(LINES)
        .min(area.height.saturating_sub(2));
    if lines == 0 {
        return;
    }
    let longest = outputs.tags.iter().map(|(tag, _)| display_width(&tag.name)).max();
    let name_width = longest.unwrap_or(0).clamp(16, 40) as u16;
    let pane = Rect {
        x: area.x,
        y: area.bottom() - lines - 2,
        width: (name_width + 30).min(area.width),
        height: lines + 2,
    };
    Clear.render(pane, buffer);
    let block = Block::bordered()
        .border_set(scene.theme.border())
        .title(" The test expects values of ");
    let inside = block.inner(pane);
    block.render(pane, buffer);
    let first = (outputs.at + 1).saturating_sub(lines as usize);
    for (line, (tag, chosen)) in (0..lines).zip(&outputs.tags[first..]) {
        let here = first + line as usize == outputs.at;
        let style = if here {
            Style::new().add_modifier(Modifier::REVERSED)
        } else {
            Style::new()
        };
        put(buffer, inside, 0, line, &" ".repeat(inside.width as usize), style);
        put(
            buffer,
            inside,
            1,
            line,
            if *chosen { "[x]" } else { "[ ]" },
            style,
        );
        put(buffer, inside, 5, line, &tag.name, style);
        put(buffer, inside, name_width + 7, line, &tag.ty.to_string(), style);
        let role = if tag.is_output { "output" } else { "" };
        put(buffer, inside, name_width + 15, line, role, style);
    }
}
