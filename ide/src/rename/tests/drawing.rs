//! The drawing around a new name.

use super::check;
use expect_test::expect;

#[test]
fn the_drawing_follows() {
    check(
        "\
+--\\--[ ]( start )--\\-----------------( )( r$0un )--+
|  /--[ ]( run )----/                             |

+--[ ]( run )--------------------------( )( x )--+
",
        "motor_is_running",
        expect![[r#"
            +--\--[ ]( start )-------------\----------------------( )( motor_is_running )--+
            |  /--[ ]( motor_is_running )--/                                               |

            +--[ ]( motor_is_running )-------------------------------------------( )( x )--+
        "#]],
    );
    check(
        "VAR_INPUT\n    start : BOOL;  # ö #\n    b     : BOOL;\nEND_VAR\n\n+--[ ]( sta$0rt )--( )( b )--+\n",
        "go",
        expect![[r#"
            VAR_INPUT
                go : BOOL;  # ö #
                b  : BOOL;
            END_VAR

            +--[ ]( go )---------------------------------------------------------( )( b )--+
        "#]],
    );
}

#[test]
fn a_network_that_nobody_laid_out_is_left_alone() {
    check(
        "+--[ ]( a$0 )------------------( )( b )--+\n\n+-[ ]( c )-( )( d )-+\n\n+--[ ]( e )------------------( )( f )--+\n",
        "longer",
        expect![[r#"
            +--[ ]( longer )-----------------------------------------------------( )( b )--+

            +-[ ]( c )-( )( d )-+

            +--[ ]( e )------------------( )( f )--+
        "#]],
    );
}

#[test]
fn what_is_as_wide_as_before_moves_nothing() {
    check(
        "VAR a,b:BOOL; END_VAR\n+-[ ]( a$0 )-(S)( b )-+\n",
        "x",
        expect![[r#"
            VAR x,b:BOOL; END_VAR
            +-[ ]( x )-(S)( b )-+
        "#]],
    );
    check(
        "VAR a,b:BOOL; END_VAR\n+-[ ]( a$0 )-(S)( b )-+\n",
        "xy",
        expect![[r#"
            VAR xy,b:BOOL; END_VAR
            +--[ ]( xy )---------------------------------------------------------(S)( b )--+
        "#]],
    );
}
