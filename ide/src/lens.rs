//! Code lenses: what can be done with a network, on a line of its own above it.
//!
//! A line between two rungs would cut the verticals of a drawing, so a lens is at the first line of a network and
//! nowhere else.

use ladder_analysis::context::{Body, Context};
use ladder_syntax::{TextRange, TextSize};

/// A lens above a network.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Lens {
    /// The first character of the network.
    pub at: TextRange,
    /// What it offers.
    pub kind: LensKind,
}

/// What a lens offers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LensKind {
    /// The program can be simulated, and its scenarios run: above its first network.
    Program,
    /// Who jumps to the label whose name is here.
    Jumps(TextSize),
    /// Who calls the function whose name is here.
    Calls(TextSize),
}

/// The lenses of a file, from top to bottom.
pub fn lenses(context: &Context) -> Vec<Lens> {
    let mut lenses = Vec::new();
    if let Some(first) = context.bodies.iter().position(|body| *body == Body::Main) {
        lenses.extend(above(context, first, LensKind::Program));
    }
    for label in &context.labels {
        lenses.extend(above(context, label.network, LensKind::Jumps(label.at.start())));
    }
    for function in &context.functions {
        lenses.extend(above(
            context,
            function.network,
            LensKind::Calls(function.at.start()),
        ));
    }
    lenses.sort_by_key(|lens| lens.at.start());
    lenses
}

fn above(context: &Context, network: usize, kind: LensKind) -> Option<Lens> {
    let start = context.networks.get(network)?.range.start();
    Some(Lens {
        at: TextRange::empty(start),
        kind,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixture::Fixture;
    use expect_test::{Expect, expect};

    /// The lenses above the lines that they are at.
    fn check(text: &str, expected: Expect) {
        let fixture = Fixture::new(text);
        let lenses = lenses(&fixture.files[0].0.context);
        let mut shown = String::new();
        let mut at = 0;
        for line in text.split_inclusive('\n') {
            for lens in lenses.iter().filter(|lens| usize::from(lens.at.start()) == at) {
                let what = match lens.kind {
                    LensKind::Program => "program",
                    LensKind::Jumps(_) => "jumps",
                    LensKind::Calls(_) => "calls",
                };
                shown.push_str(&format!("<{what}>\n"));
            }
            shown.push_str(line);
            at += line.len();
        }
        expected.assert_eq(&shown);
    }

    #[test]
    fn above_networks_only() {
        check(
            "# start #\nVAR_INPUT a : BOOL; END_VAR\n# here #\n+--\\--[ ]( a )--\\--<JMP>( done )--+\n|  /--[ ]( b )--/--<CALL>( dose )--+\n\
             +--[ ]( a )--\\--( )( y )--+\n|            /--<LBL>( done )--+\n+--<FUN>( dose )--<LBL>( inner )--+\n",
            expect![[r#"
                # start #
                VAR_INPUT a : BOOL; END_VAR
                # here #
                <program>
                +--\--[ ]( a )--\--<JMP>( done )--+
                |  /--[ ]( b )--/--<CALL>( dose )--+
                <jumps>
                +--[ ]( a )--\--( )( y )--+
                |            /--<LBL>( done )--+
                <jumps>
                <calls>
                +--<FUN>( dose )--<LBL>( inner )--+
            "#]],
        );
    }

    #[test]
    fn a_file_without_a_program() {
        check(
            "VAR_GLOBAL a : BOOL; END_VAR\n",
            expect![[r#"
            VAR_GLOBAL a : BOOL; END_VAR
        "#]],
        );
        check(
            "+--<FUN>( dose )--+\n",
            expect![[r#"
            <calls>
            +--<FUN>( dose )--+
        "#]],
        );
        check(
            "FUNCTION_BLOCK [$B]\n+--[ ]( EN )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
            expect![[r#"
                FUNCTION_BLOCK [$B]
                +--[ ]( EN )--( )( ENO )--+
                END_FUNCTION_BLOCK
            "#]],
        );
    }
}
