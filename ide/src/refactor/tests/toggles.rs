//! One block in the place of another.

use super::{check, titles};
use expect_test::expect;

#[test]
fn contacts() {
    check(
        "Make",
        "+--[ ]( st$0art )---------------------( )( run )--+\n",
        expect![[r#"
            Make `start` normally closed (changes what the rung does)

            +--[/]( start )----------------------------------------------------( )( run )--+
        "#]],
    );
    titles(
        "+--[/]( sto$0p )---------------------( )( run )--+\n",
        expect![[r#"
            Make `stop` normally open (changes what the rung does)
            Make `stop` a falling-edge contact (changes what the rung does)
            Draw a parallel contact `new_contact_1` around `stop` (no change while it is low)
            Wrap `stop` in a branch, with a copy in parallel (changes nothing yet)
            Declare the undeclared tags of the file
            Extract the network into the function `function_1`
        "#]],
    );
    titles(
        "+--[P]( sto$0p )---------------------( )( run )--+\n",
        expect![[r#"
            Make `stop` a falling-edge contact (changes what the rung does)
            Make `stop` a plain contact (changes what the rung does)
            Draw a parallel contact `new_contact_1` around `stop` (no change while it is low)
            Wrap `stop` in a branch, with a copy in parallel (changes nothing yet) -- [P] has an effect or a memory, and a copy would have them once more
            Declare the undeclared tags of the file
            Extract the network into the function `function_1`
        "#]],
    );
    titles(
        "+--[OS$0R]-------------( )( run )--+\n",
        expect![[r#"
            Take the falling edge (changes what the rung does)
            Draw a parallel contact `new_contact_1` around `[OSR]` (no change while it is low)
            Wrap `[OSR]` in a branch, with a copy in parallel (changes nothing yet) -- [OSR] has an effect or a memory, and a copy would have them once more
            Extract the network into the function `function_1`
        "#]],
    );
    titles(
        "+--[ ]( a[1..$03] )-------------( )( run )--+\nVAR a : ARRAY[1..4] OF BOOL; END_VAR\n",
        expect![[r#"
            Make `a[1..3]` normally closed (changes what the rung does)
            Draw a parallel contact `new_contact_1` around `a[1..3]` (no change while it is low)
            Wrap `a[1..3]` in a branch, with a copy in parallel (changes nothing yet)
            Extract the network into the function `function_1`
        "#]],
    );
}

#[test]
fn comparisons() {
    check(
        "Invert",
        "+--[G$0RT]( a, 5 )---------------------( )( run )--+\n",
        expect![[r#"
            Invert the comparison of `a` (changes what the rung does)

            +--[LEQ]( a, 5 )---------------------------------------------------( )( run )--+
        "#]],
    );
    titles(
        "+--[G$0T]( a, 5, 7 )---------------------( )( run )--+\n",
        expect![[r#"
            Draw a parallel contact `new_contact_1` around `a` (no change while it is low)
            Wrap `a` in a branch, with a copy in parallel (changes nothing yet)
            Declare the undeclared tags of the file
            Extract the network into the function `function_1`
        "#]],
    );
}

#[test]
fn coils() {
    titles(
        "+--[ ]( a )-------------(S)( r$0un )--+\n",
        expect![[r#"
            Reset `run` instead of setting it (changes what the rung does)
            Draw a parallel coil `new_coil_1` next to `run`
            Wrap `run` in a branch, with a copy in parallel (changes nothing yet) -- (S) has an effect or a memory, and a copy would have them once more
            Split the network before `run` (`split_1` carries the power)
            Declare the undeclared tags of the file
            Extract the network into the function `function_1`
        "#]],
    );
    titles(
        "+--[ ]( a )-------------(R)( r$0un )--+\n+--[ ]( b )--[TON]( run, 5s )--( )( y )--+\n",
        expect![[r#"
            Draw a parallel coil `new_coil_1` next to `run`
            Wrap `run` in a branch, with a copy in parallel (changes nothing yet) -- (R) has an effect or a memory, and a copy would have them once more
            Split the network before `run` (`split_1` carries the power)
            Declare the undeclared tags of the file
            Extract the network into the function `function_1`
        "#]],
    );
}
