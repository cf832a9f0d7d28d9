//! What the screen says of the last fault, and the room that it takes.

use super::plant::Plant;
use ladder_format::display_width;
use ratatui::layout::Rect;

/// From this height on a long message gets a second line.
const HIGH: u16 = 20;

/// How many lines it takes.
pub(super) fn lines(plant: &Plant, area: Rect) -> u16 {
    match text(plant) {
        None => 0,
        Some(text) if area.height >= HIGH && display_width(&text) > u32::from(area.width) => 2,
        Some(_) => 1,
    }
}

/// The fault, with its place.
pub(super) fn text(plant: &Plant) -> Option<String> {
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
