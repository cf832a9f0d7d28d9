//! Whole programs written from what is declared and drawn.

use expect_test::{Expect, expect};
use ladder_format::program::{
    Block, Declaration, Drawing, Element, Item, Network, ProgramSketch, Qualifier, RungPiece, Section,
    SectionKind,
};
use ladder_format::{Circuit, Options, format_text};

fn block(text: &str, origin: u32) -> Circuit<Element> {
    let block = Block::read(text).expect("it is a block");
    Circuit::Element(Element::of(block, Some(origin)))
}

fn network(circuit: Circuit<Element>) -> Item {
    Item::Network(Network {
        comments: Vec::new(),
        drawing: Drawing::Circuit(circuit),
    })
}

/// The text, and under it what was made from which origin.
#[track_caller]
fn check(items: Vec<Item>, expected: Expect) {
    let written = ProgramSketch { items }.write(&Options::default());
    assert_eq!(
        format_text(&written.text, &Options::default()),
        written.text,
        "it is not in canonical layout"
    );
    let mut shown = written.text.clone();
    for (range, origin) in &written.places {
        shown.push_str(&format!("{origin}: {}\n", &written.text[*range]));
    }
    expected.assert_eq(&shown);
}

#[test]
fn declarations_and_networks() {
    let mut inputs = Section::new(SectionKind::VarInput);
    inputs.declarations.push(Declaration {
        comment: Some("terminal #4".into()),
        origin: Some(1),
        ..Declaration::new("start", "BOOL")
    });
    inputs.declarations.push(Declaration {
        address: Some("%IX0.1".into()),
        ..Declaration::new("stop", "BOOL")
    });
    let mut kept = Section::new(SectionKind::Var);
    kept.qualifier = Some(Qualifier::Retain);
    kept.declarations.push(Declaration {
        initial: Some("7".into()),
        ..Declaration::new("total", "DINT")
    });
    check(
        vec![
            Item::Comment("A motor.\n\nSecond line.".into()),
            Item::Directive("profile iec".into()),
            Item::Blank,
            Item::Section(inputs),
            Item::Section(kept),
            Item::Section(Section::new(SectionKind::VarOutput)),
            Item::Blank,
            Item::Network(Network {
                comments: vec!["seal-in".into()],
                drawing: Drawing::Circuit(Circuit::Series(vec![
                    Circuit::Parallel(vec![block("[ ]( start )", 10), block("[ ](run)", 11)]),
                    block("[/]( stop )", 12),
                    Circuit::Element(Element::comment("was: door", Some(13))),
                    block("( )( run )", 14),
                ])),
            }),
            Item::Blank,
            network(block("[CTU]( total,5)", 20)),
        ],
        expect![[r#"
            # A motor. #

            # Second line. #
            # ladder: profile iec #

            VAR_INPUT
                start           : BOOL;  # terminal \x234 #
                stop  AT %IX0.1 : BOOL;
            END_VAR
            VAR RETAIN
                total : DINT := 7;
            END_VAR

            # seal-in #
            +--\--[ ]( start )--\--[/]( stop )--# was: door #------------------( )( run )--+
            |  /--[ ]( run )----/                                                          |

            +-----------------------------------------------------------[CTU]( total, 5 )--+
            1: start           : BOOL;
            10: [ ]( start )
            12: [/]( stop )
            13: # was: door #
            14: ( )( run )
            11: [ ]( run )
            20: [CTU]( total, 5 )
        "#]],
    );
}

#[test]
fn a_bridge_rung_by_rung() {
    let element =
        |text: &str| RungPiece::Element(Element::of(Block::read(text).expect("it is a block"), None));
    check(
        vec![Item::Network(Network {
            comments: Vec::new(),
            drawing: Drawing::Rungs(vec![
                vec![
                    RungPiece::Rail,
                    element("[ ]( a )"),
                    RungPiece::Down,
                    element("[ ]( b )"),
                    RungPiece::Down,
                    element("( )( y )"),
                    RungPiece::Rail,
                ],
                vec![
                    RungPiece::Rail,
                    element("[ ]( c )"),
                    RungPiece::Up,
                    RungPiece::Gap,
                    RungPiece::Up,
                    element("( )( z )"),
                    RungPiece::Rail,
                ],
            ]),
        })],
        expect![[r#"
            +--[ ]( a )--\--[ ]( b )--\------------------------------------------( )( y )--+
            +--[ ]( c )--/            /------------------------------------------( )( z )--+
        "#]],
    );
}

#[test]
fn a_block_with_a_body() {
    let mut inputs = Section::new(SectionKind::VarInput);
    inputs.declarations.push(Declaration::new("raw", "BOOL"));
    check(
        vec![Item::Block {
            header: "[$Same]".into(),
            origin: None,
            items: vec![
                Item::Section(inputs),
                network(Circuit::Series(vec![
                    block("[ ]( raw )", 1),
                    block("( )( ENO )", 2),
                ])),
            ],
        }],
        expect![[r#"
            FUNCTION_BLOCK [$Same]
            VAR_INPUT
                raw : BOOL;
            END_VAR
            +--[ ]( raw )------------------------------------------------------( )( ENO )--+
            END_FUNCTION_BLOCK
            1: [ ]( raw )
            2: ( )( ENO )
        "#]],
    );
}

#[test]
fn what_a_comment_cannot_hold() {
    check(
        vec![
            Item::Comment("ladder: allow-file(double-coil): please".into()),
            Item::Comment("pump #2\r\nbell \u{7}".into()),
            network(Circuit::Series(vec![
                Circuit::Element(Element::comment("ladder: fmt off # +--( )( y )--+", None)),
                block("( )( y )", 1),
            ])),
        ],
        expect![[r#"
            # text: ladder: allow-file(double-coil): please #
            # pump \x232 #
            # bell \x07 #
            +--# text: ladder: fmt off \x23 +--( )( y )--+ #---------------------( )( y )--+
            1: ( )( y )
        "#]],
    );
}

#[test]
fn an_offset_leads_back_to_its_origin() {
    let written = ProgramSketch {
        items: vec![
            network(Circuit::Series(vec![block("[ ]( a )", 1), block("( )( y )", 2)])),
            network(Circuit::Series(vec![block("[ ]( b )", 3), block("( )( z )", 4)])),
        ],
    }
    .write(&Options::default());
    let at = |what: &str| written.origin_at((written.text.find(what).unwrap() as u32).into());
    assert_eq!(at("a )"), Some(1));
    assert_eq!(at("---------( )( y )"), Some(1), "in the wire after it");
    assert_eq!(at("( )( y )"), Some(2));
    assert_eq!(at("+--[ ]( b )"), Some(3), "in the rail before it");
    assert_eq!(written.origin_at((written.text.len() as u32).into()), Some(4));
}

#[test]
fn a_text_as_a_sketch() {
    let text = r"# ladder: profile iec #
VAR_INPUT
    a, b : BOOL;  # both doors #
END_VAR

|  # Above. #  |
+--\--[ ]( a )--# relay #--\--( )( y )--+  # behind #
|  /--[ ]( b )-------------/            |

FUNCTION_BLOCK ($Flash)  # of a lamp #
+--[ ]( EN )--( )( ENO )--+
END_FUNCTION_BLOCK
";
    let sketch = ProgramSketch::of_text(&ladder_syntax::parse(text));
    check(
        sketch.items,
        expect![[r#"
            # ladder: profile iec #
            VAR_INPUT
                a, b : BOOL;  # both doors #
            END_VAR

            # Above. #
            # behind #
            +--\--[ ]( a )--# relay #--\-----------------------------------------( )( y )--+
            |  /--[ ]( b )-------------/                                                   |

            FUNCTION_BLOCK ($Flash)  # of a lamp #
            +--[ ]( EN )-------------------------------------------------------( )( ENO )--+
            END_FUNCTION_BLOCK
            0: # ladder: profile iec #
            24: VAR_INPUT
            38: a, b : BOOL;  # both doors #
            67: END_VAR
            79: # Above. #
            136: # behind #
            99: [ ]( a )
            109: # relay #
            123: ( )( y )
            153: [ ]( b )
            232: [ ]( EN )
            243: ( )( ENO )
        "#]],
    );
}
