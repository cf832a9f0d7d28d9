//! `misplaced-rail`: a `+` in the middle of a line, or a `|` in the middle of a wire.

mod bar_contact;

use super::form::Form;
use super::unpaired_connector::completion;
use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::excerpt::columns;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::networks::network::breaks_drawing;
use ladder_syntax::TextRange;
use ladder_syntax::wiring::{BarContact, PartKind, RungPart, bar_contacts};

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Text, "misplaced-rail", Severity::Error).fixed(Applicability::Unsafe));

pub(super) fn check(form: &Form<'_>, out: &mut Vec<Diagnostic>) {
    let network = form.network;
    for (rung, drawing) in network.wiring.rungs.iter().enumerate() {
        let is_stray = |part: &RungPart| matches!(part.kind, PartKind::StrayRail | PartKind::StrayBar);
        let line = &form.parse.lines()[network.line(rung)];
        let contacts: Vec<BarContact> = bar_contacts(&drawing.parts).collect();
        let is_drawn_well = contacts.is_empty() && !drawing.parts.iter().any(is_stray);
        if is_drawn_well || line.errors.iter().any(breaks_drawing) {
            continue;
        }
        out.extend(bar_contact::findings(form, rung, &contacts));
        let missing = completion::missing(form.parse, network.line(rung));
        let starts = drawing.parts.iter().map(|part| part.range.start());
        let columns = columns(form.parse, network.line(rung), starts);
        for (index, part) in drawing.parts.iter().enumerate() {
            let (message, help) = match part.kind {
                PartKind::StrayRail => (
                    "`+` is in the middle of a line",
                    "`+` is where a line leaves the left rail or ends at the right rail; lines are joined with \\ and /",
                ),
                PartKind::StrayBar => (
                    "`|` cuts the wire",
                    "`|` only draws the rails and verticals; lines are joined with \\ and /",
                ),
                _ => continue,
            };
            if contacts.iter().any(|contact| contact.parts.contains(&index)) {
                continue;
            }
            let range = network.part_range(form.parse, rung, index);
            let right = index > 0 && drawing.parts[index - 1].kind == PartKind::StrayRail && !part.touches;
            if part.kind == PartKind::StrayRail && right {
                // Said with the `+` before it.
                continue;
            }
            if let Some(next) = drawing.parts.get(index + 1)
                && part.kind == PartKind::StrayRail
                && next.kind == PartKind::StrayRail
                && !next.touches
            {
                let next = network.part_range(form.parse, rung, index + 1);
                out.push(
                    Diagnostic::new(RULE, range.cover(next), "a second rung begins on this line")
                        .help("each rung belongs on a line of its own")
                        .fix(
                            Applicability::Unsafe,
                            "Break the line",
                            TextRange::new(range.end(), next.start()),
                            "\n",
                        ),
                );
                continue;
            }
            let mut found = Diagnostic::new(RULE, range, message).help(help);
            // A connector may be meant. Where none is missing, what is meant the drawing does not say.
            if let Some(meant) = completion::nearest(&missing, columns[index]) {
                let title = format!("Replace with `{meant}`");
                found = found.fix(Applicability::Unsafe, title, range, meant);
            }
            out.push(found);
        }
    }
}
