//! What is offered where a rule without a fix of its own finds something: every offer, with the text after it.

use crate::refactor::quick_fixes;
use expect_test::{Expect, expect};
use ladder_analysis::analyze;
use ladder_format::{Options, apply};
use ladder_syntax::parse;
use std::fmt::Write;
use std::sync::Arc;

/// The suggestions for the findings of a rule; each leaves a text without that finding.
#[track_caller]
fn check(rule: &str, text: &str, expected: Expect) {
    let analysis = analyze(&Arc::new(parse(text)), "test.clad");
    let mut shown = String::new();
    let of_rule = analysis
        .findings()
        .iter()
        .filter(|found| found.rule.name() == rule);
    for found in of_rule {
        let _ = writeln!(shown, "{}", found.diagnostic().message);
        for action in quick_fixes(&analysis, found.range) {
            let of_it = action.finding.map(|index| analysis.findings()[index].rule.name());
            // The comments that allow it have tests of their own.
            if of_it != Some(rule) || action.title.starts_with("Allow") {
                continue;
            }
            assert!(!action.preferred, "{} is never made unasked", action.title);
            let after = apply(text, &action.aligned(&analysis, text, &Options::default()));
            let _ = writeln!(shown, "> {}\n{after}", action.title);
        }
    }
    expected.assert_eq(&shown);
}

