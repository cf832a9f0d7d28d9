//! What can be folded away: sections, structures, networks of several lines, functions, block definitions, runs of comments.

use crate::body::without_line_end;
use ladder_analysis::context::Body;
use ladder_analysis::context::Context;
use ladder_syntax::{Item, LineKind, TextRange};
use std::ops::Range;

/// A stretch of several lines that an editor may fold to its first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fold {
    /// From its first line to the end of its last, without that line's end.
    pub range: TextRange,
    /// Whether it holds nothing but comments.
    pub comment: bool,
}

/// The folds of a file by where they begin, outer ones first.
pub fn folds(context: &Context) -> Vec<Fold> {
    let parse = &context.parse;
    let structure = parse.structure_once();
    let of_lines = |lines: std::ops::Range<usize>| {
        let range = TextRange::new(
            parse.line_start(lines.start),
            parse.line_range(lines.end - 1).end(),
        );
        without_line_end(context, range)
    };
    let mut ranges: Vec<TextRange> = Vec::new();
    ranges.extend(structure.sections.iter().map(|it| of_lines(it.lines.clone())));
    for section in &structure.sections {
        ranges.extend(
            structures(context, section.lines.clone())
                .into_iter()
                .map(of_lines),
        );
    }
    ranges.extend(structure.blocks.iter().map(|it| of_lines(it.lines.clone())));
    ranges.extend(structure.networks.iter().map(|it| of_lines(it.lines.clone())));
    ranges.extend(functions(context));
    let mut folds: Vec<Fold> = ranges
        .into_iter()
        .map(|range| Fold {
            range,
            comment: false,
        })
        .collect();
    folds.extend(comments(context).map(|range| Fold { range, comment: true }));
    folds.retain(|fold| context.line_number(fold.range.start()) < context.line_number(fold.range.end()));
    folds.sort_by_key(|fold| (fold.range.start(), std::cmp::Reverse(fold.range.end())));
    folds.dedup();
    folds
}

/// The lines of each structure among those of a section.
fn structures(context: &Context, lines: Range<usize>) -> Vec<Range<usize>> {
    let kind = |line: usize| context.parse.lines()[line].kind;
    let headers = lines.clone().filter(|line| kind(*line) == LineKind::StructHeader);
    headers
        .filter_map(|header| {
            let mut after = header + 1..lines.end;
            let end = after.find(|line| kind(*line) == LineKind::StructEnd)?;
            Some(header..end + 1)
        })
        .collect()
}

/// The stretch of networks that each function takes up, as far as no block definition interrupts it.
fn functions(context: &Context) -> Vec<TextRange> {
    let mut ranges: Vec<TextRange> = Vec::new();
    let mut open = None;
    for item in &context.parse.structure_once().items {
        match *item {
            Item::Network(network) => {
                let body = context.bodies[network];
                let range = without_line_end(context, context.networks.at(network).range);
                match (body, ranges.last_mut()) {
                    (Body::Function(_), Some(last)) if open == Some(body) => *last = last.cover(range),
                    (Body::Function(_), _) => ranges.push(range),
                    _ => {}
                }
                open = Some(body);
            }
            Item::BlockHeader(_) | Item::BlockEnd(_) => open = None,
            _ => {}
        }
    }
    ranges
}

/// Comments on lines of their own, one below the other.
fn comments(context: &Context) -> impl Iterator<Item = TextRange> + '_ {
    let parse = &context.parse;
    let lines = parse.lines();
    let mut next = 0;
    std::iter::from_fn(move || {
        let first = (next..lines.len()).find(|&line| lines[line].kind == LineKind::Comment)?;
        let run = lines
            .from(first)
            .take_while(|line| line.kind == LineKind::Comment);
        next = first + run.count();
        let range = TextRange::new(parse.line_start(first), parse.line_range(next - 1).end());
        Some(without_line_end(context, range))
    })
}

#[cfg(test)]
mod tests {
    use super::folds;
    use crate::fixture::Fixture;
    use expect_test::{Expect, expect};

    fn check(text: &str, expected: Expect) {
        let fixture = Fixture::new(text);
        let context = &fixture.files[0].0.context;
        let shown = folds(&fixture.files[0].0.context).into_iter().map(|fold| {
            let line = |offset| context.line_number(offset);
            let comment = if fold.comment { " comment" } else { "" };
            format!(
                "{}-{}{comment}\n",
                line(fold.range.start()),
                line(fold.range.end())
            )
        });
        expected.assert_eq(&shown.collect::<Vec<_>>().concat());
    }

    #[test]
    fn what_folds() {
        check(
            "# a #\n# b\n   c #\n\nVAR\n  a : INT;\nEND_VAR\nVAR b : INT; END_VAR\n\
             +--\\--[ ]( a )--\\--( )( run )--+\n|  /--[ ]( run )--/             |\n\n+--( )( x )--+\n",
            expect![[r#"
                1-3 comment
                5-7
                9-10
            "#]],
        );
        check(
            "+--<CALL>( f )--+\n+--<FUN>( f )--+\n\n+--( )( x )--+\nFUNCTION_BLOCK [$B]\n# one #\n\
             VAR_INPUT\n a : BOOL;\nEND_VAR\n+--( )( a )--+\nEND_FUNCTION_BLOCK\n+--<FUN>( g )--+\n+--( )( z )--+",
            expect![[r#"
                2-4
                5-11
                7-9
                12-13
            "#]],
        );
        check(
            "VAR\n a :\n+--\\--[ ]( \r\n|  /--\r# open\n",
            expect![[r#"
            1-2
            3-4
        "#]],
        );
        check("", expect![[""]]);
    }
}
