//! Drawings that were pasted from elsewhere: drawn as ladder text wherever in them the cursor is.

use super::fixture;
use crate::refactor::quick_fixes;
use expect_test::{Expect, expect};
use ladder_analysis::analyze;
use ladder_format::{Options, apply};
use ladder_syntax::parse;
use std::sync::Arc;

#[track_caller]
fn check(marked: &str, expected: Expect) {
    let (text, range) = fixture(marked);
    let analysis = analyze(&Arc::new(parse(&text)), "test.clad");
    let offered = quick_fixes(&analysis, range);
    let drawing = offered.iter().find(|action| action.title.starts_with("Draw it"));
    let shown = match drawing {
        None => "not offered\n".to_owned(),
        Some(action) => {
            assert!(!action.preferred, "nobody but a person knows what was meant");
            let after = apply(&text, &action.aligned(&analysis, &text, &Options::default()));
            let is_crlf = text.contains("\r\n");
            assert!(!is_crlf || !after.replace("\r\n", "").contains('\n'), "{after:?}");
            after.replace("\r\n", "\n")
        }
    };
    expected.assert_eq(&shown);
}

#[test]
fn a_whole_drawing() {
    check(
        "+--[ ]( a )--( )( b )--+\n\n  start      stop      run\n|--| |---+---|/|-------( )--|\n|  $0run   |                  |\n|--| |---+                  |\n\n+--[ ]( run )--( )( lamp )--+\n",
        expect![[r#"
            +--[ ]( a )--( )( b )--+

            +--[ ]( start )--\--[/]( stop )------------------------------------( )( run )--+
            +--[ ]( run )----/                                                             |

            +--[ ]( run )--( )( lamp )--+
        "#]],
    );
    check(
        "│            T1\r\n│  Go      ┌─ TON ─┐  Fan\r\n├──┤ ├─────┤IN    Q├──(S)──┤\r\n│      T#5s┤PT   ET│$0\r\n           └───────┘\r\n",
        expect![[r#"
            +--[ ]( Go )------------------------------------[TON]( T1, T#5s )--(S)( Fan )--+
        "#]],
    );
}

#[test]
fn one_with_something_unread() {
    check(
        "  start\n|--|$0 |---{PID}---( )--|\n",
        expect![[r#"
        not offered
    "#]],
    );
}

#[test]
fn names_of_another_system_in_one_step() {
    let (text, range) = fixture("+--[$0XIC]( a )--[OTE]( y )--+\n\n+--[XIO]( b )--( )( z )--+\n");
    let analysis = analyze(&Arc::new(parse(&text)), "test.clad");
    let offered = quick_fixes(&analysis, range);
    let first = &offered[0];
    assert!(!first.preferred, "nobody but a person knows what was meant");
    let after = apply(&text, &first.aligned(&analysis, &text, &Options::default()));
    expect![[r#"
        Replace all 2 instructions that this network has wrong
        +--[ ]( a )----------------------------------------------------------( )( y )--+

        +--[XIO]( b )--( )( z )--+
    "#]]
    .assert_eq(&format!("{}\n{after}", first.title));
}

#[test]
fn rungs_as_text() {
    let (text, range) = fixture("+--[ ]( c )--( )( z )--+\n\nXIC(a)XIO(b)TON(t1,5000,$00)OTE(b);\n");
    let analysis = analyze(&Arc::new(parse(&text)), "test.clad");
    let offered = quick_fixes(&analysis, range);
    let first = &offered[0];
    let after = apply(&text, &first.aligned(&analysis, &text, &Options::default()));
    expect![[r#"
        Draw it as a rung
        +--[ ]( c )--( )( z )--+

        +--[ ]( a )--[/]( b )--\---------------------------------[TON]( t1, T#5s )--\--+
        |                      /------------------------------------------( )( b )--/  |
    "#]]
    .assert_eq(&format!("{}\n{after}", first.title));
}
