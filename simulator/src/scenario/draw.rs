//! The rows of a scenario that came out differently: what was expected and what came, the differing steps marked.

use super::bind::{Case, Target};
use super::parse::TIME;
use super::run::{Difference, Ran};
use super::steps::Steps;
use crate::value_text;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use unicode_width::UnicodeWidthStr;

/// What a line of the drawing shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LineKind {
    /// What was given to a tag.
    Given,
    /// What was expected of a tag.
    Expected,
    /// What it really was.
    Got,
    /// Carets under the steps that differ.
    Marks,
    /// The difference in words.
    Sentence,
}

/// A line of the drawing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Line {
    /// What it shows.
    pub kind: LineKind,
    /// The line, without a line end.
    pub text: String,
}

/// Draws the rows that differ, below what was given, in lines of at most about `width` letters: of a long scenario
/// the part around the first difference. `interval` is that of the simulation that ran it.
///
/// Waveforms are drawn as they are written, a letter a step. Rows of values have columns as wide as their values need.
/// Where values were given they may be why a waveform differs, so all rows are in such columns; else the waveforms come
/// first, and below them the rows of values with what was given once more in their columns.
pub fn draw(case: &Case, ran: &Ran, interval: i64, width: usize) -> Vec<Line> {
    let is_wave = |difference: &&Difference| case.expected[difference.row].target.ty() == Scalar::Bool;
    let (waves, values): (Vec<&Difference>, Vec<&Difference>) = ran.differences.iter().partition(is_wave);
    let are_values_given = case.given.iter().any(|row| row.target.ty() != Scalar::Bool);
    let groups = if are_values_given {
        vec![ran.differences.iter().collect()]
    } else {
        vec![waves, values]
    };
    let mut lines = Vec::new();
    for differences in groups.into_iter().filter(|group| !group.is_empty()) {
        let group = Group {
            case,
            ran,
            differences,
        };
        group.draw(interval, width, &mut lines);
    }
    lines
}

/// Rows that share their columns.
struct Group<'a> {
    case: &'a Case,
    ran: &'a Ran,
    differences: Vec<&'a Difference>,
}

impl Group<'_> {
    fn draw(&self, interval: i64, width: usize, lines: &mut Vec<Line>) {
        let times = self.times(interval);
        let time = times.is_some().then_some(TIME);
        let names = self.case.given.iter().map(|row| row.name.as_str()).chain(time);
        let differing = self.differences.iter().map(|difference| difference.tag.as_str());
        let longest = names
            .chain(differing)
            .map(UnicodeWidthStr::width)
            .max()
            .unwrap_or(0);
        // `name  expected  `
        let label = |name: &str, what: &str| {
            let gap = longest - name.width().min(longest);
            format!("{name}{}  {what:<8}  ", " ".repeat(gap))
        };
        let table = Table::of(self, times.as_deref(), width.saturating_sub(longest + 12).max(20));
        if let Some(times) = times {
            let cells: Vec<Drawn> = times.into_iter().map(Drawn::Text).collect();
            lines.push(Line {
                kind: LineKind::Given,
                text: label(TIME, "") + &table.row(&cells),
            });
        }
        for row in &self.case.given {
            let cells: Vec<Drawn> = row
                .values
                .iter()
                .map(|value| drawn(value.as_ref(), &row.target, "."))
                .collect();
            lines.push(Line {
                kind: LineKind::Given,
                text: label(&row.name, "") + &table.row(&cells),
            });
        }
        for difference in &self.differences {
            let (row, got) = (&self.case.expected[difference.row], &self.ran.got[difference.row]);
            let expected: Vec<Drawn> = row
                .values
                .iter()
                .map(|(value, _)| drawn(value.as_ref(), &row.target, "."))
                .collect();
            let got: Vec<Drawn> = got
                .iter()
                .map(|value| drawn(value.as_ref(), &row.target, "?"))
                .collect();
            for (kind, name, what, text) in [
                (
                    LineKind::Expected,
                    row.name.as_str(),
                    "expected",
                    table.row(&expected),
                ),
                (LineKind::Got, "", "got", table.row(&got)),
                (LineKind::Marks, "", "", table.marks(&difference.steps)),
            ] {
                let text = (label(name, what) + &text).trim_end().to_owned();
                lines.push(Line { kind, text });
            }
            lines.push(Line {
                kind: LineKind::Sentence,
                text: sentence(self.case, self.ran, difference, interval),
            });
        }
    }

    /// How long each step is, as it may be written; nothing where all are alike.
    fn times(&self, interval: i64) -> Option<Vec<String>> {
        let steps = &self.case.steps;
        if matches!(steps, Steps::Even { .. }) {
            return None;
        }
        let written = |step: usize| match steps.unusual(step) {
            Some(scans) => {
                value_text::duration(i64::try_from(scans).unwrap_or(i64::MAX).saturating_mul(interval))
            }
            None => ".".to_owned(),
        };
        Some((0..steps.count()).map(written).collect())
    }
}

