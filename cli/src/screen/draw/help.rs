//! The help, over everything else.

use super::{Scene, put};
use crate::screen::keys::HELP;
use crate::screen::theme::{heading as heading_style, quiet};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::widgets::{Block, Clear, Widget};

/// Its size, borders included.
const WIDTH: u16 = 78;
const HEIGHT: u16 = 22;

/// Where each half begins, and how many columns its keys take.
const HALVES: [(u16, u16); 2] = [(1, 15), (43, 11)];

pub(super) fn draw(buffer: &mut Buffer, scene: Scene) {
    let area = scene.view.area;
    let theme = scene.theme;
    let (width, height) = (WIDTH.min(area.width), HEIGHT.min(area.height));
    let pane = Rect {
        x: area.x + (area.width - width) / 2,
        y: area.y + (area.height - height) / 2,
        width,
        height,
    };
    // Leftovers of a column or two on either side would only confuse.
    let cleared = if area.width < WIDTH + 8 {
        Rect {
            x: area.x,
            width: area.width,
            ..pane
        }
    } else {
        pane
    };
    Clear.render(cleared, buffer);
    let block = Block::bordered()
        .border_set(theme.border())
        .title(" Help: any key closes it ");
    let inside = block.inner(pane);
    block.render(pane, buffer);
    let mut lowest = 0;
    for ((column, keys_width), groups) in HALVES.into_iter().zip(HELP) {
        let mut line = 0;
        for (title, keys) in groups {
            put(buffer, inside, column, line, title, heading_style());
            line += 1;
            for (key, does) in *keys {
                put(buffer, inside, column + 1, line, key, theme.key());
                put(buffer, inside, column + 1 + keys_width, line, does, Style::new());
                line += 1;
            }
            line += 1;
        }
        lowest = lowest.max(line);
    }
    let live = format!("{0}{0}{0}", theme.wire(true));
    let dead = format!("{0}{0}{0}", theme.wire(false));
    let legend = [
        (live, theme.live(), "power"),
        (dead, Style::new(), "no power"),
        (format!("{} tag", theme.dot(true)), theme.live(), "the tag is on"),
        ("tag F".to_owned(), theme.forced(), "forced"),
    ];
    let mut column = 1;
    for (sign, style, means) in legend {
        column = put(buffer, inside, column, lowest, &sign, style);
        column = put(
            buffer,
            inside,
            column,
            lowest,
            &format!(" {means}    "),
            Style::new(),
        );
    }
    let safety = "This is a simulator, not a safety device.";
    put(buffer, inside, 1, lowest + 1, safety, quiet());
}
