//! Hover on a block's first part: the instruction's card, or that of the user-defined block.

use super::Hover;
use super::user_block::user_block_card;
use ladder_analysis::context::Context;
use ladder_analysis::networks::BlockAt;
use ladder_analysis::networks::network::Meaning;
use ladder_instructions::{Direction, Instruction, Presence, Profile};
use std::fmt::Write;

pub(super) fn hover(context: &Context, block: BlockAt<'_>) -> Option<Hover> {
    let markdown = match block.meaning {
        Meaning::Instruction(row) => instruction(row, context.profile),
        Meaning::User(index) => user_block_card(context, &context.user_blocks[index]),
        Meaning::UnknownUser | Meaning::Unknown => return None,
    };
    Some(Hover {
        range: block.range(),
        markdown,
    })
}

/// An instruction's card in a profile: signature, what it does, operands, an example.
pub(crate) fn instruction(row: &Instruction, profile: Profile) -> String {
    let mut card = format!(
        "```clad\n{}\n```\n**{}**\n\n{}\n",
        row.signature_in(profile),
        row.title,
        row.doc.trim()
    );
    let operands: Vec<_> = row
        .operands
        .iter()
        .filter(|operand| operand.profiles.contain(profile))
        .collect();
    if !operands.is_empty() {
        card.push('\n');
    }
    for operand in operands {
        let way = match operand.direction {
            Direction::In => "",
            Direction::Out => ", written",
            Direction::InOut => ", read and written",
        };
        let optional = if operand.presence == Presence::Named {
            ", optional"
        } else {
            ""
        };
        let _ = writeln!(card, "- `{}`{way}{optional}: {}", operand.name, operand.doc);
    }
    if let Some(text) = row.in_profile(profile) {
        let _ = write!(card, "\n**In profile `{profile}`:** {text}\n");
    }
    let _ = write!(
        card,
        "\nPower out (ENO): {}\n\n```clad\n{}\n```",
        row.eno,
        row.example.trim_end()
    );
    card
}
