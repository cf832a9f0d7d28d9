//! Networks, sections and block definitions as ranges over lines.

use expect_test::{Expect, expect};
use ladder_syntax::{Item, parse};
use std::fmt::Write as _;

/// Each item with its lines.
#[track_caller]
fn check(text: &str, expect: Expect) {
    let parse = parse(text);
    let structure = parse.structure();
    let mut out = String::new();
    for item in &structure.items {
        let _ = match *item {
            Item::Network(n) => {
                let network = &structure.networks[n];
                let rungs: Vec<usize> = network.rungs(parse.lines()).collect();
                let block = network.block.map_or(String::new(), |b| format!(" in block {b}"));
                writeln!(out, "network {:?} rungs {rungs:?}{block}", network.lines)
            }
            Item::Section(n) => {
                let section = &structure.sections[n];
                let block = section.block.map_or(String::new(), |b| format!(" in block {b}"));
                let closed = if section.closed { "" } else { " not closed" };
                writeln!(out, "section {:?}{closed}{block}", section.lines)
            }
            Item::BlockHeader(n) => {
                let block = &structure.blocks[n];
                let closed = if block.closed { "" } else { " not closed" };
                writeln!(out, "block {:?}{closed}", block.lines)
            }
            other => writeln!(out, "{other:?}"),
        };
    }
    expect.assert_eq(&out);
}

#[test]
fn networks_are_chains() {
    check(
        "+--\\--\\--+\n|\n# c #\n\n/--/--\\\n/\n/--\n+--+\n\\\n+--+\n",
        expect![[r#"
            network 0..6 rungs [0, 4, 5]
            network 6..7 rungs [6]
            network 7..8 rungs [7]
            network 8..9 rungs [8]
            network 9..10 rungs [9]
        "#]],
    );
}

/// What is after the last rung of a network belongs to no network.
#[test]
fn decoration_between_networks() {
    check(
        "\n|\n+--+\n|  |\n\n# c #\n+--+\n|\n",
        expect![[r#"
        Decoration(0)
        Decoration(1)
        network 2..3 rungs [2]
        Decoration(3)
        Decoration(4)
        Decoration(5)
        network 6..7 rungs [6]
        Decoration(7)
    "#]],
    );
}

#[test]
fn a_declaration_ends_a_network() {
    check(
        "+--\\--+\nVAR a : INT; END_VAR\n/--+\n",
        expect![[r#"
        network 0..1 rungs [0]
        section 1..4
        network 4..5 rungs [4]
    "#]],
    );
    check(
        "+--\\--+\nFUNCTION_BLOCK [$B]\n/--\\--+\nEND_FUNCTION_BLOCK\n/--+\n",
        expect![[r#"
            network 0..1 rungs [0]
            block 1..4
            network 2..3 rungs [2] in block 0
            BlockEnd(3)
            network 4..5 rungs [4]
        "#]],
    );
}

#[test]
fn a_stray_line_does_not() {
    check(
        "+--\\--+\nhello\n/--+\nworld\n",
        expect![[r#"
        network 0..3 rungs [0, 2]
        Stray(3)
    "#]],
    );
}

#[test]
fn block_bodies() {
    check(
        "FUNCTION_BLOCK [$B]\nVAR_INPUT a : BOOL; END_VAR\n+--+\n\n+--+\nEND_FUNCTION_BLOCK\n+--+\n",
        expect![[r#"
            block 0..8
            section 1..4 in block 0
            network 4..5 rungs [4] in block 0
            Decoration(5)
            network 6..7 rungs [6] in block 0
            BlockEnd(7)
            network 8..9 rungs [8]
        "#]],
    );
    check(
        "FUNCTION_BLOCK [$B]\n+--+\nFUNCTION_BLOCK [$C]\n+--+\n",
        expect![[r#"
            block 0..2 not closed
            network 1..2 rungs [1] in block 0
            block 2..4 not closed
            network 3..4 rungs [3] in block 1
        "#]],
    );
    check(
        "END_FUNCTION_BLOCK\nEND_VAR\n",
        expect![[r#"
        BlockEnd(0)
        Stray(1)
    "#]],
    );
}

/// The comment above the next network stays out of a section that was never closed.
#[test]
fn unfinished_sections() {
    check(
        "VAR\na : INT;\n\n# c #\n+--+\n",
        expect![[r#"
        section 0..2 not closed
        Decoration(2)
        Decoration(3)
        network 4..5 rungs [4]
    "#]],
    );
    check(
        "VAR\na : INT;\n\n# c #\n",
        expect![[r#"
        section 0..2 not closed
        Decoration(2)
        Decoration(3)
    "#]],
    );
    check(
        "VAR\n",
        expect![[r#"
        section 0..1 not closed
    "#]],
    );
}

#[test]
fn lines_and_offsets() {
    let text = "VAR a : INT; b : INT; END_VAR\n+--+\n";
    let parse = parse(text);
    let lines: Vec<&str> = (0..parse.lines().len())
        .map(|n| &text[parse.line_range(n)])
        .collect();
    assert_eq!(lines, ["VAR ", "a : INT; ", "b : INT; ", "END_VAR\n", "+--+\n"]);
    for (offset, line) in [(0, 0), (3, 0), (4, 1), (22, 3), (29, 3), (30, 4), (35, 4)] {
        assert_eq!(parse.line_at(offset.into()), Some(line), "{offset}");
    }
    assert_eq!(ladder_syntax::parse("").line_at(0.into()), None);
}
