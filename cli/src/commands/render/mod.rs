//! `ladder render`: the diagram as a picture.

#[cfg(feature = "pdf")]
mod pdf;
#[cfg(feature = "png")]
mod raster;
pub(crate) mod scene;
pub(crate) mod text;
#[cfg(feature = "pdf")]
mod title_block;

#[cfg(not(all(feature = "pdf", feature = "png")))]
use crate::features::Feature;
use crate::findings::Source;
use crate::form::Notation;
use crate::outcome::{Failure, Outcome};
use crate::output::{DRAWN_BY, may_write};
use crate::run::{Run, Stimulus, number_of_scans, program, show_errors};
use crate::terminal::{self, Stdout};
use clap::{Args, ValueEnum};
use ladder_analysis::values::types::Scalar;
use ladder_picture::letters::Style;
#[cfg(feature = "pdf")]
use ladder_picture::sheet;
use ladder_picture::{Options, Picture, Theme};
use ladder_simulator::{Simulation, value_text};
use ladder_workspace::shown;
use std::io::{IsTerminal, Write};
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "\
Examples:
  ladder render motor.clad -o motor.svg            light or dark, as one reads
  ladder render motor.clad -o motor.png --scale 2  the same as pixels
  ladder render motor.clad -o motor.pdf            pages, with a table of tags
  ladder render motor.clad -o motor.pdf --paper letter --landscape --title Pumps
  ladder render motor.clad --theme dark > motor.svg
  ladder render motor.clad --format text           with characters
  ladder render motor.clad --format text --style ascii
                                                   with those of ASCII alone
  ladder render motor.clad -o motor.svg --scans 3 --set start=1
                                                   with power, after 3 scans
  ladder render tank.scene.svg --tags values.csv -o tank.svg
                                                   the machine with these values

Exit status: 0 fine, 1 the program has errors (it is drawn as far as it goes, but not run) or a fault stopped it,
2 a file or an argument cannot be used.";

/// Draw a program as a picture
///
/// Networks are drawn with the symbols of IEC 61131-3. In SVG and PDF files text stays text: it can be searched and
/// copied. A PDF has the declarations as a table and numbered networks, its pages break between networks, and a title
/// block names the project and its version from ladder.toml, the file, and the day of its last change.
///
/// A scene (NAME.scene.svg) is drawn as it is with the values of its program: at the start, after --scans, or those of --tags.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The program, or a scene
    file: PathBuf,

    /// Write to this file instead of stdout; its name ends in .svg, .png, .pdf or .txt. A program, or a file that this command
    /// did not make, is replaced only with --force
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    #[command(flatten)]
    from: Notation,

    /// What is written; without it the file's name decides
    #[arg(long, value_enum)]
    format: Option<Format>,

    /// The characters that a text is drawn with [default: unicode]
    #[arg(long, value_enum)]
    style: Option<Characters>,

    /// The colours
    #[arg(long, value_enum, default_value_t = Colours::Auto)]
    theme: Colours,

    /// Pixels of a PNG for each unit of the drawing [default: 2]
    #[arg(long, value_name = "FACTOR", value_parser = scale)]
    scale: Option<f32>,

    /// The paper of a PDF [default: a4]
    #[arg(long, value_enum)]
    paper: Option<Paper>,

    /// Turn the pages of a PDF: wider than high
    #[arg(long)]
    landscape: bool,

    /// What is at the head of each page of a PDF [default: the program's name]
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,

    /// Run this many scans first, and show the power and the values after the last
    #[arg(long, value_name = "N", value_parser = number_of_scans, allow_negative_numbers = true)]
    scans: Option<u64>,

    /// Of a scene: a table with the values of tags, a name and a value in each line
    #[arg(long, value_name = "FILE")]
    tags: Option<PathBuf>,

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
    /// Pages for a printer
    Pdf,
    /// Characters, for a terminal or a comment
    Text,
}

