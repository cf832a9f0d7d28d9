//! What the drawing does of itself while a person types.
//!
//! - When a block, a branch or a rung is completed its network is drawn again. One in which something is open
//!   (a parenthesis, a connector without its partner) stays as it is, to the letter.
//! - Enter within a network goes on with its rail, and below an open `\` with the branch that it leads to.
//! - A `/` at the end of such a branch draws the `\` that it comes up to.
//! - Enter after a rung that completes its network draws the network again, and begins the next rung.
//! - Enter within a block does nothing: a block has one line.
//! - Enter in a section indents the next declaration.
//! - `END_STRUCT;` goes below the name of its structure.
//! - What Enter has begun may be typed once more, and so may the rail that a completed coil reaches to; a comment or a keyword takes its place.
//!
//! What was typed stays, but for rails and wires. Where the formatter is switched off nothing is drawn.
//!
//! Edits for a text that has moved on are of no use. A client whose user types faster than the answers come asks again, about the
//! same character, from the end of its line as it is by then; for Enter from the end of the line that it began.

mod branch;
mod enter;
mod typed_over;

use ladder_analysis::context::Context;
use ladder_analysis::networks::NetworkAt;
use ladder_format::{Edit, Options, format_ranges, is_switched_off};
use ladder_syntax::{LineKind, SyntaxKind, TextSize};

/// The characters after which the drawing may do something.
pub const TRIGGERS: [char; 11] = ['\n', ')', '/', '+', '>', '#', '|', ';', 'E', 'F', 'V'];

/// The edits after a character was typed; `offset` is right after it. Sorted, none touching another.
pub fn on_type(context: &Context, offset: TextSize, typed: char, options: &Options) -> Vec<Edit> {
    let line = context.parse.line_at(offset);
    if line.is_none_or(|line| is_switched_off(&context.parse, line)) {
        return Vec::new();
    }
    if typed != '\n'
        && let Some(edits) = typed_over::typed_over(context, offset)
    {
        return edits;
    }
    match typed {
        '\n' => enter::enter(context, offset, options),
        ';' => line
            .and_then(|line| enter::struct_end(context, line))
            .into_iter()
            .collect(),
        ')' | '/' | '+' | '>' => completed(context, offset, options).unwrap_or_default(),
        _ => Vec::new(),
    }
}

/// The network drawn again, if what ends at the offset completes a block, a branch or a rung.
fn completed(context: &Context, offset: TextSize, options: &Options) -> Option<Vec<Edit>> {
    let parse = &context.parse;
    let before = offset.checked_sub(TextSize::new(1))?;
    let line = parse.line_at(before)?;
    if parse.lines()[line].kind != LineKind::Rung {
        return None;
    }
    let syntax = parse.lines()[line].syntax();
    let within = offset - parse.line_start(line);
    let token = syntax.token_at_offset(within).left_biased()?;
    if token.text_range().end() != within {
        return None;
    }
    let of = token.parent()?.kind();
    let completes = match token.kind() {
        // The first part of a coil has its operand still to come.
        SyntaxKind::R_PAREN => of == SyntaxKind::OPERAND_LIST,
        SyntaxKind::R_ANGLE => of == SyntaxKind::BLOCK_HEAD,
        SyntaxKind::UP | SyntaxKind::RAIL_CONNECTOR => true,
        _ => false,
    };
    if !completes {
        return None;
    }
    if token.kind() == SyntaxKind::UP
        && let Some(edits) = branch::closed(context, before, options)
    {
        return Some(edits);
    }
    drawn_again(context, line, options)
}

/// The edits that lay out the network of a line, if nothing in it is open.
fn drawn_again(context: &Context, line: usize, options: &Options) -> Option<Vec<Edit>> {
    let network = network_at(context, line)?;
    let open = network.broken || !network.wiring.unpaired.is_empty();
    if open || context.parse.unclosed_comment().is_some() {
        return None;
    }
    // A rail line below it is not part of what is typed.
    let mut edits = format_ranges(&context.parse, options, &[network.range]);
    edits.retain(|edit| network.range.contains_range(edit.range));
    Some(edits)
}

fn network_at(context: &Context, line: usize) -> Option<NetworkAt<'_>> {
    let structure = context.parse.structure_once();
    let networks = &structure.networks;
    let number = networks.partition_point(|network| network.lines.end <= line);
    let found = networks.get(number)?.lines.contains(&line);
    found.then(|| context.networks.at(number))
}

#[cfg(test)]
mod tests;
