//! `ladder new`: a folder to begin in, from the files in `cli/template`.

use crate::outcome::{Failure, Outcome};
use crate::terminal;
use clap::Args;
use ladder_workspace::shown;
use std::fs;
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "\
Examples:
  ladder new press        make the folder `press`, with the program `press.clad`
  ladder new lines/press  the same in the folder `lines`
  ladder new .            in this folder, by its name

Exit status: 0 fine, 2 a file is there already, or one cannot be written.";

/// Make a folder with a program, its scenarios, and what checks them
///
/// The program runs and its scenarios pass as they are. With them come the settings in `ladder.toml`, a workflow for GitHub,
/// hooks for pre-commit, and settings for editors. Nothing that is there already is replaced.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The folder; its name is that of the program: letters, digits, `-` and `_`
    #[arg(value_name = "NAME")]
    folder: PathBuf,
}

/// The files, with the words that [`filled_in`] fills in, in their names too.
const TEMPLATE: [(&str, &str); 12] = [
    ("NAME.clad", include_str!("../../template/NAME.clad")),
    (
        "NAME.ladder-test",
        include_str!("../../template/NAME.ladder-test"),
    ),
    ("ladder.toml", include_str!("../../template/ladder.toml")),
    ("README.md", include_str!("../../template/README.md")),
    ("AGENTS.md", include_str!("../../template/AGENTS.md")),
    (
        ".github/workflows/ladder.yml",
        include_str!("../../template/.github/workflows/ladder.yml"),
    ),
    (
        ".pre-commit-config.yaml",
        include_str!("../../template/.pre-commit-config.yaml"),
    ),
    (".gitattributes", include_str!("../../template/.gitattributes")),
    (".gitignore", include_str!("../../template/.gitignore")),
    (".editorconfig", include_str!("../../template/.editorconfig")),
    (
        ".vscode/extensions.json",
        include_str!("../../template/.vscode/extensions.json"),
    ),
    (
        ".vscode/settings.json",
        include_str!("../../template/.vscode/settings.json"),
    ),
];

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let folder = &arguments.folder;
    let name = name_of(folder)?;
    let files: Vec<(PathBuf, String)> = TEMPLATE
        .iter()
        .map(|(file, text)| (folder.join(filled_in(file, &name)), filled_in(text, &name)))
        .collect();
    for (file, _) in &files {
        may_be_made(folder, file)?;
    }
    write(&files)?;
    terminal::plain(&format_args!(
        "made {}: a program, {name}.clad, its scenarios and what checks them. In that folder\n\n  \
         ladder test .\n  \
         ladder prove .\n  \
         ladder sim {name}.clad\n\n\
         run the scenarios, decide what must hold in every run, and run the program live on this terminal.",
        shown::path(folder)
    ));
    Ok(Outcome::Fine)
}

/// What the program is called: as the folder, also where that is written as `.`.
fn name_of(folder: &Path) -> Result<String, Failure> {
    let named = match folder.file_name() {
        Some(_) => folder.to_owned(),
        None => folder
            .canonicalize()
            .map_err(|error| Failure::new(format!("{}: {error}", shown::path(folder))))?,
    };
    let name = named
        .file_name()
        .and_then(|name| name.to_str())
        .unwrap_or_default();
    // It is written into programs, settings and workflows: what would mean something there is no part of it.
    let fits = |c: char| c.is_alphanumeric() || c == '-' || c == '_';
    if name.is_empty() || name.starts_with('-') || !name.chars().all(fits) {
        return Err(Failure::new(format!(
            "`{name}` cannot be the name of a program: it may have letters, digits, `-` and `_`, and does not begin with `-`"
        )));
    }
    Ok(name.to_owned())
}

fn filled_in(text: &str, name: &str) -> String {
    text.replace("NAME", name)
        .replace("VERSION", env!("CARGO_PKG_VERSION"))
}

/// A file that is not there, in folders that are not elsewhere.
fn may_be_made(folder: &Path, file: &Path) -> Result<(), Failure> {
    if file.symlink_metadata().is_ok() {
        return Err(Failure::new(format!(
            "{}: this is there already; nothing is replaced, and nothing was made",
            shown::path(file)
        )));
    }
    let inner = file.ancestors().skip(1).take_while(|&inner| inner != folder);
    for inner in inner {
        if inner.symlink_metadata().is_ok_and(|found| !found.is_dir()) {
            return Err(Failure::new(format!(
                "{}: this is no folder of its own; nothing was made",
                shown::path(inner)
            )));
        }
    }
    Ok(())
}

/// All of them or, where one fails, none.
fn write(files: &[(PathBuf, String)]) -> Result<(), Failure> {
    for (number, (file, text)) in files.iter().enumerate() {
        if let Err(failure) = write_one(file, text) {
            for (made, _) in &files[..number] {
                // What is left over then is not worse than the failure that is reported.
                let _ = fs::remove_file(made);
            }
            return Err(failure);
        }
    }
    Ok(())
}

fn write_one(file: &Path, text: &str) -> Result<(), Failure> {
    if let Some(folder) = file.parent() {
        fs::create_dir_all(folder)
            .map_err(|error| Failure::new(format!("{}: cannot be made: {error}", shown::path(folder))))?;
    }
    Ok(ladder_workspace::write_made(file, text.as_bytes())?)
}
