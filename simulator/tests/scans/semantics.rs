//! The programs of `tests/corpus/semantics` give the traces next to them.

use crate::support::{set, simulation_with};
use ladder_simulator::Options;
use ladder_simulator::value_text::{cell, milliseconds, parse};
use std::fs;
use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/corpus/semantics")
}

/// The names of a list: a comma within brackets parts nothing.
fn names(list: &str) -> Vec<&str> {
    let mut depth = 0;
    let split = list.split(|c| {
        match c {
            '[' => depth += 1,
            ']' => depth -= 1,
            _ => {}
        }
        c == ',' && depth == 0
    });
    split.collect()
}

fn run(name: &str) -> String {
    let file = |extension: &str| fs::read_to_string(folder().join(format!("{name}.{extension}")));
    let text = file("clad").unwrap();
    let arguments = file("args").unwrap();
    let inputs = file("in.csv").unwrap_or_default();
    let mut words = arguments.split_whitespace();
    let (mut scans, mut interval, mut watch) = (0, 10_000_000, "");
    while let (Some(option), Some(value)) = (words.next(), words.next()) {
        match option {
            "--scans" => scans = value.parse().unwrap(),
            "--dt" => match parse(value, ladder_analysis::values::types::Scalar::Time) {
                Ok(ladder_analysis::values::value::Value::Int(nanoseconds)) => interval = nanoseconds,
                other => panic!("{other:?}"),
            },
            "--watch" => watch = value,
            other => panic!("{name}: {other}"),
        }
    }
    let mut simulation = simulation_with(
        &text,
        Options {
            interval,
            ..Options::default()
        },
    );
    let watched = names(watch);
    let points: Vec<_> = watched
        .iter()
        .map(|tag| simulation.resolve(tag).unwrap())
        .collect();
    let mut rows = inputs.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let header = rows.next().unwrap_or_default();
    let quoted = watched.iter().map(|name| {
        if name.contains(',') {
            format!("\"{name}\"")
        } else {
            (*name).to_owned()
        }
    });
    let mut csv = format!("scan,time_ms,{}\n", quoted.collect::<Vec<_>>().join(","));
    for scan in 0..scans {
        for (tag, value) in header.iter().zip(rows.next().unwrap_or_default()) {
            if !value.is_empty() {
                set(&mut simulation, tag, value);
            }
        }
        assert!(simulation.scan(), "{name}: stopped in scan {scan}");
        let cells: Vec<String> = points
            .iter()
            .map(|point| cell(&simulation.value(point), point.ty))
            .collect();
        csv.push_str(&format!(
            "{scan},{},{}\n",
            milliseconds(scan * interval),
            cells.join(",")
        ));
    }
    csv
}

#[test]
fn traces_are_equal() {
    let mut names: Vec<String> = fs::read_dir(folder())
        .unwrap()
        .filter_map(|entry| {
            Some(
                entry
                    .unwrap()
                    .file_name()
                    .to_str()?
                    .strip_suffix(".clad")?
                    .to_owned(),
            )
        })
        .collect();
    names.sort();
    assert!(names.len() >= 56, "the corpus is not there");
    let mut wrong = String::new();
    for name in names {
        let expected = fs::read_to_string(folder().join(format!("{name}.expected.csv"))).unwrap();
        let Ok(found) = std::panic::catch_unwind(|| run(&name)) else {
            wrong.push_str(&format!("{name}: panicked"));
            continue;
        };
        if found != expected {
            wrong.push_str(&format!("{name}: expected\n{expected}found\n{found}\n"));
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}
