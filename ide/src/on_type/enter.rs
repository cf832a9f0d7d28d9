//! Enter: the line below begins as the drawing goes on.

use super::typed_over::typed_over;
use super::{drawn_again, network_at};
use crate::body::line_text;
use crate::typing::{CursorContext, typing};
use ladder_analysis::context::Context;
use ladder_format::{Edit, Options, display_width};
use ladder_syntax::wiring::{PartKind, Rung};
use ladder_syntax::{LineKind, Mode, TextRange, TextSize};

/// How far declarations are in (LANGUAGE §8 rule 8).
const INDENT: &str = "    ";

/// What a rung begins with.
const RUNG: &str = "+--";

/// What a branch begins with, under its `\`.
const BRANCH: &str = "/--";

/// The edits after Enter; `offset` is on the new line.
pub(super) fn enter(context: &Context, offset: TextSize, options: &Options) -> Vec<Edit> {
    let parse = &context.parse;
    if let Some(joined) = joined_within_block(context, offset) {
        return vec![joined];
    }
    if parse.unclosed_comment().is_some_and(|open| open.start() < offset) {
        return leave_branch(context, offset, options).unwrap_or_default();
    }
    let Some((new_line, above)) = blank_line(context, offset) else {
        let split = split_after_down(context, offset);
        let edits = split.or_else(|| leave_branch(context, offset, options));
        return edits.unwrap_or_default();
    };
    let line = &parse.lines()[above];
    if line.mode_after.is_in_section()
        && matches!(
            line.kind,
            LineKind::SectionHeader | LineKind::Declaration | LineKind::StructHeader | LineKind::StructEnd
        )
    {
        let mut edits = match line.kind {
            LineKind::StructHeader => Vec::new(),
            LineKind::StructEnd => struct_end(context, above).into_iter().collect(),
            _ if matches!(line.mode_after, Mode::Struct { .. }) => Vec::new(),
            _ => outdented(context, above),
        };
        let indent = match line.mode_after {
            Mode::Struct { .. } => INDENT.repeat(2),
            _ => INDENT.to_owned(),
        };
        edits.extend(replace(context, new_line, &indent));
        return edits;
    }
    if line.kind == LineKind::SectionEnd {
        let mut edits = outdented(context, above);
        // After the declarations nothing is further in, whatever the editor has begun the line with.
        if !new_line.is_empty() {
            edits.extend(replace(context, new_line, ""));
        }
        return edits;
    }
    if !matches!(line.kind, LineKind::Rung | LineKind::Rail) {
        return Vec::new();
    }
    if is_begun(context, above) {
        return begun_again(context, new_line, above);
    }
    match goes_on(context, above) {
        Some(prefix) => replace(context, new_line, &prefix),
        None if line.kind == LineKind::Rung => {
            let mut edits = drawn_again(context, above, options).unwrap_or_default();
            if is_finished(context, above) {
                edits.extend(replace(context, new_line, RUNG));
            }
            edits
        }
        None => Vec::new(),
    }
}

/// Enter within a block: a block has one line, so the line end goes again.
fn joined_within_block(context: &Context, offset: TextSize) -> Option<Edit> {
    let parse = &context.parse;
    let line = parse.line_at(offset)?;
    let (above, start) = if parse.line_range(line).end() == offset && ends_line(context, line) {
        (line, offset)
    } else {
        (line.checked_sub(1)?, parse.line_start(line))
    };
    let before = parse.text_in(TextRange::new(start, offset));
    if parse.lines()[above].kind != LineKind::Rung || !before.trim().is_empty() {
        return None;
    }
    let text = line_text(parse, above);
    let end = parse.line_start(above) + TextSize::of(text.trim_end_matches(['\r', '\n']));
    let place = typing(context, end)?.place;
    let is_inside = matches!(place, CursorContext::Head(_) | CursorContext::Operand(_));
    is_inside.then(|| Edit {
        range: TextRange::new(end, offset),
        text: String::new(),
    })
}

