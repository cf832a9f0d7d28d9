//! What typing brings about, with `$0` where the cursor is.

use super::on_type;
use crate::fixture::Fixture;
use expect_test::{Expect, expect};
use ladder_format::{Options, apply};

/// The character before the cursor is the one that was typed; blanks there are those that an editor puts behind a
/// line end.
fn check(text: &str, expected: Expect) {
    let fixture = Fixture::new(text);
    let (_, offset, _) = fixture.ask();
    let before = fixture.text("main.clad");
    let typed = before[..usize::from(offset)]
        .trim_end_matches(' ')
        .chars()
        .next_back();
    check_typed(text, typed.unwrap(), expected);
}

/// The character is asked about once more: others were typed behind it since.
fn check_typed(text: &str, typed: char, expected: Expect) {
    let fixture = Fixture::new(text);
    let (context, offset, _) = fixture.ask();
    let before = fixture.text("main.clad");
    let edits = on_type(context, offset, typed, &Options::default());
    let shown = if edits.is_empty() {
        "nothing".to_owned()
    } else {
        let after = apply(before, &edits);
        let solid = |text: &str| text.replace([' ', '-', '|', '+', '/', '\\', '\n', '\r'], "");
        assert_eq!(solid(before), solid(&after), "nothing is lost");
        after.replace('\r', "").replace(" \n", "·\n")
    };
    expected.assert_eq(&(shown + "\n"));
}

