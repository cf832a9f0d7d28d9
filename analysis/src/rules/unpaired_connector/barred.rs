//! A branch between two others that is drawn from `|` to `|`, where the language has `/--\` and `\--/`.

use super::Side;
use super::completion::{NEAR, Row};
use crate::findings::diagnostic::{Applicability, Diagnostic, Fix};
use crate::names::context::Context;
use crate::networks::neighbours::{rung_above, rung_below};
use ladder_format::Edit;
use ladder_syntax::wiring::PartKind;
use ladder_syntax::{Parse, TextRange};

/// The first and the last `|` of a rung that wire leaves and comes to, each near to a connector of its neighbour.
fn bars(row: &Row, columns: &[usize]) -> Option<(usize, usize)> {
    let parts = &row.rung.parts;
    let is_bar = |part: usize| matches!(parts[part].kind, PartKind::Bar | PartKind::StrayBar);
    let wire = |part: usize| parts.get(part).is_some_and(|part| part.segment.is_some());
    let near = |part: usize| {
        columns
            .iter()
            .any(|column| column.abs_diff(row.spans[part].0) <= NEAR)
    };
    let leaves = |&part: &usize| is_bar(part) && near(part) && wire(part + 1) && parts[part + 1].touches;
    let comes = |&part: &usize| {
        is_bar(part) && near(part) && parts[part].touches && part.checked_sub(1).is_some_and(wire)
    };
    let first = (0..parts.len()).find(leaves)?;
    let last = (first + 1..parts.len()).rfind(comes)?;
    Some((first, last))
}

/// This many branches between two others are checked.
const MOST: usize = 20;

/// The finding, where connectors have no partners because the rungs up to the next one with connectors are such branches.
pub(super) fn found(context: &Context, own: &Side, other: &Side) -> Option<Diagnostic> {
    let parse: &Parse = &context.parse;
    let mut line = other.line;
    let mut barred: Vec<(TextRange, TextRange)> = Vec::new();
    loop {
        let row = Row::new(parse, line);
        if row.rung.connectors(other.kind).next().is_some() {
            break;
        }
        let (first, last) = bars(&row, &own.columns)?;
        barred.push((row.range(parse, first), row.range(parse, last)));
        line = match own.kind {
            PartKind::Down => rung_below(parse, line),
            _ => rung_above(parse, line),
        }
        .filter(|_| barred.len() < MOST)?;
    }
    let &(first, last) = barred.first()?;
    barred.sort_by_key(|(first, _)| first.start());
    let edit = |range, text: &str| Edit {
        range,
        text: text.to_owned(),
    };
    let edits = barred
        .iter()
        .flat_map(|&(first, last)| [edit(first, "/--\\"), edit(last, "\\--/")]);
    let mut found = Diagnostic::new(
        crate::rules::unpaired_connector::RULE,
        own.range(parse, 0),
        format!(
            "the branch on line {} begins and ends with `|`, which is decoration: nothing joins it to the branch {} it",
            context.line_number(first.start()),
            match own.kind {
                PartKind::Down => "above",
                _ => "below",
            }
        ),
    )
    .help("a branch between two others begins with `/--\\` and ends with `\\--/`")
    .related(first, "no power comes to this `|`".to_owned())
    .related(last, "no power leaves this `|`".to_owned());
    found.fixes = vec![Fix::new(
        Applicability::Unsafe,
        "Draw it with `/--\\` and `\\--/`",
        edits.collect(),
    )];
    Some(found)
}
