//! What a run writes: scan by scan, in the chosen form.

use crate::json;
use crate::output::Output;
use crate::run::Run;
use ladder_simulator::Point;
pub(super) use ladder_simulator::trace::Format;
use ladder_simulator::trace::Trace;
use std::io::{self, Write};

/// This many bytes are gathered before they are written.
const CHUNK: usize = 1 << 16;

/// Runs all scans and writes their trace. `watched` has the tags by the names that it shows.
pub(super) fn write(
    format: Format,
    run: &mut Run,
    watched: &[(String, Point)],
    out: &mut Output,
) -> io::Result<()> {
    let mut text = String::new();
    let mut trace = Trace::begin(format, &run.source.file, &run.simulation, watched, &mut text);
    while !out.is_closed() && run.scan() {
        trace.row(&run.simulation, &mut text);
        if text.len() >= CHUNK {
            put(format, &text, out)?;
            text.clear();
        }
    }
    trace.end(&mut text);
    put(format, &text, out)
}

/// Strings of a program may hold anything; what is shown on stdout is written out, what goes into a file is not.
fn put(format: Format, text: &str, out: &mut Output) -> io::Result<()> {
    match format {
        Format::Json => out.write_all(json::safe(text).as_bytes()),
        Format::Csv | Format::Vcd | Format::Svg => out.write_text(text),
    }
}
