//! What is written where, before anything is written.

use super::attributes::{was, was_line, with_block};
use crate::git::{command, output, told};
use crate::outcome::Failure;
use ladder_notations::{NOTATIONS, Notation};
use std::path::{Path, PathBuf};

/// What is to be done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Task {
    Install,
    Uninstall,
}

/// For what.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Scope {
    Repository,
    Global,
}

impl Scope {
    const fn option(self) -> &'static str {
        match self {
            Scope::Repository => "--local",
            Scope::Global => "--global",
        }
    }
}

/// The settings of git, by name.
const SETTINGS: [(&str, &str); 7] = [
    (
        "diff.ladder.xfuncname",
        "^(#.*|FUNCTION_BLOCK.*|.*<(FUN|LBL)>.*)$",
    ),
    ("diff.ladder.wordRegex", r"[][()<>+/\]|[^][()<>+/\ -]+"),
    ("diff.ladder-text.textconv", "ladder git show"),
    (
        "diff.ladder-text.xfuncname",
        "^(#.*|FUNCTION_BLOCK.*|.*<(FUN|LBL)>.*)$",
    ),
    (
        "difftool.ladder.cmd",
        "ladder diff \"$LOCAL\" \"$REMOTE\" ${MERGED:+--among=\"$MERGED\"}",
    ),
    (
        "merge.ladder.name",
        "networks and declarations of ladder programs",
    ),
    ("merge.ladder.driver", "ladder merge --path=%P %O %A %B"),
];

/// What is written.
pub(super) struct Plan {
    scope: Scope,
    attributes: PathBuf,
    /// What the file of attributes holds, and will hold.
    was: String,
    is: String,
    settings: Vec<Setting>,
}

struct Setting {
    name: &'static str,
    was: Option<String>,
    is: Option<String>,
}

impl Plan {
    /// Finds out what there is.
    ///
    /// # Errors
    /// There is no git, no repository, or a file that cannot be read.
    pub(super) fn new(task: Task, scope: Scope) -> Result<Plan, Failure> {
        let attributes = attributes_file(scope)?;
        let text = if attributes.exists() {
            ladder_workspace::read(&attributes)?
        } else {
            String::new()
        };
        // What was there before comes back: only the first installation sees it.
        let before = was(&text);
        let mut kept = Vec::new();
        let mut settings = Vec::new();
        for (name, value) in SETTINGS {
            let was = setting(scope, name)?;
            let former = match &before {
                Some(before) => before
                    .iter()
                    .find(|(of, _)| *of == name)
                    .map(|(_, was)| (*was).to_owned()),
                None if task == Task::Install => was.clone(),
                None => None,
            };
            kept.extend(former.as_deref().and_then(|former| was_line(name, former)));
            let is = match task {
                Task::Install => Some(value.to_owned()),
                // One that a person has set since then is not ours to take back.
                Task::Uninstall if was.as_deref() == Some(value) => former,
                Task::Uninstall => continue,
            };
            if was != is {
                settings.push(Setting { name, was, is });
            }
        }
        let lines = match task {
            Task::Install => [kept, attribute_lines()].concat(),
            Task::Uninstall => Vec::new(),
        };
        Ok(Plan {
            scope,
            is: with_block(&text, &lines),
            was: text,
            attributes,
            settings,
        })
    }

    /// Whether everything is so already.
    pub(super) fn is_done(&self) -> bool {
        self.was == self.is && self.settings.is_empty()
    }

    /// What is written, for people.
    pub(super) fn lines(&self) -> Vec<String> {
        let mut lines = Vec::new();
        if self.was != self.is {
            lines.push(format!("{}:", self.attributes.display()));
            let before: Vec<&str> = self.was.lines().collect();
            let after: Vec<&str> = self.is.lines().collect();
            let gone = before.iter().filter(|line| !after.contains(line));
            lines.extend(gone.map(|line| format!("  - {line}")));
            let new = after.iter().filter(|line| !before.contains(line));
            lines.extend(new.map(|line| format!("  + {line}")));
        }
        if !self.settings.is_empty() {
            lines.push(format!("git config {}:", self.scope.option()));
        }
        for setting in &self.settings {
            if let Some(was) = &setting.was {
                lines.push(format!("  - {} = {was}", setting.name));
            }
            if let Some(is) = &setting.is {
                lines.push(format!("  + {} = {is}", setting.name));
            }
        }
        lines
    }

