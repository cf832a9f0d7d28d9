//! Tells the programs what they are built from, for `--version`: the commit, if it is known, and the target.

use std::path::Path;
use std::process::Command;
use std::{env, fs};

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=LADDER_COMMIT");
    let target = env::var("TARGET").expect("set by Cargo");
    let given = env::var("LADDER_COMMIT").ok().filter(|commit| !commit.is_empty());
    let built_from = match given.or_else(packaged).or_else(checked_out) {
        Some(commit) => format!("{}, {target}", commit.get(..9).unwrap_or(&commit)),
        None => target,
    };
    println!("cargo::rustc-env=LADDER_BUILT_FROM={built_from}");
}

/// The commit that Cargo notes in a package for a registry.
fn packaged() -> Option<String> {
    let note = fs::read_to_string(".cargo_vcs_info.json").ok()?;
    let (_, after) = note.split_once("\"sha1\": \"")?;
    Some(after.split_once('"')?.0.to_owned())
}

/// The commit that git has checked out. A copy of this folder in a repository of another project is not of its commits.
fn checked_out() -> Option<String> {
    if git(&["rev-parse", "--show-prefix"])? != "cli/" {
        return None;
    }
    // Git adds a line to it whenever another commit is checked out or made.
    let log = git(&["rev-parse", "--git-path", "logs/HEAD"])?;
    if Path::new(&log).exists() {
        println!("cargo::rerun-if-changed={log}");
    }
    git(&["rev-parse", "HEAD"])
}

fn git(arguments: &[&str]) -> Option<String> {
    let output = Command::new("git").args(arguments).output().ok()?;
    let told = String::from_utf8(output.stdout).ok()?;
    output.status.success().then(|| told.trim().to_owned())
}
