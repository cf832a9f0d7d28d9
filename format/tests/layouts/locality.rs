//! Changing one network changes the lines of no other.

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
        _ => format!("+-[ ]( {a} )-\\-( )( {y} )-+\n# inside #\n+-[ ]({b})-/-( )( z )-+ # after #"),
    })
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
        let options = Options { width: if narrow { 40 } else { 80 }, ..Options::default() };
        let place = place.index(networks.len());
        let before = drawn(&networks, &options);
        networks[place] = new;
        let after = drawn(&networks, &options);
        prop_assert_eq!(before.len(), after.len());
        for (n, (before, after)) in before.iter().zip(&after).enumerate() {
            if n != place {
                prop_assert_eq!(before, after);
            }
        }
    }
}