#[test]
fn a_completed_block_draws_its_network() {
    check(
        "+--\\--[ ]( start )$0--\\--( )( run )--+\n|  /--[ ]( run )--/\n",
        expect![[r#"
            +--\--[ ]( start )--\------( )( run )--+
            |  /--[ ]( run )----/                  |

        "#]],
    );
    check(
        "+--[ ]( a )$0",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+--[ ]( a )--<RET>$0--+\n",
        expect![[r#"
        +--[ ]( a )---------------------<RET>--+

    "#]],
    );
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( bbbbbbb )--/$0\n",
        expect![[r#"
            +--\--[ ]( a )--------\------( )( y )--+
            |  /--[ ]( bbbbbbb )--/                |

        "#]],
    );
    check(
        "+--[ ]( a )--( )( y )--+$0\n\n+-[ ]( x )-( )( z )-+\n",
        expect![[r#"
            +--[ ]( a )------------------( )( y )--+

            +-[ ]( x )-( )( z )-+

        "#]],
    );
}

#[test]
fn what_is_half_typed_stays() {
    check(
        "+--[ ]( a )--( )$0--+\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+--[CALC]( y, (a + b)$0 --( )( x )--+\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+--\\--[ ]( a )--\\--( )( y )$0--+\n|  /--[ ]( b )\n",
        expect![[r#"
            nothing
        "#]],
    );
    check(
        "+--[ ]( a )$0-------------[TON]( t\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "# a (b)$0 #\n+-[ ]( a )-( )( y )-+\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+-[ ]( a )-( )( y )-+  # (c)$0 #\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+-[ ]( a )-[MOV]( y, 'x)$0' )-+\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+-[/$0]( a )-( )( y )-+\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "# open +-[ ]( a )$0-( )( y )-+\n",
        expect![[r#"
        nothing
    "#]],
    );
}

#[test]
fn enter_goes_on_with_the_rail() {
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n$0",
        expect![[r#"
            +--\--[ ]( a )--\--( )( y )--+
            |  /--
        "#]],
    );
    check(
        "+--[ ]( ä )--\\--[ ]( b )--\\--( )( y )--+\n  $0\n",
        expect![[r#"
            +--[ ]( ä )--\--[ ]( b )--\--( )( y )--+
            |            /--

        "#]],
    );
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n$0\n|  /--[ ]( b )--/            |\n",
        expect![[r#"
            +--\--[ ]( a )--\--( )( y )--+
            | ·
            |  /--[ ]( b )--/            |

        "#]],
    );
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\r\n|  |  |\r\n$0\r\n",
        expect![[r#"
            +--\--[ ]( a )--\--( )( y )--+
            |  |  |
            |  /--

        "#]],
    );
    check(
        "[ ]( b )--\\--[ ]( a )--\n$0\n",
        expect![[r#"
            [ ]( b )--\--[ ]( a )--
                      /--

        "#]],
    );
}

#[test]
fn enter_elsewhere() {
    check(
        "+--[ ]( a )-( )( y )--+\n$0",
        expect![[r#"
            +--[ ]( a )------------------( )( y )--+
            +--
        "#]],
    );
    check(
        "+--[ ]( a )-( )( y )--+\n\n$0\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+--[ ]( a )\n$0--( )( y )--+\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+--[ ]( a\n$0\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "VAR\n$0\nEND_VAR\n",
        expect![[r#"
        VAR
           ·
        END_VAR

    "#]],
    );
    check(
        "VAR\n    a : INT;\n  $0\nEND_VAR\n",
        expect![[r#"
            VAR
                a : INT;
               ·
            END_VAR

        "#]],
    );
    check(
        "VAR\n    a : INT;\nEND_VAR\n$0\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "# comment\n$0\n #\n+-[ ]( a )-+\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+--[ ]( a )--+  # open\n$0",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "\n$0",
        expect![[r#"
        nothing
    "#]],
    );
}

#[test]
fn enter_behind_a_rung_begins_the_next() {
    check(
        "+--[ ]( a )--( )( y )--+\n$0\n\n+--[ ]( x )--( )( z )--+\n",
        expect![[r#"
            +--[ ]( a )--( )( y )--+
            +--

            +--[ ]( x )--( )( z )--+

        "#]],
    );
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( b )--/            |\n$0",
        expect![[r#"
            +--\--[ ]( a )--\------------( )( y )--+
            |  /--[ ]( b )--/                      |
            +--
        "#]],
    );
    // One between two that touch, and once more a line further down.
    check(
        "+--[ ]( a )------------------( )( y )--+\n$0\n+--[ ]( x )------------------( )( z )--+\n",
        expect![[r#"
            +--[ ]( a )------------------( )( y )--+
            +--
            +--[ ]( x )------------------( )( z )--+

        "#]],
    );
    check(
        "+--[ ]( a )------------------( )( y )--+\n+--\n$0\n+--[ ]( x )------------------( )( z )--+\n",
        expect![[r#"
            +--[ ]( a )------------------( )( y )--+

            +--
            +--[ ]( x )------------------( )( z )--+

        "#]],
    );
    check(
        "+--\\--[ ]( a )--\\------------( )( y )--+\n|  /--[ ]( b )--/                      |\n$0\n+--[ ]( x )------------------( )( z )--+\n",
        expect![[r#"
            +--\--[ ]( a )--\------------( )( y )--+
            |  /--[ ]( b )--/                      |
            +--
            +--[ ]( x )------------------( )( z )--+

        "#]],
    );
    // Nothing is known of rails.
    check(
        "--[ ]( a )--( )( y )--\n$0",
        expect![[r#"
        nothing
    "#]],
    );
    // Not finished.
    check(
        "+--[ ]( a )--\n$0",
        expect![[r#"
        nothing
    "#]],
    );
    // Again and again: a line further down, then not at all.
    check(
        "+--[ ]( a )------------------( )( y )--+\n+--\n$0",
        expect![[r#"
        +--[ ]( a )------------------( )( y )--+

        +--
    "#]],
    );
    check(
        "+--[ ]( a )------------------( )( y )--+\n\n+--\n$0",
        expect![[r#"
            +--[ ]( a )------------------( )( y )--+



        "#]],
    );
}

#[test]
fn a_branch_is_drawn_as_it_is_typed() {
    check(
        "+--\\\n$0--[ ]( a )--( )( y )--+\n",
        expect![[r#"
        +--\--[ ]( a )--( )( y )--+
        |  /--

    "#]],
    );
    check(
        "+--[ ]( a )--\\\n$0 --[ ]( b )--( )( y )--+\n\n+--[ ]( x )--+\n",
        expect![[r#"
            +--[ ]( a )--\--[ ]( b )--( )( y )--+
            |            /--

            +--[ ]( x )--+

        "#]],
    );
    check(
        "+--\\--[ ]( a )--( )( y )--+\n|  /--[ ]( b )/$0\n",
        expect![[r#"
            +--\--[ ]( a )--\------------( )( y )--+
            |  /--[ ]( b )--/                      |

        "#]],
    );
    check(
        "+--\\--[ ]( first )--[ ]( second )--( )( y )--+\n|  /--[ ]( b )--/$0\n",
        expect![[r#"
            +--\--[ ]( first )--\--[ ]( second )-------------( )( y )--+
            |  /--[ ]( b )------/                                      |

        "#]],
    );
    check(
        "+--\\--[ ]( first )--[ ]( second )--( )( y )--+\n|  /--[ ]( b )-----------------------/$0\n",
        expect![[r#"
            +--\--[ ]( first )--[ ]( second )--\-------------( )( y )--+
            |  /--[ ]( b )---------------------/                       |

        "#]],
    );
    check(
        "+--\\--[ ]( a )\n|  /--[ ]( b )/$0\n\n+--[ ]( x )------------------( )( z )--+\n",
        expect![[r#"
            +--\--[ ]( a )--\--
            |  /--[ ]( b )--/

            +--[ ]( x )------------------( )( z )--+

        "#]],
    );
    check(
        "+--[ ]( s )--\\--( )( y )--( )( z )--+\n             /--( )( x )/$0\n",
        expect![[r#"
            +--[ ]( s )--\--( )( y )--\--( )( z )--+
            |            /--( )( x )--/            |

        "#]],
    );
    // The `/` of the branch was there.
    check(
        "+--\\--[ ]( a )--( )( y )--+\n|  /--/$0\n",
        expect![[r#"
            +--\--[ ]( a )--( )( y )--+
            |  /--

        "#]],
    );
    // One that has a partner, and one without a branch.
    check(
        "+--[ ]( a )--( )( y )--+\n/$0\n",
        expect![[r#"
        nothing
    "#]],
    );
}

#[test]
fn what_enter_has_begun_is_typed_once_more() {
    const RUNG: &str = "+--[ ]( a )------------------( )( y )--+\n";
    const BRANCH: &str = "+--\\--[ ]( a )--\\--( )( y )--+\n";
    check(
        &format!("{RUNG}+--+$0"),
        expect![[r#"
            +--[ ]( a )------------------( )( y )--+
            +
        "#]],
    );
    check(
        &format!("{RUNG}+--+$0\n\n{RUNG}"),
        expect![[r#"
            +--[ ]( a )------------------( )( y )--+
            +

            +--[ ]( a )------------------( )( y )--+

        "#]],
    );
    check(
        &format!("{RUNG}\n+--#$0\n{RUNG}"),
        expect![[r#"
        +--[ ]( a )------------------( )( y )--+

        #
        +--[ ]( a )------------------( )( y )--+

    "#]],
    );
    check(
        &format!("{BRANCH}|  /--|$0"),
        expect![[r#"
            +--\--[ ]( a )--\--( )( y )--+
            |
        "#]],
    );
    // Another rung, to whose end the branch comes down.
    check(
        &format!("{BRANCH}|  /--+$0"),
        expect![[r#"
            +--\--[ ]( a )--\--( )( y )--+
            +
        "#]],
    );
    check(
        &format!("{BRANCH}|  /--  /$0"),
        expect![[r#"
            +--\--[ ]( a )--\--( )( y )--+
            |  /
        "#]],
    );
    check(
        &format!("{RUNG}+--E$0"),
        expect![[r#"
        +--[ ]( a )------------------( )( y )--+
        E
    "#]],
    );
    check(
        &format!("VAR\n    a : BOOL;\n    END_VAR\n$0\n{RUNG}"),
        expect![[r#"
        VAR
            a : BOOL;
        END_VAR

        +--[ ]( a )------------------( )( y )--+

    "#]],
    );
    // The editor has taken the indent of the line above along.
    check(
        &format!("VAR\n    a : BOOL;\n    END_VAR\n    $0\n{RUNG}"),
        expect![[r#"
            VAR
                a : BOOL;
            END_VAR

            +--[ ]( a )------------------( )( y )--+

        "#]],
    );
    check(
        &format!("  VAR\n$0\n{RUNG}"),
        expect![[r#"
        VAR
           ·
        +--[ ]( a )------------------( )( y )--+

    "#]],
    );
    // A row that only leads past.
    check(
        &format!("{BRANCH}|  /--  |$0"),
        expect![[r#"
        +--\--[ ]( a )--\--( )( y )--+
        |  |
    "#]],
    );
    // Somebody types faster than the answers come.
    check(
        &format!("{RUNG}+--+--[ ]( b )$0"),
        expect![[r#"
        +--[ ]( a )------------------( )( y )--+
        +--[ ]( b )
    "#]],
    );
    check(
        &format!("{BRANCH}|  /--|  /--[ ]( b )$0"),
        expect![[r#"
        +--\--[ ]( a )--\--( )( y )--+
        |  /--[ ]( b )
    "#]],
    );
    check(
        &format!("{RUNG}\n+--# why #$0\n{RUNG}"),
        expect![[r#"
        +--[ ]( a )------------------( )( y )--+

        # why #
        +--[ ]( a )------------------( )( y )--+

    "#]],
    );
    // None of that behind something else, or in front of it.
    check(
        &format!("{RUNG}+---+$0"),
        expect![[r#"
        +--[ ]( a )------------------( )( y )--+
        +--------------------------------------+
    "#]],
    );
    check(
        &format!("{RUNG}+--+$0--( )( y )--+"),
        expect![[r#"
        +--[ ]( a )------------------( )( y )--+
        +--+-------------------------( )( y )--+
    "#]],
    );
    check(
        &format!("{BRANCH}|  /--[ ]( b )|$0"),
        expect![[r#"
        nothing
    "#]],
    );
    check(
        &format!("# in a comment\n+--+$0\n#\n{RUNG}"),
        expect![[r#"
        nothing
    "#]],
    );
}

#[test]
fn enter_behind_a_branch_leaves_the_rail_where_it_is() {
    const ROW: &str = "+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( b )--/\n";
    check(
        &format!("{ROW}$0            |"),
        expect![[r#"
        +--\--[ ]( a )--\------------( )( y )--+
        |  /--[ ]( b )--/                      |
        +--
    "#]],
    );
    check(
        &format!("{ROW}  $0          |\n\n+--[ ]( c )--( )( z )--+\n"),
        expect![[r#"
        +--\--[ ]( a )--\------------( )( y )--+
        |  /--[ ]( b )--/                      |
        +--

        +--[ ]( c )--( )( z )--+

    "#]],
    );
    // Another branch is open.
    check(
        "+--\\--\\--[ ]( a )--\\--\\--( )( y )--+\n|  |  /--[ ]( b )--/\n$0      |\n",
        expect![[r#"
            nothing
        "#]],
    );
    // A rail that somebody draws.
    check(
        &format!("{ROW}|\n$0|\n"),
        expect![[r#"
            nothing
        "#]],
    );
}

#[test]
fn an_enter_that_was_overtaken_is_asked_about_again() {
    const RUNG: &str = "+--[ ]( a )------------------( )( y )--+\n";
    // What was begun on the line above is not wanted.
    check_typed(
        &format!("{RUNG}+--\n# why$0\n{RUNG}"),
        '\n',
        expect![[r#"
            +--[ ]( a )------------------( )( y )--+

            # why
            +--[ ]( a )------------------( )( y )--+

        "#]],
    );
    check_typed(
        &format!("{RUNG}+--# why #\n+--[ ]( b )$0"),
        '\n',
        expect![[r#"
            +--[ ]( a )------------------( )( y )--+
            # why #
            +--[ ]( b )
        "#]],
    );
    check_typed(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  /--|  /--[ ]( b )--/\n+--[ ]( c )$0",
        '\n',
        expect![[r#"
            +--\--[ ]( a )--\--( )( y )--+
            |  /--[ ]( b )--/
            +--[ ]( c )
        "#]],
    );
    // The network above is drawn again, and nothing is begun.
    check_typed(
        "+-[ ]( a )-( )( y )-+\n# why #$0",
        '\n',
        expect![[r#"
            +--[ ]( a )------------------( )( y )--+
            # why #
        "#]],
    );
    check_typed(
        "# open\n+--\n+--[ ]( b )$0",
        '\n',
        expect![[r#"
            nothing
        "#]],
    );
    // A rail that somebody draws is none that was begun.
    check_typed(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  $0",
        '\n',
        expect![[r#"
            nothing
        "#]],
    );
    // A rung that was begun by hand, and a line that an editor has indented.
    check_typed(
        &format!("{RUNG}+--\n  $0[ ]( b )--( )( y )--+\n"),
        '\n',
        expect![[r#"
            nothing
        "#]],
    );
}

#[test]
fn nothing_is_drawn_where_the_formatter_is_switched_off() {
    check(
        "# ladder: fmt off #\n+-[ ](a)-( )(b)-+\n$0",
        expect![[r#"
            nothing
        "#]],
    );
    check(
        "# ladder: fmt off #\n+--\\--[ ]( start )$0--\\--( )( run )--+\n|  /--[ ]( run )--/\n",
        expect![[r#"
            nothing
        "#]],
    );
    check(
        "#ladder: fmt off#\n+-[ ](a)-( )(b)-+\n# ladder: fmt on #\n+-[ ](a)-( )(b)-+\n$0",
        expect![[r#"
            #ladder: fmt off#
            +-[ ](a)-( )(b)-+
            # ladder: fmt on #
            +--[ ]( a )------------------( )( b )--+
            +--
        "#]],
    );
}
