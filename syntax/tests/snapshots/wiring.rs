//! Parts, segments and connector pairs of networks.

use expect_test::{Expect, expect};
use ladder_syntax::parse;
use ladder_syntax::wiring::wiring;
use std::fmt::Write as _;

/// Each rung's segments (`*`: powered) with the kinds of their parts, what belongs to none, the pairs, and what
/// has no partner.
#[track_caller]
fn check(text: &str, expect: Expect) {
    let parse = parse(text);
    let mut out = String::new();
    for network in &parse.structure().networks {
        let wiring = wiring(&parse, network);
        for (offset, rung) in wiring.line_offsets.iter().zip(&wiring.rungs) {
            let line = network.lines.start + offset;
            let _ = writeln!(out, "line {line}");
            for (index, segment) in rung.segments.iter().enumerate() {
                let _ = write!(out, " {}", if segment.powered { '*' } else { '-' });
                for part in &rung.parts[segment.parts.clone()] {
                    assert_eq!(part.segment, Some(index as u32));
                    let _ = write!(out, " {:?}", part.kind);
                }
                out.push('\n');
            }
            let loose: Vec<_> = rung
                .parts
                .iter()
                .filter(|p| p.segment.is_none())
                .map(|p| p.kind)
                .collect();
            if !loose.is_empty() {
                let _ = writeln!(out, " loose {loose:?}");
            }
        }
        for point in &wiring.points {
            let below = point.upper + 1;
            let down = wiring.rungs[point.upper].parts[point.down].range.start();
            let up = wiring.rungs[below].parts[point.up].range.start();
            let _ = writeln!(
                out,
                "pair {}: rung {} column {down:?} with rung {below} column {up:?}",
                point.ordinal, point.upper
            );
        }
        for &(rung, part) in &wiring.unpaired {
            let part = &wiring.rungs[rung].parts[part];
            let _ = writeln!(out, "unpaired {:?} on rung {rung} at {:?}", part.kind, part.range);
        }
        out.push('\n');
    }
    expect.assert_eq(&out);
}

