//! The files of others: what is read of each.

use crate::run::errors;
use ladder_format::Options;
use ladder_notation::{Converted, Outcome, ReadError, Source, convert};
use ladder_notation_logix::{L5x, Rslogix500};
use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

/// The files of others, if they are here.
fn corpus(folder: &str) -> Option<PathBuf> {
    let Some(root) = std::env::var_os("LADDER_CORPUS") else {
        eprintln!("skipped: LADDER_CORPUS does not say where the files of others are");
        return None;
    };
    Some(PathBuf::from(root).join(folder))
}

fn read(path: &std::path::Path) -> Result<Converted, ReadError> {
    let bytes = fs::read(path).expect("the file can be read");
    let stem = path.file_stem().expect("a name").to_string_lossy();
    convert(&L5x, &Source::alone(&stem, &bytes), &Options::default())
}

#[test]
#[ignore = "a look at all files"]
fn show() {
    let Some(folder) = corpus("rockwell") else { return };
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() { continue; }
        println!("===== {}", path.display());
        match read(&path) {
            Ok(converted) => {
                for entry in converted.report.entries.iter() {
                    match &entry.outcome {
                        Outcome::Translated => {}
                        other => println!("  {} {} {:?}", entry.place, entry.element, other),
                    }
                }
                println!("{:?}", converted.report.tally());
                for error in errors(&converted.written.text) { println!("  ERROR {error}"); }
                fs::write(format!("/tmp/lx/out/{}.clad", path.file_stem().unwrap().to_string_lossy()), &converted.written.text).unwrap();
            }
            Err(error) => println!("  {error}"),
        }
    }
    let Some(folder) = corpus("rslogix500") else { return };
    let bytes = fs::read(folder.join("public-rungs.txt")).unwrap();
    let converted = convert(&Rslogix500, &Source::alone("x", &bytes), &Options::default()).unwrap();
    for entry in converted.report.remarks() { println!("{entry:?}"); }
    println!("{}", converted.written.text);
    for error in errors(&converted.written.text) { println!("  ERROR {error}"); }
    let _: BTreeMap<u8, u8> = BTreeMap::new();
}
