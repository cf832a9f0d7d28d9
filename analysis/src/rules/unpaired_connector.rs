//! `unpaired-connector`: a `\` without its `/` on the rung below, or the other way round.

use crate::context::{Context, rung_above, rung_below};
use crate::diagnostic::Diagnostic;
use crate::excerpt::{columns, nth, trimmed_line};
use crate::network::{NetworkFacts, breaks_drawing};
use crate::rule::Rule;
use ladder_syntax::wiring::{self, PartKind, Rung};
use ladder_syntax::{Parse, TextRange, TextSize};

/// How many connectors of one line are told: whoever draws more of them without partners knows.
const MOST: usize = 10;

pub(crate) fn check(context: &Context, network: &NetworkFacts, out: &mut Vec<Diagnostic>) {
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
        let rung = wiring::rung(&parse.lines()[line]);
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
    // A mistake in the text may have swallowed the partner.
    let misread = |line: usize| parse.lines()[line].errors.iter().any(breaks_drawing);
    if misread(line) || other_line.is_some_and(misread) {
        return;
    }
    let own = Side::new(parse, line, kind);
    let other = other_line.map(|line| Side::new(parse, line, partner(kind)));
    let paired = other.as_ref().map_or(0, |other| other.parts.len());
    let culprits = other.as_ref().and_then(|other| culprits(&own, other));
    let belongs = other.as_ref().map(|other| trimmed_line(parse, other.line));
    for (index, ordinal) in (paired..own.parts.len()).enumerate().take(MOST) {
        let suspect = culprits.as_ref().map_or(ordinal, |culprits| culprits[index]);
        let range = own.range(parse, ordinal);
        let mut found = Diagnostic::new(
            Rule::UnpairedConnector,
            range,
            message(context, &own, other.as_ref(), ordinal),
        );
        found = if suspect == ordinal {
            found.help(help(kind))
        } else {
            // Columns say what was meant, the order says what it is.
            let (name, partner_name) = (symbol(kind), symbol(partner(kind)));
            found
                .help(format!(
                    "connectors pair in their order from left to right, whatever their columns: the partner is probably \
                     missing at the {} `{name}`",
                    nth(suspect)
                ))
                .related(
                    own.range(parse, suspect),
                    format!("no `{partner_name}` stands {} this `{name}`", beside(kind)),
                )
        };
        if let Some(rung) = belongs {
            found = found.related(
                rung,
                format!("its partner `{}` belongs onto this rung", symbol(partner(kind))),
            );
        }
        out.push(with_fix(parse, &own, other.as_ref(), suspect, found));
    }
}

/// The connectors that have nothing in their column on the other line, if exactly as many as there are too many
/// have not.
fn culprits(own: &Side, other: &Side) -> Option<Vec<usize>> {
    let alone: Vec<usize> = (0..own.parts.len())
        .filter(|&n| other.columns.binary_search(&own.columns[n]).is_err())
        .collect();
    (alone.len() == own.parts.len() - other.parts.len()).then_some(alone)
}

fn message(context: &Context, own: &Side, other: Option<&Side>, ordinal: usize) -> String {
    let parse = &*context.parse;
    let number = |offset| context.line_number(offset);
    let name = symbol(own.kind);
    let here = number(own.range(parse, ordinal).start());
    let which = if own.parts.len() == 1 {
        format!("the `{name}` on line {here} has no partner")
    } else {
        format!("the {} `{name}` on line {here} has no partner", nth(ordinal))
    };
    let Some(other) = other else {
        return format!("{which}: there is no rung {} it", beside(own.kind));
    };
    let (partner, beside) = (symbol(other.kind), beside(own.kind));
    let there = number(trimmed_line(parse, other.line).start());
    match other.parts.len() {
        0 => format!("{which}: line {there} {beside} it has no `{partner}`"),
        count => format!(
            "{which}: line {here} has {} `{name}`, line {there} {beside} it has {count} `{partner}`",
            own.parts.len(),
        ),
    }
}

/// Puts the partner onto the wire in the same column, or makes the connector a wire.
fn with_fix(
    parse: &Parse,
    own: &Side,
    other: Option<&Side>,
    suspect: usize,
    found: Diagnostic,
) -> Diagnostic {
    let wire = other.and_then(|other| {
        let wires = || other.rung.parts.iter().filter(|part| part.kind == PartKind::Wire);
        let firsts = columns(parse, other.line, wires().map(|part| part.range.start()));
        wires().zip(firsts).find_map(|(part, first)| {
            let within = own.columns[suspect].checked_sub(first)?;
            let at = part.range.start() + TextSize::new(within as u32);
            let start = parse.line_start(other.line);
            (at < part.range.end()).then(|| TextRange::at(at + start, TextSize::new(1)))
        })
    });
    if let (Some(at), Some(other)) = (wire, other) {
        let partner = symbol(other.kind);
        return found.fix(
            format!("Join with `{partner}` {} it", beside(own.kind)),
            at,
            partner,
        );
    }
    let part = own.parts[suspect];
    let touches_behind = own.rung.parts.get(part + 1).is_some_and(|next| next.touches);
    if own.rung.parts[part].touches && touches_behind {
        return found.fix(
            format!("Replace `{}` with wire", symbol(own.kind)),
            own.range(parse, suspect),
            "-",
        );
    }
    found
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

const fn beside(kind: PartKind) -> &'static str {
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
