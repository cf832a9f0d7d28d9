//! `ladder run`: a program in real time.

mod hands;
pub(crate) mod served;
mod wired;

use crate::findings::Source;
use crate::form::Notation;
use crate::outcome::{Failure, Outcome};
use crate::run::{KeptIn, Plants, Retention, Stimulus, place, program, simulation};
use crate::terminal;
use clap::Args;
use hands::Hands;
use ladder_devices::lateness::Report;
use ladder_devices::real::{self, Ended};
use ladder_devices::system;
use ladder_simulator::{Simulation, real_time, value_text};
use ladder_workspace::{Settings, shown};
use std::path::PathBuf;
use std::time::Duration;

const EXAMPLES: &str = "\
Examples:
  ladder run pump.clad            in real time, until Ctrl+C
  ladder run pump.clad --plant tank.clad
                                  beside a model of the machine
  ladder run pump.clad --modbus   tags at direct addresses, on 127.0.0.1:1502
  ladder run ladder.toml          the tasks of a project
  kill -HUP PID                   take the program again from its file
  kill -USR1 PID                  how late scans were so far

What Modbus serves is in ladder.toml:

  [serve.modbus]
  write = [\"start\"]
  [serve.modbus.map]
  \"coil 0\" = \"start\"
  \"holding 100\" = \"level\"

So are the devices whose inputs and outputs are the program's:

  [[device]]
  name = \"rio\"
  modbus = \"192.168.1.20:502\"
  read = { \"discrete 0..7\" = \"%IX10.0\" }
  write = { \"coil 0..7\" = \"%QX10.0\" }

Exit status: 0 fine, 1 the program has errors or a fault stopped it, 2 a file or
an argument cannot be used.";

/// The first line of every run.
const NOTICE: &str = "this is a soft controller for tests and teaching, not a safety device: nothing that can hurt anybody may depend on it";

/// Without a setting a scan may take so many intervals.
const INTERVALS: u32 = 10;

/// Run a program in real time
///
/// Scans begin at absolute times, so that lateness does not add up. What was missed is counted, and has passed for the timers.
/// `[serve.modbus]` in ladder.toml serves tags to screens, SCADA systems and Factory I/O. `[[device]]` connects inputs and outputs
/// with devices on the network.
///
/// This is a soft controller for tests and teaching, not a safety device.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The program, or the ladder.toml of a project with tasks
    file: PathBuf,

    #[command(flatten)]
    from: Notation,

    #[command(flatten)]
    plants: Plants,

    #[command(flatten)]
    stimulus: Stimulus,

    /// Keep retentive tags in this file instead of the one of ladder.toml
    #[arg(long, value_name = "FILE")]
    retain: Option<PathBuf>,

    /// Serve tags on Modbus, at this address instead of the one of ladder.toml
    #[arg(long, value_name = "ADDRESS:PORT", num_args = 0..=1, default_missing_value = "")]
    modbus: Option<String>,

    /// Let nobody write, whatever ladder.toml says
    #[arg(long)]
    read_only: bool,

    /// Leave the devices of ladder.toml alone
    #[arg(long)]
    no_devices: bool,

    /// End after so long a time
    #[arg(long = "for", value_name = "TIME", value_parser = crate::run::time)]
    length: Option<Duration>,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    terminal::note(&NOTICE);
    let settings = Settings::of(&arguments.file)?;
    let Some(mut loaded) = Loaded::new(arguments)? else {
        return Ok(Outcome::Findings);
    };
    let inputs = arguments.stimulus.give(&mut loaded.simulation)?;
    let served = served::served(arguments, &settings, &loaded.simulation)?;
    let wired = wired::wired(arguments, &settings, served.as_ref(), &loaded.simulation)?;
    let retention = match (&arguments.retain, &settings.simulate.retain) {
        (Some(file), _) => Some(KeptIn::File(file)),
        (None, Some(named)) => Some(KeptIn::OfWorkspace(named)),
        (None, None) => None,
    };
    let retention = retention.map(|file| Retention::begin(file, &arguments.file, &mut loaded.simulation));
    let asked = crate::signals::asked(arguments.length)
        .map_err(|error| Failure::new(format!("signals cannot be watched: {error}")))?;
    let interval = real_time(loaded.simulation.options().interval);
    let longest = settings.run.watchdog.map_or(interval * INTERVALS, real_time);
    let mut hands = Hands::new(retention.transpose()?, inputs, served);
    hands.listen(&loaded.simulation)?;
    hands.connect(wired)?;
    terminal::note(&format_args!(
        "{} runs every {}; Ctrl+C ends it",
        shown::path(&arguments.file),
        value_text::duration(loaded.simulation.options().interval)
    ));
    system::wake_in_time();
    let mut report = Report::default();
    let ended = loop {
        let ended = real::run(
            &mut loaded.simulation,
            longest,
            &mut report,
            &asked,
            &mut hands,
            &end_without_it,
        );
        for fault in hands.take_faults() {
            let place = place(&loaded.source, fault.location);
            terminal::plain(&format_args!(
                "{place}: fault in scan {}: {}",
                fault.scan,
                shown::line(&fault.message)
            ));
        }
        if ended != Ended::Reload {
            break ended;
        }
        reload(arguments, &settings, &mut loaded, &mut hands);
    };
    hands.finish(&loaded.simulation)?;
    terminal::note(&report);
    Ok(match ended {
        Ended::Asked | Ended::Reload => Outcome::Fine,
        Ended::Program => {
            terminal::note(&"the program has ended with <END>");
            Outcome::Fine
        }
        Ended::Fault => Outcome::Findings,
        Ended::TooLong(took) => {
            terminal::error(&format_args!(
                "a scan took {took:.1?}, and {longest:.1?} is the most; `watchdog` in [run] of ladder.toml says how long it may take"
            ));
            Outcome::Findings
        }
    })
}

/// Ends the process: the thread that scans has not come back, so nothing can be asked of it any more.
fn end_without_it(took: Duration) {
    terminal::error(&format_args!(
        "a scan has not come back for {took:.1?}; the run ends without it, and outputs of devices stay as they were written last"
    ));
    std::process::exit(Outcome::Findings as i32)
}

/// A program that can run.
struct Loaded {
    source: Source,
    simulation: Simulation,
}

impl Loaded {
    /// Reads the program. None: it has errors, which are shown.
    fn new(arguments: &Arguments) -> Result<Option<Loaded>, Failure> {
        let from = arguments.from.form();
        let source = arguments.plants.beside(Source::read(&arguments.file, from)?)?;
        let Some(program) = program(&source) else {
            return Ok(None);
        };
        let options = arguments.stimulus.options(&arguments.file, &program)?;
        let simulation = simulation(&source, program, options)?;
        Ok(Some(Loaded { source, simulation }))
    }
}

/// Takes the program again from its file, as after a power failure: what is retentive stays. One that has errors, or that the
/// settings do not fit, is not taken.
fn reload(arguments: &Arguments, settings: &Settings, loaded: &mut Loaded, hands: &mut Hands) {
    let kept = loaded.simulation.retained();
    let next = Loaded::new(arguments).and_then(|next| {
        let Some(mut next) = next else { return Ok(None) };
        for complaint in next.simulation.warm_start(&kept) {
            terminal::warning(&complaint);
        }
        let served = served::served(arguments, settings, &next.simulation)?;
        let wired = wired::wired(arguments, settings, served.as_ref(), &next.simulation)?;
        hands.replace(served, wired, &next.simulation);
        Ok(Some(next))
    });
    match next {
        Ok(Some(next)) => {
            *loaded = next;
            terminal::note(&format_args!("{} is taken again", shown::path(&arguments.file)));
        }
        Ok(None) => terminal::warning(&"the program has errors, and the one that ran goes on"),
        Err(failure) => terminal::warning(&format_args!("{failure}; the program that ran goes on")),
    }
}
