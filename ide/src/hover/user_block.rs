//! The card of a user-defined block: its shape with the parameters, and what the comments in its definition say of it and them.
//! That of a block of the library ends with an example, as an instruction's does, and shows in a timing diagram what it does.

use crate::described::Described;
use crate::markdown;
use ladder_analysis::context::Context;
use ladder_analysis::library::Source;
use ladder_analysis::program::ParameterKind;
use ladder_analysis::written::user_block::{Parameter, UserBlockFacts};
use ladder_syntax::Name;
use std::fmt::Write;

/// The card. Of a block in another file of the workspace the comments are left out.
pub(crate) fn user_block_card(context: &Context, block: &UserBlockFacts) -> String {
    let (open, close) = block.shape.brackets();
    let names: Vec<&str> = block.parameters.iter().map(|p| p.name.as_str()).collect();
    let described = Described::of(context, block);
    let of_library = described.as_ref().and_then(Described::of_library);
    let title = match (of_library, block.file()) {
        (Some(_), _) => "**Block** of the library".to_owned(),
        (None, Some(file)) => format!("**User-defined block** in {}", markdown::code(file)),
        (None, None) => "**User-defined block**".to_owned(),
    };
    let mut card = format!(
        "```clad\n{open}{}{close}( {} )\n```\n{title}\n\n",
        block.name,
        names.join(", "),
    );
    if let Some(text) = described.as_ref().and_then(Described::description) {
        let _ = write!(card, "{text}\n\n");
    }
    for parameter in &block.parameters {
        card.push_str(&line_of(parameter));
        let comment = described.as_ref().and_then(|block| block.parameter(parameter));
        if let Some(text) = comment {
            let _ = write!(card, ": {text}");
        }
        card.push('\n');
    }
    if let Some(source) = of_library {
        card.push_str(&shown(source));
    }
    card.trim_end().to_owned()
}

/// A block that a file can name.
pub(crate) fn block_named(context: &Context, name: &Name) -> Option<UserBlockFacts> {
    if let Some(known) = context.user_blocks.iter().find(|block| block.key == *name) {
        return Some(known.clone());
    }
    let (file, block) = context.others.blocks(name).next()?;
    Some(block.imported_from(file))
}

/// `` - `wait`: TIME, input, may be left out ``
fn line_of(parameter: &Parameter) -> String {
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
    format!("- `{}`: {ty}, {way}{default}", parameter.name)
}

fn shown(source: &Source) -> String {
    format!(
        "\n```clad\n{}\n```\n\nA column is {}:\n\n```text\n{}\n```",
        source.example.trim_end(),
        source.step(),
        source.diagram().trim_end()
    )
}
