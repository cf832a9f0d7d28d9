use super::{declaration, definition, implementation, type_definition};
use crate::fixture::Fixture;
use expect_test::{Expect, expect};

fn check(text: &str, expected: Expect) {
    let fixture = Fixture::new(text);
    let (context, offset, others) = fixture.ask();
    let all = [
        ("definition", definition(context, offset, &others)),
        ("declaration", declaration(context, offset, &others)),
        ("type", type_definition(context, offset, &others)),
        ("implementation", implementation(context, offset, &others)),
    ];
    let mut shown = String::new();
    for (what, targets) in all {
        for target in targets {
            let focus = fixture.show(&target.file, target.focus);
            shown += &format!("{what}: {focus}");
            if target.range != target.focus {
                shown += &format!(" in {}", fixture.show(&target.file, target.range));
            }
            shown += "\n";
        }
    }
    expected.assert_eq(&shown);
}

#[test]
fn tags() {
    check(
        "VAR_INPUT\n    start, stop : BOOL;\nEND_VAR\n+--[ ]( st$0op )--( )( run )--+\n",
        expect![[r#"
            definition: main.clad:2:12 stop in main.clad:2:5 start, stop : BOOL;
            declaration: main.clad:2:12 stop in main.clad:2:5 start, stop : BOOL;
        "#]],
    );
    check(
        "+--[ ]( start )--[ ]( ru$0n )--+\n+--[ ]( run )--( )( run )--+\n+--[ ]( a )--(R)( run )--+\n",
        expect![[r#"
            definition: main.clad:2:21 run
            definition: main.clad:3:19 run
            declaration: main.clad:2:21 run
            declaration: main.clad:3:19 run
            implementation: main.clad:2:21 run
            implementation: main.clad:3:19 run
        "#]],
    );
    check(
        "+--[ ]( start )--[ ]( start$0 )--( )( y )--+\n",
        expect![[r#"
        definition: main.clad:1:9 start
        declaration: main.clad:1:9 start
    "#]],
    );
    check(
        "VAR lamp AT %QX0.1 : BOOL; END_VAR\n+--[ ]( a )--( )( %Q$0X0.1 )--+\n",
        expect![[r#"
            definition: main.clad:1:5 lamp in main.clad:1:5 lamp AT %QX0.1 : BOOL;
            declaration: main.clad:1:5 lamp in main.clad:1:5 lamp AT %QX0.1 : BOOL;
            implementation: main.clad:2:19 %QX0.1
        "#]],
    );
    check(
        "VAR t : TON; END_VAR\n+--[ ]( a )--[TON]( t, 5s )--+\n+--[ ]( t.D$0N )--( )( y )--+\n",
        expect![[r#"
            definition: main.clad:1:5 t in main.clad:1:5 t : TON;
            declaration: main.clad:1:5 t in main.clad:1:5 t : TON;
            type: main.clad:2:14 [TON] in main.clad:2:14 [TON]( t, 5s )
            implementation: main.clad:2:21 t
        "#]],
    );
}

#[test]
fn other_files() {
    check(
        "%% lib.clad\nVAR_GLOBAL total : DINT; END_VAR\n\
         %% main.clad\nVAR_EXTERNAL total : DINT; END_VAR\n+--[ADD]( total$0, total, 1 )--+\n",
        expect![[r#"
            definition: lib.clad:1:12 total in lib.clad:1:12 total : DINT;
            declaration: main.clad:1:14 total in main.clad:1:14 total : DINT;
            implementation: main.clad:2:11 total
        "#]],
    );
    check(
        "%% lib.clad\n+--<FUN>( count )--[ ]( a )--+\n+--[ADD]( n, n, 1 )--+\n\n\
         %% main.clad\n+--<CALL>( cou$0nt )--+\n",
        expect![[r#"
            definition: lib.clad:1:11 count in lib.clad:1:1 +--<FUN>( count )--[ ]( a )--+ ... +--[ADD]( n, n, 1 )--+
            declaration: lib.clad:1:11 count in lib.clad:1:1 +--<FUN>( count )--[ ]( a )--+ ... +--[ADD]( n, n, 1 )--+
            implementation: lib.clad:1:1 +--<FUN>( count )--[ ]( a )--+ ... +--[ADD]( n, n, 1 )--+
        "#]],
    );
    check(
        "%% lib.clad\n# waits #\nFUNCTION_BLOCK [$Wait]\nVAR_INPUT raw : BOOL; END_VAR\n+--[ ]( raw )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\
         %% main.clad\n+--[$wa$0it]( x )--( )( y )--+\n",
        expect![[r#"
            definition: lib.clad:2:17 $Wait in lib.clad:2:1 FUNCTION_BLOCK [$Wait] ... END_FUNCTION_BLOCK
            declaration: lib.clad:2:17 $Wait in lib.clad:2:1 FUNCTION_BLOCK [$Wait] ... END_FUNCTION_BLOCK
            type: lib.clad:2:17 $Wait in lib.clad:2:1 FUNCTION_BLOCK [$Wait] ... END_FUNCTION_BLOCK
            implementation: lib.clad:4:1 +--[ ]( raw )--( )( ENO )--+ in lib.clad:2:1 FUNCTION_BLOCK [$Wait] ... END_FUNCTION_BLOCK
        "#]],
    );
    check(
        "%% lib.clad\nFUNCTION_BLOCK [$Wait]\nVAR_INPUT raw : BOOL; END_VAR\nVAR_OUTPUT out : BOOL; END_VAR\n+--[ ]( raw )--( )( out )--+\nEND_FUNCTION_BLOCK\n\
         %% main.clad\n+--[$wait]( raw := x, ou$0t => z )--( )( y )--+\n",
        expect![[r#"
            definition: lib.clad:3:12 out in lib.clad:3:12 out : BOOL;
            declaration: lib.clad:3:12 out in lib.clad:3:12 out : BOOL;
            implementation: lib.clad:4:21 out
        "#]],
    );
}

#[test]
fn labels_and_functions() {
    check(
        "+--[ ]( a )--<JMP>( do$0ne )--+\n+--[ ]( b )--( )( c )--+\n\n+--<LBL>( done )--+\n",
        expect![[r#"
            definition: main.clad:4:11 done in main.clad:4:1 +--<LBL>( done )--+
            declaration: main.clad:4:11 done in main.clad:4:1 +--<LBL>( done )--+
            implementation: main.clad:4:11 done in main.clad:4:1 +--<LBL>( done )--+
        "#]],
    );
    check(
        "+--<CALL>( f$0 )--+\n+--<FUN>( f )--+\n+--[ ]( a )--\\--( )( b )--+\n|            /--( )( c )--+\n+--<FUN>( g )--+\n",
        expect![[r#"
            definition: main.clad:2:11 f in main.clad:2:1 +--<FUN>( f )--+ ... |            /--( )( c )--+
            declaration: main.clad:2:11 f in main.clad:2:1 +--<FUN>( f )--+ ... |            /--( )( c )--+
            implementation: main.clad:2:1 +--<FUN>( f )--+ ... |            /--( )( c )--+
        "#]],
    );
}

#[test]
fn nothing_to_go_to() {
    check("+--[TO$0N]( t, 5s )--+\n", expect![[""]]);
    check("+-$0-[ ]( a )--+\n", expect![[""]]);
    check("+--[ ]( SYS.ON$0 )--+\n", expect![[""]]);
    check("+--<CALL>( nothing$0 )--+\n", expect![[""]]);
    check("+--[$None$0]( a )--+\n", expect![[""]]);
}

#[test]
fn blocks_of_the_library() {
    check(
        "+--[$Deb$0ounce]( button )--( )( y )--+\n",
        expect![[r#"
        definition: library://Debounce.clad:3:17 $Debounce in library://Debounce.clad:3:1 FUNCTION_BLOCK [$Debounce] ... END_FUNCTION_BLOCK
        declaration: library://Debounce.clad:3:17 $Debounce in library://Debounce.clad:3:1 FUNCTION_BLOCK [$Debounce] ... END_FUNCTION_BLOCK
        type: library://Debounce.clad:3:17 $Debounce in library://Debounce.clad:3:1 FUNCTION_BLOCK [$Debounce] ... END_FUNCTION_BLOCK
        implementation: library://Debounce.clad:14:1 +--[ ]( EN )--[ ]( raw )--------------------[TON]( high, wait )--(S)( clean )--+ ... +--[ ]( clean )----------------------------------------------------( )( ENO )--+ in library://Debounce.clad:3:1 FUNCTION_BLOCK [$Debounce] ... END_FUNCTION_BLOCK
    "#]],
    );
    check(
        "+--[$Debounce]( button, wa$0it := 5ms )--( )( y )--+\n",
        expect![[r#"
        definition: library://Debounce.clad:6:5 wait in library://Debounce.clad:6:5 wait : TIME := T#20ms;
        declaration: library://Debounce.clad:6:5 wait in library://Debounce.clad:6:5 wait : TIME := T#20ms;
        implementation: main.clad:1:25 wait
    "#]],
    );
}

/// A block of the workspace's own takes the place of the library's.
#[test]
fn an_own_block_comes_first() {
    check(
        "+--[$Deb$0ounce]( button )--( )( y )--+\n%% own.clad\nFUNCTION_BLOCK [$DEBOUNCE]\nVAR_INPUT a : BOOL; END_VAR\nEND_FUNCTION_BLOCK\n",
        expect![[r#"
            definition: own.clad:1:17 $DEBOUNCE in own.clad:1:1 FUNCTION_BLOCK [$DEBOUNCE] ... END_FUNCTION_BLOCK
            declaration: own.clad:1:17 $DEBOUNCE in own.clad:1:1 FUNCTION_BLOCK [$DEBOUNCE] ... END_FUNCTION_BLOCK
            type: own.clad:1:17 $DEBOUNCE in own.clad:1:1 FUNCTION_BLOCK [$DEBOUNCE] ... END_FUNCTION_BLOCK
            implementation: own.clad:1:17 $DEBOUNCE in own.clad:1:1 FUNCTION_BLOCK [$DEBOUNCE] ... END_FUNCTION_BLOCK
        "#]],
    );
}

#[test]
fn types_members_and_values() {
    let types = "TYPE\n    Phase : (IDLE, FILLING, MIXING := 10);\n    Motor : STRUCT\n        speed   : REAL;\n        running : BOOL;\n        delay   : TON;\n    END_STRUCT;\nEND_TYPE\n\nVAR\n    pump  : Motor := (speed := 20.0);\n    lines : ARRAY[1..4] OF Motor;\n    step  : Phase := FILLING;\n    k     : INT;\nEND_VAR\n\n";
    let check = |rest: &str, expected: Expect| check(&format!("{types}{rest}"), expected);
    check(
        "+--[ ]( pump.runn$0ing )--( )( Q1 )--+\n",
        expect![[r#"
        definition: main.clad:5:9 running
        declaration: main.clad:5:9 running
    "#]],
    );
    check(
        "+--[EQ]( step, FILL$0ING )--( )( Q1 )--+\n",
        expect![[r#"
            definition: main.clad:2:20 FILLING
            declaration: main.clad:2:20 FILLING
            type: main.clad:2:5 Phase
        "#]],
    );
    check(
        "+--[ ]( li$0nes[k].running )--( )( Q1 )--+\n",
        expect![[r#"
        definition: main.clad:12:5 lines in main.clad:12:5 lines : ARRAY[1..4] OF Motor;
        declaration: main.clad:12:5 lines in main.clad:12:5 lines : ARRAY[1..4] OF Motor;
        type: main.clad:3:5 Motor
    "#]],
    );
}
