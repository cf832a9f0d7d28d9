//! The watched tags with their values and their past.

use super::{Scene, heading, put};
use crate::screen::values;
use crate::screen::wave::wave;
use ladder_analysis::values::types::Scalar;
use ladder_format::display_width;
use ladder_simulator::chart::Track;
use ladder_simulator::value_text;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

/// Names and values have this many columns at most.
const NAME: u16 = 20;
const VALUE: u16 = 12;

pub(super) fn draw(buffer: &mut Buffer, pane: Rect, scene: Scene) {
    let Scene { view, plant, theme } = scene;
    let tracks = plant.watched();
    if pane.height == 0 || tracks.is_empty() {
        return;
    }
    let interval = plant.simulation().options().interval;
    let span = (view.scale.scans() as i64).saturating_mul(interval);
    let mut right = format!("[ ] 1 column = {} ms", value_text::milliseconds(span));
    let shown = tracks.len().min(pane.height as usize - 1);
    if shown < tracks.len() {
        right = format!("{} more  {right}", tracks.len() - shown);
    }
    heading(buffer, pane, "Watch", &right, theme);
    let longest = |of: &dyn Fn(&Track) -> u32, most: u16| {
        let all = tracks.iter().take(shown).map(of).max().unwrap_or(0);
        (all as u16).min(most)
    };
    let name_width = longest(&|track| display_width(&track.point.name), NAME);
    let value_width = longest(&|track| display_width(&value(track, scene)), VALUE).max(6);
    for (line, track) in (1..).zip(&tracks[..shown]) {
        draw_track(buffer, pane, line, track, name_width, value_width, scene);
    }
}

fn value(track: &Track, scene: Scene) -> String {
    values::short(&scene.plant.value(&track.point), track.point.ty)
}

fn draw_track(
    buffer: &mut Buffer,
    pane: Rect,
    line: u16,
    track: &Track,
    name_width: u16,
    value_width: u16,
    scene: Scene,
) {
    let Scene { view, plant, theme } = scene;
    let point = &track.point;
    let is_bit = point.ty == Scalar::Bool;
    let style = if plant.is_forced(point) {
        theme.forced()
    } else if is_bit && plant.is_high(point) {
        theme.live()
    } else {
        Style::new()
    };
    let name_pane = Rect {
        width: (name_width + 1).min(pane.width),
        ..pane
    };
    put(buffer, name_pane, 1, line, &point.name, style);
    if plant.is_forced(point) {
        put(buffer, pane, name_width + 1, line, "F", theme.forced());
    }
    let value_at = name_width + 3;
    let value_pane = Rect {
        width: (value_at + value_width).min(pane.width),
        ..pane
    };
    let value_style = if is_bit { style } else { theme.value() };
    put(
        buffer,
        value_pane,
        value_at,
        line,
        &value(track, scene),
        value_style,
    );
    let wave_at = value_at + value_width + 1;
    if point.ty.is_string() || wave_at >= pane.width {
        return;
    }
    let columns = usize::from(pane.width - wave_at);
    let text = wave(track, columns, view.scale.scans(), plant.scans(), theme.charset);
    put(buffer, pane, wave_at, line, &text, theme.wave());
}
