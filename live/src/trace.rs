//! The trace of chosen tags, for a client that draws it.

use ladder_simulator::chart::{self, Kind, Level, Mark, Track, Window};
use serde_json::Value;

use crate::engine::Engine;
use crate::messages::{Cursors, Reach, Tick, Trace, TraceColumn, TraceTag, Traced, TracedKind};
use crate::request::Failure;

/// More tags than this nobody can look at.
const MOST_TAGS: usize = 64;

/// More columns than this no screen has.
const MOST_COLUMNS: u64 = 10_000;

/// No simulation comes so far.
const MOST_SCANS: u64 = 1 << 53;

/// As many as are drawn if the client does not say.
const COLUMNS: u64 = 1000;
const TICKS: u64 = 8;

/// More ticks than this nobody can read.
const MOST_TICKS: u64 = 100;

/// This many ticks a scale of values has, more or less.
const TICKS_OF_SCALE: u64 = 3;

impl Engine {
    /// The scans that one can go to.
    pub(crate) fn reach(&self) -> Reach {
        let here = self.scans();
        Reach {
            first: here - (self.behind() as u64).min(here),
            last: here + self.ahead() as u64,
        }
    }

    /// Records tags from now on, and says what is drawn of them.
    pub(crate) fn trace(&mut self, asked: &Trace) -> Result<Traced, Failure> {
        check(asked)?;
        let named = asked.tags.iter();
        let mut points = Vec::new();
        let of_names: Vec<Option<usize>> = named
            .map(|name| {
                let point = self.session.find(name).ok()?;
                let same = |known: &ladder_simulator::Point| known.name == point.name;
                Some(points.iter().position(same).unwrap_or_else(|| {
                    points.push(point);
                    points.len() - 1
                }))
            })
            .collect();
        self.recorder.watch(points, &self.session);
        let newest = self.reach().last;
        let oldest = self.recorder.tracks().iter().filter_map(Track::first).min();
        let oldest = oldest.unwrap_or_else(|| newest.max(1));
        let last = asked.last.unwrap_or(newest).min(MOST_SCANS);
        let span = asked.span.unwrap_or((last + 1).saturating_sub(oldest));
        let window = Window::new(last, span, asked.columns.unwrap_or(COLUMNS));
        let interval = i64::try_from(self.interval().as_nanos()).unwrap_or(i64::MAX);
        let drawn = Drawn {
            engine: self,
            asked,
            window,
            newest,
        };
        let tags = asked.tags.iter().zip(of_names);
        let tags = tags.map(|(name, track)| match track {
            Some(track) => drawn.tag(&self.recorder.tracks()[track]),
            None => unknown(name),
        });
        Ok(Traced {
            tags: tags.collect(),
            revision: self.recorder.revision(),
            interval_ms: interval as f64 / 1e6,
            first: window.first,
            last: window.last,
            per: window.per,
            oldest,
            newest,
            here: self.scans(),
            reach: self.reach(),
            ticks: window
                .ticks(interval, asked.ticks.unwrap_or(TICKS))
                .into_iter()
                .map(|tick| Tick {
                    at: tick.at / interval as f64,
                    text: tick.text,
                })
                .collect(),
            cursors: cursors(&asked.cursors, interval),
        })
    }
}

fn check(asked: &Trace) -> Result<(), Failure> {
    let within = |what: &str, number: Option<u64>, most: u64| match number {
        Some(number) if number == 0 || number > most => Err(Failure::Invalid(format!(
            "{what} is {number}; it must be from 1 to {most}"
        ))),
        _ => Ok(()),
    };
    within("columns", asked.columns, MOST_COLUMNS)?;
    within("ticks", asked.ticks, MOST_TICKS)?;
    within("span", asked.span, u64::from(u32::MAX))?;
    if asked.tags.len() > MOST_TAGS {
        return Err(Failure::Invalid(format!(
            "{} tags are too many for a trace; choose up to {MOST_TAGS}",
            asked.tags.len()
        )));
    }
    if asked.cursors.len() > 2 {
        return Err(Failure::Invalid("a trace has two cursors at most".into()));
    }
    Ok(())
}

/// What the program has no tag for.
fn unknown(name: &str) -> TraceTag {
    TraceTag {
        name: name.to_owned(),
        type_name: String::new(),
        kind: TracedKind::Unknown,
        now: None,
        oldest: None,
        range: None,
        ticks: Vec::new(),
        columns: Vec::new(),
        readings: Vec::new(),
        difference: None,
    }
}

fn cursors(scans: &[u64], interval: i64) -> Option<Cursors> {
    let time = |scan: u64| i64::try_from(scan).unwrap_or(i64::MAX).saturating_mul(interval);
    let duration = |nanoseconds: i64| chart::duration(nanoseconds);
    Some(Cursors {
        times: match scans {
            [] => return None,
            _ => scans.iter().map(|scan| duration(time(*scan))).collect(),
        },
        difference: match scans {
            [from, to] if to < from => Some(format!("-{}", duration(time(from - to)))),
            [from, to] => Some(format!("+{}", duration(time(to - from)))),
            _ => None,
        },
    })
}

/// A trace that is being put together.
struct Drawn<'e> {
    engine: &'e Engine,
    asked: &'e Trace,
    window: Window,
    newest: u64,
}

impl Drawn<'_> {
    fn tag(&self, track: &Track) -> TraceTag {
        let ty = track.point.ty;
        let columns = track.columns(&self.window, self.asked.since.unwrap_or(0), self.newest);
        let at = |scan: &u64| track.at(*scan).filter(|_| *scan <= self.newest);
        let readings: Vec<_> = self.asked.cursors.iter().map(at).collect();
        let simulation = self.engine.session.simulation();
        TraceTag {
            name: track.point.name.clone(),
            type_name: ty.to_string(),
            kind: match track.kind() {
                Kind::Bit => TracedKind::Bit,
                Kind::Number => TracedKind::Number,
                Kind::Text => TracedKind::Text,
            },
            now: Some(chart::reading(&simulation.value(&track.point), ty)),
            oldest: track.first(),
            range: match track.kind() {
                Kind::Number => track
                    .range()
                    .map(|(least, greatest)| [json(least), json(greatest)]),
                Kind::Bit | Kind::Text => None,
            },
            ticks: track
                .ticks(TICKS_OF_SCALE)
                .into_iter()
                .map(|tick| Tick {
                    at: tick.at,
                    text: tick.text,
                })
                .collect(),
            columns: columns.into_iter().map(column).collect(),
            difference: match readings[..] {
                [Some(from), Some(to)] => chart::difference(from, to, ty),
                _ => None,
            },
            readings: readings
                .into_iter()
                .map(|value| value.map(|value| chart::reading(value, ty)))
                .collect(),
        }
    }
}

fn column(chart::Column { number, mark }: chart::Column) -> TraceColumn {
    match mark {
        Mark::Bit(level) => TraceColumn::Single(
            number,
            Value::from(match level {
                Level::Low => 0,
                Level::High => 1,
                Level::Both => 2,
            }),
        ),
        Mark::Number {
            least,
            greatest,
            last,
        } => TraceColumn::Number(number, json(least), json(greatest), json(last)),
        Mark::Text(text) => TraceColumn::Single(number, Value::from(text)),
    }
}

/// A whole number is written without a point.
fn json(number: f64) -> Value {
    if number.fract() == 0.0 && number.abs() < 9e15 {
        Value::from(number as i64)
    } else {
        Value::from(number)
    }
}
