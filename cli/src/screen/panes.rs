//! Where everything is on the terminal.
//!
//! ```text
//! bar      file, state, speed, scan, time
//! diagram                                  | watch (next to it if there is room for both)
//! inputs
//! watch (below otherwise)
//! fault    if there is one
//! info     what is selected, the last message, what is being typed
//! hints    the keys
//! ```

use super::fault;
use super::inputs;
use super::plant::Plant;
use ratatui::layout::Rect;

/// The parts of the screen. What has no room has no height.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Panes {
    pub(super) bar: Rect,
    /// Next to the diagram, for marks on its lines.
    pub(super) gutter: Rect,
    pub(super) diagram: Rect,
    pub(super) inputs: Rect,
    pub(super) watch: Rect,
    pub(super) fault: Rect,
    pub(super) info: Rect,
    pub(super) hints: Rect,
}

/// The narrowest watch list that is worth standing next to the diagram.
const NEXT_TO: u16 = 56;

/// The columns that a diagram next to the watch list gets at least: those of the widest rungs that the formatter
/// makes, and some for the values at their ends.
const DIAGRAM: u16 = 100;

/// Divides the terminal.
pub(super) fn panes(area: Rect, plant: &Plant) -> Panes {
    let fault_lines = fault::lines(plant, area);
    let tracks = plant.watched().len() as u16;
    let input_lines = inputs::flow(plant, area.width).lines;
    let mut rest = area;
    let bar = take_top(&mut rest, 1);
    let hints = take_bottom(&mut rest, 1);
    let info = take_bottom(&mut rest, 1);
    let fault = take_bottom(&mut rest, fault_lines);
    // The diagram keeps at least half of what is left.
    let next_to = area.width >= DIAGRAM + NEXT_TO;
    let mut room = rest.height / 2;
    let watch_lines = match tracks {
        0 => 0,
        _ if next_to => 0,
        tracks => (tracks + 1).min(room.saturating_sub(if input_lines == 0 { 0 } else { input_lines + 1 })),
    };
    let watch_below = take_bottom(&mut rest, if watch_lines < 2 { 0 } else { watch_lines });
    room = room.saturating_sub(watch_below.height);
    let input_lines = match input_lines {
        0 => 0,
        lines => (lines + 1).min(room),
    };
    let inputs = take_bottom(&mut rest, if input_lines < 2 { 0 } else { input_lines });
    let mut diagram = rest;
    let mut watch = watch_below;
    if next_to && tracks > 0 {
        let width = (area.width - DIAGRAM).min(80);
        diagram.width -= width;
        watch = Rect {
            x: diagram.right() + 1,
            width: width - 1,
            ..rest
        };
    }
    // Where there is room, lines have their numbers.
    let numbers = plant.sheet.height().max(1).ilog10() as u16 + 4;
    let gutter_width = if area.width >= DIAGRAM + numbers {
        numbers
    } else {
        3
    };
    let gutter = Rect {
        width: gutter_width.min(diagram.width),
        ..diagram
    };
    diagram.x += gutter.width;
    diagram.width -= gutter.width;
    Panes {
        bar,
        gutter,
        diagram,
        inputs,
        watch,
        fault,
        info,
        hints,
    }
}

fn take_top(rest: &mut Rect, lines: u16) -> Rect {
    let lines = lines.min(rest.height);
    let taken = Rect {
        height: lines,
        ..*rest
    };
    rest.y += lines;
    rest.height -= lines;
    taken
}

fn take_bottom(rest: &mut Rect, lines: u16) -> Rect {
    let lines = lines.min(rest.height);
    rest.height -= lines;
    Rect {
        y: rest.bottom(),
        height: lines,
        ..*rest
    }
}
