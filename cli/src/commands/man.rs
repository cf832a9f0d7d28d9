//! `ladder man`: the manual pages, made from the same texts as the help.

use super::pages::{Described, Program};
use crate::outcome::{Failure, Outcome};
use crate::output::{Existing, may_write};
use crate::terminal::{self, Stdout};
use clap::{Args, Command};
use clap_mangen::Man;
use clap_mangen::roff::{Roff, bold, roman};
use ladder_workspace::shown;
use std::io::{self, Write};
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  ladder man | man -l -                    read the page of `ladder`
  ladder man sim | man -l -                read the page of `ladder sim`
  ladder man -o ~/.local/share/man/man1    install all pages: `man ladder-sim`

Exit status: 0 fine, 2 there is no such command, or a page cannot be written.";

/// Print a manual page, or write all of them into a folder
///
/// The pages are ladder(1), one for each command such as ladder-check(1), and ldfmt(1).
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The command whose page is printed, or `ldfmt`; without it that of `ladder`
    #[arg(conflicts_with = "output")]
    command: Option<String>,

    /// Write all pages into this folder, which is made if it is not there
    #[arg(short, long, value_name = "FOLDER")]
    output: Option<PathBuf>,

    /// Replace files of these names even if they are no manual pages of ladder
    #[arg(long, requires = "output")]
    force: bool,
}

pub(crate) fn run(arguments: &Arguments, described: Described) -> Result<Outcome, Failure> {
    let pages = pages(described);
    if let Some(folder) = &arguments.output {
        std::fs::create_dir_all(folder)
            .map_err(|error| Failure::new(format!("{}: cannot be made: {error}", shown::path(folder))))?;
        let file_of = |page| folder.join(format!("{}.1", name(page)));
        for page in &pages {
            may_write(&file_of(page), Existing::by(arguments.force))?;
        }
        for page in &pages {
            let file = file_of(page);
            ladder_workspace::write_made(&file, &text(page)?)?;
        }
        terminal::note(&format_args!(
            "{} pages are in {}",
            pages.len(),
            shown::path(folder)
        ));
        return Ok(Outcome::Fine);
    }
    let wanted = arguments.command.as_deref().unwrap_or("ladder");
    let found = pages.iter().find(|page| {
        let name = name(page);
        name == wanted || name.strip_prefix("ladder-") == Some(wanted)
    });
    let Some(page) = found else {
        return Err(Failure::new(format!(
            "there is no command `{wanted}`; `ladder help` lists the commands"
        )));
    };
    let mut out = Stdout::new();
    out.write_all(&text(page)?)?;
    out.flush()?;
    Ok(Outcome::Fine)
}

/// Each program and command that a person may look up.
fn pages(described: Described) -> Vec<Command> {
    let mut ladder = described(Program::Ladder).disable_help_subcommand(true);
    ladder.build();
    let commands: Vec<Command> = ladder.get_subcommands().cloned().collect();
    let mut ldfmt = described(Program::Ldfmt);
    ldfmt.build();
    [ladder].into_iter().chain(commands).chain([ldfmt]).collect()
}

/// `ladder-check`
fn name(page: &Command) -> String {
    page.get_display_name()
        .unwrap_or_else(|| page.get_name())
        .to_owned()
}

/// The page. What is below the help, examples and the exit status, are sections of their own, line by line.
fn text(page: &Command) -> io::Result<Vec<u8>> {
    let below = page.get_after_help().map(ToString::to_string).unwrap_or_default();
    let man = Man::new(page.clone())
        .title(name(page).to_uppercase())
        .source(concat!("ladder ", env!("CARGO_PKG_VERSION")))
        .manual("Ladder");
    let mut text = Vec::new();
    man.render_title(&mut text)?;
    man.render_name_section(&mut text)?;
    man.render_synopsis_section(&mut text)?;
    man.render_description_section(&mut text)?;
    if page.get_arguments().any(|argument| !argument.is_hide_set()) {
        man.render_options_section(&mut text)?;
    }
    if page.has_subcommands() {
        man.render_subcommands_section(&mut text)?;
    }
    sections(&below).to_writer(&mut text)?;
    let mut see = Roff::new();
    see.control("SH", ["SEE ALSO"]);
    let other = if name(page) == "ladder" { "ldfmt" } else { "ladder" };
    see.text([bold(other), roman("(1)")]);
    see.to_writer(&mut text)?;
    Ok(text)
}

/// Paragraphs as sections: the first words before a colon are the heading.
fn sections(below: &str) -> Roff {
    let mut roff = Roff::new();
    let mut open = false;
    for line in below.lines() {
        let heading = ["Examples:", "Exit status:"]
            .into_iter()
            .find_map(|heading| Some((heading, line.strip_prefix(heading)?)));
        if let Some((heading, after)) = heading {
            if open {
                roff.control("fi", []);
            }
            roff.control("SH", [heading.trim_end_matches(':').to_uppercase().as_str()]);
            // Examples are shown as they are typed; a sentence is filled.
            open = after.is_empty();
            if open {
                roff.control("nf", []);
            } else {
                roff.text([roman(after.trim())]);
            }
        } else if !line.is_empty() || !open {
            roff.text([roman(line)]);
        }
    }
    if open {
        roff.control("fi", []);
    }
    roff
}
