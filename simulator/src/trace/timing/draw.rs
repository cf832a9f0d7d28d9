//! The picture itself.

use super::{Change, Lane, Signal, Timing};
use crate::chart::{Tick, time_ticks};
use ladder_syntax::xml::Escaped;
use std::fmt::Write;
use unicode_width::UnicodeWidthStr;

/// Width of a character at the size that names and values are written in.
const LETTER: f64 = 7.25;
/// From one lane to the next.
const LANE: f64 = 36.0;
/// From low to high.
const SWING: f64 = 20.0;
/// Around everything.
const MARGIN: f64 = 16.0;
/// Above the first lane, for the axis.
const AXIS: f64 = 26.0;
/// How wide a column is at most, and how wide all of them are.
const WIDEST_COLUMN: f64 = 28.0;
const WIDEST: f64 = 960.0;
const NARROWEST: f64 = 280.0;

const STYLE: &str = "\
  .paper { fill: #ffffff }
  text { font: 12px ui-monospace, 'SF Mono', 'Cascadia Mono', 'JetBrains Mono', Menlo, Consolas, monospace }
  .name { fill: #1f2933; text-anchor: end }
  .tick { fill: #616e7c; font-size: 10.5px; text-anchor: middle }
  .note { fill: #616e7c; font-size: 10.5px }
  .first { text-anchor: start }
  .value { fill: #1e3a5f; font-size: 11px; text-anchor: middle }
  .grid { stroke: #e4e7eb; stroke-width: 1 }
  .lane { stroke: #f0f2f4; stroke-width: 1 }
  .wave { stroke: #12805c; stroke-width: 1.75; fill: none; stroke-linejoin: round; stroke-linecap: round }
  .high { fill: #12805c; fill-opacity: .13 }
  .bus { stroke: #3b6fb6; stroke-width: 1.25; fill: #3b6fb6; fill-opacity: .08; stroke-linejoin: round }
  .curve { stroke: #3b6fb6; stroke-width: 1.5; fill: none; stroke-linejoin: round }
  .under { fill: #3b6fb6; fill-opacity: .1 }
  @media (prefers-color-scheme: dark) {
    .paper { fill: #14181d }
    .name { fill: #e4e7eb }
    .tick, .note { fill: #9aa5b1 }
    .value { fill: #cfe1f7 }
    .grid { stroke: #2b333c }
    .lane { stroke: #1e242b }
    .wave { stroke: #4ade9c }
    .high { fill: #4ade9c; fill-opacity: .16 }
    .bus { stroke: #7fb0ee; fill: #7fb0ee; fill-opacity: .12 }
    .curve { stroke: #7fb0ee }
    .under { fill: #7fb0ee; fill-opacity: .14 }
  }
";

pub(super) fn svg(timing: &Timing) -> String {
    let page = Page::of(timing);
    let mut out = String::new();
    // Writing to a String does not fail.
    let _ = page.write(timing, &mut out);
    out
}

/// The measures of a picture.
struct Page {
    /// Where time 0 is.
    left: f64,
    /// How wide a column is.
    column: f64,
    /// How wide all columns are.
    plot: f64,
    /// Room right of the plot, for the ends of curves' scales.
    right: f64,
    width: f64,
    height: f64,
}

impl Page {
    fn of(timing: &Timing) -> Page {
        let longest = timing
            .lanes
            .iter()
            .map(|lane| letters(&lane.name))
            .fold(0.0, f64::max);
        let left = MARGIN + longest * LETTER + 14.0;
        let columns = timing.columns.max(1) as f64;
        let plot = (columns * WIDEST_COLUMN).clamp(NARROWEST, WIDEST);
        let column = plot / columns;
        let scales = timing
            .lanes
            .iter()
            .filter_map(|lane| scale(lane, timing.columns, column))
            .map(|scale| letters(&scale.low).max(letters(&scale.high)))
            .fold(0.0, f64::max);
        let right = if scales > 0.0 { scales * 6.5 + 10.0 } else { 0.0 };
        Page {
            left,
            column,
            plot,
            right,
            width: left + plot + right + MARGIN,
            height: MARGIN + AXIS + timing.lanes.len() as f64 * LANE + MARGIN,
        }
    }

    fn x(&self, column: u64) -> f64 {
        self.left + column as f64 * self.column
    }

    fn write(&self, timing: &Timing, out: &mut String) -> std::fmt::Result {
        let (width, height) = (n(self.width), n(self.height));
        let title = Escaped(&timing.title);
        writeln!(
            out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" role=\"img\">"
        )?;
        writeln!(out, "<title>{title}</title>\n<style>\n{STYLE}</style>")?;
        writeln!(
            out,
            "<rect class=\"paper\" width=\"100%\" height=\"100%\" rx=\"8\"/>"
        )?;
        self.axis(timing, out)?;
        for (index, lane) in timing.lanes.iter().enumerate() {
            let top = MARGIN + AXIS + index as f64 * LANE;
            self.lane(lane, timing.columns, top, out)?;
        }
        writeln!(out, "</svg>")
    }

    fn axis(&self, timing: &Timing, out: &mut String) -> std::fmt::Result {
        let (top, bottom) = (MARGIN + AXIS - 6.0, self.height - MARGIN);
        let end = timing.interval.max(1) as f64 * timing.columns.max(1) as f64;
        for Tick {
            at: time,
            text: label,
        } in time_ticks(0.0, end, self.plot / 84.0)
        {
            let x = self.left + time / end * self.plot;
            writeln!(
                out,
                "<line class=\"grid\" x1=\"{0}\" y1=\"{1}\" x2=\"{0}\" y2=\"{2}\"/>\
                 <text class=\"tick\" x=\"{0}\" y=\"{3}\">{label}</text>",
                n(x),
                n(top),
                n(bottom),
                n(top - 6.0)
            )?;
        }
        Ok(())
    }

    fn lane(&self, lane: &Lane, columns: u64, top: f64, out: &mut String) -> std::fmt::Result {
        let high = top + (LANE - SWING) / 2.0;
        let low = high + SWING;
        writeln!(
            out,
            "<text class=\"name\" x=\"{}\" y=\"{}\">{}</text>",
            n(self.left - 14.0),
            n(high + SWING / 2.0 + 4.0),
            Escaped(&lane.name)
        )?;
        writeln!(
            out,
            "<line class=\"lane\" x1=\"{}\" y1=\"{y}\" x2=\"{}\" y2=\"{y}\"/>",
            n(MARGIN),
            n(self.left + self.plot + self.right),
            y = n(top + LANE)
        )?;
        match (&lane.signal, scale(lane, columns, self.column)) {
            (Signal::Levels(changes), _) => self.wave(changes, columns, high, low, out),
            (Signal::Values(changes), Some(scale)) => self.curve(changes, columns, high, low, &scale, out),
            (Signal::Values(changes), None) => self.bus(changes, columns, high, low, out),
        }
    }

    fn wave(
        &self,
        changes: &[(u64, bool)],
        columns: u64,
        high: f64,
        low: f64,
        out: &mut String,
    ) -> std::fmt::Result {
        let mut path = String::new();
        for (index, &(at, level)) in changes.iter().enumerate() {
            let (from, to) = (self.x(at), self.x(next(changes, index, columns, |c| c.0)));
            let y = if level { high } else { low };
            let step = if index == 0 {
                format!("M{} {}", n(from), n(y))
            } else {
                format!("V{}", n(y))
            };
            path.push_str(&format!("{step}H{}", n(to)));
            if level {
                writeln!(
                    out,
                    "<rect class=\"high\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>",
                    n(from),
                    n(high),
                    n(to - from),
                    n(SWING)
                )?;
            }
        }
        writeln!(out, "<path class=\"wave\" d=\"{path}\"/>")
    }

    fn bus(
        &self,
        changes: &[Change],
        columns: u64,
        high: f64,
        low: f64,
        out: &mut String,
    ) -> std::fmt::Result {
        let mid = f64::midpoint(high, low);
        for (index, Change { column, text, .. }) in changes.iter().enumerate() {
            let (from, to) = (
                self.x(*column),
                self.x(next(changes, index, columns, |c| c.column)),
            );
            let slant = f64::min(4.0, (to - from) / 2.0);
            writeln!(
                out,
                "<path class=\"bus\" d=\"M{} {mid}L{a} {high}H{b}L{} {mid}L{b} {low}H{a}Z\">\
                 <title>{}</title></path>",
                n(from),
                n(to),
                Escaped(text),
                a = n(from + slant),
                b = n(to - slant),
                mid = n(mid),
                high = n(high),
                low = n(low)
            )?;
            if let Some(text) = fitting(text, to - from - 2.0 * slant) {
                writeln!(
                    out,
                    "<text class=\"value\" x=\"{}\" y=\"{}\">{}</text>",
                    n(f64::midpoint(from, to)),
                    n(mid + 4.0),
                    Escaped(&text)
                )?;
            }
        }
        Ok(())
    }

    fn curve(
        &self,
        changes: &[Change],
        columns: u64,
        high: f64,
        low: f64,
        scale: &Scale,
        out: &mut String,
    ) -> std::fmt::Result {
        let mut path = String::new();
        for (index, Change { column, number, .. }) in changes.iter().enumerate() {
            let (from, to) = (
                self.x(*column),
                self.x(next(changes, index, columns, |c| c.column)),
            );
            let part = (number.unwrap_or(scale.least) - scale.least) / (scale.most - scale.least);
            let y = n(low - part * SWING);
            let step = if index == 0 {
                format!("M{} {y}", n(from))
            } else {
                format!("V{y}")
            };
            path.push_str(&format!("{step}H{}", n(to)));
        }
        let (start, end) = (self.left, self.left + self.plot);
        writeln!(
            out,
            "<path class=\"under\" d=\"{path}V{low}H{}Z\"/><path class=\"curve\" d=\"{path}\"/>",
            n(start),
            low = n(low)
        )?;
        for (text, y) in [(&scale.high, high + 5.0), (&scale.low, low + 3.0)] {
            writeln!(
                out,
                "<text class=\"note\" x=\"{}\" y=\"{}\">{}</text>",
                n(end + 8.0),
                n(y),
                Escaped(text)
            )?;
        }
        Ok(())
    }
}

/// The ends of a curve.
struct Scale {
    least: f64,
    most: f64,
    low: String,
    high: String,
}

/// The scale of a lane that is drawn as a curve: most of its values have no room for their text, and are numbers.
fn scale(lane: &Lane, columns: u64, column: f64) -> Option<Scale> {
    let Signal::Values(changes) = &lane.signal else {
        return None;
    };
    if changes.len() < 4 {
        return None;
    }
    let has_room = |index: usize| {
        let change = &changes[index];
        let width = (next(changes, index, columns, |c| c.column) - change.column) as f64 * column;
        letters(&change.text) * LETTER + 8.0 <= width
    };
    let roomy = (0..changes.len()).filter(|&index| has_room(index)).count();
    if roomy * 2 >= changes.len() {
        return None;
    }
    let mut ends: Option<[(f64, &str); 2]> = None;
    for change in changes {
        let here = (change.number?, change.text.as_str());
        let [low, high] = ends.unwrap_or([here, here]);
        ends = Some([
            if here.0 < low.0 { here } else { low },
            if here.0 > high.0 { here } else { high },
        ]);
    }
    let [(least, low), (most, high)] = ends?;
    Some(Scale {
        least,
        most,
        low: low.to_owned(),
        high: high.to_owned(),
    })
}

/// The column at which a change's successor is, or the end.
fn next<T>(changes: &[T], index: usize, columns: u64, column: impl Fn(&T) -> u64) -> u64 {
    changes.get(index + 1).map_or(columns, column)
}

/// A letter of a monospaced font is one wide, East Asian ones two.
fn letters(text: &str) -> f64 {
    text.width() as f64
}

/// As much of a text as fits; none if it is not worth it.
fn fitting(text: &str, width: f64) -> Option<String> {
    let room = (width / 6.7) as usize;
    if letters(text) as usize <= room {
        return Some(text.to_owned());
    }
    if room < 4 {
        return None;
    }
    let kept: String = text.chars().take(room - 1).collect();
    Some(format!("{kept}…"))
}

/// A coordinate with at most two decimals.
fn n(value: f64) -> String {
    let rounded = libm::round(value * 100.0) / 100.0;
    format!("{rounded}")
}
