//! New names that are refused.

use super::check;
use expect_test::expect;

#[test]
fn names_that_something_else_has() {
    let plant = "%% a.clad\nVAR_GLOBAL total : DINT; END_VAR\n+--<FUN>( count )--+\n\
        FUNCTION_BLOCK [$Hold]\nEND_FUNCTION_BLOCK\n\
        %% b.clad\nVAR mine : DINT; END_VAR\n+--[GT]( total, mine )--( )( y )--+\n+--<LBL>( l )--<JMP>( m )--+\n\
        +--<FUN>( own )--+\nFUNCTION_BLOCK [$Own]\nVAR_INPUT i : BOOL; END_VAR\nEND_FUNCTION_BLOCK\n\
        %% c.clad\n+--[ ]( other )--( )( y )--+\n";
    let at = |place: &str| plant.replacen(place, &format!("{place}$0"), 1);
    check(
        &at("VAR mine"),
        "total",
        expect![[r#"
        refused: there is a tag `total` in a.clad already: both would become one
    "#]],
    );
    check(
        &at("VAR mine"),
        "y",
        expect![[r#"
        refused: there is a tag `y` on line 2 of b.clad already: both would become one
    "#]],
    );
    check(
        &at("VAR_GLOBAL total"),
        "other",
        expect![[r#"
        refused: there is a tag `other` on line 1 of c.clad already: both would become one
    "#]],
    );
    check(
        &at("VAR_GLOBAL total"),
        "mine",
        expect![[r#"
        refused: there is a tag `mine` on line 1 of b.clad already: both would become one
    "#]],
    );
    check(
        &at("<FUN>( own"),
        "count",
        expect![[r#"
        refused: there is a function `count` on line 2 of a.clad already: both would become one
    "#]],
    );
    check(
        &at("<FUN>( count"),
        "own",
        expect![[r#"
        refused: there is a function `own` on line 4 of b.clad already: both would become one
    "#]],
    );
    check(
        &at("[$Own"),
        "hold",
        expect![[r#"
        refused: there is a user-defined block `$hold` on line 3 of a.clad already: both would become one
    "#]],
    );
    check(
        &at("<LBL>( l"),
        "m",
        expect![[r#"
        refused: the jump on line 3 of b.clad names `m`, which is not there: it would mean this one
    "#]],
    );
    // A body's own tag may hide a global one that it does not name.
    check(
        &at("VAR_INPUT i"),
        "total",
        expect![[r#"
            %% b.clad
            VAR mine : DINT; END_VAR
            +--[GT]( total, mine )--( )( y )--+
            +--<LBL>( l )--<JMP>( m )--+
            +--<FUN>( own )--+
            FUNCTION_BLOCK [$Own]
            VAR_INPUT total : BOOL; END_VAR
            END_FUNCTION_BLOCK
        "#]],
    );
    // Another case of the same name is the same name.
    check(
        "+--[ ]( Run$0 )---------------------( )( rUN )--+\n",
        "RUN",
        expect![[r#"
            +--[ ]( RUN )---------------------( )( RUN )--+
        "#]],
    );
}

#[test]
fn names_that_are_refused() {
    let tag = "VAR a, b : BOOL; END_VAR\n+--[ ]( a$0 )--( )( b )--+\n";
    for (new, expected) in [
        (
            "",
            expect![[r#"
            refused: a name is needed
        "#]],
        ),
        (
            "1a",
            expect![[r#"
            refused: `1a` is not a name: write a letter or `_`, then letters, digits and `_`
        "#]],
        ),
        (
            "a b",
            expect![[r#"
            refused: `a b` is not a name: write a letter or `_`, then letters, digits and `_`
        "#]],
        ),
        (
            "true",
            expect![[r#"
            refused: `true` is a word of the language: choose another name
        "#]],
        ),
        (
            "Var",
            expect![[r#"
            refused: `Var` is a word of the language: choose another name
        "#]],
        ),
        (
            "B",
            expect![[r#"
            refused: there is a tag `B` on line 1 of main.clad already: both would become one
        "#]],
        ),
    ] {
        check(tag, new, expected);
    }
    let block = "FUNCTION_BLOCK [$B]\nVAR_INPUT raw$0 : BOOL; END_VAR\n+--[ ]( raw )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n";
    check(
        block,
        "eno",
        expect![[r#"
        refused: a block has `eno` of its own: choose another name
    "#]],
    );
    let block = block.replace("raw$0", "raw").replace("[$B]", "[$$0B]");
    check(
        &block,
        "$B_1_",
        expect![[r#"
            refused: `$B_1_` cannot name a block: write `$`, a letter, then letters, digits and `_` (not last, not two together)
        "#]],
    );
    check(
        &block,
        "1",
        expect![[r#"
            refused: `1` cannot name a block: write `$`, a letter, then letters, digits and `_` (not last, not two together)
        "#]],
    );
    check(
        "+--[ ]( a$0 )--<CALL>( f )--+\n",
        "é",
        expect![[r#"
            +--[ ]( é )--<CALL>( f )--+
        "#]],
    );
}
