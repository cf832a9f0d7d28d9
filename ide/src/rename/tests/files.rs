//! Names that several files, or several bodies, have in common.

use super::check;
use expect_test::expect;

#[test]
fn all_files() {
    let plant = "%% a.clad\nVAR_GLOBAL\n    total : DINT;\nEND_VAR\n\
        %% b.clad\nVAR_EXTERNAL\n    total : DINT;\nEND_VAR\n+--[GT]( total, 3 )------------( )( y )--+\n\
        %% c.clad\nVAR total : INT; END_VAR\n+--[GT]( total, 3 )------------( )( y )--+\n";
    check(
        &plant.replace(
            "  total : DINT;\nEND_VAR\n%% b",
            "  tot$0al : DINT;\nEND_VAR\n%% b",
        ),
        "sum",
        expect![[r#"
            %% a.clad
            VAR_GLOBAL
                sum : DINT;
            END_VAR
            %% b.clad
            VAR_EXTERNAL
                sum : DINT;
            END_VAR
            +--[GT]( sum, 3 )----------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        "%% lib.clad\nFUNCTION_BLOCK [$Wait]\nVAR_INPUT\n    raw : BOOL;\nEND_VAR\n+--[ ]( raw )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\
         %% main.clad\n+--[$Wait]( ra$0w := x )-------------( )( y )--+\n",
        "button",
        expect![[r#"
            %% main.clad
            +--------------------------------------------[$Wait]( button := x )--( )( y )--+
            %% lib.clad
            FUNCTION_BLOCK [$Wait]
            VAR_INPUT
                button : BOOL;
            END_VAR
            +--[ ]( button )---------------------------------------------------( )( ENO )--+
            END_FUNCTION_BLOCK
        "#]],
    );
    check(
        "%% lib.clad\nFUNCTION_BLOCK [$Wait]\nVAR_INPUT raw : BOOL; END_VAR\n+--[ ]( raw )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\
         %% main.clad\n+--[$wa$0it]( x )--------------------( )( y )--+\n",
        "Pause",
        expect![[r#"
            %% main.clad
            +-----------------------------------------------------[$Pause]( x )--( )( y )--+
            %% lib.clad
            FUNCTION_BLOCK [$Pause]
            VAR_INPUT raw : BOOL; END_VAR
            +--[ ]( raw )--( )( ENO )--+
            END_FUNCTION_BLOCK
        "#]],
    );
    check(
        "%% lib.clad\n+--<FUN>( count )--+\n%% main.clad\n+--[ ]( a )--------------<CALL>( cou$0nt )--+\n",
        "add_one",
        expect![[r#"
            %% main.clad
            +--[ ]( a )-------------------------------------------------<CALL>( add_one )--+
            %% lib.clad
            +--<FUN>( add_one )------------------------------------------------------------+
        "#]],
    );
}

#[test]
fn labels() {
    check(
        "+--<LBL>( top )--[ ]( a )-----<JMP>( t$0op )--+\n\n+--<FUN>( f )--<JMP>( top )--+\n",
        "again",
        expect![[r#"
            +--<LBL>( again )--[ ]( a )------------------------------------<JMP>( again )--+

            +--<FUN>( f )--<JMP>( top )--+
        "#]],
    );
    // The block jumps to the label of each place where it is.
    check(
        "FUNCTION_BLOCK <$Go>\n+--[ ]( EN )--<JMP>( out )--+\nEND_FUNCTION_BLOCK\n\
         FUNCTION_BLOCK <$Via>\n+--<$Go>--+\nEND_FUNCTION_BLOCK\n\
         +--<$Go>--<LBL>( o$0ut )--+\n+--<FUN>( f )--<$Via>--<LBL>( out )--+\n+--<FUN>( g )--<LBL>( out )--+\n",
        "done",
        expect![[r#"
            FUNCTION_BLOCK <$Go>
            +--[ ]( EN )----------------------------------------------------<JMP>( done )--+
            END_FUNCTION_BLOCK
            FUNCTION_BLOCK <$Via>
            +--<$Go>--+
            END_FUNCTION_BLOCK
            +--<$Go>--<LBL>( done )--------------------------------------------------------+
            +--<FUN>( f )--<$Via>--<LBL>( done )-------------------------------------------+
            +--<FUN>( g )--<LBL>( out )--+
        "#]],
    );
}
