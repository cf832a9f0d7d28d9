//! `ladder render`: the diagram as a picture.

mod raster;

use crate::findings::Source;
use crate::outcome::{Failure, Outcome};
use crate::run::{Run, Stimulus, place, program};
use crate::terminal::Stdout;
use clap::{Args, ValueEnum};
use ladder_analysis::types::Scalar;
use ladder_interchange::picture::{self, Options, Theme};
use ladder_simulator::{Simulation, value_text};
use std::io::{IsTerminal, Write};
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "\
Examples:
  ladder render motor.clad -o motor.svg            the diagram, in the reader's own light or dark colours
  ladder render motor.clad -o motor.png --scale 2  the same as pixels
  ladder render motor.clad --theme dark > motor.svg
  ladder render motor.clad -o motor.svg --scans 3 --set start=1
                                                   with the power and the values after three scans

Exit status: 0 fine, 1 the program has errors, 2 a file or an argument cannot be used.";

/// Draw a program as a picture
///
/// Networks are drawn with the symbols of IEC 61131-3. In an SVG file text stays text: it can be searched and
/// copied.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The program
    file: PathBuf,

    /// Write to this file instead of stdout; its name ends in .svg or .png
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// What is written; without it the file's name decides
    #[arg(long, value_enum)]
    format: Option<Format>,

    /// The colours
    #[arg(long, value_enum, default_value_t = Colours::Auto)]
    theme: Colours,

    /// Pixels of a PNG for each unit of the drawing
    #[arg(long, value_name = "FACTOR", default_value = "2", value_parser = scale)]
    scale: f32,

    /// Run so many scans first, and show the power and the values after the last
    #[arg(long, value_name = "N")]
    scans: Option<u64>,

    #[command(flatten)]
    stimulus: Stimulus,
}

/// What a picture is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// Lines and text
    Svg,
    /// Pixels
    Png,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Colours {
    /// As the reader's screen has it (a PNG: light)
    Auto,
    /// Dark on white
    Light,
    /// Light on black
    Dark,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let format = format(arguments)?;
    let text = ladder_workspace::read(&arguments.file)?;
    let source = Source::new(arguments.file.display().to_string(), text);
    let theme = match (arguments.theme, format) {
        (Colours::Auto, Format::Svg) => Theme::Auto,
        (Colours::Auto, Format::Png) | (Colours::Light, _) => Theme::Light,
        (Colours::Dark, _) => Theme::Dark,
    };
    let svg = match arguments.scans {
        None => picture::svg(
            &source.analyze().context,
            &Options {
                theme,
                ..Options::default()
            },
        ),
        Some(scans) => match running(arguments, &source, scans, theme)? {
            Some(svg) => svg,
            None => return Ok(Outcome::Findings),
        },
    };
    let bytes = match format {
        Format::Svg => svg.into_bytes(),
        Format::Png => raster::png(&svg, arguments.scale)
            .map_err(|problem| Failure::new(format!("{}: {problem}", source.file)))?,
    };
    match target(arguments) {
        Some(file) => ladder_workspace::write(file, &bytes)?,
        None => {
            let mut out = Stdout::new();
            out.write_all(&bytes)?;
            out.flush()?;
        }
    }
    Ok(Outcome::Fine)
}

/// The picture of the program after so many scans; none if it has errors, which stderr then shows.
fn running(
    arguments: &Arguments,
    source: &Source,
    scans: u64,
    theme: Theme,
) -> Result<Option<String>, Failure> {
    let options = arguments.stimulus.options(&arguments.file)?;
    let Some(program) = program(source) else {
        return Ok(None);
    };
    let mut simulation = Simulation::new(program, options)
        .map_err(|error| Failure::new(format!("{}: {}", place(source, error.location), error.message)))?;
    let inputs = arguments.stimulus.give(&mut simulation)?;
    let mut run = Run {
        simulation,
        inputs,
        source,
        scans,
        retention: None,
    };
    while run.scan() {}
    let simulation = &run.simulation;
    let power = simulation
        .power()
        .filter(|(_, location, _)| location.file == 0)
        .map(|(_, location, on)| (location.range, on))
        .collect();
    let value = |operand: &str| value_of(simulation, operand);
    let options = Options {
        theme,
        power: Some(power),
        value: Some(&value),
    };
    Ok(Some(picture::svg(&source.analyze().context, &options)))
}

/// The value of an operand that is worth showing: how far a timer or counter is, or a number. That of a BOOL is
/// seen by its power, that of a literal by itself.
fn value_of(simulation: &Simulation, operand: &str) -> Option<String> {
    if operand.starts_with(|first: char| first.is_ascii_digit() || matches!(first, '-' | '\'')) {
        return None;
    }
    let point = ["", ".ET", ".CV"]
        .iter()
        .find_map(|member| simulation.resolve(&format!("{operand}{member}")).ok())?;
    (point.ty != Scalar::Bool).then(|| value_text::display(&simulation.value(&point), point.ty))
}

/// The file to write; none for stdout.
fn target(arguments: &Arguments) -> Option<&Path> {
    arguments.output.as_deref().filter(|file| *file != Path::new("-"))
}

fn format(arguments: &Arguments) -> Result<Format, Failure> {
    let format = match (arguments.format, target(arguments)) {
        (Some(format), _) => format,
        (None, None) => Format::Svg,
        (None, Some(file)) => by_name(file)?,
    };
    if format == Format::Png && target(arguments).is_none() && std::io::stdout().is_terminal() {
        return Err(Failure::new(
            "a PNG is not for a terminal; name a file with -o, for example -o motor.png",
        ));
    }
    Ok(format)
}

fn by_name(file: &Path) -> Result<Format, Failure> {
    let ending = file
        .extension()
        .map(|ending| ending.to_string_lossy().to_lowercase());
    match ending.as_deref() {
        Some("svg") => Ok(Format::Svg),
        Some("png") => Ok(Format::Png),
        _ => Err(Failure::new(format!(
            "{}: the name does not say which picture it is; end it in .svg or .png, or add --format",
            file.display()
        ))),
    }
}

fn scale(text: &str) -> Result<f32, String> {
    let scale: f32 = text
        .parse()
        .map_err(|_| "write a number, for example 2".to_owned())?;
    if (0.1..=10.0).contains(&scale) {
        Ok(scale)
    } else {
        Err("it must lie between 0.1 and 10".to_owned())
    }
}
