use super::references;
use crate::fixture::Fixture;
use expect_test::{Expect, expect};

fn check(text: &str, expected: Expect) {
    let fixture = Fixture::new(text);
    let (context, offset, others) = fixture.ask();
    let shown: Vec<String> = references(context, offset, &others)
        .iter()
        .map(|it| format!("{} {:?}\n", fixture.show(&it.file, it.range), it.usage))
        .collect();
    expected.assert_eq(&shown.concat());
}

#[test]
fn a_tag_is_read_and_written() {
    check(
        "VAR run$0 : BOOL; END_VAR\n+--[ ]( start )--( )( RUN )--+\n+--[ ]( run )--[ADD]( n, n, 1 )--+\n",
        expect![[r#"
            main.clad:1:5 run Definition
            main.clad:2:23 RUN Write
            main.clad:3:9 run Read
        "#]],
    );
    check(
        "+--[ADD]( $0n, n, 1 )--[MOV]( a[n], a[2] )--[CALC]( y, -( n + N ) )--+\n",
        expect![[r#"
            main.clad:1:11 n Write
            main.clad:1:14 n Read
            main.clad:1:31 n Read
            main.clad:1:57 n Read
            main.clad:1:61 N Read
        "#]],
    );
}

#[test]
fn members_and_bits() {
    check(
        "+--[ ]( a )--[TON]( t, 5s )--( )( t.$0Q )--+\n+--[ ]( t.dn )--[ ]( t.ET )--( )( x )--+\n",
        expect![[r#"
            main.clad:1:37 Q Write
            main.clad:2:11 dn Read
        "#]],
    );
    check(
        "+--[ ]( t.Q )--[TON]( $0t, 5s )--+\n",
        expect![[r#"
        main.clad:1:9 t Read
        main.clad:1:23 t ReadWrite
    "#]],
    );
    check(
        "+--[ ]( w.3 )--( )( w.$03 )--[MOV]( w, 4 )--+\n",
        expect![[r#"
        main.clad:1:11 3 Read
        main.clad:1:23 3 Write
    "#]],
    );
    check(
        "+--[ ]( SYS.$0ON )--[ ]( sys.on )--( )( y )--+\n",
        expect![[r#"
        main.clad:1:9 SYS.ON Read
        main.clad:1:24 sys.on Read
    "#]],
    );
}

#[test]
fn a_body_has_names_of_its_own() {
    check(
        "FUNCTION_BLOCK [$Hold]\nVAR_INPUT raw : BOOL; END_VAR\nVAR_OUTPUT out : BOOL; END_VAR\n\
         +--[ ]( raw )--( )( out )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\
         +--[ ]( raw )--[$Hold]( raw := x, out => y$0 )--( )( y )--+\n",
        expect![[r#"
            main.clad:6:42 y Write
            main.clad:6:52 y Write
        "#]],
    );
    let hold = |cursor: &str| {
        format!(
            "%% hold.clad\nFUNCTION_BLOCK [$Hold]\nVAR_INPUT raw : BOOL; END_VAR\nVAR_OUTPUT out : BOOL; END_VAR\n\
             +--[ ]( {cursor} )--( )( out )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\
             %% main.clad\n+--[ ]( raw )--[$hold]( RAW := x, out => y )--( )( y )--+\n"
        )
    };
    check(
        &hold("r$0aw"),
        expect![[r#"
        hold.clad:2:11 raw Definition
        hold.clad:4:9 raw Read
        main.clad:1:25 RAW Write
    "#]],
    );
    check(
        &hold("raw").replace("out => y", "out$0 => y"),
        expect![[r#"
        main.clad:1:35 out Read
        hold.clad:3:12 out Definition
        hold.clad:4:21 out Write
    "#]],
    );
    check(
        &hold("raw").replace("[$hold]", "[$h$0old]"),
        expect![[r#"
        main.clad:1:17 $hold Mention
        hold.clad:1:17 $Hold Definition
    "#]],
    );
    check(
        &hold("raw").replace("[$Hold]", "[$Hold$0]"),
        expect![[r#"
        hold.clad:1:17 $Hold Definition
        main.clad:1:17 $hold Mention
    "#]],
    );
}

#[test]
fn globals_are_one_tag_in_all_files() {
    check(
        "%% a.clad\nVAR_GLOBAL total : DINT; END_VAR\n\
         %% b.clad\nVAR_EXTERNAL Total : DINT; END_VAR\n+--[ADD]( total, to$0tal, 1 )--+\n\
         %% c.clad\n+--[GT]( total, 3 )--( )( y )--+\n\
         %% d.clad\nVAR total : DINT; END_VAR\n+--[GT]( total, 3 )--( )( y )--+\n",
        expect![[r#"
            b.clad:1:14 Total Declaration
            b.clad:2:11 total Write
            b.clad:2:18 total Read
            a.clad:1:12 total Definition
            c.clad:1:10 total Read
        "#]],
    );
    check(
        "%% a.clad\n+--[ ]( %IX0.0 )--( )( y )--+\n%% b.clad\n+--[ ]( %ix0$0.0 )--( )( y )--+\n",
        expect![[r#"
            b.clad:1:9 %ix0.0 Read
            a.clad:1:9 %IX0.0 Read
        "#]],
    );
    check(
        "%% a.clad\n+--[ ]( x )--( )( y )--+\n%% b.clad\n+--[ ]( x$0 )--( )( y )--+\n",
        expect![[r#"
            b.clad:1:9 x Read
        "#]],
    );
}

#[test]
fn functions_and_labels() {
    check(
        "%% a.clad\n+--<CALL>( cou$0nt )--+\n+--<FUN>( count )--+\n+--<CALL>( Count )--+\n\
         %% b.clad\n+--<CALL>( count )--+\n\
         %% c.clad\n+--<CALL>( count )--+\n+--<FUN>( count )--+\n",
        expect![[r#"
            a.clad:1:12 count Mention
            a.clad:2:11 count Definition
            a.clad:3:12 Count Mention
            b.clad:1:12 count Mention
        "#]],
    );
    check(
        "+--<LBL>( top )--+\n+--<JMP>( to$0p )--+\n+--<FUN>( f )--+\n+--<JMP>( top )--+\n",
        expect![[r#"
            main.clad:1:11 top Definition
            main.clad:2:11 top Mention
        "#]],
    );
    check(
        "+--[ ]( a )--<JMP>( nowhere$0 )--+\n",
        expect![[r#"
        main.clad:1:21 nowhere Mention
    "#]],
    );
}

#[test]
fn instructions() {
    check(
        "VAR t : TO$0N; END_VAR\n+--[TON]( t, 5s )--+\n+--[ton]( u, 5s )--+\n",
        expect![[r#"
            main.clad:2:4 [TON] Mention
            main.clad:3:4 [ton] Mention
        "#]],
    );
}

#[test]
fn half_written_text() {
    check(
        "+--[ ]( a )--[TON]( a$0\n",
        expect![[r#"
        main.clad:1:9 a Read
        main.clad:1:21 a ReadWrite
    "#]],
    );
    check(
        "+--[ ]( a )--[FOO]( $0a, a )--( )( y\n",
        expect![[r#"
        main.clad:1:9 a Read
        main.clad:1:21 a ReadWrite
        main.clad:1:24 a ReadWrite
    "#]],
    );
    check(
        "VAR\n  a$0 : \n+--[ ]( a )--\n",
        expect![[r#"
        main.clad:2:3 a Definition
        main.clad:3:9 a Read
    "#]],
    );
    check("+--[ ]( $0 )--+\n", expect![[""]]);
    check("$0", expect![[""]]);
}

/// The library's own file is among them.
#[test]
fn of_a_block_of_the_library() {
    check(
        "+--[$Deb$0ounce]( button )--( )( y )--+\n%% other.clad\n+--[$Debounce]( b )--( )( z )--+\n",
        expect![[r#"
            main.clad:1:5 $Debounce Mention
            other.clad:1:5 $Debounce Mention
            library://Debounce.clad:3:17 $Debounce Definition
        "#]],
    );
}
