//! `unpaired-connector`: a `\` without its `/` on the rung below, or the other way round.

mod barred;
pub(super) mod completion;

use super::form::Form;
use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::excerpt::{columns, trimmed_line};
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::context::Context;
use crate::networks::neighbours::{rung_above, rung_below};
use crate::networks::network::breaks_drawing;
use ladder_syntax::numeral::nth;
use ladder_syntax::wiring::{self, PartKind, Rung, bar_contacts};
use ladder_syntax::{Parse, TextRange};

pub(crate) const RULE: Rule = Rule(
    &RuleFacts::new(RuleGroup::Connectors, "unpaired-connector", Severity::Error)
        .fixed(Applicability::Unsafe),
);

/// How many connectors of one line are reported: more say nothing new.
const MOST: usize = 10;

/// With this many connectors on a line the columns are compared one by one.
const MOST_COMPARED: usize = 64;

pub(super) fn check(form: &Form<'_>, out: &mut Vec<Diagnostic>) {
    let network = form.network;
    // A network with a connector that lacks its partner is broken.
    let Some(context) = form.file else { return };
    let wiring = &network.wiring;
    for of_rung in wiring.unpaired.chunk_by(|a, b| a.0 == b.0) {
        let rung = of_rung[0].0;
        for kind in [PartKind::Up, PartKind::Down] {
            if of_rung
                .iter()
                .any(|&(_, part)| wiring.rungs[rung].parts[part].kind == kind)
            {
                unpaired(context, network.line(rung), kind, out);
            }
        }
    }
}

/// The connectors of one kind on a line, or on the line where their partners should be.
struct Side {
    line: usize,
    rung: Rung,
    kind: PartKind,
    /// The parts that are these connectors.
    parts: Vec<usize>,
    columns: Vec<usize>,
}

impl Side {
    fn new(parse: &Parse, line: usize, kind: PartKind) -> Side {
        let rung = wiring::rung(&parse.lines()[line].tree());
        let parts: Vec<usize> = rung.connectors(kind).collect();
        let starts = parts.iter().map(|&part| rung.parts[part].range.start());
        let columns = columns(parse, line, starts);
        Side {
            line,
            rung,
            kind,
            parts,
            columns,
        }
    }

    fn range(&self, parse: &Parse, ordinal: usize) -> TextRange {
        self.rung.parts[self.parts[ordinal]].range + parse.line_start(self.line)
    }
}

fn unpaired(context: &Context, line: usize, kind: PartKind, out: &mut Vec<Diagnostic>) {
    let parse = &*context.parse;
    let other_line = match kind {
        PartKind::Down => rung_below(parse, line),
        _ => rung_above(parse, line),
    };
    // An error in the text may have swallowed the partner.
    let misread = |line: usize| {
        let foreign = context.foreign_comments().on_line(line).is_some();
        // `--|/|--` is a contact.
        let is_contact = || {
            bar_contacts(&wiring::rung(&parse.lines()[line].tree()).parts)
                .next()
                .is_some()
        };
        foreign || is_contact() || parse.lines()[line].errors.iter().any(breaks_drawing)
    };
    let lines = parse.lines();
    let is_drawn = |line: &usize| !lines[*line].kind.is_decoration();
    let neighbour = match kind {
        PartKind::Down => (line + 1..lines.len()).find(is_drawn),
        _ => (0..line).rev().find(is_drawn),
    };
    let in_comment = neighbour.is_some_and(|line| context.foreign_comments().on_line(line).is_some());
    if in_comment || misread(line) || other_line.is_some_and(misread) {
        return;
    }
    let own = Side::new(parse, line, kind);
    let other = other_line.map(|line| Side::new(parse, line, partner(kind)));
    if let Some(found) = other
        .as_ref()
        .and_then(|other| barred::found(context, &own, other))
    {
        return out.push(found);
    }
    let paired = other.as_ref().map_or(0, |other| other.parts.len());
    let culprits = other.as_ref().and_then(|other| culprits(&own, other));
    let belongs = other.as_ref().map(|other| trimmed_line(parse, other.line));
    for (index, ordinal) in (paired..own.parts.len()).enumerate().take(MOST) {
        let suspect = culprits.as_ref().map_or(ordinal, |culprits| culprits[index]);
        let range = own.range(parse, ordinal);
        let mut found = Diagnostic::new(RULE, range, message(context, &own, other.as_ref(), ordinal));
        found = if suspect == ordinal {
            found.help(help(kind))
        } else {
            // Columns say what was meant, the order says what it is.
            let (name, partner_name) = (symbol(kind), symbol(partner(kind)));
            found
                .help(format!(
                    "connectors pair in their order from left to right, whatever their columns: the partner is probably \
                     missing at the {} `{name}`",
                    nth(suspect + 1)
                ))
                .related(
                    own.range(parse, suspect),
                    format!("no `{partner_name}` is {} this `{name}`", next_to(kind)),
                )
        };
        if let Some(rung) = belongs {
            found = found.related(
                rung,
                format!("its partner `{}` belongs onto this rung", symbol(partner(kind))),
            );
        }
        found.fixes = completion::fixes(parse, &own, other.as_ref(), suspect);
        out.push(found);
    }
}

