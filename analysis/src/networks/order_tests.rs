//! The order of evaluation: blocks by their operands in the order in which they run.

use crate::analyze;
use crate::program::Step;
use crate::written::facts::NodeKind;
use expect_test::{Expect, expect};
use std::sync::Arc;

/// Each step in a few letters: `rail`, `none`, a block's first operand with the number of its EN, a join.
fn check(text: &str, expected: Expect) {
    let parse = Arc::new(ladder_syntax::parse(text));
    let analysis = analyze(&parse, "test.clad");
    let mut shown = String::new();
    for network in &analysis.context.networks {
        for (number, step) in network.order.steps.iter().enumerate() {
            let what = match step {
                Step::Start { rail: true } => "rail".to_owned(),
                Step::Start { rail: false } => "none".to_owned(),
                Step::Join { upper, lower } => format!("{upper} or {lower}"),
                Step::Block { block, en } => {
                    let name = match network.blocks[*block]
                        .facts
                        .operands
                        .first()
                        .map(|o| &o.value.kind)
                    {
                        Some(NodeKind::Name(name)) => name.to_string(),
                        _ => network.blocks[*block].head_text(),
                    };
                    format!("{name} after {en}")
                }
            };
            shown.push_str(&format!("{number}: {what}\n"));
        }
        shown.push_str("--\n");
    }
    expected.assert_eq(&shown);
}

#[test]
fn seal_in() {
    check(
        "+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  /--[ ]( run )----/\n",
        expect![[r#"
        0: rail
        1: none
        2: 0 or 1
        3: start after 2
        4: run after 2
        5: 3 or 4
        6: stop after 5
        7: run after 6
        --
    "#]],
    );
}

#[test]
fn staggered_branches_run_inwards_first() {
    check(
        "+--\\--[ ]( a )--------\\--( )( y )--+\n|  /--\\--[ ]( b )--\\--/\n|     /--[ ]( c )--/\n",
        expect![[r#"
            0: rail
            1: none
            2: 0 or 1
            3: a after 2
            4: none
            5: 2 or 4
            6: b after 5
            7: c after 5
            8: 6 or 7
            9: 3 or 8
            10: y after 9
            --
        "#]],
    );
}

#[test]
fn segments_side_by_side() {
    check(
        "+--\\--[ ]( a )--\\-----\\--[ ]( c )--\\--( )( y )--+\n|  /--[ ]( b )--/     /--[ ]( d )--/\n",
        expect![[r#"
            0: rail
            1: none
            2: 0 or 1
            3: a after 2
            4: b after 2
            5: 3 or 4
            6: none
            7: 5 or 6
            8: c after 7
            9: d after 7
            10: 8 or 9
            11: y after 10
            --
        "#]],
    );
}

#[test]
fn a_branch_that_passes_a_line() {
    check(
        "+--\\-----\\--[ ]( a )--\\-----\\--( )( y )--+\n|  /--\\  /--[ ]( b )--/  \\--/\n|     /--[ ]( c )--------/\n",
        expect![[r#"
            0: rail
            1: none
            2: 0 or 1
            3: none
            4: 2 or 3
            5: none
            6: 2 or 5
            7: a after 6
            8: b after 6
            9: 7 or 8
            10: none
            11: c after 4
            12: 10 or 11
            13: 9 or 12
            14: y after 13
            --
        "#]],
    );
}

#[test]
fn a_bridge() {
    check(
        "+--[ ]( a )--\\--[ ]( b )--\\--( )( y )--+\n+--[ ]( c )--/--[/]( d )--/\n",
        expect![[r#"
        0: rail
        1: a after 0
        2: rail
        3: c after 2
        4: 1 or 3
        5: b after 4
        6: d after 4
        7: 5 or 6
        8: y after 7
        --
    "#]],
    );
}

#[test]
fn connectors_without_partner_are_passed_over() {
    check(
        "+--\\--[ ]( a )--( )( y )--+\n   /--[ ]( b )--/\n",
        expect![[r#"
        0: rail
        1: none
        2: 0 or 1
        3: a after 2
        4: y after 3
        5: b after 2
        --
    "#]],
    );
}

/// `run` of the language's definition nests as deep as the network is high.
#[test]
fn ten_thousand_rungs() {
    let mut text = String::from("+--\\--[ ]( a )--\\--( )( y )--+\n");
    for _ in 0..10_000 {
        text.push_str("   /--\\--[ ]( b )--\\--/\n");
    }
    text.push_str("      /--[ ]( c )--/\n");
    let parse = Arc::new(ladder_syntax::parse(&text));
    let analysis = analyze(&parse, "test.clad");
    let steps = &analysis.context.networks.at(0).facts().order.steps;
    assert_eq!(
        steps
            .iter()
            .filter(|step| matches!(step, Step::Join { .. }))
            .count(),
        2 * 10_001
    );
}
