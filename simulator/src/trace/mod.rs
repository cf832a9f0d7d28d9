//! Traces: what the tags of a run held, scan by scan, in the forms that other programs read (LANGUAGE §10).
//!
//! ```text
//! Simulation --row, after each scan--> Trace --csv | json | vcd | timing--> text
//! ```
//!
//! A [`Trace`] writes into a string that its caller empties when it likes, so that a long run takes no more memory
//! than a short one. The exception is the timing diagram, whose width depends on the last scan.

mod csv;
mod json;
mod timing;
mod vcd;

use crate::simulation::Simulation;
use crate::tags::Point;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;

/// The form of a trace.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Format {
    /// A row of cells for each scan.
    Csv,
    /// One object with a list of scans.
    Json,
    /// A value change dump, as waveform viewers read it.
    Vcd,
    /// A timing diagram as a picture.
    Svg,
}

/// What a trace is about.
#[derive(Debug, Clone)]
struct Header {
    /// The program, as it is to be named.
    program: String,
    /// Nanoseconds from one scan to the next.
    interval: i64,
    /// The names of what is not run, as no reader understood it.
    unread_parts: Vec<String>,
    tags: Vec<Tag>,
}

/// A tag that is traced.
#[derive(Debug, Clone)]
struct Tag {
    /// As it was asked for.
    name: String,
    point: Point,
}

impl Tag {
    fn ty(&self) -> Scalar {
        self.point.ty
    }
}

/// A form that traces are written in. Rows come in the order of the scans, from 0.
trait Write: std::fmt::Debug {
    fn begin(&mut self, header: &Header, out: &mut String);
    /// `values` has one for each tag of the header.
    fn row(&mut self, header: &Header, scan: u64, values: &[Value], out: &mut String);
    /// `scans` rows have been written.
    fn end(&mut self, header: &Header, scans: u64, out: &mut String);
}

/// A trace that is being written.
#[derive(Debug)]
pub struct Trace {
    header: Header,
    writer: Box<dyn Write>,
    values: Vec<Value>,
    scans: u64,
}

impl Trace {
    /// A trace of some points, by the names that it is to show. What is before the first row goes to `out`.
    pub fn begin(
        format: Format,
        program: &str,
        simulation: &Simulation,
        points: &[(String, Point)],
        out: &mut String,
    ) -> Trace {
        let tags = points.iter().map(|(name, point)| Tag {
            name: name.clone(),
            point: point.clone(),
        });
        let header = Header {
            program: program.to_owned(),
            interval: simulation.options().interval,
            unread_parts: simulation
                .program()
                .unread_parts()
                .map(|(_, name, _)| name.to_owned())
                .collect(),
            tags: tags.collect(),
        };
        let mut writer: Box<dyn Write> = match format {
            Format::Csv => Box::new(csv::Csv),
            Format::Json => Box::new(json::Json),
            Format::Vcd => Box::new(vcd::Vcd::default()),
            Format::Svg => Box::new(timing::Recorder::default()),
        };
        writer.begin(&header, out);
        Trace {
            header,
            writer,
            values: Vec::new(),
            scans: 0,
        }
    }

    /// Writes what the points hold after a scan.
    pub fn row(&mut self, simulation: &Simulation, out: &mut String) {
        self.values.clear();
        let points = self.header.tags.iter().map(|tag| &tag.point);
        self.values.extend(points.map(|point| simulation.value(point)));
        self.writer.row(&self.header, self.scans, &self.values, out);
        self.scans += 1;
    }

    /// Writes what is after the last row.
    pub fn end(mut self, out: &mut String) {
        self.writer.end(&self.header, self.scans, out);
    }
}

/// The clock at the beginning of a scan, in nanoseconds.
fn time_of(scan: u64, interval: i64) -> i64 {
    i64::try_from(scan).unwrap_or(i64::MAX).saturating_mul(interval)
}