/// What a drawing with characters is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Characters {
    /// Box-drawing characters
    Unicode,
    /// - | + ( ), and = for a wire with power: for where nothing else is shown
    Ascii,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Paper {
    /// 210 mm by 297 mm
    A4,
    /// 8.5 by 11 inches
    Letter,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Colours {
    /// As the reader's screen has it (a PNG or PDF: light)
    Auto,
    /// Dark on white
    Light,
    /// Light on black
    Dark,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let format = format(arguments)?;
    check(arguments, format)?;
    if let Some(file) = target(arguments) {
        may_write(file, arguments.stimulus.existing())?;
    }
    if ladder_workspace::is_scene(&arguments.file) {
        return scene::run(arguments, format);
    }
    let source = Source::read(&arguments.file, arguments.from.form())?;
    let theme = match (arguments.theme, format) {
        (Colours::Auto, Format::Svg) => Theme::Auto,
        (Colours::Auto, Format::Png | Format::Pdf | Format::Text) | (Colours::Light, _) => Theme::Light,
        (Colours::Dark, _) => Theme::Dark,
    };
    if format == Format::Text {
        return characters(arguments, &source);
    }
    let (picture, outcome) = match arguments.scans {
        None => at_rest(arguments, &source),
        Some(scans) => match running(arguments, &source, scans)? {
            Some(drawn) => drawn,
            None => return Ok(Outcome::Findings),
        },
    };
    let bytes = match format {
        Format::Svg => ladder_picture::svg(&picture, theme).into_bytes(),
        #[cfg(not(feature = "png"))]
        Format::Png => return Err(Feature::Png.left_out()),
        #[cfg(feature = "png")]
        Format::Png => raster::png(
            &ladder_picture::svg(&picture, theme),
            arguments.scale.unwrap_or(2.0),
        )
        .map_err(|problem| Failure::new(format!("{}: {problem}", shown::line(&source.file))))?,
        Format::Pdf => pages(arguments, &source, &picture, theme)?,
        Format::Text => Vec::new(),
    };
    write(arguments, format, &bytes)?;
    Ok(outcome)
}

/// The diagram drawn with characters, at rest or after this many scans.
fn characters(arguments: &Arguments, source: &Source) -> Result<Outcome, Failure> {
    let style = match arguments.style {
        None | Some(Characters::Unicode) => Style::Unicode,
        Some(Characters::Ascii) => Style::Ascii,
    };
    let (drawn, outcome) = match arguments.scans {
        None => (text::drawn(source, None, style), rest(source)),
        Some(scans) => match simulated(arguments, source, scans)? {
            Some(run) => (text::drawn(source, Some(&run.simulation), style), run.outcome()),
            None => return Ok(Outcome::Findings),
        },
    };
    write(arguments, Format::Text, drawn.as_bytes())?;
    Ok(outcome)
}

fn write(arguments: &Arguments, format: Format, bytes: &[u8]) -> Result<(), Failure> {
    match target(arguments) {
        // So that it is known for what it is when it is drawn again.
        Some(file) if format == Format::Text => {
            let signed = [bytes, b"\n", DRAWN_BY.as_bytes(), b" #\n"].concat();
            ladder_workspace::write_made(file, &signed)?;
        }
        Some(file) => ladder_workspace::write_made(file, bytes)?,
        None => {
            let mut out = Stdout::new();
            match format {
                Format::Svg | Format::Text => {
                    out.write_all(shown::text(&String::from_utf8_lossy(bytes)).as_bytes())?;
                }
                Format::Png | Format::Pdf => out.write_all(bytes)?,
            }
            out.flush()?;
        }
    }
    Ok(())
}

/// Refuses what has no effect on the picture that is asked for: it was meant to have one.
fn check(arguments: &Arguments, format: Format) -> Result<(), Failure> {
    if arguments.scale.is_some() && format != Format::Png {
        return Err(Failure::new(
            "--scale is about the pixels of a PNG; other pictures are as large as they are shown",
        ));
    }
    let pages = arguments.paper.is_some() || arguments.landscape || arguments.title.is_some();
    if pages && format != Format::Pdf {
        return Err(Failure::new(
            "--paper, --landscape and --title are about the pages of a PDF; end the file's name in .pdf",
        ));
    }
    if arguments.style.is_some() && format != Format::Text {
        return Err(Failure::new(
            "--style is about a drawing with characters; add --format text, or end the file's name in .txt",
        ));
    }
    if arguments.tags.is_some() && !ladder_workspace::is_scene(&arguments.file) {
        return Err(Failure::new(
            "--tags is about a scene, a drawing of the machine: NAME.scene.svg; `ladder why` reads a table for a program",
        ));
    }
    if arguments.scans.is_none() && arguments.stimulus.is_given() {
        return Err(Failure::new(
            "--dt, --inputs, --set and --force are about a run; add the number of scans, for example --scans 1",
        ));
    }
    Ok(())
}

/// Where the right rail of networks is that take the whole width of a page; none where there are no pages.
#[cfg(feature = "pdf")]
fn rail(arguments: &Arguments) -> Option<u32> {
    matches!(format(arguments), Ok(Format::Pdf)).then(|| paper(arguments).rail())
}

#[cfg(not(feature = "pdf"))]
fn rail(_: &Arguments) -> Option<u32> {
    None
}

/// The pages that are asked for, with nothing on them yet.
#[cfg(feature = "pdf")]
fn paper(arguments: &Arguments) -> sheet::Options<'static> {
    sheet::Options {
        size: match arguments.paper {
            None | Some(Paper::A4) => sheet::Size::A4,
            Some(Paper::Letter) => sheet::Size::Letter,
        },
        orientation: if arguments.landscape {
            sheet::Orientation::Landscape
        } else {
            sheet::Orientation::Portrait
        },
        title: "",
        note: "",
        block: &[],
    }
}

