//! What keeps its name, or its type.

use super::super::prepare_rename;
use super::{check, renamed};
use crate::fixture::Fixture;
use expect_test::{Expect, expect};

#[test]
fn a_type_that_follows_from_the_name() {
    let check = |text: &str, new: &str, expected: Expect| check(text, new, expected);
    check(
        "+--[MOV]( MI1$0, 3 )--+\n",
        "MF1",
        expect![[r#"
        refused: `MI1` is not declared, and is an internal tag of type DINT; the name `MF1` would make it an internal tag of type LREAL: declare it first
    "#]],
    );
    check(
        "+--[MOV]( MF1$0, 3 )--+\n",
        "speed",
        expect![[r#"
        refused: `MF1` is not declared, and is an internal tag of type LREAL; the name `speed` would make it an internal tag of type DINT: declare it first
    "#]],
    );
    check(
        "+--[ ]( M1$0 )--------------------------( )( y )--+\n",
        "start",
        expect![[r#"
            refused: `M1` is not declared, and is an internal tag of type BOOL; the name `start` would make it an input of type BOOL: declare it first
        "#]],
    );
    check(
        "+--[ ]( start$0 )--------------------( )( y )--+\n",
        "I7",
        expect![[r#"
            +--[ ]( I7 )---------------------------------------------------------( )( y )--+
        "#]],
    );
}

#[test]
fn what_keeps_its_name() {
    let check = |text: &str, expected: Expect| {
        let fixture = Fixture::new(text);
        let (context, offset, _) = fixture.ask();
        let prepared = match prepare_rename(context, offset) {
            Err(refused) => format!("refused: {refused}\n"),
            Ok(None) => "nothing\n".to_owned(),
            Ok(Some(it)) => format!("{} `{}`\n", fixture.show("main.clad", it.range), it.name),
        };
        expected.assert_eq(&prepared);
        if prepared.starts_with("refused") || prepared.starts_with("nothing") {
            assert!(renamed(text, "x").starts_with("refused"));
        }
    };
    check(
        "+--[ ]( r$0un )--+\n",
        expect![[r#"
        main.clad:1:9 run `run`
    "#]],
    );
    check(
        "+--[$Ho$0ld]( run )--+\n",
        expect![[r#"
        main.clad:1:5 $Hold `$Hold`
    "#]],
    );
    check(
        "+--[ ]( %IX0$0.0 )--+\n",
        expect![[r#"
        refused: `%IX0.0` is a direct address: it says where the signal is. Declare a tag with AT to give it a name
    "#]],
    );
    check(
        "+--[ ]( t.Q$0 )--+\n",
        expect![[r#"
        refused: the members of a timer, counter or bistable, and the bits of a tag, keep their names
    "#]],
    );
    check(
        "+--[ ]( SYS.ON$0 )--+\n",
        expect![[r#"
        refused: the tags of SYS keep their names
    "#]],
    );
    check(
        "+--[TON$0]( t, 1s )--+\n",
        expect![[r#"
        refused: instructions keep their names
    "#]],
    );
    check(
        "FUNCTION_BLOCK [$B]\n+--[ ]( EN$0 )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
        expect![[r#"
            refused: EN and ENO belong to every block: they keep their names
        "#]],
    );
    check(
        "+--$0[ ]( a )--+\n",
        expect![[r#"
        refused: instructions keep their names
    "#]],
    );
    check(
        "+-$0-[ ]( a )--+\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+--[CALC]( y, SQ$0RT(a) )--+\n",
        expect![[r#"
        nothing
    "#]],
    );
}

#[test]
fn an_address_stays_where_it_is_written() {
    let text = "VAR lamp AT %QX0.1 : BOOL; END_VAR\n+--[ ]( lamp )--[ ]( %QX0.1 )--( )( y )--+\n";
    check(
        &text.replacen("lamp", "la$0mp", 1),
        "light",
        expect![[r#"
            VAR light AT %QX0.1 : BOOL; END_VAR
            +--[ ]( light )--[ ]( %QX0.1 )---------------------------------------( )( y )--+
        "#]],
    );
    check(
        &text.replacen("( %QX", "( %Q$0X", 1),
        "light",
        expect![[r#"
        refused: `%QX0.1` is a direct address: it says where the signal is. Declare a tag with AT to give it a name
    "#]],
    );
}

#[test]
fn the_library_keeps_its_names() {
    for text in [
        "+--[$Deb$0ounce]( button )--( )( y )--+\n",
        "+--[$Debounce]( button, w$0ait := 5ms )--( )( y )--+\n",
    ] {
        assert_eq!(
            renamed(text, "$Other"),
            "refused: the blocks of the library and their operands keep their names\n"
        );
    }
}
