//! `merge-conflict`: both forms of something are in the text, between the comments of a merge.

use crate::context::Context;
use crate::findings::diagnostic::{Applicability, Diagnostic, Fix};
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use ladder_format::Edit;
use ladder_syntax::{LineKind, Parse, Part, TextRange};

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Text, "merge-conflict", Severity::Error).fixed(Applicability::Unsafe));

/// A comment of a merge, by its signs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Sign {
    Ours,
    Theirs,
    End,
}

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let parse = &*context.parse;
    let commented = parse.lines().of_parts_that(Part::is_commented);
    let comments = commented.filter(|(_, line)| matches!(line.kind, LineKind::Comment | LineKind::Rail));
    let mut signs = comments.filter_map(|(number, line)| Some((number, sign(line.text())?)));
    let mut open: Option<(usize, Option<usize>)> = None;
    for (line, sign) in signs.by_ref() {
        match (sign, open) {
            (Sign::Ours, _) => {
                if let Some((ours, _)) = open.replace((line, None)) {
                    out.push(found(parse, ours));
                }
            }
            (Sign::Theirs, Some((ours, None))) => open = Some((ours, Some(line))),
            (Sign::End, Some((ours, Some(theirs)))) => {
                out.push(with_fixes(found(parse, ours), parse, [ours, theirs, line]));
                open = None;
            }
            // A line of signs may be one under a title; without the others only the end of a conflict is one.
            (Sign::Theirs, _) => {}
            (Sign::End, Some((ours, None))) => {
                out.push(found(parse, ours));
                open = None;
            }
            (Sign::End, None) => out.push(found(parse, line)),
        }
    }
    out.extend(open.map(|(ours, _)| found(parse, ours)));
}

/// Which sign a comment line is.
fn sign(text: &str) -> Option<Sign> {
    // Cheap: most comments are none.
    let text = text.trim().strip_prefix('#')?.trim_start();
    let (sign, after) = match text.as_bytes().first()? {
        b'<' => (Sign::Ours, text.strip_prefix("<<<<<<<")?),
        b'=' => (Sign::Theirs, text.strip_prefix("=======")?),
        b'>' => (Sign::End, text.strip_prefix(">>>>>>>")?),
        _ => return None,
    };
    after.starts_with([' ', '#']).then_some(sign)
}

fn found(parse: &Parse, line: usize) -> Diagnostic {
    let range = parse.line_range(line);
    let text = parse.text_in(range);
    let before = text.len() - text.trim_start().len();
    let start = range.start() + ladder_syntax::TextSize::new(before as u32);
    Diagnostic::new(
        RULE,
        TextRange::at(start, ladder_syntax::TextSize::of(text.trim())),
        "a merge left both forms of something here: it is not decided which one holds",
    )
    .help("keep one of the two, or make one of them, and remove the three comments")
}

/// Keeping one form is taking out the other, with the three comments.
fn with_fixes(found: Diagnostic, parse: &Parse, [ours, theirs, end]: [usize; 3]) -> Diagnostic {
    let without = |lines: [(usize, usize); 2]| -> Vec<Edit> {
        let edits = lines.map(|(first, last)| Edit {
            range: parse.line_range(first).cover(parse.line_range(last)),
            text: String::new(),
        });
        edits.into()
    };
    let keep = |title: &str, edits| Fix::new(Applicability::Unsafe, title, edits);
    found
        .with(keep("Keep ours", without([(ours, ours), (theirs, end)])))
        .with(keep("Keep theirs", without([(ours, theirs), (end, end)])))
}
