//! Hover on a block's first part: the instruction's card, or the user-defined block's parameters.

use super::Hover;
use crate::markdown;
use ladder_analysis::context::Context;
use ladder_analysis::networks::BlockAt;
use ladder_analysis::networks::network::Meaning;
use ladder_analysis::networks::user_block::UserBlockFacts;
use ladder_analysis::program::ParameterKind;
use ladder_instructions::{Direction, Instruction, Presence, Profile};
use std::fmt::Write;

pub(super) fn hover(context: &Context, block: BlockAt<'_>) -> Option<Hover> {
    let markdown = match block.meaning {
        Meaning::Instruction(row) => instruction(row, context.profile),
        Meaning::User(index) => user_block_card(&context.user_blocks[index]),
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

/// A user-defined block: its shape with the parameters, and what each is.
pub(crate) fn user_block_card(block: &UserBlockFacts) -> String {
    let (open, close) = block.shape.brackets();
    let names: Vec<&str> = block.parameters.iter().map(|p| p.name.as_str()).collect();
    let mut card = format!(
        "```clad\n{open}{}{close}( {} )\n```\n**User-defined block**{}\n\n",
        block.name,
        names.join(", "),
        block
            .file()
            .map(|file| format!(" in {}", markdown::code(file)))
            .unwrap_or_default(),
    );
    for parameter in &block.parameters {
        let way = match parameter.kind {
            ParameterKind::Input => "input",
            ParameterKind::Output => "output",
            ParameterKind::InOut => "in and out",
        };
        let ty = parameter.ty.map(|ty| ty.to_string()).unwrap_or_default();
        let default = if parameter.has_default {
            ", may be left out"
        } else {
            ""
        };
        let _ = writeln!(card, "- `{}`: {ty}, {way}{default}", parameter.name);
    }
    card.trim_end().to_owned()
}
