//! `ladder why`: why a tag holds what it holds, from values that were taken from a controller, without a run.

mod json;

use crate::commands::render::text;
use crate::findings::Source;
use crate::form::Notation;
use crate::json::to_writer_pretty;
use crate::outcome::{Failure, Outcome};
use crate::run::{Plants, program, with_wording};
use crate::terminal::Stdout;
use crate::values::Given;
use clap::{Args, ValueEnum};
use ladder_analysis::program::Program;
use ladder_simulator::{Judged, Moment, Options, Simulation};
use ladder_workspace::shown;
use std::io::{self, Write};
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  ladder why press.clad run --tags values.csv
  ladder why press.clad run --tags values.csv --format json

The table has a name and a value a row, with `,`, `;` or tabs between them:

  start,1
  stop,FALSE
  warmup.ACC,1500

A header may say which columns they are in: `name` or `tag`, `value` or `Monitor value`.

Exit status: 0 the program explains the value, 1 the values contradict it, some that are needed are not there, or the
program has errors, 2 a file cannot be read, or there is no such tag.";

/// What the settings say does not count here, as it does for a run.
const NAMED_PLANT: &str = "A model of the machine, which is asked, too: what comes from it is followed through the connection. `FILE as NAME` calls it otherwise than \
                           `plant`; may be given again";

/// Say why a tag holds what it holds, from values that were taken from a controller
///
/// The networks that write the tag are run once, each from the values of the table, and drawn with their power: no time passes, and no
/// edge comes through. What decides is followed back to other tags. Values that contradict the program are said, and which are needed and
/// not in the table.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, mut_arg("plant", |plant| plant.long_help(NAMED_PLANT)))]
pub(crate) struct Arguments {
    /// The program
    file: PathBuf,

    /// The tag
    tag: String,

    /// The table of values, in CSV
    #[arg(long, value_name = "FILE")]
    tags: PathBuf,

    #[command(flatten)]
    from: Notation,

    #[command(flatten)]
    plants: Plants,

    /// How the answer is written
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For people, with the networks drawn
    Text,
    /// One object
    Json,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let source = Source::read(&arguments.file, arguments.from.form())?;
    let source = arguments.plants.named_beside(source)?;
    let Some(program) = program(&source) else {
        return Ok(Outcome::Findings);
    };
    // No time passes.
    let options = Options {
        interval: 0,
        ..Options::default()
    };
    let simulation = Simulation::new(program, options).map_err(|error| Failure::new(error.message))?;
    let point = simulation.resolve(&arguments.tag);
    let point = point.map_err(|unknown| Failure::new(unknown.to_string()))?;
    let given = Given::read(&arguments.tags, &simulation)?;
    let mut moment = Moment::new(simulation, given.values.clone()).map_err(|faults| {
        let what = faults
            .first()
            .map_or_else(String::new, |fault| fault.message.clone());
        Failure::new(format!(
            "with these values the program does not come through a scan: {what}"
        ))
    })?;
    let judged = moment.why(&point);
    let is_sound = !contradicts(&judged)
        && judged.undecided().is_empty()
        && missing(&judged).is_empty()
        && given.constants.is_empty();
    let mut out = Stdout::new();
    match arguments.format {
        Format::Text => people(&source, &moment, &judged, &given, &mut out)?,
        Format::Json => {
            let program = moment.simulation().program();
            let members = source.members(&program.files);
            let unread = unread_writers(program, &judged);
            let answer = with_wording(&members, &program.files, |wording| {
                json::Answer::of(&judged, &given, unread, wording)
            });
            to_writer_pretty(&mut out, &answer)?;
            writeln!(out)?;
        }
    }
    out.flush()?;
    Ok(if is_sound {
        Outcome::Fine
    } else {
        Outcome::Findings
    })
}

/// The unread parts that may write the tag, or one that it was followed back to.
fn unread_writers(program: &Program, judged: &Judged) -> Vec<String> {
    let own = program.unread_writers(&judged.point.name);
    let mut names: Vec<String> = own.into_iter().map(str::to_owned).collect();
    for because in &judged.because {
        names.extend(unread_writers(program, because));
    }
    names.sort();
    names.dedup();
    names
}

/// Whether a value contradicts the program, of the tag or of one that it was followed back to.
fn contradicts(judged: &Judged) -> bool {
    judged.contradiction().is_some() || judged.because.iter().any(contradicts)
}

/// The names of the values that are needed and not there. What a given value came from is not needed.
fn missing(judged: &Judged) -> Vec<String> {
    let mut names = Vec::new();
    if !judged.is_given && judged.writers == 0 {
        names.push(judged.point.name.clone());
    }
    add_missing(judged, &mut names);
    names.sort();
    names.dedup();
    names
}

fn add_missing(judged: &Judged, names: &mut Vec<String>) {
    names.extend(judged.missing.iter().map(|point| point.name.clone()));
    let followed = judged.because.iter();
    for because in followed.filter(|because| judged.missing.contains(&because.point)) {
        add_missing(because, names);
    }
}

fn people(
    source: &Source,
    moment: &Moment,
    judged: &Judged,
    given: &Given,
    out: &mut Stdout,
) -> io::Result<()> {
    let program = moment.simulation().program();
    reasons(source, moment.simulation(), judged, out)?;
    let mut note = |what: &str, names: Vec<String>| -> io::Result<()> {
        if names.is_empty() {
            return Ok(());
        }
        writeln!(out, "\n{what}: {}", shown::line(&names.join(", ")))
    };
    let parts = unread_writers(program, judged);
    let parts = parts.iter().map(|name| format!("`{name}`")).collect();
    note("unread parts that may write what is seen here", parts)?;
    if contradicts(judged) {
        let why = "they were taken in mid-scan, something else writes the tag, or the controller runs another program";
        note("the values contradict the program", vec![why.to_owned()])?;
    }
    note(
        "needed, and not in the table (taken as they begin)",
        missing(judged),
    )?;
    note(
        "another value in the program, where these are constants",
        given.constants.clone(),
    )?;
    let unknown = given
        .unknown
        .iter()
        .map(|(line, name)| format!("{name} (line {line})"));
    note("in the table, and not in the program", unknown.collect())
}

/// A line for each tag, and the networks that write the first, with their power.
pub(crate) fn reasons(
    source: &Source,
    simulation: &Simulation,
    judged: &Judged,
    out: &mut Stdout,
) -> io::Result<()> {
    let program = simulation.program();
    let members = source.members(&program.files);
    let text = with_wording(&members, &program.files, |wording| wording.judged_text(judged));
    for line in text.lines() {
        writeln!(out, "{}", shown::line(line))?;
    }
    let mut drawn: Vec<usize> = judged.judgements.iter().map(|it| it.network).collect();
    drawn.dedup();
    for network in drawn {
        let location = program.networks[network].location;
        if location.file == 0 {
            let drawing = text::network(source, simulation, location.range);
            write!(out, "\n{}", shown::text(&drawing))?;
        }
    }
    Ok(())
}
