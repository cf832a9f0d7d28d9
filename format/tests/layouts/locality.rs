//! Changing one network changes the lines of no other, unless the file's rail moves.

use ladder_format::{Options, format_text};
use proptest::prelude::*;

/// A network as someone types it; the names decide how wide it is.
fn network() -> impl Strategy<Value = String> {
    let name = (1..30usize).prop_map(|length| "n".repeat(length));
    (0..6usize, name.clone(), name.clone(), name).prop_map(|(shape, a, b, y)| match shape {
        0 => format!("+-[ ]({a})-[/]( {b} )-( )({y})-+"),
        1 => format!("+-\\-[ ]({a})-\\-( )( {y} )-+\n/-[ ]( {b})-/"),
        2 => format!("+-[ ]({a})-\\-( )( {y} )-+\n\n|\n/-[TON]( {b},T#5s)-( )( z )--+"),
        3 => format!("+-\\-[ ]({a})-\\-\\-[ ]( x )-\\-( )( {y} )-+\n/-[ ]( {b})-/ /-[ ]( z )-/"),
        4 => format!("-[ ]({a})-( )({y})"),
        _ => format!("+-[ ]( {a} )-\\-( )( {y} )-+\n# inside #\n+-[ ]({b})-/-( )( z )-+ # behind #"),
    })
}

/// The column of the rail that a network asks the file for.
fn rail(network: &str, options: &Options) -> usize {
    let drawn = format_text(network, options);
    let column = |line: &str| {
        let line = line.split("  #").next().unwrap_or(line);
        line.ends_with('+').then_some(line.len())
    };
    let rail = drawn.lines().filter_map(column).max().unwrap_or(0);
    if rail > options.width as usize || rail % 20 != 0 {
        0
    } else {
        rail
    }
}

fn file_rail(networks: &[String], options: &Options) -> usize {
    networks
        .iter()
        .map(|network| rail(network, options))
        .max()
        .unwrap_or(0)
}

fn drawn(networks: &[String], options: &Options) -> Vec<String> {
    let text = format_text(&format!("{}\n", networks.join("\n\n# next #\n")), options);
    text.split("\n# next #\n").map(str::to_owned).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, ..ProptestConfig::default() })]

    #[test]
    fn other_networks_keep_their_lines(
        mut networks in prop::collection::vec(network(), 2..8),
        place in any::<prop::sample::Index>(),
        new in network(),
        narrow in any::<bool>(),
    ) {
        // With the least width each network has a rail of its own, and nothing ever moves: merges rest on that.
        let options = Options { width: if narrow { 40 } else { 100 }, ..Options::default() };
        let place = place.index(networks.len());
        let (before, rail_before) = (drawn(&networks, &options), file_rail(&networks, &options));
        networks[place] = new;
        let (after, rail_after) = (drawn(&networks, &options), file_rail(&networks, &options));
        prop_assert_eq!(before.len(), after.len());
        let same_rail = narrow || rail_before == rail_after;
        for (n, (before, after)) in before.iter().zip(&after).enumerate() {
            if n != place && same_rail {
                prop_assert_eq!(before, after);
            }
        }
    }
}
