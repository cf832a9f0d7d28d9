//! Networks drawn from sketches.

use expect_test::{Expect, expect};
use ladder_format::{ElementKind, Options, Sketch, display_width, format_text};

/// A sketch and the texts of its elements, from rungs in a short form: `+ \ / a( b) `, a word is a block that
/// decides, one with `!` acts, `~` is a place without wire.
fn sketch(rungs: &[&str]) -> (Sketch, Vec<String>) {
    let mut sketch = Sketch::new();
    let mut texts = Vec::new();
    for rung in rungs {
        sketch.begin_rung();
        let mut joined = false;
        for (n, word) in rung.split_whitespace().enumerate() {
            let (kind, text) = match word {
                "~" => {
                    joined = false;
                    continue;
                }
                "+" if n == 0 => (ElementKind::LeftRail, String::new()),
                "+" => (ElementKind::RightRail, String::new()),
                "\\" => (ElementKind::Down, String::new()),
                "/" => (ElementKind::Up, String::new()),
                "--" => (ElementKind::Stub, String::new()),
                _ => match word.strip_prefix('!') {
                    Some(tag) => (ElementKind::Acting, format!("( )( {tag} )")),
                    None => (ElementKind::Condition, format!("[ ]( {word} )")),
                },
            };
            let width = match kind {
                ElementKind::Stub => 2,
                _ => display_width(&text).max(1),
            };
            sketch.push(kind, joined, width);
            texts.push(text);
            joined = true;
        }
    }
    (sketch, texts)
}

#[track_caller]
fn check(rungs: &[&str], expected: Expect) {
    let (sketch, texts) = sketch(rungs);
    let layout = sketch.lay_out(&Options::default());
    let mut text = String::new();
    layout.draw(|n| &texts[n], "\n", &mut text);
    expected.assert_eq(&text);
    assert_eq!(
        format_text(&text, &Options::default()),
        text,
        "the formatter draws it otherwise"
    );
}

#[test]
fn a_branch() {
    check(
        &["+ \\ start \\ stop !run +", "/ run /"],
        expect![[r#"
            +--\--[ ]( start )--\--[ ]( stop )---------------------------------( )( run )--+
            |  /--[ ]( run )----/                                                          |
        "#]],
    );
}

#[test]
fn nested_and_closed() {
    check(
        &["+ a \\ b \\ !y \\ +", "/ \\ c / !zz /", "/ !w ~ d --"],
        expect![[r#"
            +--[ ]( a )--\--[ ]( b )-----\------------------------------------( )( y )--\--+
            |            /--\--[ ]( c )--/-----------------------------------( )( zz )--/  |
            |               /--( )( w )  [ ]( d )--                                        |
        "#]],
    );
}

#[test]
fn a_wide_one_has_a_rail_of_its_own() {
    check(
        &["+ a !y +"],
        expect![[r#"
            +--[ ]( a )----------------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        &["+ a_name_that_is_too_long_for_it !y +"],
        expect![[r#"
            +--[ ]( a_name_that_is_too_long_for_it )-----------------------------( )( y )--+
        "#]],
    );
}

#[test]
fn without_partner_or_rail() {
    check(
        &["a \\ b", "c \\ d", "/ / e"],
        expect![[r#"
        [ ]( a )--\--[ ]( b )
        [ ]( c )--\--[ ]( d )
                  /--/--[ ]( e )
    "#]],
    );
}
