//! Large programs, and those made to take long.

use crate::harness::outline;
use ladder_review::{Verdict, compare};
use std::fmt::Write;
use std::time::{Duration, Instant};

const NETWORKS: usize = 10_000;

/// In a build without optimisation on a busy machine. What grows with the square of the networks takes minutes.
const MOST: Duration = Duration::from_secs(20);

fn program(network: impl Fn(usize) -> String) -> String {
    let mut text = String::new();
    for number in 0..NETWORKS {
        let _ = writeln!(text, "{}\n", network(number));
    }
    text
}

/// What became of the networks: how many of each verdict, and how many have moved.
#[track_caller]
fn counts(old: &str, new: &str) -> Vec<(&'static str, usize)> {
    let (old, new) = (outline(old), outline(new));
    let start = Instant::now();
    let comparison = compare(&old, &new);
    let took = start.elapsed();
    assert!(took < MOST, "{took:?}");
    comparison.counts()
}

fn plain(number: usize) -> String {
    format!("+--[ ]( a{number} )--[/]( b{number} )--( )( y{number} )--+")
}

#[test]
fn ten_edits_of_ten_thousand_networks() {
    let old = program(plain);
    let new = program(|number| {
        if number % 1000 == 7 {
            plain(number).replace("[/]", "[ ]")
        } else {
            plain(number)
        }
    });
    assert_eq!(counts(&old, &new), [("edited", 10), ("same", 9990)]);
}

#[test]
fn networks_that_are_all_the_same() {
    let old = program(|_| plain(1));
    let new = program(|_| plain(1)).replacen("[/]", "[ ]", 1);
    assert_eq!(counts(&old, &new), [("edited", 1), ("same", 9999)]);
}

#[test]
fn nothing_in_common() {
    let new = program(|number| format!("+--[P]( c{number} )--(S)( z{number} )--+"));
    assert_eq!(
        counts(&program(plain), &new),
        [("new", NETWORKS), ("gone", NETWORKS)]
    );
}

#[test]
fn everything_writes_one_tag_and_is_edited() {
    let network = |number: usize, contact: &str| format!("+--{contact}( a{number} )--( )( y )--+");
    let old = program(|number| network(number, "[ ]"));
    let new = program(|number| network(number, "[/]"));
    assert_eq!(counts(&old, &new), [("edited", NETWORKS)]);
}

#[test]
fn the_other_way_round() {
    let old = program(plain);
    let new = program(|number| plain(NETWORKS - 1 - number));
    let counts = counts(&old, &new);
    assert_eq!(counts.iter().map(|(_, count)| count).sum::<usize>(), NETWORKS);
    assert_eq!(counts[0], ("moved", NETWORKS - 1));
}

#[test]
fn two_kinds_in_turn() {
    let old = program(|number| plain(number % 2));
    let new = program(|number| plain(number % 3 % 2));
    counts(&old, &new);
}

#[test]
fn a_network_that_writes_everything() {
    let mut wide = "+".to_owned();
    for number in 0..NETWORKS {
        let _ = write!(wide, "--( )( y{number} )");
    }
    let old = format!("{wide}--+\n\n{}", program(plain));
    let new = format!(
        "{wide}--( )( z )--+\n\n{}",
        program(|number| plain(number).replace("[/]", "[ ]"))
    );
    let (old, new) = (outline(&old), outline(&new));
    let start = Instant::now();
    let comparison = compare(&old, &new);
    assert!(start.elapsed() < MOST);
    assert!(
        comparison
            .changes
            .iter()
            .all(|change| change.verdict == Verdict::Edited)
    );
}
