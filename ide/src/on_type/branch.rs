//! A `/` that ends a branch below a rung: the `\` on the rung is drawn, as near above it as it can be.

use super::network_at;
use crate::body::line_text;
use ladder_analysis::context::Context;
use ladder_analysis::networks::NetworkAt;
use ladder_format::{Edit, Options, apply, display_width, format_ranges};
use ladder_syntax::wiring::{PartKind, Rung, wiring};
use ladder_syntax::{TextRange, TextSize};

/// The edits after a `/` at an offset was typed that has no partner. None if it ends no branch, or if something else in
/// its network is open.
pub(super) fn closed(context: &Context, at: TextSize, options: &Options) -> Option<Vec<Edit>> {
    let parse = &context.parse;
    let line = parse.line_at(at)?;
    let network = network_at(context, line)?;
    if parse.unclosed_comment().is_some() {
        return None;
    }
    let row = (0..network.wiring.rungs.len()).find(|&rung| network.line(rung) == line)?;
    let above = row.checked_sub(1)?;
    let rung = &network.wiring.rungs[row];
    let ups: Vec<usize> = rung.connectors(PartKind::Up).collect();
    let downs: Vec<usize> = network.wiring.rungs[above].connectors(PartKind::Down).collect();
    let number = ups
        .iter()
        .position(|&part| network.part_range(parse, row, part).start() == at)?;
    let all_here = network
        .wiring
        .unpaired
        .iter()
        .all(|&(of, part)| of == row && rung.parts[part].kind == PartKind::Up);
    if ups.len() != downs.len() + 1 || number == 0 || !all_here {
        return None;
    }
    if ends_nothing(rung, ups[number - 1], ups[number]) {
        // Typed over the `/` that Enter has begun the branch with.
        return Some(vec![Edit {
            range: TextRange::at(at, TextSize::of('/')),
            text: String::new(),
        }]);
    }
    let column = column_of(context, network, row, ups[number]);
    let place = gap(
        context,
        network,
        above,
        (downs[number - 1], downs.get(number).copied()),
        column,
    )?;
    drawn(context, network, &place, options)
}

/// Whether only wire lies between two connectors.
fn ends_nothing(rung: &Rung, left: usize, right: usize) -> bool {
    let between = &rung.parts[left + 1..right];
    between.iter().all(|part| part.kind == PartKind::Wire)
}

/// Where the `\` is put in: after the block between two connectors whose end is nearest to a column. After coils only
/// where nothing else is.
fn gap(
    context: &Context,
    network: NetworkAt<'_>,
    row: usize,
    (left, right): (usize, Option<usize>),
    column: u32,
) -> Option<Edit> {
    let parse = &context.parse;
    let parts = &network.wiring.rungs[row].parts;
    let right = right.unwrap_or(parts.len());
    let text = line_text(parse, network.line(row));
    let is_coil = |part: usize| text[parts[part].range].starts_with('(');
    let blocks = (left + 1..right).filter(|&part| parts[part].kind == PartKind::Block);
    let after = blocks.min_by_key(|&part| {
        let next = parts.get(part + 1).filter(|next| next.kind == PartKind::Wire);
        let end = next.map_or(parts[part].range.end(), |wire| wire.range.end());
        let end = display_width(&text[..end.into()]);
        (is_coil(part), end.abs_diff(column))
    })?;
    let wire = parts
        .get(after + 1)
        .filter(|next| next.kind == PartKind::Wire && next.touches);
    let range = wire.map_or(TextRange::empty(parts[after].range.end()), |wire| wire.range);
    Some(Edit {
        range: range + parse.line_start(network.line(row)),
        text: "--\\--".to_owned(),
    })
}

fn column_of(context: &Context, network: NetworkAt<'_>, row: usize, part: usize) -> u32 {
    let text = line_text(&context.parse, network.line(row));
    let start = network.wiring.rungs[row].parts[part].range.start();
    display_width(&text[..start.into()])
}

/// The network with one edit, drawn again: an edit for each line that is another one.
fn drawn(context: &Context, network: NetworkAt<'_>, edit: &Edit, options: &Options) -> Option<Vec<Edit>> {
    let parse = &context.parse;
    let old = parse.to_string();
    let raw = apply(&old, std::slice::from_ref(edit));
    let changed = parse.updated(&old, &raw);
    let grown = edit.text.len() as u32 - u32::from(edit.range.len());
    let range = TextRange::new(network.range.start(), network.range.end() + TextSize::new(grown));
    let networks = &changed.structure().networks;
    let number = networks.partition_point(|of| of.lines.end <= network.line(0));
    if !wiring(&changed, networks.get(number)?).unpaired.is_empty() {
        return None;
    }
    let new = apply(&raw, &format_ranges(&changed, options, &[range]));
    let first = network.line(0);
    let start = usize::from(parse.line_start(first));
    let lines = old[start..usize::from(network.range.end())].split_inclusive('\n');
    let new_lines = new.get(start..)?.split_inclusive('\n');
    let mut at = parse.line_start(first);
    let mut edits = Vec::new();
    for (line, new_line) in lines.zip(new_lines) {
        edits.extend(difference(line.trim_end(), new_line.trim_end(), at));
        at += TextSize::of(line);
    }
    Some(edits)
}

/// What differs between two lines, as one edit.
fn difference(old: &str, new: &str, start: TextSize) -> Option<Edit> {
    let same = old.chars().zip(new.chars()).take_while(|(a, b)| a == b);
    let before: usize = same.map(|(c, _)| c.len_utf8()).sum();
    let (old, new) = (&old[before..], &new[before..]);
    let same = old
        .chars()
        .rev()
        .zip(new.chars().rev())
        .take_while(|(a, b)| a == b);
    let after: usize = same.map(|(c, _)| c.len_utf8()).sum();
    let (old, new) = (&old[..old.len() - after], &new[..new.len() - after]);
    let differs = !old.is_empty() || !new.is_empty();
    differs.then(|| Edit {
        range: TextRange::at(start + TextSize::new(before as u32), TextSize::of(old)),
        text: new.to_owned(),
    })
}
