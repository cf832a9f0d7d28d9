//! `ladder sim`: runs a program.

mod trace;

#[cfg(not(feature = "screen"))]
use crate::features::Feature;
use crate::findings::{Source, with_line_feeds};
use crate::form::Notation;
use crate::outcome::{Failure, Outcome};
use crate::output::{DRAWN_BY, Output};
use crate::run::{
    KeptIn, Plants, Retention, Run, Stimulus, note_undriven, number_of_scans, program, simulation,
};
#[cfg(feature = "screen")]
use crate::screen;
use crate::terminal;
use clap::{Args, ValueEnum};
use ladder_analysis::program::{Argument, Place, Program, TagId};
use ladder_simulator::{Point, Simulation, diagram, diagram_of};
use ladder_workspace::shown;
use std::collections::HashSet;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  ladder sim motor.clad               the diagram, live, on this terminal
  ladder sim motor.clad --scans 100   100 scans, all tags as CSV
  ladder sim motor.clad --scans 100 --set start=1
                                      `start` is high from the first scan on
  ladder sim motor.clad --scans 3 --set start=1 --format diagram
                                      the program with its power after 3 scans
  ladder sim motor.clad --scans 50 --inputs in.csv --watch run,warmup.ET
                                      these two tags; the inputs from a file
  ladder sim motor.clad --scans 90 --inputs in.csv --format svg -o motor.svg
                                      a timing diagram
  ladder sim pump.ld --scans 100      a program of another system, as it is
  ladder sim pump.clad --plant tank.clad
                                      the program beside a model of its machine

A row of the file for --inputs is given to the program before one scan; its header names the tags:

  start,stop
  1,0
  0,
  ,1

An empty cell leaves the tag as it is.

Exit status: 0 fine, 1 the program has errors, 2 a file or an argument cannot be used.";

/// Run a program in the simulator
///
/// On a terminal, `ladder sim FILE` shows the diagram itself, live, with its inputs to switch; `?` lists the keys.
///
/// With --scans it runs a number of scans and writes what the tags held after each. Scans count from 0. The same program, inputs
/// and interval give the same result on every machine.
///
/// This is a simulator, not a safety device.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The program
    file: PathBuf,

    #[command(flatten)]
    from: Notation,

    /// How many scans to run; without it, on a terminal, the program is shown running
    #[arg(long, value_name = "N", value_parser = number_of_scans, allow_negative_numbers = true)]
    scans: Option<u64>,

    #[command(flatten)]
    plants: Plants,

    #[command(flatten)]
    stimulus: Stimulus,

    /// Keep retentive tags in this file: what it holds is there before the first scan, and it is written at the end
    #[arg(long, value_name = "FILE")]
    retain: Option<PathBuf>,

    /// The tags to write, in this order; an array stands for its elements, `a[2..5]` for some of them.
    /// A structure stands for its members. Without it every elementary part of every tag, sorted by name, but not constants, the
    /// insides of blocks' states, and arrays of more than 64 elements
    #[arg(long, value_name = "TAG,...")]
    watch: Vec<String>,

    /// What is written
    #[arg(long, value_enum, default_value_t = Format::Csv)]
    format: Format,

    /// Write to this file instead of stdout; `-` is stdout. A program, or a file that this command did not make, is
    /// replaced only with --force
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// What a run writes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// A row of values for each scan
    Csv,
    /// One object: the tags with their types, and the values of each scan
    Json,
    /// A value change dump, for waveform viewers such as GTKWave
    Vcd,
    /// A timing diagram as a picture
    Svg,
    /// The program with its power after the last scan; `=` is a live wire
    Diagram,
}

impl Arguments {
    /// Nothing is asked for that only a batch can do.
    fn asks_for_the_screen(&self) -> bool {
        self.scans.is_none() && self.output.is_none() && self.format == Format::Csv
    }
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    if ladder_workspace::is_scenario(&arguments.file) {
        let file = arguments.file.display();
        return Err(Failure::new(format!(
            "{file}: this file has scenarios, no program; `ladder test {file}` runs them"
        )));
    }
    let from = arguments.from.form();
    let watch = names_in(&arguments.watch);
    if arguments.asks_for_the_screen() && terminal::is_interactive() {
        #[cfg(not(feature = "screen"))]
        return Err(Feature::Screen.left_out());
        #[cfg(feature = "screen")]
        return screen::run(&screen::Request {
            file: &arguments.file,
            from,
            plants: &arguments.plants,
            stimulus: &arguments.stimulus,
            retain: arguments.retain.as_deref(),
            watch: &watch,
        });
    }
    let source = arguments.plants.beside(Source::read(&arguments.file, from)?)?;
    let scans = arguments.scans.ok_or_else(|| {
        Failure::new("say how many scans to run, for example --scans 100; `ladder sim --help` shows more")
    })?;
    let Some(program) = program(&source) else {
        return Ok(Outcome::Findings);
    };
    let options = arguments.stimulus.options(&arguments.file, &program)?;
    let mut simulation = simulation(&source, program, options)?;

    // All that can be wrong with the arguments is found before anything is written.
    let watched = watched(&simulation, &watch, &source)?;
    let retention = match &arguments.retain {
        Some(file) => Some(Retention::begin(
            KeptIn::File(file),
            &arguments.file,
            &mut simulation,
        )?),
        None => None,
    };
    let inputs = arguments.stimulus.give(&mut simulation)?;
    note_undriven(&simulation, &inputs, &arguments.stimulus);

