//! The end of a line that is wider than the screen: what the rung does stands there, so it is brought into sight where
//! nothing but wire is in its way.

use super::diagram::{draw_values, look, value_text};
use super::{Scene, put};
use crate::screen::columns;
use crate::screen::sheet::Block;
use ladder_format::display_width;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

/// Draws the last block of a line, and the line's values if there is room, at the right edge.
pub(super) fn draw(
    buffer: &mut Buffer,
    pane: Rect,
    row: u16,
    line: usize,
    blocks: &[(&Block, bool)],
    scene: Scene,
) {
    let Scene { view, plant, theme } = scene;
    if pane.width == 0 {
        return;
    }
    let sheet = &plant.sheet;
    let (text, start) = (sheet.line(line), sheet.line_start(line));
    let right = view.left + pane.width as usize;
    let end_of = |block: &Block| columns::column(text, block.end - start);
    let hides_a_block = blocks.iter().any(|(block, _)| end_of(block) > right);
    if !hides_a_block && sheet.shown(line).next().is_none() {
        // Only wire and rail.
        return;
    }
    // A block that is cut counts as in the way: half of a name is no name, but it tells that there is one.
    let begins = |block: &Block| columns::column(text, block.start - start);
    let in_the_way = blocks
        .iter()
        .filter(|(block, _)| begins(block) < right)
        .map(|(block, _)| end_of(block).saturating_sub(view.left));
    let free_from = in_the_way.max().unwrap_or(0) as u16 + 1;
    let more = theme.more();
    let last = blocks.last().filter(|(block, _)| begins(block) >= right);
    let Some(&(block, _)) = last else {
        put(buffer, pane, pane.width - 1, row, more, theme.note());
        return;
    };
    let block_width = (end_of(block) - begins(block)) as u16;
    let values: u16 = sheet
        .shown(line)
        .map(|shown| display_width(&value_text(shown, scene)) as u16 + 2)
        .sum();
    let room = pane.width.saturating_sub(free_from);
    let needed = if block_width + 2 + values <= room {
        block_width + 2 + values
    } else {
        block_width + 2
    };
    if needed > room {
        put(buffer, pane, pane.width - 1, row, more, theme.note());
        return;
    }
    let column = pane.width - needed;
    put(buffer, pane, column, row, more, theme.note());
    put(buffer, pane, column + 1, row, " ", Style::new());
    let marks = sheet.marks(line);
    let mut end = column + 2;
    for cell in columns::cells(sheet.block_text(block)) {
        let offset = block.start + cell.offset;
        let under = marks.iter().find(|mark| (mark.start..mark.end).contains(&offset));
        let look = look(offset, &text[offset - start..], under, blocks, scene);
        let shown = look.instead.map_or_else(|| cell.shown.to_owned(), String::from);
        put(buffer, pane, end, row, &shown, look.style);
        end += cell.width as u16;
    }
    if needed > block_width + 2 {
        put(buffer, pane, end, row, "  ", Style::new());
        draw_values(buffer, pane, row, end + 2, line, scene);
    }
}