#[test]
fn seal_in() {
    check(
        "+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  |                |                           |\n|  /--[ ]( run )----/                           |\n",
        expect![[r#"
            line 0
             * LeftRail Wire Down Wire Block Wire Down Wire Block Wire Block Wire RightRail
            line 2
             - Up Wire Block Wire Up
             loose [Bar, Bar]
            pair 0: rung 0 column 3 with rung 1 column 3
            pair 1: rung 0 column 20 with rung 1 column 20

        "#]],
    );
}

#[test]
fn side_by_side_and_passing() {
    check(
        "+--\\--[ ]( a )--\\-----\\--[ ]( c )--\\--( )( y )--+\n|  /--[ ]( b )--/     /--[ ]( d )--/            |\n",
        expect![[r#"
            line 0
             * LeftRail Wire Down Wire Block Wire Down Wire Down Wire Block Wire Down Wire Block Wire RightRail
            line 1
             - Up Wire Block Wire Up
             - Up Wire Block Wire Up
             loose [Bar, Bar]
            pair 0: rung 0 column 3 with rung 1 column 3
            pair 1: rung 0 column 16 with rung 1 column 16
            pair 2: rung 0 column 22 with rung 1 column 22
            pair 3: rung 0 column 35 with rung 1 column 35

        "#]],
    );
    check(
        "+--\\-----\\--[ ]( a )--\\--+\n|  /--\\  /--[ ]( b )--/  |\n|     /--[ ]( c )\n",
        expect![[r#"
            line 0
             * LeftRail Wire Down Wire Down Wire Block Wire Down Wire RightRail
            line 1
             - Up Wire Down
             - Up Wire Block Wire Up
             loose [Bar, Bar]
            line 2
             - Up Wire Block
             loose [Bar]
            pair 0: rung 0 column 3 with rung 1 column 3
            pair 1: rung 0 column 9 with rung 1 column 9
            pair 2: rung 0 column 22 with rung 1 column 22
            pair 0: rung 1 column 6 with rung 2 column 6

        "#]],
    );
}

/// Pairs go by order, whatever the columns.
#[test]
fn pairs_by_order() {
    check(
        "\\ \\ \\\n      / /\n",
        expect![[r#"
        line 0
         - Down
         - Down
         - Down
        line 1
         - Up
         - Up
        pair 0: rung 0 column 0 with rung 1 column 6
        pair 1: rung 0 column 2 with rung 1 column 8
        unpaired Down on rung 0 at 4..5

    "#]],
    );
    check(
        "\\\n/ / /\n",
        expect![[r#"
        line 0
         - Down
        line 1
         - Up
         - Up
         - Up
        pair 0: rung 0 column 0 with rung 1 column 0
        unpaired Up on rung 1 at 2..3
        unpaired Up on rung 1 at 4..5

    "#]],
    );
    check(
        "--/--\n\\--\n",
        expect![[r#"
        line 0
         - Wire Up Wire
        unpaired Up on rung 0 at 2..3

        line 1
         - Down Wire
        unpaired Down on rung 0 at 0..1

    "#]],
    );
    check(
        "\\/\n|\n\n# c #\n/\\\n/\n",
        expect![[r#"
        line 0
         - Down Up
        line 4
         - Up Down
        line 5
         - Up
        pair 0: rung 0 column 0 with rung 1 column 0
        pair 0: rung 1 column 1 with rung 2 column 0
        unpaired Up on rung 0 at 1..2

    "#]],
    );
}

#[test]
fn white_space_and_bars_break_a_wire() {
    check(
        "+-- --|--|--+\n",
        expect![[r#"
        line 0
         * LeftRail Wire
         - Wire
         - Wire
         - Wire RightRail
         loose [StrayBar, StrayBar]

    "#]],
    );
    check(
        "|--[ ]( a )--|\n",
        expect![[r#"
        line 0
         - Wire Block Wire
         loose [Bar, Bar]

    "#]],
    );
    check(
        "+|--||--|+\n",
        expect![[r#"
        line 0
         * LeftRail
         - Wire
         - Wire
         - RightRail
         loose [StrayBar, Bar, Bar, StrayBar]

    "#]],
    );
}

#[test]
fn rails() {
    check(
        "+\n",
        expect![[r#"
        line 0
         * LeftRail

    "#]],
    );
    check(
        "++\n",
        expect![[r#"
        line 0
         * LeftRail RightRail

    "#]],
    );
    check(
        "| # c # +--+--+--+ # d # |\n",
        expect![[r#"
        line 0
         * LeftRail Wire StrayRail Wire StrayRail Wire RightRail
         loose [Bar, Comment, Comment, Bar]

    "#]],
    );
    check(
        "--+--\n",
        expect![[r#"
        line 0
         - Wire StrayRail Wire

    "#]],
    );
    check(
        "[ ]( a )+( )( y )\n",
        expect![[r#"
        line 0
         - Block StrayRail Block

    "#]],
    );
    check(
        "x +--+ x\n",
        expect![[r#"
            line 0
             * LeftRail Wire RightRail
             loose [Junk, Junk]

        "#]],
    );
    check(
        "x+--+x\n",
        expect![[r#"
        line 0
         * Junk LeftRail Wire RightRail Junk

    "#]],
    );
}

/// A comment joins what touches it on both sides; at an end, or next to white space or a bar, it joins nothing.
#[test]
fn comments() {
    check(
        "# a #+-# b #[ ]( c )# d ## e #( )( y )--+# f #\n",
        expect![[r#"
            line 0
             * LeftRail Wire Comment Block Comment Comment Block Wire RightRail
             loose [Comment, Comment]

        "#]],
    );
    check(
        "+--# a #--( )( y )--+\n",
        expect![[r#"
        line 0
         * LeftRail Wire Comment Wire Block Wire RightRail

    "#]],
    );
    check(
        "+--# a # --# b #\n",
        expect![[r#"
        line 0
         * LeftRail Wire
         - Wire
         loose [Comment, Comment]

    "#]],
    );
    check(
        "--# a #|# b #--|# c #|--\n",
        expect![[r#"
        line 0
         - Wire
         - Wire
         - Wire
         loose [Comment, Bar, Comment, Bar, Comment, Bar]

    "#]],
    );
    check(
        "+--[ ]( a )--# three\nand more #--( )( w )--+\n",
        expect![[r#"
            line 0
             * LeftRail Wire Block Wire Comment Wire Block Wire RightRail

        "#]],
    );
    check(
        "+--\\# a #\n   /# b #/# c #\\\n",
        expect![[r#"
        line 0
         * LeftRail Wire Down
         loose [Comment]
        line 1
         - Up Comment Up Comment Down
        pair 0: rung 0 column 3 with rung 1 column 3
        unpaired Up on rung 1 at 9..10
        unpaired Down on rung 1 at 15..16

    "#]],
    );
}

#[test]
fn blocks_touch() {
    check(
        "+[ ]( a )[OSR]( )( y )\\/+\n",
        expect![[r#"
        line 0
         * LeftRail Block Block Block Down Up RightRail
        unpaired Down on rung 0 at 22..23
        unpaired Up on rung 0 at 23..24

    "#]],
    );
}

#[test]
fn errors_act_as_wire() {
    check(
        "+--x--+\n",
        expect![[r#"
        line 0
         * LeftRail Wire Junk Wire RightRail

    "#]],
    );
    check(
        "+--x]]y--+\n",
        expect![[r#"
        line 0
         * LeftRail Wire Junk Wire RightRail

    "#]],
    );
    check(
        "+--[ ]( a --( )( y )--+\n",
        expect![[r#"
            line 0
             * LeftRail Wire Block Wire Block Wire RightRail

        "#]],
    );
}
