//! Inlay hints: what a coil computes, at the end of its line.
//!
//! A hint within a rung would shift the columns of everything right of it, so they are after the last character of
//! a line and nowhere else.

use crate::body::line_text;
use ladder_analysis::context::Context;
use ladder_analysis::formulas;
use ladder_instructions::Shape;
use ladder_syntax::{TextRange, TextSize};

/// A hint at the end of a line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Inlay {
    /// The end of the line.
    pub at: TextSize,
    /// What it says.
    pub label: String,
    /// All of it, where the label is cut.
    pub whole: Option<String>,
}

/// A longer hint is cut: most of a screen is for the drawing.
const WIDTH: usize = 60;

/// The hints at the lines that touch a range: `run := (start OR run) AND NOT stop`.
pub fn inlays(context: &Context, within: TextRange) -> Vec<Inlay> {
    let parse = &context.parse;
    let first = context
        .networks
        .partition_point(|network| network.range.end() <= within.start());
    let mut inlays = Vec::new();
    for (index, network) in context.networks.iter().enumerate().skip(first) {
        if network.range.start() > within.end() {
            break;
        }
        if !network.blocks().any(|bound| bound.facts.shape == Shape::Coil) {
            continue;
        }
        let Some(formulas) = formulas(context, index) else {
            continue;
        };
        // The coils of one rung share the end of its line.
        let mut of_rungs: Vec<Vec<String>> = vec![Vec::new(); network.wiring.rungs.len()];
        for (block, effect) in formulas.effects() {
            let facts = &network.block(block).bound().facts;
            if facts.shape == Shape::Coil {
                of_rungs[facts.rung].push(effect);
            }
        }
        for (rung, effects) in of_rungs
            .into_iter()
            .enumerate()
            .filter(|(_, effects)| !effects.is_empty())
        {
            let line = network.line(rung);
            let end = end_of_line(&line_text(parse, line));
            let at = parse.line_start(line) + TextSize::new(end as u32);
            if parse.line_start(line) > within.end() || at < within.start() {
                continue;
            }
            let whole = effects.join("; ");
            let cut = whole.chars().count() > WIDTH;
            inlays.push(Inlay {
                at,
                label: if cut {
                    whole.chars().take(WIDTH - 3).chain("...".chars()).collect()
                } else {
                    whole.clone()
                },
                whole: cut.then_some(whole),
            });
        }
    }
    inlays
}

/// Where a line ends before its line end. One that spans lines ends where its last does.
fn end_of_line(line: &str) -> usize {
    line.trim_end_matches(['\n', '\r']).len()
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::{Expect, expect};
    use std::sync::Arc;

    fn check(text: &str, expected: Expect) {
        let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(text)), "test.clad");
        let mut shown = text.to_owned();
        let all = TextRange::up_to(TextSize::of(text));
        for inlay in inlays(&analysis.context, all).iter().rev() {
            let at = usize::from(inlay.at);
            assert!(
                text[at..].is_empty() || text[at..].starts_with(['\n', '\r']),
                "only at line ends"
            );
            shown.insert_str(at, &format!("  {{{}}}", inlay.label));
        }
        expected.assert_eq(&shown.replace('\r', ""));
    }

    #[test]
    fn formulas_at_line_ends() {
        check(
            "+--\\--[ ]( start )--\\--[/]( stop )--\\--( )( run )--\\--+\n|  /--[ ]( run )----/           /--(S)( seen )--/  |   \n\
             +--[ ]( run )--[TON]( t, 5s )--( )( a )--( )( b )--+  # two #\n+--[ ]( x )--[ADD]( n, n, 1 )--+\n",
            expect![[r#"
                +--\--[ ]( start )--\--[/]( stop )--\--( )( run )--\--+  {run := (start OR run) AND NOT stop}
                |  /--[ ]( run )----/           /--(S)( seen )--/  |     {seen := seen OR (start OR run) AND NOT stop}
                +--[ ]( run )--[TON]( t, 5s )--( )( a )--( )( b )--+  # two #  {a := t.Q; b := t.Q}
                +--[ ]( x )--[ADD]( n, n, 1 )--+
            "#]],
        );
        check("+--[ ]( a )--( )( y", expect!["+--[ ]( a )--( )( y"]);
        let long = "+--[ ]( the_first_of_many )--[ ]( the_second_of_many )--[ ]( the_third_of_many )--( )( y )--+\r\n";
        check(
            long,
            expect![[r#"
                +--[ ]( the_first_of_many )--[ ]( the_second_of_many )--[ ]( the_third_of_many )--( )( y )--+  {y := the_first_of_many AND the_second_of_many AND the_thi...}
            "#]],
        );
    }

    #[test]
    fn only_where_a_user_looks() {
        let text = "+--[ ]( a )--( )( b )--+\n".repeat(10);
        let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(&text)), "test.clad");
        let line = TextRange::at(TextSize::new(25 * 4 + 3), TextSize::new(5));
        assert_eq!(inlays(&analysis.context, line).len(), 1);
    }
}
