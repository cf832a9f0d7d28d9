//! The rows of a scenario that came out differently: what was expected and what came, the differing steps marked.

use super::bind::{Case, Give};
use super::parse::TIME;
use super::run::{Difference, Ran};
use super::steps::Steps;
use super::suite::Suite;
use super::watch::{Outside, Violation};
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

/// Draws the rows that differ and the properties that are violated, below what was given, in lines of at most about `width`
/// letters: of a long scenario the part around the first difference. `interval` is that of the simulation that ran it.
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
    let groups = groups.into_iter().map(|group: Vec<&Difference>| {
        let entries = group.into_iter();
        let entries = entries.map(|difference| of_difference(case, ran, difference, interval));
        entries.collect::<Vec<Entry>>()
    });
    // The tags of each property are its own, and so are its columns.
    let violations = ran.violations.iter();
    let violations = violations.map(|violation| vec![of_violation(case, violation, interval)]);
    let mut lines = Vec::new();
    for entries in groups.chain(violations).filter(|entries| !entries.is_empty()) {
        draw_group(case, &entries, interval, width, &mut lines);
    }
    lines
}

/// Rows that show one thing that is wrong, and what it is.
struct Entry<'a> {
    rows: Vec<Row<'a>>,
    steps: &'a [usize],
    sentence: String,
}

struct Row<'a> {
    kind: LineKind,
    name: &'a str,
    what: &'static str,
    cells: Vec<Drawn>,
}

fn of_difference<'a>(case: &'a Case, ran: &'a Ran, difference: &'a Difference, interval: i64) -> Entry<'a> {
    let (row, got) = (&case.expected[difference.row], &ran.got[difference.row]);
    let ty = row.target.ty();
    let expected = row.values.iter().map(|(value, _)| drawn(value.as_ref(), ty, "."));
    let got = got.iter().map(|value| drawn(value.as_ref(), ty, "?"));
    Entry {
        rows: vec![
            Row {
                kind: LineKind::Expected,
                name: &row.name,
                what: "expected",
                cells: expected.collect(),
            },
            Row {
                kind: LineKind::Got,
                name: "",
                what: "got",
                cells: got.collect(),
            },
        ],
        steps: &difference.steps,
        sentence: sentence(case, ran, difference, interval),
    }
}

fn of_violation<'a>(case: &'a Case, violation: &'a Violation, interval: i64) -> Entry<'a> {
    let is_given = |name: &str| case.given.iter().any(|row| row.name == name);
    let seen = violation.seen.iter();
    let rows = seen
        .filter(|(point, _)| !is_given(&point.name))
        .map(|(point, values)| Row {
            kind: LineKind::Got,
            name: &point.name,
            what: "",
            cells: values
                .iter()
                .map(|value| drawn(Some(value), point.ty, ""))
                .collect(),
        });
    Entry {
        rows: rows.collect(),
        steps: &violation.steps,
        sentence: violation_sentence(case, violation, interval),
    }
}

/// Draws what shares its columns.
fn draw_group(case: &Case, entries: &[Entry], interval: i64, width: usize, lines: &mut Vec<Line>) {
    let time = times(case, interval).map(|cells| Row {
        kind: LineKind::Given,
        name: TIME,
        what: "",
        cells,
    });
    let given = case.given.iter().map(|row| Row {
        kind: LineKind::Given,
        name: &row.name,
        what: "",
        cells: row
            .values
            .iter()
            .map(|given| match given {
                Some(Give::Back) if row.target.ty() == Scalar::Bool => Drawn::Level('~'),
                Some(Give::Back) => Drawn::Nothing("~"),
                Some(Give::Value(value)) => drawn(Some(value), row.target.ty(), "."),
                None => Drawn::Nothing("."),
            })
            .collect(),
    });
    let given: Vec<Row> = time.into_iter().chain(given).collect();
    let rows = || given.iter().chain(entries.iter().flat_map(|entry| &entry.rows));
    let longest = rows().map(|row| row.name.width()).max().unwrap_or(0);
    // `name  expected  `
    let widest = rows().map(|row| row.what.len()).max().unwrap_or(0);
    let label = |name: &str, what: &str| {
        let gap = longest - name.width().min(longest);
        let what = if widest > 0 {
            format!("{what:<widest$}  ")
        } else {
            String::new()
        };
        format!("{name}{}  {what}", " ".repeat(gap))
    };
    let first = entries.iter().filter_map(|entry| entry.steps.first()).min();
    let room = width.saturating_sub(longest + 12).max(20);
    let table = Table::of(case.steps(), rows(), *first.unwrap_or(&0), room);
    let drawn = |row: &Row| Line {
        kind: row.kind,
        text: (label(row.name, row.what) + &table.row(&row.cells))
            .trim_end()
            .to_owned(),
    };
    lines.extend(given.iter().map(drawn));
    for entry in entries {
        lines.extend(entry.rows.iter().map(drawn));
        lines.push(Line {
            kind: LineKind::Marks,
            text: (label("", "") + &table.marks(entry.steps)).trim_end().to_owned(),
        });
        lines.push(Line {
            kind: LineKind::Sentence,
            text: entry.sentence.clone(),
        });
    }
}

