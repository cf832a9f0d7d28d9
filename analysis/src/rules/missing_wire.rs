//! `missing-wire`: two blocks, or a block and a connector, touch without a `-` between them.

use super::form::Form;
use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::networks::NetworkAt;
use crate::networks::network::breaks_drawing;
use crate::written::facts::Head;
use ladder_instructions::{Shape, lookup};
use ladder_syntax::wiring::PartKind;
use ladder_syntax::{TextRange, TextSize};

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Text, "missing-wire", Severity::Warning).fixed(Applicability::Safe));

pub(super) fn check(form: &Form<'_>, out: &mut Vec<Diagnostic>) {
    let network = form.network;
    // Blocks are in the order of the rungs and parts, so one index follows them.
    let mut block = 0;
    for (rung, drawing) in network.wiring.rungs.iter().enumerate() {
        let line = network.line(rung);
        let start = form.parse.line_start(line);
        // Where a bracket is missing, two blocks touch because of that.
        let misread = form.parse.lines()[line].errors.iter().any(breaks_drawing);
        for (index, part) in drawing.parts.iter().enumerate() {
            let is_block = part.kind == PartKind::Block;
            block += usize::from(is_block);
            let Some(before) = index.checked_sub(1).filter(|_| part.touches) else {
                continue;
            };
            let before = &drawing.parts[before];
            let connects = |kind| {
                matches!(
                    kind,
                    PartKind::Down | PartKind::Up | PartKind::LeftRail | PartKind::RightRail
                )
            };
            let lacks_wire = match before.kind {
                PartKind::Block => is_block || connects(part.kind),
                kind => is_block && connects(kind),
            };
            // A connector without its partner is the greater error.
            let is_unpaired = |part| network.wiring.unpaired.binary_search(&(rung, part)).is_ok();
            if !lacks_wire || misread || is_unpaired(index) || is_unpaired(index - 1) {
                continue;
            }
            let seam = TextRange::new(before.range.end(), part.range.start()) + start;
            if is_block && before.kind == PartKind::Block && block >= 2 && takes_next_head(network, block - 2)
            {
                out.push(took_head(network, block - 2));
                continue;
            }
            out.push(
                Diagnostic::new(RULE, around(seam), message(before.kind, part.kind))
                    .help("draw a `-` between them")
                    // Things that touch are connected already.
                    .fix(Applicability::Safe, "Insert wire", seam, "--"),
            );
        }
    }
}

/// A place to show: the characters on both sides of the seam.
fn around(seam: TextRange) -> TextRange {
    let one = TextSize::new(1);
    TextRange::new(seam.start() - one, seam.end() + one)
}

fn message(before: PartKind, after: PartKind) -> String {
    let name = |kind| match kind {
        PartKind::Block => "a block",
        PartKind::Down => "`\\`",
        PartKind::Up => "`/`",
        _ => "`+`",
    };
    if before == after {
        return "two blocks touch without a wire between them".to_owned();
    }
    format!(
        "{} and {} touch without a wire between them",
        name(before),
        name(after)
    )
}

/// Whether a block without operands has taken the first part of the next one as its operand list, as in
/// `[OSR]( )( y )`.
pub(crate) fn takes_next_head(network: NetworkAt<'_>, index: usize) -> bool {
    let (Some(block), Some(next)) = (network.blocks.get(index), network.blocks.get(index + 1)) else {
        return false;
    };
    // `[NOT]` has a row with operands as well.
    let mut rows = lookup(block.facts.shape, block.facts.head.text());
    let mut without_operands = || rows.any(|row| row.limit() == Some(0));
    block.facts.list_range.is_some()
        && !block.faulty
        && next.facts.rung == block.facts.rung
        && next.facts.range.start() == block.facts.range.end()
        && next.facts.shape == Shape::Coil
        && next.facts.list_range.is_none()
        && matches!(next.facts.head, Head::Mnemonic(_))
        && without_operands()
}

fn took_head(network: NetworkAt<'_>, index: usize) -> Diagnostic {
    let (block, next) = (network.block(index), network.block(index + 1));
    let head = block.head_text();
    let list = block.facts.list_range.unwrap_or(block.facts.range);
    let between = TextRange::new(block.facts.head_range.end(), list.start());
    let mut found = Diagnostic::new(
        RULE,
        block.absolute(list.cover(next.facts.range)),
        format!("{head} takes the next parentheses as its operands: the wire between them is missing"),
    );
    // What is after is not a block that could run.
    found.severity = Severity::Error;
    found
        .help(format!("{head} has no operands: keep a `-` after it"))
        .fix(
            Applicability::Safe,
            format!("Insert wire after {head}"),
            block.absolute(between),
            "--",
        )
}