#[test]
fn the_coils_of_a_tag_are_combined() {
    check(
        "double-coil",
        r"# by hand #
+--[ ]( hand )--[ ]( start )--( )( pump )--+  # old #

+--[ ]( a )--( )( z )--+

# automatic #
+--[ ]( auto )--\--[ ]( level )--\--( )( pump )--+
|               /--[TON]( t, 5s )--/             |
",
        expect![[r#"
            `pump` is written by 2 coils: the last one alone decides
            > Combine the 2 coils of `pump` into one (changes what the program does)
            +--[ ]( a )----------------------------------------------------------( )( z )--+

            # by hand #
            # automatic #
            +--\--[ ]( hand )--[ ]( start )--------------------------------\--( )( pump )--+  # old #
            |  /--[ ]( auto )--\--[ ]( level )--------------------------\--/               |
            |                  /------------------------[TON]( t, 5s )--/                  |

        "#]],
    );
    check(
        "double-coil",
        r"+--[ ]( a )--( )( y )--+
+--\--[ ]( b )--\--( )( y )--+
|  /--[ ]( c )--/            |
+--[ ]( d )--( )( y )--+
",
        expect![[r#"
            `y` is written by 3 coils: the last one alone decides
            > Combine the 3 coils of `y` into one (changes what the program does)
            +--\--[ ]( a )--------------\----------------------------------------( )( y )--+
            |  /--\--[ ]( b )--------\--/                                                  |
            |     /--\--[ ]( c )--\--/                                                     |
            |        /--[ ]( d )--/                                                        |

        "#]],
    );
    // What cannot be one rung: another kind of coil, another output on the rung.
    check(
        "double-coil",
        r"+--[ ]( a )--( )( y )--+
+--[ ]( b )--(/)( y )--+
+--[ ]( c )--( )( x )--+
+--[ ]( d )--\--( )( x )--+
|            /--( )( z )--+
",
        expect![[r#"
            `y` is written by 2 coils: the last one alone decides
            `x` is written by 2 coils: the last one alone decides
        "#]],
    );
}

#[test]
fn a_contact_after_a_coil_gets_a_branch() {
    check(
        "contact-after-coil",
        r"+--[ ]( a )--( )( y )--[ ]( b )--( )( z )--+

+--[ ]( c )--(S)( x )--( )( w )--\--[ ]( d )--\--( )( v )--+
|                                /--[ ]( e )--/            |
",
        expect![[r#"
            [ ]( b ) is after a coil: readers look for it left of the coils
            > Draw a branch before the coil `y`
            +--[ ]( a )--\----------------------------------------------------( )( y )--\--+
            |            /--[ ]( b )------------------------------------------( )( z )--/  |

            +--[ ]( c )--(S)( x )--( )( w )--\--[ ]( d )--\--( )( v )--+
            |                                /--[ ]( e )--/            |

            [ ]( d ) is after a coil: readers look for it left of the coils
            > Draw a branch before the coil `x` (changes what the rung does)
            +--[ ]( a )--( )( y )--[ ]( b )--( )( z )--+

            +--[ ]( c )--\------------------------------------------(S)( x )--( )( w )--\--+
            |            /--\--[ ]( d )--\------------------------------------( )( v )--/  |
            |               /--[ ]( e )--/                                                 |

        "#]],
    );
}

#[test]
fn a_dead_end() {
    check(
        "dead-end",
        r"VAR a, b, c, y : BOOL; END_VAR

+--\--[ ]( a )-----------------------( )( y )--+
|  /--[ ]( b )--[ ]( c )                       |
",
        expect![[r#"
            the power of [ ]( b ) goes nowhere: nothing that acts is after it
            > Join it to the line above, as a parallel branch
            VAR a, b, c, y : BOOL; END_VAR

            +--\--[ ]( a )------------\------------------------------------------( )( y )--+
            |  /--[ ]( b )--[ ]( c )--/                                                    |

            > Put a coil `new_coil_1` after it
            VAR
                a, b, c, y : BOOL;
                new_coil_1 : BOOL;
            END_VAR

            +--\--[ ]( a )-------------------------------------------------------( )( y )--+
            |  /--[ ]( b )--[ ]( c )------------------------------------( )( new_coil_1 )--+

            > Remove `b`, whose power nothing uses
            VAR a, b, c, y : BOOL; END_VAR

            +--[ ]( a )----------------------------------------------------------( )( y )--+

        "#]],
    );
    check(
        "dead-end",
        r"+--[ ]( a )--\--[ ]( b )--( )( y )--+
|            /---                   |
",
        expect![[r#"
            this wire ends at nothing
            > Put a coil `new_coil_1` after it
            +--[ ]( a )--\--[ ]( b )---------------------------------------------( )( y )--+
            |            /----------------------------------------------( )( new_coil_1 )--+

            > Remove the wire, whose power nothing uses
            +--[ ]( a )--[ ]( b )------------------------------------------------( )( y )--+

        "#]],
    );
}

#[test]
fn a_line_that_begins_with_nothing() {
    check(
        "open-wire",
        r"+--[ ]( a )--\--( )( y )--+
|  --[ ]( b )--/          |
",
        expect![[r#"
            no power can reach this wire: it begins neither at the left rail nor at a connector
            > Begin at the left rail
            +--[ ]( a )--\-------------------------------------------------------( )( y )--+
            +--[ ]( b )--/                                                                 |

            > Begin it as a branch of the line above
            +--\--[ ]( a )--\----------------------------------------------------( )( y )--+
            |  /--[ ]( b )--/                                                              |

        "#]],
    );
    check(
        "open-wire",
        r"+--[ ]( a )--\--( )( y )--+
|--[ ]( b )--/            |
",
        expect![[r#"
            no power can reach this wire: it begins neither at the left rail nor at a connector
            > Begin at the left rail
            +--[ ]( a )--\-------------------------------------------------------( )( y )--+
            +--[ ]( b )--/                                                                 |

        "#]],
    );
}

#[test]
fn what_never_or_always_conducts() {
    check(
        "constant-power",
        r"+--[ ]( a )--[ ]( b )--[/]( a )--( )( y )--+

+--\--[ ]( a )--\--[ ]( c )--( )( z )--+
|  /--[/]( a )--/                      |

+--[GE]( n, n )--( )( x )--+
",
        expect![[r#"
            no power ever comes through here: when this conducts, what is before it does not
            > Draw a wire in the place of `[/]( a )`
            +--[ ]( a )--[ ]( b )------------------------------------------------( )( y )--+

            +--\--[ ]( a )--\--[ ]( c )--( )( z )--+
            |  /--[/]( a )--/                      |

            +--[GE]( n, n )--( )( x )--+

            > Draw a wire in the place of `[ ]( a )`
            +--[ ]( b )--[/]( a )------------------------------------------------( )( y )--+

            +--\--[ ]( a )--\--[ ]( c )--( )( z )--+
            |  /--[/]( a )--/                      |

            +--[GE]( n, n )--( )( x )--+

            one of these branches always conducts: together they are a bare wire
            > Draw a wire instead of the branches
            +--[ ]( a )--[ ]( b )--[/]( a )--( )( y )--+

            +--[ ]( c )----------------------------------------------------------( )( z )--+

            +--[GE]( n, n )--( )( x )--+

            [GE]( n, n ) always conducts
            > Draw a wire in its place
            +--[ ]( a )--[ ]( b )--[/]( a )--( )( y )--+

            +--\--[ ]( a )--\--[ ]( c )--( )( z )--+
            |  /--[/]( a )--/                      |

            +--------------------------------------------------------------------( )( x )--+

        "#]],
    );
}

#[test]
fn what_decides_nothing() {
    check(
        "redundant-element",
        r"+--[ ]( a )--\--[ ]( a )--[ ]( b )--\--( )( y )--+
|            /--[ ]( c )------------/            |
",
        expect![[r#"
            [ ]( a ) changes nothing here
            > Draw a wire in its place
            +--[ ]( a )--\--[ ]( b )--\------------------------------------------( )( y )--+
            |            /--[ ]( c )--/                                                    |

        "#]],
    );
    check(
        "shorted-branch",
        r"+--[ ]( a )--\--[ ]( b )--\--( )( y )--+
|            /------------/            |
",
        expect![[r#"
            a bare wire next to [ ]( b ) shorts it: it decides nothing
            > Remove the branch with `b`
            +--[ ]( a )----------------------------------------------------------( )( y )--+

        "#]],
    );
    check(
        "duplicate-branch",
        r"+--\--[ ]( a )--\--( )( y )--+
|  /--[ ]( a )--/            |
",
        expect![[r#"
            this branch conducts in the same cases as the one above it: one of them is enough
            > Remove the branch with `a`
            +--[ ]( a )----------------------------------------------------------( )( y )--+

        "#]],
    );
}

#[test]
fn a_block_on_a_timer_of_another_gets_one_of_its_own() {
    check(
        "duplicate-timer",
        "VAR a, b, y, z : BOOL; warmup : TON; END_VAR\n+--[ ]( a )--[TON]( warmup, T#5s )--( )( y )--+\n\n+--[ ]( b )--[TON]( warmup, T#5s )--( )( z )--+\n",
        expect![[r#"
            the timer `warmup` has a second block: both would work on one TON
            > Give this block a timer of its own: `warmup_1`
            VAR
                a, b, y, z : BOOL;
                warmup     : TON;
                warmup_1   : TON;
            END_VAR
            +--[ ]( a )--[TON]( warmup, T#5s )--( )( y )--+

            +--[ ]( b )---------------------------------[TON]( warmup_1, T#5s )--( )( z )--+

        "#]],
    );
    check(
        "duplicate-timer",
        "+--[ ]( a )--[TON]( t1, T#5s )--( )( y )--+\n\n+--[ ]( b )--[TON]( t1, T#5s )--( )( z )--+\n",
        expect![[r#"
            the timer `t1` has a second block: both would work on one TON
            > Give this block a timer of its own: `t2`
            +--[ ]( a )--[TON]( t1, T#5s )--( )( y )--+

            +--[ ]( b )---------------------------------------[TON]( t2, T#5s )--( )( z )--+

        "#]],
    );
    check(
        "duplicate-counter",
        "TYPE\n    Part : STRUCT\n        n : CTU;\n    END_STRUCT;\nEND_TYPE\nVAR\n    p : ARRAY[1..2] OF Part;\nEND_VAR\n+--[CTU]( p[1].n, 10 )--( )( y )--+\n\n+--[CTU]( p[1].n, 10 )--( )( z )--+\n",
        expect![[r#"
            the counter `p[1].n` has a second block: both would work on one CTU
            > Give this block a counter of its own: `n_1`
            TYPE
                Part : STRUCT
                    n : CTU;
                END_STRUCT;
            END_TYPE
            VAR
                p   : ARRAY[1..2] OF Part;
                n_1 : CTU;
            END_VAR
            +--[CTU]( p[1].n, 10 )--( )( y )--+

            +--------------------------------------------------[CTU]( n_1, 10 )--( )( z )--+

        "#]],
    );
    check(
        "duplicate-instance",
        "FUNCTION_BLOCK [$X]\nVAR n : DINT; END_VAR\n+--[ADD]( n, n, 1 )--( )( ENO )--+\nEND_FUNCTION_BLOCK\nVAR x : $X; END_VAR\n+--[$X]( x )--( )( y )--+\n\n+--[$X]( x )--( )( z )--+\n",
        expect![[r#"
            a second [$X] works on `x`: what one does the other sees
            > Give this block a state of its own: `x_1`
            FUNCTION_BLOCK [$X]
            VAR n : DINT; END_VAR
            +--[ADD]( n, n, 1 )--( )( ENO )--+
            END_FUNCTION_BLOCK
            VAR
                x   : $X;
                x_1 : $X;
            END_VAR
            +--[$X]( x )--( )( y )--+

            +-------------------------------------------------------[$X]( x_1 )--( )( z )--+

        "#]],
    );
}