    /// Writes it.
    ///
    /// # Errors
    /// A file cannot be written.
    pub(super) fn write(&self) -> Result<(), Failure> {
        for setting in &self.settings {
            let mut git = command(Path::new("."));
            git.args(["config", self.scope.option()]);
            match &setting.is {
                Some(value) => git.args(["--replace-all", setting.name, value]),
                None => git.args(["--unset-all", setting.name]),
            };
            let output = output(&mut git)?;
            if !output.status.success() {
                return Err(Failure::new(format!("{}: {}", setting.name, told(&output))));
            }
        }
        if self.was != self.is && self.is.is_empty() {
            return std::fs::remove_file(&self.attributes).map_err(|error| {
                Failure::new(format!(
                    "{}: it cannot be removed: {error}",
                    self.attributes.display()
                ))
            });
        }
        if self.was != self.is {
            if let Some(folder) = self.attributes.parent() {
                std::fs::create_dir_all(folder).map_err(|error| {
                    Failure::new(format!(
                        "{}: the folder cannot be made: {error}",
                        folder.display()
                    ))
                })?;
            }
            ladder_workspace::write(&self.attributes, self.is.as_bytes())?;
        }
        Ok(())
    }
}

/// Which files are compared and merged how.
fn attribute_lines() -> Vec<String> {
    let mut lines = vec!["*.clad diff=ladder merge=ladder".to_owned()];
    // Names that other files may have as well are left alone.
    let own = NOTATIONS.iter().filter(|it| it.is_read() && it.owns_extension());
    for extension in own.flat_map(|notation: &&dyn Notation| notation.extensions()) {
        let letters = extension.chars().map(|letter| match letter {
            letter if letter.is_ascii_alphabetic() => {
                format!("[{}{}]", letter.to_ascii_lowercase(), letter.to_ascii_uppercase())
            }
            letter => letter.to_string(),
        });
        lines.push(format!("*.{} diff=ladder-text", letters.collect::<String>()));
    }
    lines
}

/// The value of a setting, if it has one.
fn setting(scope: Scope, name: &str) -> Result<Option<String>, Failure> {
    let output = output(command(Path::new(".")).args(["config", scope.option(), "--get", name]))?;
    let value = String::from_utf8_lossy(&output.stdout);
    let value = value.strip_suffix('\n').unwrap_or(&value);
    Ok(output.status.success().then(|| value.to_owned()))
}

/// The file of attributes that belongs to nobody else: of a repository the one that is not committed.
fn attributes_file(scope: Scope) -> Result<PathBuf, Failure> {
    match scope {
        Scope::Repository => {
            let git = output(command(Path::new(".")).args(["rev-parse", "--git-path", "info/attributes"]))?;
            if !git.status.success() {
                return Err(Failure::new(told(&git)));
            }
            Ok(PathBuf::from(String::from_utf8_lossy(&git.stdout).trim_end()))
        }
        Scope::Global => {
            let named = [
                "config",
                "--global",
                "--type=path",
                "--get",
                "core.attributesFile",
            ];
            let git = output(command(Path::new(".")).args(named))?;
            let name = String::from_utf8_lossy(&git.stdout);
            if git.status.success() && !name.trim().is_empty() {
                return Ok(PathBuf::from(name.trim_end_matches(['\n', '\r'])));
            }
            let variable = |name: &str| std::env::var_os(name).filter(|value| !value.is_empty());
            let config = variable("XDG_CONFIG_HOME").map(PathBuf::from);
            let home = || variable("HOME").or_else(|| variable("USERPROFILE"));
            let config = config.or_else(|| home().map(|home| Path::new(&home).join(".config")));
            match config {
                Some(config) => Ok(config.join("git/attributes")),
                None => Err(Failure::new(
                    "it is not known where this user's settings are: HOME is not set",
                )),
            }
        }
    }
}
