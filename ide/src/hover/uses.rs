//! Who writes and who reads a tag: the lines, and a few of the rungs.

use crate::body::line_text;
use crate::markdown;
use ladder_analysis::AccessKind;
use ladder_analysis::context::Context;
use ladder_analysis::names::scope::{Origin, SectionKind, TagFacts};
use ladder_analysis::program::Access;
use ladder_syntax::{LineKind, TextSize};
use std::fmt::Write;

/// This many lines are named.
const MOST_LINES: usize = 8;

/// This many rungs are shown.
const MOST_RUNGS: usize = 3;

/// A rung that is wider than this is cut.
const WIDTH: usize = 100;

/// A line's number, as a link to it.
pub(super) fn line_link(line: usize) -> String {
    format!("[{line}](#L{line})")
}

/// Where a tag is written and read. `here`: where the user sees it already.
pub(super) fn card(context: &Context, tag: &TagFacts, here: Option<TextSize>) -> String {
    let mut card = String::new();
    let of_workspace = matches!(
        tag.origin,
        Origin::Declared(SectionKind::Global | SectionKind::External) | Origin::Shared
    );
    let here_only = if of_workspace && context.others.have_files() {
        " in this file"
    } else {
        ""
    };
    for (verb, wanted) in [
        ("Written", Access::writes as fn(Access) -> bool),
        ("Read", Access::reads),
    ] {
        let lines = lines(context, tag, wanted);
        let _ = match lines.as_slice() {
            [] => write!(card, "  \n{verb}{here_only}: nowhere"),
            [line] => write!(card, "  \n{verb}{here_only}: line {line}"),
            lines => write!(card, "  \n{verb}{here_only}: lines {}", lines.join(", ")),
        };
    }
    let rungs = rungs(context, tag, here);
    if !rungs.is_empty() {
        let _ = write!(card, "\n\n{}", markdown::drawing("clad", &rungs.join("\n")));
    }
    card
}

/// The lines of the uses that `wanted` takes, each once; those that set or reset the tag say so.
fn lines(context: &Context, tag: &TagFacts, wanted: impl Fn(Access) -> bool) -> Vec<String> {
    let uses = context.uses(tag).zip(tag.uses.access_kinds());
    let uses = uses.filter(|(place, _)| wanted(place.access));
    let mut lines: Vec<(usize, Option<AccessKind>)> = uses
        .map(|(place, kind)| {
            let latch = matches!(kind, AccessKind::Set | AccessKind::Reset).then_some(kind);
            (context.line_number(place.range.start()), latch)
        })
        .collect();
    lines.sort_unstable();
    lines.dedup();
    let more = lines.len().saturating_sub(MOST_LINES);
    let mut shown: Vec<String> = lines
        .iter()
        .take(MOST_LINES)
        .map(|&(line, latch)| match latch {
            Some(kind) => format!("{} ({})", line_link(line), kind.words()),
            None => line_link(line),
        })
        .collect();
    if more > 0 {
        shown.push(format!("and {more} more"));
    }
    shown
}

/// The first rungs that write the tag, then the first that read it, in the order of the text. The one that
/// the user sees already is left out.
fn rungs(context: &Context, tag: &TagFacts, here: Option<TextSize>) -> Vec<String> {
    let parse = &context.parse;
    let looked_at = here.and_then(|here| parse.line_at(here));
    let mut found: Vec<usize> = Vec::new();
    for wanted in [Access::writes as fn(Access) -> bool, Access::reads] {
        for place in context.uses(tag).filter(|place| wanted(place.access)) {
            if found.len() == MOST_RUNGS {
                break;
            }
            if let Some(line) = parse.line_at(place.range.start())
                && Some(line) != looked_at
                && !found.contains(&line)
            {
                found.push(line);
            }
        }
    }
    found.sort_unstable();
    let rungs = found
        .into_iter()
        .filter(|&line| parse.lines()[line].kind == LineKind::Rung);
    rungs
        .filter_map(|line| excerpt(&line_text(parse, line)))
        .collect()
}

/// A rung as it is drawn, cut at the end if it is wide. None if it spans lines.
fn excerpt(line: &str) -> Option<String> {
    let line = line.trim_end().trim_start_matches('\u{feff}');
    if line.contains(['\n', '\r', '`']) {
        return None;
    }
    if line.chars().count() <= WIDTH {
        return Some(line.to_owned());
    }
    let cut: String = line.chars().take(WIDTH - 3).collect();
    Some(cut + "...")
}