/// The connectors that have nothing in their column on the other line, if exactly as many as there are too many
/// have not; else those that are left when every partner goes to a connector as near as can be.
fn culprits(own: &Side, other: &Side) -> Option<Vec<usize>> {
    let alone: Vec<usize> = (0..own.parts.len())
        .filter(|&n| other.columns.binary_search(&own.columns[n]).is_err())
        .collect();
    if alone.len() == own.parts.len() - other.parts.len() {
        return Some(alone);
    }
    (own.parts.len() <= MOST_COMPARED).then(|| left_over(&own.columns, &other.columns))
}

/// Which of some columns are left when each of the others, which are fewer, takes one of them in their order and all
/// distances together are smallest.
fn left_over(own: &[usize], other: &[usize]) -> Vec<usize> {
    // The smallest sum for the first `o` of the others among the first `n`.
    let mut sums = vec![vec![usize::MAX; other.len() + 1]; own.len() + 1];
    sums[0][0] = 0;
    for n in 1..=own.len() {
        sums[n][0] = 0;
        for o in 1..=other.len().min(n) {
            let taken = sums[n - 1][o - 1].saturating_add(own[n - 1].abs_diff(other[o - 1]));
            sums[n][o] = taken.min(sums[n - 1][o]);
        }
    }
    let (mut n, mut o) = (own.len(), other.len());
    let mut left = Vec::with_capacity(n - o);
    while n > 0 {
        if sums[n][o] == sums[n - 1][o] {
            left.push(n - 1);
        } else {
            o -= 1;
        }
        n -= 1;
    }
    left.reverse();
    left
}

fn message(context: &Context, own: &Side, other: Option<&Side>, ordinal: usize) -> String {
    let parse = &*context.parse;
    let number = |offset| context.line_number(offset);
    let name = symbol(own.kind);
    let here = number(own.range(parse, ordinal).start());
    let which = if own.parts.len() == 1 {
        format!("the `{name}` on line {here} has no partner")
    } else {
        format!("the {} `{name}` on line {here} has no partner", nth(ordinal + 1))
    };
    let Some(other) = other else {
        return format!("{which}: there is no rung {} it", next_to(own.kind));
    };
    let (partner, next_to) = (symbol(other.kind), next_to(own.kind));
    let there = number(trimmed_line(parse, other.line).start());
    match other.parts.len() {
        0 => format!("{which}: line {there} {next_to} it has no `{partner}`"),
        count => format!(
            "{which}: line {here} has {} `{name}`, line {there} {next_to} it has {count} `{partner}`",
            own.parts.len(),
        ),
    }
}

const fn partner(kind: PartKind) -> PartKind {
    match kind {
        PartKind::Down => PartKind::Up,
        _ => PartKind::Down,
    }
}

const fn symbol(kind: PartKind) -> &'static str {
    match kind {
        PartKind::Down => "\\",
        _ => "/",
    }
}

const fn next_to(kind: PartKind) -> &'static str {
    match kind {
        PartKind::Down => "below",
        _ => "above",
    }
}

const fn help(kind: PartKind) -> &'static str {
    match kind {
        PartKind::Down => "every `\\` needs a `/` on the rung below: together they join the two lines",
        _ => "every `/` needs a `\\` on the rung above: together they join the two lines",
    }
}
