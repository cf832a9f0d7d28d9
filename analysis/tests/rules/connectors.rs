//! Connectors without a partner.

use crate::check::{check, clean};
use expect_test::expect;

#[test]
fn nothing_below_or_above() {
    check("+--[ ]( a )--\\--( )( y )--+\n", expect![[r#""#]]);
    check("+--[ ]( a )--( )( y )--+\n|  /--[ ]( b )--\n", expect![[r#""#]]);
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  ---[ ]( b )---            |\n",
        expect![[r#""#]],
    );
}

#[test]
fn one_too_many() {
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( b )---            |\n",
        expect![[r#""#]],
    );
    // The columns say that the first one lacks its partner, the order says it is the second.
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  ---[ ]( b )--/            |\n",
        expect![[r#""#]],
    );
    check(
        "+-----[ ]( a )--\\--( )( y )--+\n|  /--[ ]( b )--/            |\n",
        expect![[r#""#]],
    );
}

#[test]
fn in_the_middle_of_three() {
    check(
        "+--\\--[ ]( a )-----\\--( )( y )--+\n|  /--\\--[ ]( b )--/            |\n|     /--[ ]( c )--/            |\n",
        expect![[r#""#]],
    );
}

#[test]
fn no_other_rule_follows() {
    // Without its partner the branch has no power: that is the same mistake.
    check(
        "+--[ ]( a )--\\--( )( y )--+\n|                         |\n|            ---( )( z )--+\n",
        expect![[r#""#]],
    );
    check("+--[ ]( a --\\--( )( y )--+\n", expect![[r#""#]]);
}

#[test]
fn pairs() {
    clean("+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( b )--/            |\n");
    // Columns do not matter.
    clean("+--\\--[ ]( a )--\\--( )( y )--+\n|     /--[ ]( b )--/            |\n");
}
