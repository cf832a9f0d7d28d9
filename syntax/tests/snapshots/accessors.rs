//! The typed views, on whole and on broken text.

use expect_test::{Expect, expect};
use ladder_syntax::ast::{
    AstNode, Block, BlockHeader, Declaration, Expression, HeadName, NamedOperand, NodeView, Operand,
    SectionHeader, Subscript, TokenView,
};
use ladder_syntax::{Parse, parse};
use std::fmt::Write as _;

fn all<'g, N: AstNode<'g>>(parse: &'g Parse) -> Vec<N> {
    fn collect<'g, N: AstNode<'g>>(node: NodeView<'g>, found: &mut Vec<N>) {
        found.extend(N::cast(node));
        for child in node.children() {
            collect(child, found);
        }
    }
    let mut found = Vec::new();
    collect(NodeView::root(parse.green()), &mut found);
    found
}

/// An expression as its views give it: every part that is missing is `?`.
fn show(expression: Option<&Expression<'_>>) -> String {
    let Some(expression) = expression else {
        return "?".to_owned();
    };
    let token = |t: Option<TokenView<'_>>| t.map_or("?".to_owned(), |t| t.text().to_owned());
    let list = |values: Vec<Expression<'_>>| {
        values
            .iter()
            .map(|v| show(Some(v)))
            .collect::<Vec<_>>()
            .join(", ")
    };
    match expression {
        Expression::Name(t) => format!("name {}", t.text()),
        Expression::Address(t) => format!("address {}", t.text()),
        Expression::Literal(t) => format!("literal {}", t.text()),
        Expression::Member(n) => format!("({} . {})", show(n.base().as_ref()), token(n.member())),
        Expression::Index(n) => {
            let subscripts = n.subscripts().map(|subscript| match subscript {
                Subscript::Index(index) => show(Some(&index)),
                Subscript::Range(range) => {
                    let (first, last) = (range.first(), range.last());
                    format!("{} .. {}", show(first.as_ref()), show(last.as_ref()))
                }
            });
            let subscripts: Vec<String> = subscripts.collect();
            let subscripts = if subscripts.is_empty() {
                "?".to_owned()
            } else {
                subscripts.join(", ")
            };
            format!("({}[{subscripts}])", show(n.base().as_ref()))
        }
        Expression::Unary(n) => format!("({} {})", token(n.operator()), show(n.operand().as_ref())),
        Expression::Binary(n) => format!(
            "({} {} {})",
            show(n.left().as_ref()),
            token(n.operator()),
            show(n.right().as_ref())
        ),
        Expression::Paren(n) => format!("(paren {})", show(n.inner().as_ref())),
        Expression::Call(n) => format!(
            "({}({}))",
            show(n.callee().as_ref()),
            list(n.arguments().collect())
        ),
        Expression::Struct(n) => {
            let members = n.members();
            let member = |(name, value)| format!("({name} := {value})");
            let shown = members.map(|it| (token(it.name()), show(it.value().as_ref())));
            shown.map(member).collect::<Vec<_>>().concat()
        }
        Expression::Array(n) => format!("[{}]", list(n.values().collect())),
        Expression::Error(n) => format!("error {n}"),
    }
}

fn show_named(operand: &NamedOperand<'_>) -> String {
    let token = |t: Option<TokenView<'_>>| t.map_or("?".to_owned(), |t| t.text().to_owned());
    format!(
        "{} {} {}",
        token(operand.name()),
        token(operand.arrow()),
        show(operand.value().as_ref())
    )
}

#[track_caller]
fn check_blocks(text: &str, expect: Expect) {
    let mut out = String::new();
    for block in all::<Block<'_>>(&parse(text)) {
        let head = match block.head().map(|h| h.name()) {
            Some(HeadName::Blank) => "blank".to_owned(),
            Some(HeadName::Mnemonic(t)) => format!("mnemonic {}", t.text()),
            Some(HeadName::User(t)) => format!("user {}", t.text()),
            None => "?".to_owned(),
        };
        let list = if block.operand_list().is_some() {
            ""
        } else {
            ", no list"
        };
        let _ = writeln!(out, "{:?} {head}{list}", block.shape());
        for operand in block.operands() {
            let _ = match &operand {
                Operand::Positional(e) => writeln!(out, "  {:?} {}", operand.range(), show(Some(e))),
                Operand::Named(n) => writeln!(out, "  {:?} {}", operand.range(), show_named(n)),
            };
        }
    }
    expect.assert_eq(&out);
}