/// The blanks of the physical line that an offset is in, if it holds nothing else, and the logical line above it.
fn blank_line(context: &Context, offset: TextSize) -> Option<(TextRange, usize)> {
    let parse = &context.parse;
    let line = parse.line_at(offset)?;
    // At the end of the text there is no logical line after the last line end.
    if parse.line_range(line).end() == offset && ends_line(context, line) {
        return Some((TextRange::empty(offset), line));
    }
    let text = line_text(parse, line);
    let before = &text[..usize::from(offset - parse.line_start(line))];
    let is_rail = parse.lines()[line].kind == LineKind::Rail && text.trim() == "|";
    // The rail at the right was drawn when the branch was closed, and Enter has taken it along.
    let is_taken_along = is_rail && !before.contains('|') && after_branch(context, line);
    if parse.lines()[line].kind != LineKind::Blank && !is_taken_along {
        return None;
    }
    let above = line.checked_sub(1).filter(|&above| ends_line(context, above))?;
    let blanks = TextSize::of(text.trim_end_matches(['\r', '\n']));
    Some((TextRange::at(parse.line_start(line), blanks), above))
}

/// Whether the line above is a row that ends with its branch, and without a rail at the right.
fn after_branch(context: &Context, line: usize) -> bool {
    line.checked_sub(1).is_some_and(|above| {
        context.parse.lines()[above].kind == LineKind::Rung
            && line_text(&context.parse, above).trim_end().ends_with('/')
    })
}

fn ends_line(context: &Context, line: usize) -> bool {
    let text = line_text(&context.parse, line);
    text.ends_with(['\n', '\r'])
}

/// What the line below one begins with, if the network goes on there: its rail, and blanks up to the first `\`
/// that waits for its partner.
fn goes_on(context: &Context, above: usize) -> Option<String> {
    let parse = &context.parse;
    let structure = parse.structure_once();
    let structure = &structure.networks;
    // Rail lines after the last rung do not belong to the network any more.
    let rung_above = (0..=above)
        .rev()
        .take_while(|&line| parse.lines()[line].kind.is_decoration() || line == above)
        .find(|&line| parse.lines()[line].kind == LineKind::Rung)
        .or_else(|| {
            let mut lines = (0..above).rev();
            lines
                .find(|&line| !parse.lines()[line].kind.is_decoration())
                .filter(|&line| parse.lines()[line].kind == LineKind::Rung)
        })?;
    let network = network_at(context, rung_above)?;
    let number = structure.partition_point(|network| network.lines.end <= rung_above);
    let rung = (0..network.wiring.rungs.len()).find(|&rung| network.line(rung) == rung_above)?;
    let open = network
        .wiring
        .unpaired
        .iter()
        .find(|(of, part)| *of == rung && network.wiring.rungs[rung].parts[*part].kind == PartKind::Down);
    let inside = structure[number].lines.end > above + 1;
    if open.is_none() && !inside {
        return None;
    }
    let railed = network.wiring.rungs.iter().any(Rung::has_left_rail);
    let mut prefix = if railed { "|  ".to_owned() } else { String::new() };
    if let Some(&(_, part)) = open {
        let range = network.part_range(parse, rung, part);
        let text = line_text(parse, rung_above);
        let before = &text[..usize::from(range.start() - parse.line_start(rung_above))];
        let column = display_width(before.rsplit(['\n', '\r']).next().unwrap_or(before));
        while display_width(&prefix) < column {
            prefix.push(' ');
        }
        prefix.push_str(BRANCH);
    }
    Some(prefix)
}

/// `VAR` and `END_VAR` put at the left edge, if they were typed after the blanks of a declaration.
fn outdented(context: &Context, line: usize) -> Vec<Edit> {
    let parse = &context.parse;
    if parse.lines()[line].kind == LineKind::Declaration {
        return Vec::new();
    }
    let text = line_text(parse, line);
    let blanks = text.len() - text.trim_start_matches([' ', '\t']).len();
    let range = TextRange::at(parse.line_start(line), TextSize::of(&text[..blanks]));
    let edit = Edit {
        range,
        text: String::new(),
    };
    if range.is_empty() { Vec::new() } else { vec![edit] }
}

/// `END_STRUCT;` put below the name of its structure, if it was typed after the blanks of a member.
pub(super) fn struct_end(context: &Context, line: usize) -> Option<Edit> {
    let parse = &context.parse;
    let text = line_text(parse, line);
    let blanks = text.len() - text.trim_start_matches([' ', '\t']).len();
    let is_end = parse.lines()[line].kind == LineKind::StructEnd && &text[..blanks] != INDENT;
    is_end.then(|| Edit {
        range: TextRange::at(parse.line_start(line), TextSize::of(&text[..blanks])),
        text: INDENT.to_owned(),
    })
}