/// The picture as pages of a PDF.
#[cfg(feature = "pdf")]
fn pages(
    arguments: &Arguments,
    source: &Source,
    picture: &Picture,
    theme: Theme,
) -> Result<Vec<u8>, Failure> {
    let stem = arguments.file.file_stem().map(|stem| stem.to_string_lossy());
    let title = match (&arguments.title, &stem) {
        (Some(title), _) => title,
        (None, Some(stem)) => &**stem,
        (None, None) => "",
    };
    let note = match arguments.scans {
        None => String::new(),
        Some(1) => "after 1 scan".to_owned(),
        Some(scans) => format!("after {scans} scans"),
    };
    let block = title_block::title_block(&arguments.file)?;
    let options = sheet::Options {
        title,
        note: &note,
        block: &block,
        ..paper(arguments)
    };
    let sheets = sheet::sheets(&source.analyze().context, picture, &options);
    let document = pdf::document(&sheets, title, theme)
        .map_err(|problem| Failure::new(format!("{}: {problem}", source.file)))?;
    if !document.missing.is_empty() {
        let letters: String = document
            .missing
            .iter()
            .take(20)
            .filter(|c| !c.is_control())
            .collect();
        terminal::warning(&format_args!(
            "{}: the built-in font has no letters for {letters}: a PDF shows a mark in their place, an SVG \
             has them from its reader's fonts",
            source.file
        ));
    }
    Ok(document.bytes)
}

#[cfg(not(feature = "pdf"))]
fn pages(_: &Arguments, _: &Source, _: &Picture, _: Theme) -> Result<Vec<u8>, Failure> {
    Err(Feature::Pdf.left_out())
}

/// The picture of the program as it is written. One with errors is drawn as well, and stderr shows them.
fn at_rest(arguments: &Arguments, source: &Source) -> (Picture, Outcome) {
    let options = Options {
        rail: rail(arguments),
        ..Options::default()
    };
    let picture = ladder_picture::picture(&source.analyze().context, &options);
    (picture, rest(source))
}

/// What is reported about a program that is drawn without being run.
fn rest(source: &Source) -> Outcome {
    if !source.has_errors() {
        return Outcome::Fine;
    }
    show_errors(source);
    terminal::error(&format_args!(
        "{}: drawn as far as it goes; the program has errors",
        shown::line(&source.file)
    ));
    Outcome::Findings
}

/// The program after this many scans; none if it has errors, which stderr then shows.
fn simulated<'s>(arguments: &Arguments, source: &'s Source, scans: u64) -> Result<Option<Run<'s>>, Failure> {
    let Some(program) = program(source) else {
        return Ok(None);
    };
    let run = Run::whole(&arguments.stimulus, &arguments.file, (source, program), scans)?;
    Ok(Some(run))
}

/// The picture of the program after this many scans; none if it has errors.
fn running(
    arguments: &Arguments,
    source: &Source,
    scans: u64,
) -> Result<Option<(Picture, Outcome)>, Failure> {
    let Some(run) = simulated(arguments, source, scans)? else {
        return Ok(None);
    };
    let simulation = &run.simulation;
    let power = simulation
        .power()
        .filter(|(_, location, _)| location.file == 0)
        .map(|(_, location, on)| (location.range, on))
        .collect();
    let value = |operand: &str| value_of(simulation, operand);
    let options = Options {
        power: Some(power),
        value: Some(&value),
        rail: rail(arguments),
        ..Options::default()
    };
    let picture = ladder_picture::picture(&source.analyze().context, &options);
    Ok(Some((picture, run.outcome())))
}

/// The value of an operand: of a timer or counter how far it is, of a BOOL 0 or 1. That of a literal is seen by itself.
fn value_of(simulation: &Simulation, operand: &str) -> Option<String> {
    if operand.starts_with(|first: char| first.is_ascii_digit() || matches!(first, '-' | '\'')) {
        return None;
    }
    let point = ["", ".ET", ".CV"]
        .iter()
        .find_map(|member| simulation.resolve(&format!("{operand}{member}")).ok())?;
    let value = simulation.value(&point);
    Some(match point.ty {
        Scalar::Bool => value_text::cell(&value, point.ty),
        _ => value_text::display(&value, point.ty),
    })
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
    let not_text = match format {
        Format::Svg | Format::Text => None,
        Format::Png => Some("a PNG is not for a terminal; name a file with -o, for example -o motor.png"),
        Format::Pdf => Some("a PDF is not for a terminal; name a file with -o, for example -o motor.pdf"),
    };
    if let Some(why) = not_text
        && target(arguments).is_none()
        && std::io::stdout().is_terminal()
    {
        return Err(Failure::new(why));
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
        Some("pdf") => Ok(Format::Pdf),
        Some("txt") => Ok(Format::Text),
        _ => Err(Failure::new(format!(
            "{}: the name does not say which picture it is; end it in .svg, .png, .pdf or .txt, or add --format",
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
