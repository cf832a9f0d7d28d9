//! `ladder online`: what a running controller is doing, in the program's text. It is read, and never written.

mod record;
mod report;

use crate::commands::run::served;
use crate::findings::Source;
use crate::outcome::{Failure, Outcome};
use crate::output::{Existing, Output};
use crate::run::program;
#[cfg(feature = "screen")]
use crate::screen;
use crate::terminal;
use clap::Args;
use ladder_devices::online::{Controller, Wrong};
use ladder_simulator::online::{Connection, Doubt, Online, PATIENCE, Watching};
use ladder_workspace::{Settings, shown};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, sync_channel};
use std::time::{Duration, Instant};

const EXAMPLES: &str = "\
Examples:
  ladder online press.clad --from logix:192.168.1.10/0
                                  live, on this terminal
  ladder online press.clad --from modbus:192.168.1.20:502 --once
                                  one reading: the diagram with its power
  ladder online press.clad --once --why run
                                  and why the motor runs
  ladder online press.clad --once --tags-out values.csv
                                  the values, for `ladder why --tags`
  ladder online press.clad --record night.csv
                                  what the inputs do, until Ctrl+C; then
                                  ladder sim press.clad --inputs night.csv --dt 200ms --scans 100

Without --from, [online] in ladder.toml says which controller:

  [online]
  logix = \"192.168.1.10/0\"

Exit status: 0 fine, 1 the values contradict the program, or it has errors, 2 the
controller cannot be read.";

/// So long a first reading may take, by itself and with all waits of the connection.
const FIRST: Duration = Duration::from_secs(15);

/// So many tags that differ are named one by one.
const MOST_TOLD: usize = 20;

/// Show what a running controller is doing, in the program's text
///
/// The values of the controller are read again and again, and the power of each rung is what they say. Nothing is ever written to the
/// controller: only requests that read get through. The values of one reading are not from one scan, so edges and what is over
/// within a scan are not seen.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The program that the controller runs
    file: PathBuf,

    /// The controller: logix:ADDRESS/SLOT or modbus:HOST:PORT [default: what ladder.toml says]
    #[arg(long, value_name = "SOURCE")]
    from: Option<String>,

    /// Read once, write the diagram with its power, and end
    #[arg(long)]
    once: bool,

    /// With --once: why this tag holds what it holds
    #[arg(long, value_name = "TAG", requires = "once")]
    why: Option<String>,

    /// With --once: write the values to this file, a name and a value a row
    #[arg(long, value_name = "FILE", requires = "once")]
    tags_out: Option<PathBuf>,

    /// Record the inputs in this file, a row for each reading: `ladder sim --inputs` plays it
    #[arg(long, value_name = "FILE", conflicts_with = "once")]
    record: Option<PathBuf>,

    /// Record these tags, too; may be given again
    #[arg(long, value_name = "TAG", requires = "record")]
    watch: Vec<String>,

    /// Record for so long a time
    #[arg(long = "for", value_name = "TIME", requires = "record", value_parser = crate::run::time)]
    length: Option<Duration>,

    /// Replace a file that is there, whatever it is
    #[arg(long)]
    force: bool,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let settings = Settings::of(&arguments.file)?;
    let controller = controller(arguments, &settings)?;
    if !arguments.once && arguments.record.is_none() && !terminal::is_interactive() {
        return Err(Failure::new(
            "say what is to be done: --once writes the diagram with its power, --record FILE.csv records; on a terminal it is shown live",
        ));
    }
    let source = Source::read(&arguments.file, None)?;
    let Some(program) = program(&source) else {
        return Ok(Outcome::Findings);
    };
    let online = Online::new(program).map_err(Failure::new)?;
    let (wake, woken) = sync_channel(1);
    // Once is enough; on the screen, and while it records, nobody waits for it.
    let wake = move || {
        let _ = wake.try_send(());
    };
    let watch = controller.watch(&stem(&arguments.file), &online, wake);
    let watch = watch.map_err(|wrong| failure(&arguments.file, wrong))?;
    let mut watching = Watching::new(online, Box::new(watch));
    if let Some(file) = &arguments.record {
        first(&controller, &mut watching, &woken)?;
        report::differences(&watching);
        return record::record(arguments, file, &controller, watching);
    }
    if !arguments.once {
        #[cfg(not(feature = "screen"))]
        return Err(crate::features::Feature::Screen.left_out());
        #[cfg(feature = "screen")]
        return screen::watch(
            &arguments.file,
            &source,
            controller.to_string(),
            (watching, controller.every()),
        );
    }
    first(&controller, &mut watching, &woken)?;
    settle(&mut watching, &woken);
    if let Some(file) = &arguments.tags_out {
        let mut out = Output::open(Some(file), Existing::by(arguments.force))?;
        report::values(&watching, &mut out)?;
        out.finish()?;
    }
    report::once(&source, &controller, &mut watching, arguments.why.as_deref())
}

/// The controller that is meant.
fn controller(arguments: &Arguments, settings: &Settings) -> Result<Controller, Failure> {
    let asked = settings.online.as_ref();
    let controller = match &arguments.from {
        Some(text) => Some(
            Controller::parse(text, asked).map_err(|message| Failure::new(format!("--from: {message}")))?,
        ),
        None => asked.and_then(Controller::of),
    };
    controller.ok_or_else(|| {
        Failure::new(
            "which controller? Write --from logix:192.168.1.10/0 or --from modbus:192.168.1.20:502, or put [online] into ladder.toml",
        )
    })
}

/// What the file is called without its extension.
fn stem(file: &Path) -> String {
    file.file_stem()
        .map_or_else(String::new, |stem| stem.to_string_lossy().into_owned())
}

/// What is wrong with settings next to the program of a file.
fn failure(file: &Path, wrong: Vec<Wrong>) -> Failure {
    // What comes from the command line is at no place.
    if wrong.iter().all(|wrong| !wrong.at.is_empty()) {
        return served::failure(file, wrong);
    }
    Failure::of_lines(wrong.into_iter().map(|wrong| wrong.message))
}

/// Waits for the first snapshot.
///
/// # Errors
/// There is none: why.
fn first(controller: &Controller, watching: &mut Watching, woken: &Receiver<()>) -> Result<(), Failure> {
    let end = Instant::now() + FIRST;
    loop {
        if watching.look() {
            return Ok(());
        }
        if let Connection::Lost(why) = &watching.newest().connection {
            return Err(Failure::new(format!("the controller {why}")));
        }
        let left = end.saturating_duration_since(Instant::now());
        if woken.recv_timeout(left).is_err() && left.is_zero() {
            return Err(Failure::new(format!(
                "{controller} has told nothing within {FIRST:?}"
            )));
        }
    }
}

/// Reads on while it is open whether a value contradicts the program or has changed while it was read.
fn settle(watching: &mut Watching, woken: &Receiver<()>) {
    // On a busy machine something always has: what does not stay is not waited for.
    let mut left = PATIENCE - 1;
    while left > 0 && !watching.online().doubts().iter().all(Doubt::is_reported) {
        if woken.recv_timeout(FIRST).is_err() || watching.newest().connection != Connection::Open {
            return;
        }
        left -= u32::from(watching.look());
    }
}

/// The controller, as a heading has it.
fn heading(controller: &Controller, watching: &Watching) -> String {
    shown::line(&format!("{controller}: {}", watching.status())).into_owned()
}
