//! Selections that grow: operand, block, segment, rung, network, function or block definition, file.

use crate::body::{self, without_line_end};
use crate::comments;
use crate::locate::{OnRung, on_rung};
use ladder_analysis::context::Context;
use ladder_analysis::written::facts::{Node, NodeKind};
use ladder_syntax::{LineKind, TextRange, TextSize};

/// The ranges around an offset from the innermost to the whole file, each larger than the one before.
pub fn selections(context: &Context, offset: TextSize) -> Vec<TextRange> {
    let parse = &context.parse;
    let mut grown = Grown {
        ranges: Vec::new(),
        offset,
    };
    if let Some(line) = parse.line_at(offset) {
        words(context, line, &mut grown);
        match parse.lines()[line].kind {
            LineKind::Rung => {
                if let Some(place) = on_rung(context, offset) {
                    drawing(context, &place, &mut grown);
                }
                grown.add(without_line_end(context, parse.line_range(line)));
                // A cursor after what is half-written is on blanks.
                grown.add(line_text(context, line));
                network(context, line, &mut grown);
            }
            _ => {
                grown.add(without_line_end(context, parse.line_range(line)));
                network(context, line, &mut grown);
                comment_run(context, line, &mut grown);
            }
        }
        around(context, line, &mut grown);
    }
    grown.add(TextRange::up_to(parse.text_len()));
    if grown.ranges.is_empty() {
        grown.ranges.push(TextRange::up_to(parse.text_len()));
    }
    grown.ranges
}

struct Grown {
    ranges: Vec<TextRange>,
    offset: TextSize,
}

impl Grown {
    /// Adds a range that is larger than the last; any other is left out.
    fn add(&mut self, range: TextRange) {
        let larger = match self.ranges.last() {
            Some(last) => range.contains_range(*last) && range.len() > last.len(),
            None => range.contains_inclusive(self.offset) && !range.is_empty(),
        };
        if larger {
            self.ranges.push(range);
        }
    }
}

/// A line without its line end.
fn line_text(context: &Context, line: usize) -> TextRange {
    let range = context.parse.line_range(line);
    let text = body::line_text(&context.parse, line);
    let end = text.len() - text.trim_end_matches(['\r', '\n']).len();
    TextRange::new(range.start(), range.end() - TextSize::new(end as u32))
}

/// The word or comment at the offset.
fn words(context: &Context, line: usize, grown: &mut Grown) {
    let parse = &context.parse;
    let start = parse.line_start(line);
    let syntax = parse.lines()[line].syntax();
    let tokens = syntax.token_at_offset(grown.offset - start);
    let solid = tokens.filter(|token| !token.kind().is_trivia() || token.text().starts_with('#'));
    // Between two the word is meant, not the bracket.
    let word = solid.max_by_key(|token| {
        let first = token.text().chars().next();
        first.is_some_and(|c| c.is_alphanumeric() || matches!(c, '_' | '%' | '$' | '\''))
    });
    if let Some(token) = word {
        grown.add(token.text_range() + start);
        // In the tree: names with members, declarations, operands.
        for node in token
            .parent_ancestors()
            .take_while(|node| node.parent().is_some())
        {
            grown.add(node.text_range() + start);
        }
    }
}

fn drawing(context: &Context, place: &OnRung<'_>, grown: &mut Grown) {
    let facts = context.networks.at(place.network);
    if let Some(block) = place.block {
        let within = grown.offset.checked_sub(block.base).unwrap_or_default();
        for operand in &block.facts.operands {
            if operand.range.contains_inclusive(within) {
                path(&operand.value, within, &mut |range| {
                    grown.add(block.absolute(range));
                });
                grown.add(block.absolute(operand.range));
            }
        }
        grown.add(block.range());
    }
    grown.add(facts.part_range(&context.parse, place.rung, place.part));
    let rung = &facts.wiring.rungs[place.rung];
    if let Some(segment) = place.drawn.segment.and_then(|it| rung.segments.get(it as usize)) {
        let (first, last) = (segment.parts.start, segment.parts.end - 1);
        let range = |part| facts.part_range(&context.parse, place.rung, part);
        grown.add(range(first).cover(range(last)));
    }
}

/// The expressions around an offset, from the innermost.
fn path(node: &Node, offset: TextSize, add: &mut impl FnMut(TextRange)) {
    if !node.range.contains_inclusive(offset) {
        return;
    }
    let inner: Vec<&Node> = match &node.kind {
        NodeKind::Member(base, _) | NodeKind::Unary(_, base) | NodeKind::Paren(base) => vec![base],
        NodeKind::Index(base, index) => vec![base, index],
        NodeKind::Range(base, first, last) => vec![base, first, last],
        NodeKind::Binary(_, left, right) => vec![left, right],
        NodeKind::Call(_, values) | NodeKind::Array(values) | NodeKind::Repeat(_, values) => {
            values.iter().collect()
        }
        _ => Vec::new(),
    };
    for inner in inner {
        path(inner, offset, add);
    }
    add(node.range);
}

/// The network that a line belongs to, then with the comments above it.
fn network(context: &Context, line: usize, grown: &mut Grown) {
    let Some(network) = context.networks.on_line(line) else {
        return;
    };
    let range = without_line_end(context, network.range);
    grown.add(range);
    if let Some((first, _)) = comments::above(context, network.first_line) {
        grown.add(TextRange::new(context.parse.line_start(first), range.end()));
    }
}

/// The comments one below the other.
fn comment_run(context: &Context, line: usize, grown: &mut Grown) {
    let lines = context.parse.lines();
    if lines[line].kind != LineKind::Comment {
        return;
    }
    let comment = |it: &usize| lines[*it].kind == LineKind::Comment;
    let first = (0..=line).rev().take_while(comment).last().unwrap_or(line);
    let last = (line..lines.len()).take_while(comment).last().unwrap_or(line);
    let range = TextRange::new(
        context.parse.line_start(first),
        context.parse.line_range(last).end(),
    );
    grown.add(without_line_end(context, range));
}

