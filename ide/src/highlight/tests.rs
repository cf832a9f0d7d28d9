use super::highlights;
use crate::fixture::Fixture;
use expect_test::{Expect, expect};

fn check(text: &str, expected: Expect) {
    let fixture = Fixture::new(text);
    let (context, offset, _) = fixture.ask();
    let shown: Vec<String> = highlights(context, offset)
        .iter()
        .map(|it| {
            let place = fixture.show("main.clad", it.range);
            format!("{} {:?}\n", place.trim_start_matches("main.clad:"), it.usage)
        })
        .collect();
    expected.assert_eq(&shown.concat());
}

#[test]
fn a_tag() {
    check(
        "VAR\n\trun : BOOL;\nEND_VAR\n+--[ ]( start )--\\--( )( ru$0n )--+\r\n|  /--[ ]( run )--/  # run #\n",
        expect![[r#"
            2:2 run Definition
            4:26 run Write
            5:12 run Read
        "#]],
    );
    check(
        "+--# 温度 #--[ ]( ö )--( )( Ö$0 )--+\n",
        expect![[r#"
        1:17 ö Read
        1:27 Ö Write
    "#]],
    );
}

#[test]
fn connectors() {
    let seal = "+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( y )--/            |\n";
    let at = |offset: usize| {
        let mut text = seal.to_owned();
        text.insert_str(offset, "$0");
        text
    };
    check(
        &at(3),
        expect![[r#"
        1:4 \ Mention
        2:4 / Mention
    "#]],
    );
    check(
        &at(seal.rfind('/').unwrap()),
        expect![[r#"
        1:17 \ Mention
        2:17 / Mention
    "#]],
    );
    check(
        "+--$0\\--[ ]( a )--( )( y )--+\n",
        expect![[r#"
        1:4 \ Mention
    "#]],
    );
}

#[test]
fn rails() {
    check(
        "$0+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( y )--/            |\n\n+--[ ]( b )--( )( z )--+\n",
        expect![[r#"
            1:1 + Mention
            1:30 + Mention
            2:1 | Mention
            2:30 | Mention
        "#]],
    );
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( y )--/            |$0\n",
        expect![[r#"
            1:1 + Mention
            1:30 + Mention
            2:1 | Mention
            2:30 | Mention
        "#]],
    );
}

#[test]
fn pairs_of_words() {
    check(
        "VAR$0\n  a : BOOL;\nEND_VAR\n",
        expect![[r#"
        1:1 VAR Mention
        3:1 END_VAR Mention
    "#]],
    );
    check(
        "VAR RETAIN\n  a : BOOL;\nEND_$0VAR\n",
        expect![[r#"
        1:1 VAR Mention
        3:1 END_VAR Mention
    "#]],
    );
    check("VAR RETAIN$0\n  a : BOOL;\nEND_VAR\n", expect![[""]]);
    check(
        "FUNCTION_BLOCK$0 [$B]\n+--[ ]( EN )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
        expect![[r#"
            1:1 FUNCTION_BLOCK Mention
            3:1 END_FUNCTION_BLOCK Mention
        "#]],
    );
    check(
        "+--<FO$0R>( 3 )--+\n+--[ADD]( n, n, 1 )--+\n+--<NEXT>--+\n",
        expect![[r#"
            1:4 <FOR> Mention
            3:4 <NEXT> Mention
        "#]],
    );
    check(
        "+--<NEXT>--+\n+--<FOR>( 3 )--+\n+--<NEXT$0>--+\n",
        expect![[r#"
        2:4 <FOR> Mention
        3:4 <NEXT> Mention
    "#]],
    );
    check(
        "+--<FOR$0>( 3 )--+\n",
        expect![[r#"
        1:4 <FOR> Mention
    "#]],
    );
}

#[test]
fn a_contact_is_not_every_contact() {
    check("+--[ $0]( a )--[ ]( b )--( )( y )--+\n", expect![[""]]);
    check(
        "+--[TO$0N]( t, 1s )--[TOF]( u, 1s )--[ton]( v, 1s )--+\n",
        expect![[r#"
        1:4 [TON] Mention
        1:36 [ton] Mention
    "#]],
    );
}
