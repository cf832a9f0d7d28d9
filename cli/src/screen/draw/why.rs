//! Why a tag holds what it holds, over everything else.

use super::{Scene, put};
use crate::screen::view::Reasons;
use ladder_format::display_width;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::widgets::{Block, Clear, Widget};

/// Longer lines are hard to read.
const WIDTH: u16 = 100;

pub(super) fn draw(buffer: &mut Buffer, reasons: &Reasons, scene: Scene) {
    let area = scene.view.area;
    let width = area.width.min(WIDTH);
    let lines = wrapped(&reasons.text, usize::from(width.saturating_sub(4)));
    let height = (lines.len() as u16 + 2).min(area.height);
    let pane = Rect {
        x: area.x + (area.width - width) / 2,
        y: area.y + (area.height - height) / 2,
        width,
        height,
    };
    Clear.render(pane, buffer);
    let hidden = lines.len().saturating_sub(usize::from(height.saturating_sub(2)));
    let title = match hidden {
        0 => " Why? Any key closes it ",
        _ => " Why? up, down; any other key closes it ",
    };
    let block = Block::bordered().border_set(scene.theme.border()).title(title);
    let inside = block.inner(pane);
    block.render(pane, buffer);
    let top = reasons.top.min(hidden);
    for (row, line) in (0..inside.height).zip(&lines[top..]) {
        put(buffer, inside, 1, row, line, Style::new());
    }
}

/// The lines of a text in this many columns. What goes on in a further line is deeper than where it began.
fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines = Vec::new();
    for line in text.lines() {
        let depth = line.len() - line.trim_start().len();
        let mut now = " ".repeat(depth);
        let mut is_new = true;
        for word in line.split_whitespace() {
            let longer = display_width(&now) as usize + 1 + display_width(word) as usize;
            if !is_new && longer > width {
                lines.push(std::mem::replace(&mut now, " ".repeat(depth + 4)));
                is_new = true;
            }
            if !is_new {
                now.push(' ');
            }
            now.push_str(word);
            is_new = false;
        }
        lines.push(now);
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_wrapped() {
        let lines = wrapped("run is 0 since the start\n  start is 0", 14);
        assert_eq!(lines, ["run is 0 since", "    the start", "  start is 0"]);
        assert_eq!(wrapped("incomprehensibilities", 5), ["incomprehensibilities"]);
    }
}
