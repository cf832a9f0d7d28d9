//! What has another name, in comparisons and merges.

use crate::harness::outline;
use expect_test::{Expect, expect};
use ladder_review::rename::renamed;
use ladder_review::report::{Compared, text};
use ladder_review::whole::Whole;
use ladder_review::{Limits, Sides, compare_renamed, merge};

const PUMP: &str = "\
TYPE
    Motor : STRUCT
        speed   : INT;
        running : BOOL;
    END_STRUCT;
END_TYPE
VAR_INPUT
    start, stop : BOOL;
END_VAR
VAR_OUTPUT
    pump : BOOL;
    lamp : BOOL;
END_VAR
VAR
    seal : BOOL;
    main : Motor;
END_VAR

FUNCTION_BLOCK [$Follow]
VAR_INPUT   raw : BOOL;  END_VAR
VAR_OUTPUT  out : BOOL;  END_VAR
+--[ ]( raw )--( )( out )--+
END_FUNCTION_BLOCK

+--\\--[ ]( start )--\\--[/]( stop )-------------( )( seal )--+
|  /--[ ]( seal )---/                                       |

+--[ ]( seal )--[$Follow]( seal, pump )--( )( main.running )--+

+--[ ]( pump )--<CALL>( blink )----------------------------+

+--[ ]( main.running )--( )( lamp )------------------------+

+--<FUN>( blink )--[MOV]( main.speed, 3 )------------------+
";

fn check(old: &str, new: &str, expected: Expect) {
    let (old, new) = (outline(old), outline(new));
    let renamed = renamed(&old, &new);
    let (old, renames) = match renamed {
        Some(renamed) => (outline(&renamed.text), renamed.renames),
        None => (old, Vec::new()),
    };
    let mut comparison = compare_renamed(&old, &new, renames);
    comparison.decide_whole(Limits::default(), usize::MAX);
    let same = comparison.whole == Some(Whole::Same);
    let compared = Compared {
        old: Some("old.clad"),
        new: Some("new.clad"),
        renamed: false,
        comparison,
    };
    let mut lines: Vec<String> = text::report(&compared)
        .into_iter()
        .map(|line| line.text)
        .collect();
    lines.push(format!("the same: {same}"));
    expected.assert_eq(&(lines.join("\n") + "\n"));
}

/// A text with another word wherever a word is.
fn with(text: &str, word: &str, other: &str) -> String {
    text.replace(word, other)
}

