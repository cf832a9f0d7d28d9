//! One block in the place of another of its kind: open and closed contacts, edges, set and reset, comparisons.

use super::names::called;
use super::place::Selected;
use super::{Action, ActionKind};
use ladder_analysis::networks::BlockAt;
use ladder_analysis::values::types::Type;
use ladder_analysis::written::facts::NodeKind;
use ladder_format::Edit;
use ladder_instructions::Op;

pub(crate) fn offer(place: &Selected<'_>, out: &mut Vec<Action>) {
    let Some(on) = &place.on else { return };
    let Some(block) = on.block().filter(|block| !block.faulty) else {
        return;
    };
    let Some((row, items)) = on.items.clone() else {
        return;
    };
    let name = called(&block, &on.drawing.rows[row].items[items.start].text);
    for &(head, what) in others(block) {
        if !may_be(place, block, head) {
            continue;
        }
        let edit = Edit {
            range: block.head_range(),
            text: head.to_owned(),
        };
        let title = format!("{what} (changes what the rung does)").replace("{}", &name);
        out.push(Action::new(ActionKind::Rewrite, title, vec![edit]));
    }
}

/// The first parts that can take the block's place, each with what that means.
fn others(block: BlockAt<'_>) -> &'static [(&'static str, &'static str)] {
    let Some(op) = block.op() else { return &[] };
    let spelling = block.facts.head.text().to_ascii_uppercase();
    let trigger = spelling.ends_with("_TRIG");
    // `EQU`, `GRT`: three letters stay three letters.
    let long = spelling.len() == 3;
    match op {
        Op::Contact => &[
            ("[/]", "Make `{}` normally closed"),
            ("[P]", "Make `{}` a rising-edge contact"),
        ],
        Op::NegatedContact => &[
            ("[ ]", "Make `{}` normally open"),
            ("[N]", "Make `{}` a falling-edge contact"),
        ],
        Op::RisingContact => &[
            ("[N]", "Make `{}` a falling-edge contact"),
            ("[ ]", "Make `{}` a plain contact"),
        ],
        Op::FallingContact => &[
            ("[P]", "Make `{}` a rising-edge contact"),
            ("[/]", "Make `{}` a plain normally closed contact"),
        ],
        Op::OneShotRising if trigger => &[("[F_TRIG]", "Take the falling edge")],
        Op::OneShotFalling if trigger => &[("[R_TRIG]", "Take the rising edge")],
        Op::OneShotRising => &[("[OSF]", "Take the falling edge")],
        Op::OneShotFalling => &[("[OSR]", "Take the rising edge")],
        Op::Coil => &[("(/)", "Invert the coil `{}`")],
        Op::NegatedCoil => &[("( )", "Make `{}` a plain coil")],
        Op::SetCoil => &[("(R)", "Reset `{}` instead of setting it")],
        Op::ResetCoil => &[("(S)", "Set `{}` instead of resetting it")],
        Op::RetentiveSet => &[("(RM)", "Reset `{}` instead of setting it")],
        Op::RetentiveReset => &[("(SM)", "Set `{}` instead of resetting it")],
        Op::RisingCoil => &[("(N)", "Let `{}` show the falling edge")],
        Op::FallingCoil => &[("(P)", "Let `{}` show the rising edge")],
        // With more than two values these are not opposites.
        _ if block.facts.operands.len() != 2 => &[],
        Op::Eq if long => &[("[NEQ]", "Invert the comparison of `{}`")],
        Op::Ne if long => &[("[EQU]", "Invert the comparison of `{}`")],
        Op::Gt if long => &[("[LEQ]", "Invert the comparison of `{}`")],
        Op::Le if long => &[("[GRT]", "Invert the comparison of `{}`")],
        Op::Lt if long => &[("[GEQ]", "Invert the comparison of `{}`")],
        Op::Ge if long => &[("[LES]", "Invert the comparison of `{}`")],
        Op::Eq => &[("[NE]", "Invert the comparison of `{}`")],
        Op::Ne => &[("[EQ]", "Invert the comparison of `{}`")],
        Op::Gt => &[("[LE]", "Invert the comparison of `{}`")],
        Op::Le => &[("[GT]", "Invert the comparison of `{}`")],
        Op::Lt => &[("[GE]", "Invert the comparison of `{}`")],
        Op::Ge => &[("[LT]", "Invert the comparison of `{}`")],
        _ => &[],
    }
}

/// Whether the operand can be in the other block: edges take no range, and only a bit can be set or inverted.
fn may_be(place: &Selected<'_>, block: BlockAt<'_>, head: &str) -> bool {
    let Some(operand) = block.facts.operands.first() else {
        return true;
    };
    let is_range = matches!(operand.value.kind, NodeKind::Range(..));
    match head {
        "[P]" | "[N]" | "(/)" => !is_range,
        "(S)" => !is_state(place, block),
        _ => true,
    }
}

/// Whether the operand is a timer, counter or bistable.
fn is_state(place: &Selected<'_>, block: BlockAt<'_>) -> bool {
    let range = block.absolute(block.facts.operands[0].value.range);
    let tags = place.context.scopes.iter().flat_map(|scope| &scope.tags);
    let states = tags.filter(|tag| matches!(tag.ty, Some(Type::State(_))));
    states
        .flat_map(|tag| place.context.uses(tag))
        .any(|found| found.range == range && found.whole)
}
