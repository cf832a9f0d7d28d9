use super::{Outlined, outline};
use crate::fixture::Fixture;
use expect_test::{Expect, expect};

fn check(text: &str, expected: Expect) {
    let fixture = Fixture::new(text);
    let context = &fixture.files[0].0.context;
    let mut shown = String::new();
    show(&fixture, &outline(context), None, 0, &mut shown);
    expected.assert_eq(&shown);
}

fn show(fixture: &Fixture, items: &[Outlined], parent: Option<&Outlined>, depth: usize, out: &mut String) {
    for item in items {
        assert!(item.range.contains_range(item.focus), "{item:?}");
        assert!(
            parent.is_none_or(|it| it.range.contains_range(item.range)),
            "{item:?}"
        );
        assert!(!item.name.is_empty());
        let detail = item
            .detail
            .as_deref()
            .map(|it| format!(" ({it})"))
            .unwrap_or_default();
        let place = fixture.show("main.clad", item.range);
        let place = place.trim_start_matches("main.clad:");
        *out += &format!(
            "{}{:?} {}{detail}: {place}\n",
            "  ".repeat(depth),
            item.kind,
            item.name
        );
        show(fixture, &item.children, Some(item), depth + 1, out);
    }
}

#[test]
fn every_part_of_a_file() {
    check(
        "# The tags #\nVAR_INPUT\n    start, stop : BOOL;  # ö #\nEND_VAR\nVAR CONSTANT limit : INT := 3; END_VAR\n\n\
         # ladder: allow(never-read): no #\n# Motor 1 # # main #\n+--\\--[ ]( start )--\\--( )( run )--+\n|  /--[ ]( run )----/             |\n\n\
         +--<LBL>( again )--[ADD]( n, n, 1 )--[TON]( t, 5s )--(S)( a[3] )--( )( b.2 )--+\n\n\
         # counts #\n+--<FUN>( count )--[ADD]( n, n, 1 )--+\n# second #\n+--( )( x )--+\n\n\
         # waits #\nFUNCTION_BLOCK [$Wait]\nVAR_INPUT raw : BOOL; END_VAR\nVAR_OUTPUT out : BOOL; END_VAR\n\
         # inside #\n+--[ ]( raw )--( )( out )--+\nEND_FUNCTION_BLOCK\n\
         +--[$Wait]( p, q )--+\n",
        expect![[r#"
            Section VAR_INPUT (The tags): 1:1 # The tags # ... END_VAR
              Tag start (BOOL, read): 3:5 start, stop : BOOL;
              Tag stop (BOOL): 3:5 start, stop : BOOL;
            Section VAR CONSTANT: 5:1 VAR CONSTANT limit : INT := 3; END_VAR
              Constant limit (INT): 5:14 limit : INT := 3;
            Network Motor 1 (run): 7:1 # ladder: allow(never-read): no # ... |  /--[ ]( run )----/             |
            Network Network 2 (n, set a, b): 12:1 +--<LBL>( again )--[ADD]( n, n, 1 )--[TON]( t, 5s )--(S)( a[3] )--( )( b.2 )--+
              Label again (<LBL>): 12:11 again
            Function count (counts): 14:1 # counts # ... +--( )( x )--+
              Network counts (n): 14:1 # counts # ... +--<FUN>( count )--[ADD]( n, n, 1 )--+
              Network second (x): 16:1 # second # ... +--( )( x )--+
            Block [$Wait] (( raw, out => )): 19:1 # waits # ... END_FUNCTION_BLOCK
              Section VAR_INPUT: 21:1 VAR_INPUT raw : BOOL; END_VAR
                Parameter raw (BOOL, read): 21:11 raw : BOOL;
              Section VAR_OUTPUT: 22:1 VAR_OUTPUT out : BOOL; END_VAR
                Parameter out (BOOL, write): 22:12 out : BOOL;
              Network inside (out): 23:1 # inside # ... +--[ ]( raw )--( )( out )--+
            Network Network 6 (q): 26:1 +--[$Wait]( p, q )--+
        "#]],
    );
}

#[test]
fn half_written_text() {
    check(
        "VAR\n  a : \n+--[ ]( a\nFUNCTION_BLOCK\n+--<FUN>( \n+--<LBL>( x\n",
        expect![[r#"
            Section VAR: 1:1 VAR ...   a :
              Tag a (DINT, read): 2:3 a :
            Network Network 1: 3:1 +--[ ]( a
            Block [?] (( )): 4:1 FUNCTION_BLOCK ... +--<LBL>( x
              Network Network 2: 5:1 +--<FUN>(
              Network Network 3: 6:1 +--<LBL>( x
                Label x (<LBL>): 6:11 x
        "#]],
    );
    check(
        "\u{feff}# title # +--[ ]( a )--( )( b )--+\r\n\r\n| # in a rail line # |\r\n+--( )( c )--+",
        expect![[r#"
            Network title (b): 1:1 ﻿# title # +--[ ]( a )--( )( b )--+
            Network in a rail line (c): 3:1 | # in a rail line # | ... +--( )( c )--+
        "#]],
    );
    check("# only #", expect![[""]]);
    check(
        "FUNCTION_BLOCK <$Go>\n+--<FUN>( inner )--( )( a )--+\n+--<LBL>( l )--+\nEND_FUNCTION_BLOCK\n",
        expect![[r#"
            Block <$Go> (( )): 1:1 FUNCTION_BLOCK <$Go> ... END_FUNCTION_BLOCK
              Function inner: 2:1 +--<FUN>( inner )--( )( a )--+ ... +--<LBL>( l )--+
                Network Network 1 (a): 2:1 +--<FUN>( inner )--( )( a )--+
                Network Network 2: 3:1 +--<LBL>( l )--+
                  Label l (<LBL>): 3:11 l
        "#]],
    );
}