#[test]
fn a_tag() {
    check(
        PUMP,
        &with(PUMP, "seal", "runs"),
        expect![[r#"
            --- old.clad
            +++ new.clad
                15 the same, 1 renamed

            renamed: tag seal -> runs (5 places)

                ... 15 the same

            the programs do the same in every run
            the same: true
        "#]],
    );
    check(
        PUMP,
        &with(PUMP, "pump", "pump_1"),
        expect![[r#"
            --- old.clad
            +++ new.clad
                15 the same, 1 renamed

            renamed: output pump -> pump_1 (3 places)

                ... 15 the same

            the programs do the same in every run, but for the names
            the same: true
        "#]],
    );
}

#[test]
fn members_types_blocks_functions_and_parameters() {
    let new = with(PUMP, "speed", "rate");
    let new = with(&new, "Motor", "Drive");
    let new = with(&new, "$Follow", "$Copy");
    let new = with(&new, "blink", "flash");
    check(
        PUMP,
        &with(&new, "raw", "input"),
        expect![[r#"
            --- old.clad
            +++ new.clad
                15 the same, 5 renamed

            renamed: type Motor -> Drive (2 places)
            renamed: member speed -> rate (2 places)
            renamed: block $Follow -> $Copy (2 places)
            renamed: tag raw -> input (2 places)
            renamed: function blink -> flash (2 places)

                ... 15 the same

            the programs do the same in every run
            the same: true
        "#]],
    );
}

#[test]
fn the_rest_is_compared_under_the_new_name() {
    let new = with(PUMP, "seal", "runs").replace("[/]( stop )", "[ ]( stop )");
    check(
        PUMP,
        &new,
        expect![[r#"
            --- old.clad
            +++ new.clad
                1 edited, 14 the same, 1 renamed

            renamed: tag seal -> runs (5 places)

                ... 10 the same

            edited: network, line 25, writes runs
            - +--\--[ ]( start )--\--[/]( stop )------------------------------( )( runs )--+
                                     ^^^^^^^^^^^
            - |  /--[ ]( runs )---/                                                        |
            + +--\--[ ]( start )--\--[ ]( stop )------------------------------( )( runs )--+
                                     ^^^^^^^^^^^
            + |  /--[ ]( runs )---/                                                        |

                ... 4 the same

            the programs differ in scan 0, at 0s
                start    -
                pump  => -  (old)
                pump  => _  (new)
                lamp  => -  (old)
                lamp  => _  (new)
            the same: false
        "#]],
    );
}

#[test]
fn another_tag_is_no_rename() {
    let at = |address: &str, name: &str| {
        format!("VAR_INPUT\n    {name} AT {address} : BOOL;\nEND_VAR\n\n+--[ ]( {name} )--( )( y )--+\n")
    };
    check(
        &at("%IX0.0", "a"),
        &at("%IX0.1", "b"),
        expect![[r#"
        --- old.clad
        +++ new.clad
            1 edited, 1 new, 1 gone

        new: declaration of b, line 2
        + b AT %IX0.1 : BOOL;

        gone: declaration of a, was line 2
        - a AT %IX0.0 : BOOL;

        edited: network, line 5, writes y
        - +--[ ]( a )--------------------------------------------------------( )( y )--+
             ^^^^^^^^
        + +--[ ]( b )--------------------------------------------------------( )( y )--+
             ^^^^^^^^

        the programs differ in scan 0, at 0s
            a    -
            y => -  (old)
            y => _  (new)
        the same: false
    "#]],
    );
    check(
        "+--[ ]( I1 )--( )( Q1 )--+\n",
        "+--[ ]( I2 )--( )( Q1 )--+\n",
        expect![[r#"
            --- old.clad
            +++ new.clad
                1 edited

            edited: network, line 1, writes Q1
            - +--[ ]( I1 )------------------------------------------------------( )( Q1 )--+
                 ^^^^^^^^^
            + +--[ ]( I2 )------------------------------------------------------( )( Q1 )--+
                 ^^^^^^^^^

            the programs differ in scan 0, at 0s
                I1    -
                Q1 => -  (old)
                Q1 => _  (new)
            the same: false
        "#]],
    );
}

fn merged(base: &str, ours: &str, theirs: &str) -> String {
    let [base, ours, theirs] = [base, ours, theirs].map(outline);
    let sides = Sides {
        base: &base,
        ours: &ours,
        theirs: &theirs,
    };
    let merged = merge(sides).expect("it can be merged");
    let mut text = ladder_format::format_text(&merged.text, &ladder_format::Options::default());
    for conflict in &merged.conflicts {
        text.push_str(&format!("conflict: {conflict}\n"));
    }
    for refused in &merged.refused {
        text.push_str(&format!("refused: {refused}\n"));
    }
    text
}

const SMALL: &str = "\
VAR
    passed : BOOL;
    total  : DINT;
END_VAR

+--[ ]( beam )-----------( )( passed )--+

+--[ ]( passed )--[ADD]( total, total, 1 )--+
";

const NEW_RUNG: &str = "\n+--[ ]( passed )--( )( lamp )--+\n";

#[test]
fn a_rename_goes_into_what_the_other_side_wrote() {
    let renamed = with(SMALL, "passed", "box_gone");
    let rung = format!("{SMALL}{NEW_RUNG}");
    let both = merged(SMALL, &renamed, &rung);
    assert_eq!(both, merged(SMALL, &rung, &renamed));
    expect![[r#"
        VAR
            box_gone : BOOL;
            total    : DINT;
        END_VAR

        +--[ ]( beam )------------------------------------------------( )( box_gone )--+

        +--[ ]( box_gone )-----------------------------------[ADD]( total, total, 1 )--+

        +--[ ]( box_gone )------------------------------------------------( )( lamp )--+
    "#]]
    .assert_eq(&both);
}

#[test]
fn both_sides_rename_and_edit() {
    let ours = with(SMALL, "passed", "box_gone").replace("total, 1", "total, 2");
    let theirs = with(SMALL, "total", "boxes") + NEW_RUNG;
    expect![[r#"
        VAR
            box_gone : BOOL;
            boxes    : DINT;
        END_VAR

        +--[ ]( beam )------------------------------------------------( )( box_gone )--+

        +--[ ]( box_gone )-----------------------------------[ADD]( boxes, boxes, 2 )--+

        +--[ ]( box_gone )------------------------------------------------( )( lamp )--+
    "#]]
    .assert_eq(&merged(SMALL, &ours, &theirs));
    // The same name from both is one.
    let theirs = with(SMALL, "passed", "box_gone") + "\n+--[ ]( box_gone )--( )( lamp )--+\n";
    expect![[r#"
        VAR
            box_gone : BOOL;
            total    : DINT;
        END_VAR

        +--[ ]( beam )------------------------------------------------( )( box_gone )--+

        +--[ ]( box_gone )-----------------------------------[ADD]( total, total, 2 )--+

        +--[ ]( box_gone )------------------------------------------------( )( lamp )--+
    "#]]
    .assert_eq(&merged(SMALL, &ours, &theirs));
}

#[test]
fn two_new_names_for_one_thing_are_a_conflict() {
    let (ours, theirs) = (
        with(SMALL, "passed", "box_gone"),
        with(SMALL, "passed", "box_out"),
    );
    expect![[r#"
        VAR
            box_gone : BOOL;
            box_out  : BOOL;
            total    : DINT;
        END_VAR

        +--[ ]( beam )------------------------------------------------( )( box_gone )--+

        +--[ ]( beam )-------------------------------------------------( )( box_out )--+

        # <<<<<<< ours #
        +--[ ]( box_gone )--[ADD]( total, total, 1 )--+
        # ======= #
        +--[ ]( box_out )--[ADD]( total, total, 1 )--+
        # >>>>>>> theirs #
        conflict: both sides edited the network that writes total
        refused: ours renamed the tag passed to box_gone, and theirs to box_out
    "#]]
    .assert_eq(&merged(SMALL, &ours, &theirs));
}

#[test]
fn a_name_that_the_other_side_has_given_away_is_a_conflict() {
    let ours = with(SMALL, "passed", "box_gone");
    let theirs = SMALL.replace("    total ", "    box_gone : BOOL;\n    total ")
        + "\n+--[ ]( passed )--( )( box_gone )--+\n";
    expect![[r#"
        VAR
            box_gone : BOOL;
            total    : DINT;
        END_VAR

        # <<<<<<< ours #
        +--[ ]( beam )-----------( )( box_gone )--+
        # ======= #
        +--[ ]( passed )--( )( box_gone )--+
        # >>>>>>> theirs #

        +--[ ]( box_gone )-----------------------------------[ADD]( total, total, 1 )--+
        conflict: both sides added the network that writes box_gone
        refused: ours renamed the tag passed to box_gone; in what the other side wrote, there is a tag `box_gone` on line 3 of main.clad already: both would become one
    "#]].assert_eq(&merged(SMALL, &ours, &theirs));
}
