//! Three texts as one.

use crate::harness::outline;
use expect_test::{Expect, expect};
use ladder_format::{Options, format_text};
use ladder_review::{NotMerged, Sides, merge};

/// The merged text as it is laid out, with the conflicts after it.
fn merged(base: &str, ours: &str, theirs: &str) -> Result<(String, Vec<String>), NotMerged> {
    let (base, ours, theirs) = (outline(base), outline(ours), outline(theirs));
    let sides = Sides {
        base: &base,
        ours: &ours,
        theirs: &theirs,
    };
    let merged = merge(sides)?;
    let conflicts = merged.conflicts.iter().map(ToString::to_string);
    let options = Options {
        width: 60,
        ..Options::default()
    };
    Ok((format_text(&merged.text, &options), conflicts.collect()))
}

fn check(base: &str, ours: &str, theirs: &str, expected: Expect) {
    let shown = match merged(base, ours, theirs) {
        Ok((text, conflicts)) => {
            let conflicts = conflicts.iter().map(|it| format!("conflict: {it}\n"));
            text + &conflicts.collect::<Vec<_>>().concat()
        }
        Err(error) => format!("{error}\n"),
    };
    expected.assert_eq(&shown);
}

const BASE: &str = "\
# Two pumps #

VAR_INPUT
    start, stop : BOOL;
END_VAR
VAR
    t : TON;
END_VAR

# The first #
+--[ ]( start )--( )( one )--+

# The second #
+--[ ]( one )--[TON]( t, 5s )--( )( two )--+

+--[ ]( stop )--( )( off )--+
";