    let mut out = Output::open(arguments.output.as_deref(), arguments.stimulus.existing())?;
    let mut run = Run {
        simulation,
        inputs,
        source: &source,
        scans,
        retention,
    };
    match arguments.format {
        Format::Csv => trace::write(trace::Format::Csv, &mut run, &watched, &mut out)?,
        Format::Json => trace::write(trace::Format::Json, &mut run, &watched, &mut out)?,
        Format::Vcd => trace::write(trace::Format::Vcd, &mut run, &watched, &mut out)?,
        Format::Svg => trace::write(trace::Format::Svg, &mut run, &watched, &mut out)?,
        Format::Diagram => {
            while run.scan() {}
            diagrams(&source, &run.simulation, &mut out)?;
            if out.is_file() {
                out.write_text(&format!("\n{DRAWN_BY} #\n"))?;
            }
        }
    }
    out.finish()?;
    run.finish()?;
    Ok(run.outcome())
}

/// The program with its power, and below it the other files that it uses, each under its name.
fn diagrams(source: &Source, simulation: &Simulation, out: &mut Output) -> Result<(), Failure> {
    out.write_text(&with_line_feeds(&diagram(&source.text, simulation)))?;
    let program = simulation.program();
    for (index, name) in program.files.iter().enumerate().skip(1) {
        let file = index as u32;
        let runs = program
            .networks
            .iter()
            .any(|network| network.location.file == file);
        let Some(other) = source.other(name).filter(|_| runs) else {
            continue;
        };
        let drawn = diagram_of(file, &other.text, simulation);
        out.write_text(&format!(
            "\n# {} #\n\n{}",
            shown::line(name),
            with_line_feeds(&drawn)
        ))?;
    }
    Ok(())
}

/// The names in some lists: a comma in brackets parts none.
fn names_in(lists: &[String]) -> Vec<String> {
    let mut names = Vec::new();
    for list in lists {
        let (mut open, mut start) = (0u32, 0);
        for (at, byte) in list.bytes().enumerate() {
            match byte {
                b'[' => open += 1,
                b']' => open = open.saturating_sub(1),
                b',' if open == 0 => {
                    names.push(list[start..at].to_owned());
                    start = at + 1;
                }
                _ => {}
            }
        }
        names.push(list[start..].to_owned());
    }
    names
}

/// The tags to write: those asked for, by the names they were asked for with, or every elementary part of every tag of the
/// program but constants, sorted by name. Where a run is about the coils, only the tags that blocks write.
fn watched(
    simulation: &Simulation,
    names: &[String],
    source: &Source,
) -> Result<Vec<(String, Point)>, Failure> {
    if names.iter().any(|name| name.trim().is_empty()) {
        return Err(Failure::new(
            "--watch: a name is missing; write the tags as in --watch run,warmup.ET",
        ));
    }
    if !names.is_empty() {
        let mut watched = Vec::new();
        for name in names {
            match simulation.resolve_all(name).as_deref() {
                Ok([point]) if !opens(name, point) => watched.push((name.trim().to_owned(), point.clone())),
                Ok(points) => watched.extend(points.iter().map(|point| (point.name.clone(), point.clone()))),
                Err(unknown) => return Err(Failure::new(format!("--watch {name}: {unknown}"))),
            }
        }
        return Ok(watched);
    }
    let program = simulation.program();
    let written = source
        .foreign()
        .filter(|foreign| foreign.shows_coils())
        .map(|_| written_tags(program));
    let own = (0..).map(TagId).zip(&program.tags);
    let own = own.filter(|(_, tag)| tag.block.is_none());
    let own = own.map(|(id, tag)| (id, tag.name.as_str()));
    let others = program.other_names.iter().filter(|other| other.block.is_none());
    let others = others.map(|other| (other.tag, other.name.as_str()));
    let shown = own
        .chain(others)
        .filter(|(id, _)| written.as_ref().is_none_or(|written| written.contains(id)));
    let mut watched: Vec<(String, Point)> = shown
        .flat_map(|(id, name)| {
            let points = simulation.in_table(id).into_iter();
            points.map(move |point| (called(name, &program.tags[id.0 as usize].name, &point), point))
        })
        .collect();
    watched.sort_by_cached_key(|(name, _)| in_order(name));
    // A tag is shadowed by one of the same name before it.
    watched.dedup_by(|(name, _), (before, _)| name.eq_ignore_ascii_case(before));
    Ok(watched)
}

/// A path so that it comes after what it begins with, and elements come by their numbers.
fn in_order(path: &str) -> Vec<(String, i64)> {
    let path = ladder_syntax::Name::new(path);
    let mut is_index = false;
    let mut steps = Vec::new();
    for step in path.as_str().split_inclusive(['.', '[', ',', ']']) {
        let text = step.trim().trim_end_matches(['.', '[', ',', ']']);
        match text.parse() {
            Ok(number) if is_index => steps.push((String::new(), number)),
            _ if text.is_empty() => {}
            _ => steps.push((text.to_owned(), 0)),
        }
        is_index = step.ends_with(['[', ',']);
    }
    steps
}

/// Whether a name stands for what a tag opens into, of which there is only one.
fn opens(name: &str, point: &Point) -> bool {
    name.contains("..") || (point.name.contains(['[', '.']) && !name.contains(['[', '.']))
}

/// What a tag, or a part of it, is called where the tag goes by this name.
fn called(name: &str, own: &str, point: &Point) -> String {
    match point.name.strip_prefix(own) {
        Some(rest) => format!("{name}{rest}"),
        None => point.name.clone(),
    }
}

/// The tags that a block writes as a whole.
fn written_tags(program: &Program) -> HashSet<TagId> {
    let blocks = program.networks.iter().flat_map(|network| &network.blocks);
    let arguments = blocks.flat_map(|block| &block.arguments);
    arguments
        .filter_map(|bound| match &bound.argument {
            Argument::Place(Place::Tag(id), _) => Some(*id),
            _ => None,
        })
        .collect()
}
