//! Networks drawn from what is in series and in parallel.

use expect_test::{Expect, expect};
use ladder_format::{Circuit, ElementKind, Options, format_text};

type Drawn = Circuit<(ElementKind, String)>;

fn contact(tag: &str) -> Drawn {
    Circuit::Element((ElementKind::Condition, format!("[ ]( {tag} )")))
}

fn coil(tag: &str) -> Drawn {
    Circuit::Element((ElementKind::Acting, format!("( )( {tag} )")))
}

fn series<const N: usize>(parts: [Drawn; N]) -> Drawn {
    Circuit::Series(parts.into())
}

fn parallel<const N: usize>(branches: [Drawn; N]) -> Drawn {
    Circuit::Parallel(branches.into())
}

#[track_caller]
fn check(circuit: &Drawn, expected: Expect) {
    let text = circuit.draw(&Options::default(), "\n", |(kind, text)| (*kind, text));
    expected.assert_eq(&text);
    assert_eq!(
        format_text(&text, &Options::default()),
        text,
        "the formatter draws it otherwise"
    );
}

#[test]
fn one_after_the_other() {
    check(
        &series([contact("a"), contact("b"), coil("y")]),
        expect![[r#"
            +--[ ]( a )--[ ]( b )------------------------------------------------( )( y )--+
        "#]],
    );
}

#[test]
fn branches_side_by_side_and_below_each_other() {
    check(
        &series([
            parallel([contact("a"), contact("b"), contact("c")]),
            parallel([contact("d"), contact("e")]),
            coil("y"),
        ]),
        expect![[r#"
            +--\--[ ]( a )--------\--\--[ ]( d )--\------------------------------( )( y )--+
            |  /--\--[ ]( b )--\--/  /--[ ]( e )--/                                        |
            |     /--[ ]( c )--/                                                           |
        "#]],
    );
}

#[test]
fn a_branch_in_an_upper_branch_is_passed() {
    check(
        &series([
            parallel([
                series([contact("a"), parallel([contact("b"), contact("c")])]),
                contact("d"),
                Circuit::Series(Vec::new()),
            ]),
            parallel([coil("y"), coil("z")]),
        ]),
        expect![[r#"
            +--\--[ ]( a )--\--[ ]( b )--\-----\--\---------------------------( )( y )--\--+
            |  /--\         /--[ ]( c )--/  \--/  /---------------------------( )( z )--/  |
            |     /--\--[ ]( d )--\---------/                                              |
            |        /------------/                                                        |
        "#]],
    );
}