#[test]
fn blocks_and_operands() {
    check_blocks(
        "+--[ ]( a )--[/]( %IX0.0 )--(S)()--<RET>--[$B]( t.Q, a[i], a[1..9], R := r, FOUND => f )--[",
        expect![[r#"
            Logical blank
              8..9 name a
            Logical mnemonic /
              18..24 address %IX0.0
            Coil mnemonic S
            Function mnemonic RET, no list
            Logical user $B
              48..51 (name t . Q)
              53..57 (name a[name i])
              59..66 (name a[literal 1 .. literal 9])
              68..74 R := name r
              76..86 FOUND => name f
            Logical blank, no list
        "#]],
    );
}

#[test]
fn expressions() {
    check_blocks(
        "[CALC]( y, -a + NOT (b * 2) ^ SQRT(c, 'x') )--[CALC]( a[b + 1].c[2] )",
        expect![[r#"
            Logical mnemonic CALC
              8..9 name y
              11..42 ((- name a) + ((NOT (paren (name b * literal 2))) ^ (name SQRT(name c, literal 'x'))))
            Logical mnemonic CALC
              54..67 (((name a[(name b + literal 1)]) . c)[literal 2])
        "#]],
    );
}

#[test]
fn parts_that_are_missing() {
    check_blocks(
        "[CALC]( * b, a +, - , a[], a[..2], a[1..], a., (), f(), R :=, := r, 5 := x, a.5, +1 + +b )",
        expect![[r#"
            Logical mnemonic CALC
              8..11 (? * name b)
              13..16 (name a + ?)
              18..19 (- ?)
              22..25 (name a[?])
              27..33 (name a[? .. literal 2])
              35..41 (name a[literal 1 .. ?])
              43..45 (name a . ?)
              47..49 (paren ?)
              51..54 (name f())
              56..60 R := ?
              62..66 ? := name r
              68..74 ? := name x
              76..79 (name a . 5)
              81..88 (literal 1 + name b)
        "#]],
    );
}

#[test]
fn declarations() {
    let text = "VAR_INPUT CONSTANT\na, b AT %IX0.0 : ARRAY[-1..9] OF STRING[5] := [1, 2(0)];\nc : ;\nd AT : INT := ;\ne : Foo := -5;\nEND_VAR";
    let mut out = String::new();
    for header in all::<SectionHeader<'_>>(&parse(text)) {
        let qualifiers: Vec<String> = header.qualifiers().map(|t| t.text().to_owned()).collect();
        let _ = writeln!(
            out,
            "{:?} {qualifiers:?}",
            header.section().map(|t| t.text().to_owned())
        );
    }
    for declaration in all::<Declaration<'_>>(&parse(text)) {
        let names: Vec<String> = declaration.names().map(|t| t.text().to_owned()).collect();
        let ty = declaration.type_ref().map(|ty| {
            let numbers: Vec<String> = ty
                .dimensions()
                .into_iter()
                .chain(ty.limits())
                .map(|bound| format!("{}{}", if bound.negative { "-" } else { "" }, bound.token.text()))
                .collect();
            format!(
                "{:?} array {} {numbers:?}",
                ty.name().map(|t| t.text().to_owned()),
                ty.is_array()
            )
        });
        let _ = writeln!(
            out,
            "{names:?} at {:?} type {ty:?} value {}",
            declaration.address().map(|t| t.text().to_owned()),
            show(declaration.initial_value().as_ref())
        );
    }
    expect![[r#"
        Some("VAR_INPUT") ["CONSTANT"]
        ["a", "b"] at Some("%IX0.0") type Some("Some(\"STRING\") array true [\"-1\", \"9\", \"5\"]") value [literal 1, (literal 2(literal 0))]
        ["c"] at None type Some("None array false []") value ?
        ["d"] at None type None value ?
        ["e"] at None type Some("Some(\"Foo\") array false []") value (- literal 5)
    "#]].assert_eq(&out);
}

#[test]
fn block_headers() {
    let mut out = String::new();
    for text in [
        "FUNCTION_BLOCK [$B]",
        "FUNCTION_BLOCK ($C)",
        "FUNCTION_BLOCK <$D",
        "FUNCTION_BLOCK",
    ] {
        for header in all::<BlockHeader<'_>>(&parse(text)) {
            let head = header.head().map(|h| (h.shape(), h.name()));
            let _ = writeln!(
                out,
                "{text}: {}",
                match head {
                    Some((shape, HeadName::User(t))) => format!("{shape:?} {}", t.text()),
                    Some((shape, _)) => format!("{shape:?} ?"),
                    None => "?".to_owned(),
                }
            );
        }
    }
    expect![[r#"
        FUNCTION_BLOCK [$B]: Logical $B
        FUNCTION_BLOCK ($C): Coil $C
        FUNCTION_BLOCK <$D: Function $D
        FUNCTION_BLOCK: ?
    "#]]
    .assert_eq(&out);
}

#[test]
fn casting_asks_for_the_kind() {
    let parse = parse("+--+");
    let root = NodeView::root(parse.green());
    assert!(Block::cast(root).is_none());
    assert!(Expression::cast(root).is_none());
}
