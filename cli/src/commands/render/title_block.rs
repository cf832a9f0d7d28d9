//! What the title block of printed pages says: the project, its version, the file, and the day.

use crate::outcome::Failure;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_simulator::value_text;
use ladder_workspace::{Settings, shown};
use std::path::Path;
use std::time::UNIX_EPOCH;

/// The cells from left to right. Name and version are those of `ladder.toml`; what it does not say has no cell.
///
/// # Errors
/// The settings cannot be read.
pub(super) fn title_block(program: &Path) -> Result<Vec<String>, Failure> {
    let project = Settings::of(program)?.project;
    let file = program.file_name().map(|name| name.to_string_lossy());
    let version = project.version.map(|version| format!("Version {version}"));
    let cells = [
        project.name,
        version,
        file.map(std::borrow::Cow::into_owned),
        day(program),
    ];
    let cells = cells.into_iter().flatten().filter(|cell| !cell.is_empty());
    Ok(cells.map(|cell| shown::line(&cell).to_string()).collect())
}

/// The day on which the program was changed last, so that the same program makes the same pages. `SOURCE_DATE_EPOCH` is
/// obeyed, for files whose times mean nothing, as after a checkout.
fn day(program: &Path) -> Option<String> {
    const DAY: i64 = 24 * 60 * 60;
    const SECOND: i64 = 1_000_000_000;
    let given = std::env::var("SOURCE_DATE_EPOCH").ok();
    let given = given.and_then(|seconds| seconds.trim().parse::<i64>().ok());
    let seconds = given.or_else(|| {
        let changed = std::fs::metadata(program).and_then(|file| file.modified()).ok()?;
        let since = changed.duration_since(UNIX_EPOCH).ok()?;
        i64::try_from(since.as_secs()).ok()
    })?;
    let midnight = seconds.div_euclid(DAY).checked_mul(DAY)?.checked_mul(SECOND)?;
    let day = value_text::display(&Value::Int(midnight), Scalar::Date);
    Some(day.trim_start_matches("D#").to_owned())
}
