//! The CSV that a run writes: one row for each scan.

use super::output::Output;
use super::run::Run;
use csv::Writer;
use ladder_simulator::{Point, value_text};
use std::io;

/// Runs all scans and writes the header and their rows. `watched` has the tags by the names that the header shows.
pub(super) fn write(run: &mut Run, watched: &[(String, Point)], out: Output) -> io::Result<Output> {
    let interval = run.simulation.options().interval;
    let mut writer = Writer::from_writer(out);
    let names = watched.iter().map(|(name, _)| name.as_str());
    writer.write_record(["scan", "time_ms"].into_iter().chain(names))?;
    let mut scan: i64 = 0;
    while !writer.get_ref().is_closed() && run.scan() {
        writer.write_field(scan.to_string())?;
        writer.write_field(value_text::milliseconds(scan.saturating_mul(interval)))?;
        for (_, point) in watched {
            writer.write_field(value_text::cell(&run.simulation.value(point), point.ty))?;
        }
        writer.write_record(None::<&[u8]>)?;
        scan += 1;
    }
    writer.into_inner().map_err(csv::IntoInnerError::into_error)
}
