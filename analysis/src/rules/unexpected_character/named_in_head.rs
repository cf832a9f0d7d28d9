//! A contact or coil that holds its tag in its first part, next to what it is: `[/stop]`, `(SET lamp)`, `[XIC start]`.

use crate::findings::diagnostic::{Applicability, Diagnostic};
use ladder_instructions::{Group, Instruction, Shape, known_elsewhere, lookup};
use ladder_syntax::{TextRange, TextSize, is_identifier};

/// Says so in the finding about the tag. `before` and `after` are what is around it on its line.
pub(crate) fn explain(found: Diagnostic, before: &str, tag: &str, after: &str) -> Diagnostic {
    let Some((shape, row, opening)) = before_tag(before).filter(|_| is_identifier(tag)) else {
        return found;
    };
    let (_, closing) = shape.brackets();
    let inside = after.trim_start_matches([' ', '\t']);
    let Some(rest) = inside.strip_prefix(closing) else {
        return found;
    };
    if rest.trim_start_matches([' ', '\t']).starts_with('(') {
        return found;
    }
    let written = format!("{}( {tag} )", row.block());
    let start = found.range.start() - TextSize::of(&before[opening..]);
    let end = found.range.end() + TextSize::of(&after[..after.len() - rest.len()]);
    found
        .help(format!("the tag is in parentheses of its own: {written}"))
        .fix(
            Applicability::Unsafe,
            format!("Write {written}"),
            TextRange::new(start, end),
            written,
        )
}

/// The brackets that open before the tag, the contact or coil that their first word says, and where they open.
fn before_tag(before: &str) -> Option<(Shape, &'static Instruction, usize)> {
    let opening = before.rfind(['[', '('])?;
    let shape = match before.as_bytes()[opening] {
        b'[' => Shape::Logical,
        _ => Shape::Coil,
    };
    let sign = before[opening + 1..].trim();
    let own = lookup(shape, sign).find(|row| row.takes(1));
    let row = own.or_else(|| known_elsewhere(sign))?;
    let is_bit = matches!(row.group, Group::Condition | Group::Coil) && row.takes(1);
    // What is drawn as a coil is not a contact.
    let is_of_shape = row.shape == shape || shape == Shape::Logical;
    (!sign.is_empty() && is_bit && is_of_shape).then_some((shape, row, opening))
}