/// A difference in words: `run is FALSE in step 3 (at 300ms), TRUE was expected; 4 of 9 steps differ`.
pub fn sentence(case: &Case, ran: &Ran, difference: &Difference, interval: i64) -> String {
    let row = &case.expected[difference.row];
    let ty = row.target.ty();
    let step = difference.steps[0];
    let shown =
        |value: Option<&Value>| value.map_or_else(String::new, |value| value_text::display(value, ty));
    let wanted = shown(row.values[step].0.as_ref());
    // The last scan of the step.
    let scans = i64::try_from(case.steps.begin(step + 1)).unwrap_or(i64::MAX) - 1;
    let when = format!(
        "in step {step} (at {})",
        value_text::duration(scans.saturating_mul(interval))
    );
    let mut text = match &ran.got[difference.row][step] {
        Some(got) => format!(
            "{} is {} {when}, {wanted} was expected",
            row.name,
            shown(Some(got))
        ),
        None => format!("{} has no value {when}, {wanted} was expected", row.name),
    };
    if difference.steps.len() > 1 {
        text.push_str(&format!(
            "; {} of {} steps differ",
            difference.steps.len(),
            case.steps()
        ));
    }
    if row.tolerance.is_none()
        && let (Some(Value::Real(wanted)), Some(Value::Real(got))) =
            (&row.values[step].0, &ran.got[difference.row][step])
        && (wanted - got).abs() <= wanted.abs() * 1e-4
    {
        text.push_str("; give the row a tolerance, as in ± 0.001");
    }
    text
}

/// A cell as it is drawn.
enum Drawn {
    /// One letter that fills its column.
    Level(char),
    Text(String),
}

fn drawn(value: Option<&Value>, target: &Target, none: &str) -> Drawn {
    match value {
        None => Drawn::Text(none.to_owned()),
        Some(Value::Bool(high)) => Drawn::Level(if *high { '-' } else { '_' }),
        Some(value) => {
            let text = value_text::display(value, target.ty());
            Drawn::Text(match text.strip_prefix("T#") {
                Some(duration) => duration.to_owned(),
                None => text,
            })
        }
    }
}

/// The columns of the drawing.
struct Table {
    /// How wide each step is.
    widths: Vec<usize>,
    /// The steps that are shown.
    from: usize,
    to: usize,
}

impl Table {
    fn of(group: &Group, times: Option<&[String]>, room: usize) -> Table {
        let mut widths = vec![1; group.case.steps()];
        let mut has_texts = false;
        let mut take = |step: usize, value: Option<&Value>, target: &Target| {
            if let Drawn::Text(text) = drawn(value, target, ".") {
                has_texts |= value.is_some();
                widths[step] = widths[step].max(text.width());
            }
        };
        for row in &group.case.given {
            for (step, value) in row.values.iter().enumerate() {
                take(step, value.as_ref(), &row.target);
            }
        }
        for difference in &group.differences {
            let row = &group.case.expected[difference.row];
            for (step, (wanted, _)) in row.values.iter().enumerate() {
                take(step, wanted.as_ref(), &row.target);
                take(step, group.ran.got[difference.row][step].as_ref(), &row.target);
            }
        }
        for (width, time) in widths.iter_mut().zip(times.unwrap_or_default()) {
            has_texts = true;
            *width = (*width).max(time.width());
        }
        if has_texts {
            // A blank after each value.
            for width in &mut widths {
                *width += 1;
            }
        }
        let first = group
            .differences
            .iter()
            .filter_map(|difference| difference.steps.first())
            .min();
        let (from, to) = window(&widths, first.copied().unwrap_or(0), room);
        Table { widths, from, to }
    }

    fn row(&self, cells: &[Drawn]) -> String {
        let mut text = String::new();
        if self.from > 0 {
            text.push('…');
        }
        for (cell, &width) in cells.iter().zip(&self.widths).take(self.to).skip(self.from) {
            match cell {
                Drawn::Level(letter) => text.extend(std::iter::repeat_n(*letter, width)),
                Drawn::Text(value) => {
                    text.push_str(value);
                    text.extend(std::iter::repeat_n(' ', width - value.width().min(width)));
                }
            }
        }
        if self.to < self.widths.len() {
            text.push('…');
        }
        text.trim_end().to_owned()
    }

    fn marks(&self, steps: &[usize]) -> String {
        let mut text = String::new();
        if self.from > 0 {
            text.push(' ');
        }
        let spaced = self.widths.iter().all(|&width| width > 1);
        for (step, &width) in self.widths.iter().enumerate().take(self.to).skip(self.from) {
            let mark = if steps.contains(&step) { '^' } else { ' ' };
            // The blank after a value is not part of it.
            let marked = if spaced { width - 1 } else { width };
            text.extend(std::iter::repeat_n(mark, marked));
            text.extend(std::iter::repeat_n(' ', width - marked));
        }
        text.trim_end().to_owned()
    }
}

/// As many steps as there is room for, with the first difference in the left third of them.
fn window(widths: &[usize], first: usize, room: usize) -> (usize, usize) {
    if widths.iter().sum::<usize>() <= room {
        return (0, widths.len());
    }
    // Room for the dots at both ends.
    let room = room - 2;
    let mut from = first;
    let mut before = 0;
    while from > 0 && before + widths[from - 1] <= room / 3 {
        from -= 1;
        before += widths[from];
    }
    let (mut to, mut used) = (from, 0);
    while to < widths.len() && (used + widths[to] <= room || to <= first) {
        used += widths[to];
        to += 1;
    }
    // Room that is left over at the end is used at the beginning.
    while from > 0 && used + widths[from - 1] <= room {
        from -= 1;
        used += widths[from];
    }
    (from, to)
}