/// How long each step is, as it may be written; nothing where all are alike.
fn times(case: &Case, interval: i64) -> Option<Vec<Drawn>> {
    let steps = &case.steps;
    if matches!(steps, Steps::Even { .. }) {
        return None;
    }
    let written = |step: usize| match steps.unusual(step) {
        Some(scans) => {
            let scans = i64::try_from(scans).unwrap_or(i64::MAX);
            Drawn::Text(value_text::duration(scans.saturating_mul(interval)))
        }
        None => Drawn::Text(".".to_owned()),
    };
    Some((0..steps.count()).map(written).collect())
}

/// A violation in words: `"the contactors exclude each other" is violated in scan 3 (at 300ms)`.
pub fn violation_sentence(case: &Case, violation: &Violation, interval: i64) -> String {
    let step = case.step_at(violation.scan);
    let mut text = violated_in_scan(&violation.name, violation.scan, Some(step), interval);
    if violation.scans > 1 {
        text.push_str(&format!("; {} scans violate it", violation.scans));
    }
    text
}

/// That a scan violates a property, in words; with its step if it is one of a scenario.
pub fn violated_in_scan(property: &str, scan: u64, step: Option<usize>, interval: i64) -> String {
    let time = value_text::duration(i64::try_from(scan).unwrap_or(i64::MAX).saturating_mul(interval));
    let step = step.map_or(String::new(), |step| format!("step {step}, "));
    format!("the property \"{property}\" is violated in scan {scan} ({step}at {time})")
}

/// Where a run leaves what is assumed, in words.
pub fn outside_sentence(suite: &Suite, outside: &Outside, interval: i64) -> String {
    let assumed = suite.assumptions.get(outside.assumption);
    let time = i64::try_from(outside.scan)
        .unwrap_or(i64::MAX)
        .saturating_mul(interval);
    format!(
        "outside of what is assumed from scan {} (at {}) on, where `{}` does not hold: the properties are not watched from there",
        outside.scan,
        value_text::duration(time),
        assumed.map_or("", |assumed| &assumed.text)
    )
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
    /// What is where there is no value.
    Nothing(&'static str),
    Text(String),
}

fn drawn(value: Option<&Value>, ty: Scalar, none: &'static str) -> Drawn {
    match value {
        None => Drawn::Nothing(none),
        Some(Value::Bool(high)) => Drawn::Level(if *high { '-' } else { '_' }),
        Some(value) => {
            let text = value_text::display(value, ty);
            Drawn::Text(match text.strip_prefix("T#") {
                Some(duration) => duration.to_owned(),
                None => text,
            })
        }
    }
}

/// The columns of the drawing.
struct Table {
    /// How wide each step is, with what is between it and the next.
    widths: Vec<usize>,
    /// How much that is.
    gap: usize,
    /// The steps that are shown.
    from: usize,
    to: usize,
}

impl Table {
    /// Columns of these rows, of which as many are shown as there is room for.
    fn of<'r>(steps: usize, rows: impl Iterator<Item = &'r Row<'r>>, first: usize, room: usize) -> Table {
        let mut widths = vec![1; steps];
        let mut has_texts = false;
        for row in rows {
            for (width, cell) in widths.iter_mut().zip(&row.cells) {
                if let Drawn::Text(text) = cell {
                    has_texts = true;
                    *width = (*width).max(text.width());
                }
            }
        }
        // A blank between values.
        let gap = usize::from(has_texts);
        for width in widths.iter_mut().rev().skip(1) {
            *width += gap;
        }
        let (from, to) = window(&widths, first, room);
        Table {
            widths,
            gap,
            from,
            to,
        }
    }

    fn row(&self, cells: &[Drawn]) -> String {
        let mut text = String::new();
        if self.from > 0 {
            text.push('…');
        }
        for (cell, &width) in cells.iter().zip(&self.widths).take(self.to).skip(self.from) {
            match cell {
                Drawn::Level(letter) => text.extend(std::iter::repeat_n(*letter, width)),
                Drawn::Nothing(value) => padded(&mut text, value, width),
                Drawn::Text(value) => padded(&mut text, value, width),
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
        for (step, &width) in self.widths.iter().enumerate().take(self.to).skip(self.from) {
            let mark = if steps.contains(&step) { '^' } else { ' ' };
            let gap = if step + 1 < self.widths.len() { self.gap } else { 0 };
            text.extend(std::iter::repeat_n(mark, width - gap));
            text.extend(std::iter::repeat_n(' ', gap));
        }
        text.trim_end().to_owned()
    }
}

fn padded(text: &mut String, value: &str, width: usize) {
    text.push_str(value);
    text.extend(std::iter::repeat_n(' ', width - value.width().min(width)));
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
