//! The blocks of the library: each does what its scenarios say, and has its place in the book.

mod elsewhere;
mod page;
mod pid;
mod use_of_blocks;

use crate::tested::Tested;
use expect_test::expect_file;
use ladder_analysis::library::{SOURCES, Use};
use ladder_analysis::{analyze, written::user_block::Parameter};
use ladder_format::{Options, format_text};
use ladder_simulator::coverage::Coverage;
use ladder_simulator::scenario;
use ladder_syntax::parse;
use ladder_tests::project;
use page::parameters;
use std::path::{Path, PathBuf};
use std::sync::Arc;

#[test]
fn every_file_is_a_block() {
    let folder = project::root().join("library");
    let stems = |folder: &Path, extension: &str| -> Vec<String> {
        let files = project::files(folder, extension);
        let here = files.iter().filter(|file| file.parent() == Some(folder));
        here.map(|file| file.file_stem().expect("a name").to_string_lossy().into_owned())
            .collect()
    };
    let of = |wanted: Use| SOURCES.iter().filter(move |source| source.is_for == wanted);
    let names = |wanted: Use| of(wanted).map(|source| &source.name[1..]).collect::<Vec<_>>();
    assert_eq!(stems(&folder, "clad"), names(Use::Programs));
    assert_eq!(stems(&folder.join("plants"), "clad"), names(Use::Plants));
    let mut all = [names(Use::Programs), names(Use::Plants)].concat();
    all.sort_unstable();
    assert_eq!(stems(&folder.join("scenarios"), "clad"), all);
    assert_eq!(stems(&folder.join("scenarios"), "ladder-test"), all);
}

#[test]
fn nothing_is_found_in_them_and_they_stand_in_the_canonical_layout() {
    for source in SOURCES {
        for text in [source.text, source.example] {
            let findings = analyze(&Arc::new(parse(text)), source.name)
                .diagnostics()
                .to_vec();
            assert!(findings.is_empty(), "{}: {findings:#?}", source.name);
            assert_eq!(format_text(text, &Options::default()), text, "{}", source.name);
        }
        let file = project::root().join(format!("library/scenarios/{}.ladder-test", &source.name[1..]));
        expect_file![file].assert_eq(&scenario::layout(source.scenarios));
    }
}

/// The definition is above the example here, so that what the scenarios reach in it is seen.
#[test]
fn their_scenarios_pass_and_reach_all_of_them() {
    let mut problems = Vec::new();
    for source in SOURCES {
        let name = PathBuf::from(source.name);
        let text = format!("{}\n{}", source.text, source.example);
        let mut tested = Tested::of(name.clone(), scenario::parse(source.scenarios), name, &text);
        let mut coverage = Coverage::of(&mut tested.simulation);
        let passed = tested.passed_by(&mut problems, |simulation| coverage.scan(simulation));
        coverage.finish(&tested.simulation);
        assert!(
            passed.len() >= 3,
            "{} has {} scenarios",
            source.name,
            passed.len()
        );
        let networks = coverage.networks.iter().filter(|network| network.scans == 0);
        let parts = coverage.parts.iter().filter(|part| !(part.on && part.off));
        let unseen = networks
            .map(|network| network.location)
            .chain(parts.map(|part| part.location));
        // What is in other blocks of the library their own scenarios reach.
        for location in unseen.filter(|location| location.file == 0) {
            let part = &text[std::ops::Range::<usize>::from(location.range)];
            problems.push(format!("{}: never exercised: {part}", source.name));
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n\n"));
}

/// The book, hovers and completion read what the comments say.
#[test]
fn everything_is_described() {
    for source in SOURCES {
        let analysis = analyze(&Arc::new(parse(source.text)), source.name);
        let known = &analysis.context.user_blocks[0].parameters;
        let named: Vec<&str> = known.iter().map(|known: &Parameter| &*known.name).collect();
        let parameters = parameters(source);
        let described: Vec<&str> = parameters.iter().map(|parameter| parameter.name).collect();
        assert_eq!(named, described, "{}", source.name);
        for parameter in &parameters {
            assert!(
                !parameter.meaning.is_empty(),
                "{}: {}",
                source.name,
                parameter.name
            );
        }
        assert!(source.description().ends_with('.'), "{}", source.name);
        assert!((4..80).contains(&source.summary().len()), "{}", source.name);
        assert!(source.diagram().lines().count() >= 2, "{}", source.name);
        assert!(!source.step().is_empty(), "{}", source.name);
    }
}