#[test]
fn edits_of_different_networks_and_declarations() {
    let ours = BASE
        .replace("t : TON;", "t : TON;\n    ours : BOOL;")
        .replace("[ ]( start )", "[P]( start )");
    let theirs = BASE
        .replace("t : TON;", "t : TON;\n    theirs : BOOL;")
        .replace("5s", "7s")
        + "\n+--[ ]( theirs )--( )( lamp )--+\n";
    check(
        BASE,
        &ours,
        &theirs,
        expect![[r#"
        # Two pumps #

        VAR_INPUT
            start, stop : BOOL;
        END_VAR
        VAR
            t      : TON;
            ours   : BOOL;
            theirs : BOOL;
        END_VAR

        # The first #
        +--[P]( start )--------------------------------( )( one )--+

        # The second #
        +--[ ]( one )------------------[TON]( t, 7s )--( )( two )--+

        +--[ ]( stop )---------------------------------( )( off )--+

        +--[ ]( theirs )------------------------------( )( lamp )--+
    "#]],
    );
}

#[test]
fn two_edits_of_one_network() {
    let ours = BASE.replace("5s", "6s");
    let theirs = BASE.replace("5s", "7s").replace("( stop )", "( halt )");
    check(
        BASE,
        &ours,
        &theirs,
        expect![[r#"
        # Two pumps #

        VAR_INPUT
            start, stop : BOOL;
        END_VAR
        VAR
            t : TON;
        END_VAR

        # The first #
        +--[ ]( start )--------------------------------( )( one )--+

        # <<<<<<< ours #
        # The second #
        +--[ ]( one )--[TON]( t, 6s )--( )( two )--+
        # ======= #
        # The second #
        +--[ ]( one )--[TON]( t, 7s )--( )( two )--+
        # >>>>>>> theirs #

        +--[ ]( halt )---------------------------------( )( off )--+
        conflict: both sides edited the network that writes t, two
    "#]],
    );
}

#[test]
fn an_edit_of_what_the_other_side_removed() {
    let ours = BASE.replace("+--[ ]( stop )--( )( off )--+\n", "");
    let theirs = BASE.replace("[ ]( stop )", "[/]( stop )");
    check(
        BASE,
        &ours,
        &theirs,
        expect![[r#"
        # Two pumps #

        VAR_INPUT
            start, stop : BOOL;
        END_VAR
        VAR
            t : TON;
        END_VAR

        # The first #
        +--[ ]( start )--------------------------------( )( one )--+

        # The second #
        +--[ ]( one )------------------[TON]( t, 5s )--( )( two )--+

        # <<<<<<< ours: removed #
        # ======= #
        +--[/]( stop )--( )( off )--+
        # >>>>>>> theirs #
        conflict: ours removed, and theirs edited, the network that writes off
    "#]],
    );
    check(
        BASE,
        &theirs,
        &ours,
        expect![[r#"
        # Two pumps #

        VAR_INPUT
            start, stop : BOOL;
        END_VAR
        VAR
            t : TON;
        END_VAR

        # The first #
        +--[ ]( start )--------------------------------( )( one )--+

        # The second #
        +--[ ]( one )------------------[TON]( t, 5s )--( )( two )--+

        # <<<<<<< ours #
        +--[/]( stop )--( )( off )--+
        # ======= #
        # >>>>>>> theirs: removed #
        conflict: theirs removed, and ours edited, the network that writes off
    "#]],
    );
}

#[test]
fn two_edits_of_one_declaration() {
    let ours = BASE.replace("t : TON", "t : TOF");
    let theirs = BASE.replace("t : TON", "t : TP");
    check(
        BASE,
        &ours,
        &theirs,
        expect![[r#"
        # Two pumps #

        VAR_INPUT
            start, stop : BOOL;
        END_VAR
        VAR

        # <<<<<<< ours #
            t : TOF;
        # ======= #
            t : TP;
        # >>>>>>> theirs #
        END_VAR

        # The first #
        +--[ ]( start )--------------------------------( )( one )--+

        # The second #
        +--[ ]( one )------------------[TON]( t, 5s )--( )( two )--+

        +--[ ]( stop )---------------------------------( )( off )--+
        conflict: both sides edited the declaration of t
    "#]],
    );
}

#[test]
fn a_layout_is_no_edit() {
    let ours = format_text(BASE, &Options::default());
    let theirs = BASE.replace("5s", "7s").replace("--+\n", "----+\n");
    check(
        BASE,
        &ours,
        &theirs,
        expect![[r#"
        # Two pumps #

        VAR_INPUT
            start, stop : BOOL;
        END_VAR
        VAR
            t : TON;
        END_VAR

        # The first #
        +--[ ]( start )--------------------------------( )( one )--+

        # The second #
        +--[ ]( one )------------------[TON]( t, 7s )--( )( two )--+

        +--[ ]( stop )---------------------------------( )( off )--+
    "#]],
    );
}

#[test]
fn one_side_moves_and_the_other_edits() {
    let off = "+--[ ]( stop )--( )( off )--+\n";
    let ours = BASE
        .replace(off, "")
        .replace("# The first #", &format!("{off}\n# The first #"));
    let theirs = BASE.replace("[ ]( stop )", "[/]( stop )");
    check(
        BASE,
        &ours,
        &theirs,
        expect![[r#"
        # Two pumps #

        VAR_INPUT
            start, stop : BOOL;
        END_VAR
        VAR
            t : TON;
        END_VAR

        +--[/]( stop )---------------------------------( )( off )--+

        # The first #
        +--[ ]( start )--------------------------------( )( one )--+

        # The second #
        +--[ ]( one )------------------[TON]( t, 5s )--( )( two )--+
    "#]],
    );
    check(
        BASE,
        &theirs,
        &ours,
        expect![[r#"
        # Two pumps #

        VAR_INPUT
            start, stop : BOOL;
        END_VAR
        VAR
            t : TON;
        END_VAR

        +--[/]( stop )---------------------------------( )( off )--+

        # The first #
        +--[ ]( start )--------------------------------( )( one )--+

        # The second #
        +--[ ]( one )------------------[TON]( t, 5s )--( )( two )--+
    "#]],
    );
}

#[test]
fn a_section_that_one_side_removed_and_the_other_added_to() {
    let ours = BASE.replace("VAR\n    t : TON;\nEND_VAR\n", "");
    let theirs = BASE.replace("t : TON;", "t : TON;\n    more : BOOL;");
    check(
        BASE,
        &ours,
        &theirs,
        expect![[r#"
        # Two pumps #

        VAR_INPUT
            start, stop : BOOL;
        END_VAR
        VAR
            more : BOOL;
        END_VAR

        # The first #
        +--[ ]( start )--------------------------------( )( one )--+

        # The second #
        +--[ ]( one )------------------[TON]( t, 5s )--( )( two )--+

        +--[ ]( stop )---------------------------------( )( off )--+
    "#]],
    );
}

#[test]
fn both_add_the_same_and_something_of_one_name() {
    let ours = format!("{BASE}\n+--[ ]( a )--( )( lamp )--+\n\n+--[ ]( b )--( )( horn )--+\n");
    let theirs = format!("{BASE}\n+--[ ]( a )--( )( lamp )--+\n\n+--[ ]( c )--( )( horn )--+\n");
    check(
        BASE,
        &ours,
        &theirs,
        expect![[r#"
        # Two pumps #

        VAR_INPUT
            start, stop : BOOL;
        END_VAR
        VAR
            t : TON;
        END_VAR

        # The first #
        +--[ ]( start )--------------------------------( )( one )--+

        # The second #
        +--[ ]( one )------------------[TON]( t, 5s )--( )( two )--+

        +--[ ]( stop )---------------------------------( )( off )--+

        +--[ ]( a )-----------------------------------( )( lamp )--+

        # <<<<<<< ours #
        +--[ ]( b )--( )( horn )--+
        # ======= #
        +--[ ]( c )--( )( horn )--+
        # >>>>>>> theirs #
        conflict: both sides added the network that writes horn
    "#]],
    );
}

#[test]
fn blocks_and_settings() {
    let base = "\
# ladder: cycle 10ms #
FUNCTION_BLOCK [$Seal]
VAR_INPUT on : BOOL; END_VAR
+--[ ]( on )--( )( ENO )--+
END_FUNCTION_BLOCK
FUNCTION_BLOCK [$Old]
+--[ ]( EN )--( )( ENO )--+
END_FUNCTION_BLOCK
";
    let ours = base
        .replace("on : BOOL;", "on : BOOL; off : BOOL;")
        .replace("10ms", "20ms");
    let theirs = base.replace("[ ]( on )", "[P]( on )");
    let gone = theirs.find("FUNCTION_BLOCK [$Old]").expect("it is there");
    check(
        base,
        &ours,
        &theirs[..gone],
        expect![[r#"
        # ladder: cycle 20ms #
        FUNCTION_BLOCK [$Seal]
        VAR_INPUT
            on  : BOOL;
            off : BOOL;
        END_VAR
        +--[P]( on )-----------------------------------( )( ENO )--+
        END_FUNCTION_BLOCK
    "#]],
    );
}

#[test]
fn comments_that_both_changed() {
    let ours = BASE
        .replace("The first", "Pump 1")
        .replace("Two pumps", "Pumps of hall 1");
    let theirs = BASE
        .replace("The first", "P1")
        .replace("Two pumps", "Pumps of hall 2");
    check(
        BASE,
        &ours,
        &theirs,
        expect![[r#"
        # Pumps of hall 1 #

        # Pumps of hall 2 #

        VAR_INPUT
            start, stop : BOOL;
        END_VAR
        VAR
            t : TON;
        END_VAR

        # <<<<<<< ours #
        # Pump 1 #
        +--[ ]( start )--( )( one )--+
        # ======= #
        # P1 #
        +--[ ]( start )--( )( one )--+
        # >>>>>>> theirs #

        # The second #
        +--[ ]( one )------------------[TON]( t, 5s )--( )( two )--+

        +--[ ]( stop )---------------------------------( )( off )--+
        conflict: both sides edited the network that writes one
    "#]],
    );
}

#[test]
fn line_ends_and_the_byte_order_mark_are_those_of_ours() {
    let ours = format!("\u{feff}{}", BASE.replace('\n', "\r\n"));
    let theirs = BASE.replace("5s", "7s");
    let (text, conflicts) = merged(BASE, &ours, &theirs).expect("it is clear");
    assert!(conflicts.is_empty());
    assert!(text.starts_with("\u{feff}# Two"), "{text:?}");
    assert!(text.contains("7s"));
    assert_eq!(text.matches('\n').count(), text.matches("\r\n").count());
}

#[test]
fn what_is_not_closed() {
    check(
        BASE,
        &BASE.replace("END_VAR\n\n#", "\n\n#"),
        BASE,
        expect![[r#"
            the section in line 6 of ours is not closed, so it is not known what belongs to it; close it first
        "#]],
    );
    check(
        BASE,
        BASE,
        &format!("{BASE}# note"),
        expect![[r#"
        the comment in line 17 of theirs is not closed, so it is not known what belongs to it; close it first
    "#]],
    );
    check(
        BASE,
        BASE,
        &format!("{BASE}FUNCTION_BLOCK [$B]\n"),
        expect![[r#"
            the block in line 17 of theirs is not closed, so it is not known what belongs to it; close it first
        "#]],
    );
}

#[test]
fn connectors_that_would_pair_across_networks() {
    let base = "+--[ ]( a )--( )( b )--+\n\n+--[ ]( c )--( )( d )--+\n";
    let ours = "+--[ ]( a )--\\--( )( b )--+\n\n+--[ ]( c )--( )( d )--+\n";
    let theirs = "+--[ ]( a )--( )( b )--+\n\n+--[ ]( e )--/--( )( f )--+\n\n+--[ ]( c )--( )( d )--+\n";
    check(
        base,
        ours,
        theirs,
        expect![[r#"
        errors in the texts join networks of one side to those of the other; fix the connectors first
    "#]],
    );
}
