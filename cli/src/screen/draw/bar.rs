//! The bar on top: which program, and how it goes.

use super::{Scene, put};
use crate::screen::theme::{Charset, reversed};
use crate::screen::values;
use ladder_format::display_width;
use ladder_simulator::Status;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

pub(super) fn draw(buffer: &mut Buffer, pane: Rect, scene: Scene) {
    let Scene { view, plant, theme } = scene;
    let style = reversed();
    put(buffer, pane, 0, 0, &" ".repeat(pane.width as usize), style);
    let unicode = theme.charset == Charset::Unicode;
    if let Some((controller, watching)) = plant.watching() {
        let sign = match (view.running, unicode) {
            (true, true) => "▶ ONLINE",
            (true, false) => "> ONLINE",
            (false, true) => "■ HELD",
            (false, false) => ". HELD",
        };
        let left = format!(
            " {}  {sign}  {controller}  {}",
            plant.sheet.file,
            watching.status()
        );
        put(buffer, pane, 0, 0, &left, style);
        return;
    }
    let (sign, state) = match plant.status() {
        Status::Ended => (if unicode { "■" } else { "." }, "ENDED".to_owned()),
        Status::Faulted => ("!", "STOPPED BY A FAULT".to_owned()),
        Status::Ready if view.running => (if unicode { "▶" } else { ">" }, format!("RUNNING {}", view.speed)),
        Status::Ready if plant.is_open() => (
            if unicode { "■" } else { "." },
            format!("IN SCAN {}", plant.scans()),
        ),
        Status::Ready => (if unicode { "■" } else { "." }, "PAUSED".to_owned()),
    };
    let mut left = format!(" {}  {sign} {state}", plant.sheet.file);
    if !view.running && plant.status() == Status::Ready {
        left.push_str(&format!("  speed {}", view.speed));
    }
    let mut right = format!(
        "scan {}  {} ",
        plant.scans(),
        values::clock(plant.simulation().time())
    );
    let (_, ahead) = plant.history();
    if ahead > 0 {
        right = format!("{ahead} back  {right}");
    }
    match plant.forces() {
        0 => {}
        1 => right = format!("1 FORCE  {right}"),
        more => right = format!("{more} FORCES  {right}"),
    }
    let right_width = display_width(&right) as u16;
    let end = put(buffer, pane, 0, 0, &left, style);
    if end + right_width < pane.width {
        put(buffer, pane, pane.width - right_width, 0, &right, style);
    } else {
        put(buffer, pane, end + 2, 0, &right, style);
    }
}