/// Whether a line holds nothing but the beginning of a rung.
fn is_begun(context: &Context, line: usize) -> bool {
    let text = line_text(&context.parse, line);
    let text = text.trim();
    text.starts_with('+') && text[1..].chars().all(|c| c == '-')
}

/// Enter on a rung that was only begun: it is begun a line further down, once; then it is given up.
fn begun_again(context: &Context, new_line: TextRange, above: usize) -> Vec<Edit> {
    let parse = &context.parse;
    let text = line_text(parse, above);
    let begun = text.trim_end_matches(['\r', '\n']);
    let mut edits = vec![Edit {
        range: TextRange::at(parse.line_start(above), TextSize::of(begun)),
        text: String::new(),
    }];
    let after_rung = above
        .checked_sub(1)
        .is_some_and(|before| parse.lines()[before].kind == LineKind::Rung);
    edits.extend(replace(context, new_line, if after_rung { RUNG } else { "" }));
    edits
}

/// Whether the network of a line is drawn from rail to rail, and nothing in it is open.
fn is_finished(context: &Context, line: usize) -> bool {
    let Some(network) = network_at(context, line) else {
        return false;
    };
    let rungs = &network.wiring.rungs;
    !network.broken
        && network.wiring.unpaired.is_empty()
        && rungs.iter().any(Rung::has_left_rail)
        && rungs.iter().any(Rung::has_right_rail)
}

/// Enter that a client asks about again when the next line has already been written: nothing is begun there any more. What the
/// line above had begun is taken back, or its network is drawn again.
fn leave_branch(context: &Context, offset: TextSize, options: &Options) -> Option<Vec<Edit>> {
    let parse = &context.parse;
    let line = parse.line_at(offset.checked_sub(TextSize::new(1))?)?;
    let within = usize::from(offset - parse.line_start(line));
    let before = &line_text(parse, line)[..within];
    if before.trim().is_empty() || before.contains(['\r', '\n']) {
        return None;
    }
    let above = line.checked_sub(1).filter(|&above| ends_line(context, above))?;
    let begun = TextSize::of(line_text(parse, above).trim_end_matches(['\r', '\n']));
    if is_begun(context, above) {
        let range = TextRange::at(parse.line_start(above), begun);
        return Some(replace(context, range, ""));
    }
    let again = typed_over(context, parse.line_start(above) + begun);
    again.or_else(|| drawn_again(context, above, options))
}

/// Enter right after a `\` in the middle of a rung: what was after it stays on the rung, and the new line is
/// the branch.
fn split_after_down(context: &Context, offset: TextSize) -> Option<Vec<Edit>> {
    let parse = &context.parse;
    let line = parse.line_at(offset)?;
    let above = line.checked_sub(1).filter(|&above| ends_line(context, above))?;
    let kinds = (parse.lines()[above].kind, parse.lines()[line].kind);
    if kinds != (LineKind::Rung, LineKind::Rung) {
        return None;
    }
    let (text, rung) = (line_text(parse, line), line_text(parse, above));
    let before = &text[..usize::from(offset - parse.line_start(line))];
    let rung = rung.trim_end_matches(['\r', '\n']);
    let rest = text.trim_end_matches(['\r', '\n']);
    let moved = rest.trim();
    // A connector after it would pair with one on the new line.
    if !before.trim().is_empty()
        || !rung.ends_with('\\')
        || !moved.starts_with('-')
        || moved.contains(['\\', '/'])
    {
        return None;
    }
    let prefix = goes_on(context, above)?;
    let after = parse.line_start(above) + TextSize::of(rung);
    Some(vec![
        Edit {
            range: TextRange::empty(after),
            text: moved.to_owned(),
        },
        Edit {
            range: TextRange::at(parse.line_start(line), TextSize::of(rest)),
            text: prefix,
        },
    ])
}

fn replace(context: &Context, range: TextRange, new: &str) -> Vec<Edit> {
    let text = crate::outline::text_of(&context.parse, range);
    if text == new {
        return Vec::new();
    }
    vec![Edit {
        range,
        text: new.to_owned(),
    }]
}
