//! The options, and formatting a part of a file.

use expect_test::{Expect, expect};
use ladder_format::{Options, apply, format_ranges, format_text};
use ladder_syntax::{TextRange, TextSize, parse};

#[track_caller]
fn check(text: &str, options: &Options, expected: Expect) {
    let new = format_text(text, options);
    assert_eq!(format_text(&new, options), new);
    expected.assert_eq(&new);
}

#[test]
fn width() {
    let text = "+--[ ]( a )--( )( y )--+\n+--[ ]( first_input )--[ ]( second_input )--( )( output )--+\n";
    check(
        text,
        &Options {
            width: 60,
            ..Options::default()
        },
        expect![[r#"
            +--[ ]( a )--------------------------------------( )( y )--+
            +--[ ]( first_input )--[ ]( second_input )--( )( output )--+
        "#]],
    );
    check(
        text,
        &Options {
            width: 50,
            ..Options::default()
        },
        expect![[r#"
            +--[ ]( a )----------------------------( )( y )--+
            +--[ ]( first_input )--[ ]( second_input )--( )( output )--+
        "#]],
    );
    check(
        text,
        &Options {
            width: 0,
            ..Options::default()
        },
        expect![[r#"
            +--[ ]( a )------------------( )( y )--+
            +--[ ]( first_input )--[ ]( second_input )--( )( output )--+
        "#]],
    );
}

#[test]
fn spacing() {
    let text = "+--\\--[ ]( a )--\\--( )( y )--+ # after #\n# between #\n/--[ ]( b )--/\n";
    check(
        text,
        &Options {
            spacing: 1,
            ..Options::default()
        },
        expect![[r#"
            +-\-[ ]( a )-\--------------------------------------------------------( )( y )-+  # after #
            | # between #                                                                  |
            | /-[ ]( b )-/                                                                 |
        "#]],
    );
    check(
        text,
        &Options {
            spacing: 4,
            ..Options::default()
        },
        expect![[r#"
            +----\----[ ]( a )----\--------------------------------------------( )( y )----+  # after #
            |    # between #      |                                                        |
            |    /----[ ]( b )----/                                                        |
        "#]],
    );
}

/// Formats what touches the text between the two `~`.
#[track_caller]
fn check_range(text: &str, expected: Expect) {
    let start = text.find('~').unwrap();
    let end = text.rfind('~').unwrap() - 1;
    let text = text.replace('~', "");
    let range = TextRange::new(TextSize::new(start as u32), TextSize::new(end as u32));
    let edits = format_ranges(&parse(&text), &Options::default(), &[range]);
    expected.assert_eq(&apply(&text, &edits));
}

#[test]
fn only_what_the_range_touches() {
    check_range(
        "+-[ ]( a )-+\n\n\n+-[ ]( b )-~( )( y~ )-+\n\n\n+-[ ]( first_input )--[ ]( second_input )--( )( output )-+\n",
        expect![[r#"
            +-[ ]( a )-+


            +--[ ]( b )----------------------------------------------------------( )( y )--+


            +-[ ]( first_input )--[ ]( second_input )--( )( output )-+
        "#]],
    );
}

#[test]
fn a_network_is_formatted_as_a_whole() {
    check_range(
        "+-\\-[ ]( a )-\\-( )( y )-+\n\n /-[ ](~ ~b )-/\n+-[ ]( c )-( )( y )-+\n",
        expect![[r#"
            +--\--[ ]( a )--\----------------------------------------------------( )( y )--+
            |  |            |                                                              |
            |  /--[ ]( b )--/                                                              |
            +-[ ]( c )-( )( y )-+
        "#]],
    );
}

#[test]
fn sections_and_the_lines_between() {
    check_range(
        "VAR a:INT~; END_VAR\n\n\n+-[ ]~( a )-+\nVAR b:INT; END_VAR\n",
        expect![[r#"
            VAR
                a : INT;
            END_VAR

            +--[ ]( a )--------------------------------------------------------------------+
            VAR b:INT; END_VAR
        "#]],
    );
}