/// The section, the function, the block definition.
fn around(context: &Context, line: usize, grown: &mut Grown) {
    let parse = &context.parse;
    let structure = parse.structure_once();
    let lines = |lines: &std::ops::Range<usize>| {
        let range = TextRange::new(
            parse.line_start(lines.start),
            parse.line_range(lines.end - 1).end(),
        );
        without_line_end(context, range)
    };
    if let Some(section) = structure.sections.iter().find(|it| it.lines.contains(&line)) {
        grown.add(lines(&section.lines));
    }
    let network = structure.networks.partition_point(|it| it.lines.end <= line);
    if structure
        .networks
        .get(network)
        .is_some_and(|it| it.lines.contains(&line))
    {
        let body = context.bodies[network];
        grown.add(body::networks(context, body).unwrap_or_default());
    }
    if let Some(block) = structure.blocks.iter().find(|it| it.lines.contains(&line)) {
        grown.add(lines(&block.lines));
    }
}

#[cfg(test)]
mod tests {
    use super::selections;
    use crate::fixture::Fixture;
    use expect_test::{Expect, expect};

    fn check(text: &str, expected: Expect) {
        let fixture = Fixture::new(text);
        let (context, offset, _) = fixture.ask();
        let shown = selections(context, offset).into_iter().map(|range| {
            let text = fixture.text("main.clad")[range].replace('\n', "⏎");
            format!("{text}.\n")
        });
        expected.assert_eq(&shown.collect::<Vec<_>>().concat());
    }

    #[test]
    fn on_a_rung() {
        check(
            "+--( )( z )--+\n\n# motor #\n+--\\--[ ]( start )--\\--[GT]( a[i$0 + 1], 3 )--( )( run )--+\n|  /--[ ]( run )----/\n",
            expect![[r#"
                i.
                i + 1.
                a[i + 1].
                ( a[i + 1], 3 ).
                [GT]( a[i + 1], 3 ).
                +--\--[ ]( start )--\--[GT]( a[i + 1], 3 )--( )( run )--+.
                +--\--[ ]( start )--\--[GT]( a[i + 1], 3 )--( )( run )--+⏎|  /--[ ]( run )----/.
                # motor #⏎+--\--[ ]( start )--\--[GT]( a[i + 1], 3 )--( )( run )--+⏎|  /--[ ]( run )----/.
                +--( )( z )--+⏎⏎# motor #⏎+--\--[ ]( start )--\--[GT]( a[i + 1], 3 )--( )( run )--+⏎|  /--[ ]( run )----/.
                +--( )( z )--+⏎⏎# motor #⏎+--\--[ ]( start )--\--[GT]( a[i + 1], 3 )--( )( run )--+⏎|  /--[ ]( run )----/⏎.
            "#]],
        );
        check(
            "+--[ ]( a )-$0-|  --( )( y )--+\n",
            expect![[r#"
                --.
                +--[ ]( a )--.
                +--[ ]( a )--|  --( )( y )--+.
                +--[ ]( a )--|  --( )( y )--+⏎.
            "#]],
        );
        check(
            "+--[T$0ON]( t, 5s )--+\n+--<FUN>( f )--+\n",
            expect![[r#"
                TON.
                [TON].
                [TON]( t, 5s ).
                +--[TON]( t, 5s )--+.
                +--[TON]( t, 5s )--+⏎+--<FUN>( f )--+⏎.
            "#]],
        );
        check(
            "+--<FUN>( f )--+\n|\n+--( )( $0 )--+\n",
            expect![[r#"
                ( )(  ).
                +--( )(  )--+.
                +--<FUN>( f )--+⏎|⏎+--( )(  )--+.
                +--<FUN>( f )--+⏎|⏎+--( )(  )--+⏎.
            "#]],
        );
    }

    #[test]
    fn outside_of_networks() {
        check(
            "VAR\n  a, b$0 : INT;\nEND_VAR\n+--( )( y )--+\n",
            expect![[r#"
                b.
                a, b.
                  a, b : INT;.
                VAR⏎  a, b : INT;⏎END_VAR.
                VAR⏎  a, b : INT;⏎END_VAR⏎+--( )( y )--+⏎.
            "#]],
        );
        check(
            "# one #\n# tw$0o #\n\n+--( )( y )--+\n",
            expect![[r#"
                # two #.
                # one #⏎# two #.
                # one #⏎# two #⏎⏎+--( )( y )--+⏎.
            "#]],
        );
        check(
            "FUNCTION_BLOCK [$B]\nVAR_INPUT raw$0 : BOOL; END_VAR\n+--( )( raw )--+\nEND_FUNCTION_BLOCK\n",
            expect![[r#"
                raw.
                raw : BOOL;.
                VAR_INPUT raw : BOOL; END_VAR.
                FUNCTION_BLOCK [$B]⏎VAR_INPUT raw : BOOL; END_VAR⏎+--( )( raw )--+⏎END_FUNCTION_BLOCK.
                FUNCTION_BLOCK [$B]⏎VAR_INPUT raw : BOOL; END_VAR⏎+--( )( raw )--+⏎END_FUNCTION_BLOCK⏎.
            "#]],
        );
        check(
            "$0",
            expect![[r#"
                .
            "#]],
        );
        check(
            "\n\n$0\n",
            expect![[r#"
                ⏎⏎⏎.
            "#]],
        );
        check(
            "+--[GT]( a, $0\n",
            expect![[r#"
                +--[GT]( a, .
                +--[GT]( a, ⏎.
            "#]],
        );
    }
}
