//! The last fault, with its place.

use super::{Scene, put};
use crate::screen::plant::Plant;
use ladder_format::display_width;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// From this height on a long message gets a second line.
const HIGH: u16 = 20;

/// How many lines it takes.
pub(in crate::screen) fn lines(plant: &Plant, area: Rect) -> u16 {
    match text(plant) {
        None => 0,
        Some(text) if area.height >= HIGH && display_width(&text) > u32::from(area.width) => 2,
        Some(_) => 1,
    }
}

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

fn text(plant: &Plant) -> Option<String> {
    let (fault, times) = plant.last_fault()?;
    let place = match plant.sheet.place_name(fault.location) {
        Some(place) => place,
        None => {
            let files = &plant.simulation().program().files;
            files.get(fault.location.file as usize)?.clone()
        }
    };
    let mut text = format!(" ! {place}: scan {}", fault.scan);
    if times > 1 {
        text.push_str(&format!(" ({times} times)"));
    }
    text.push_str(&format!(": {}", fault.message));
    Some(text)
}
