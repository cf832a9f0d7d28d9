//! The card of a user-defined block: its shape with the parameters, and what the comments in its definition say of it and them.

use crate::comments;
use crate::markdown::{self, escaped};
use ladder_analysis::context::Context;
use ladder_analysis::library;
use ladder_analysis::networks::user_block::{Parameter, UserBlockFacts};
use ladder_analysis::program::ParameterKind;
use std::fmt::Write;

/// The card. Of a block in another file of the workspace the comments are left out: that text is not here.
pub(crate) fn user_block_card(context: &Context, block: &UserBlockFacts) -> String {
    let (open, close) = block.shape.brackets();
    let names: Vec<&str> = block.parameters.iter().map(|p| p.name.as_str()).collect();
    let of_library = block.file().and_then(|file| library::analysis(file));
    let place = match (block.file(), &of_library) {
        (_, Some(_)) => " of the library".to_owned(),
        (Some(file), None) => format!(" in {}", markdown::code(file)),
        (None, None) => String::new(),
    };
    let title = if of_library.is_some() {
        "Block"
    } else {
        "User-defined block"
    };
    let mut card = format!(
        "```clad\n{open}{}{close}( {} )\n```\n**{title}**{place}\n\n",
        block.name,
        names.join(", "),
    );
    let definition = match (&of_library, block.file()) {
        (Some(analysis), _) => Some(&*analysis.context),
        (None, None) => Some(context),
        (None, Some(_)) => None,
    };
    let own = definition.and_then(|context| {
        let own = &context.user_blocks[..context.own_blocks];
        let item = own.iter().position(|own| own.key == block.key)?;
        Some((context, item))
    });
    // The library is written as Markdown, what anybody else wrote is not.
    let said = |text: String| match of_library {
        Some(_) => text,
        None => escaped(&text).into_owned(),
    };
    if let Some(text) = own.and_then(|(context, item)| description(context, item)) {
        let _ = write!(card, "{}\n\n", said(text));
    }
    for parameter in &block.parameters {
        card.push_str(&line_of(parameter));
        let comment = own.and_then(|(context, item)| {
            let tag = context.scopes.get(item + 1)?.tags.get(parameter.tag)?;
            comments::of_declaration(context, tag)
        });
        if let Some(text) = comment {
            let _ = write!(card, ": {}", said(text));
        }
        card.push('\n');
    }
    card.trim_end().to_owned()
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

/// What the comments right above a definition say, as paragraphs.
fn description(context: &Context, item: usize) -> Option<String> {
    let parse = &context.parse;
    let (first, last) = comments::above(context, parse.line_at(context.user_blocks[item].at.start())?)?;
    let all = (first..=last).flat_map(|line| comments::of_line(parse, line));
    let paragraphs: Vec<String> = all.filter_map(|(_, comment)| comments::whole(&comment)).collect();
    (!paragraphs.is_empty()).then(|| paragraphs.join("\n\n"))
}
