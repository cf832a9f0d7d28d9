//! Parts of arrays whose index is computed: `lines[k].running`, `g[i, j]`, `warm[k].Q`.

use super::{Problem, Scope};
use crate::tags::Point;
use ladder_analysis::program::Tag;
use ladder_analysis::values::types::Type;
use ladder_syntax::{Name, SyntaxKind, SyntaxNode};
use std::collections::BTreeMap;

/// No expression reads more elements of arrays than this.
const MOST_ELEMENTS: u64 = 100_000;

/// A path with an index: where its indices are, and all that it can mean.
pub(super) struct Elements {
    /// The indices, the outermost first.
    pub(super) indices: Vec<SyntaxNode>,
    /// First and last index of each array around the part.
    pub(super) dimensions: Vec<(i64, i64)>,
    /// Each element, in the order of the indices.
    pub(super) points: Vec<Point>,
    /// The path, with `[]` for each index.
    pub(super) name: String,
}

impl Elements {
    /// What a path with computed indices can mean. None: it names no part of an array.
    pub(super) fn of(node: &SyntaxNode, scope: Scope<'_>) -> Result<Option<Elements>, Problem> {
        let (mut name, mut indices) = (String::new(), Vec::new());
        add_path(node, &mut name, &mut indices);
        if indices.is_empty() {
            return Ok(None);
        }
        let Some(found) = of_column(&name, scope)?.or_else(|| of_states(&name, indices.len(), scope)) else {
            return Ok(None);
        };
        let (dimensions, points) = found;
        if dimensions.len() != indices.len() {
            return Err(format!(
                "{name} has {} here, and an index for each of its {} is needed",
                counted_indices(indices.len()),
                dimensions.len()
            ));
        }
        Ok(Some(Elements {
            indices,
            dimensions,
            points,
            name,
        }))
    }
}

fn counted_indices(count: usize) -> String {
    ladder_syntax::numeral::counted(count, "index")
}

/// The path without its indices, and these.
fn add_path(node: &SyntaxNode, name: &mut String, indices: &mut Vec<SyntaxNode>) {
    let mut parts = node.children();
    match (node.kind(), parts.next()) {
        (SyntaxKind::INDEX_EXPR, Some(of)) => {
            add_path(&of, name, indices);
            for index in parts {
                name.push_str("[]");
                indices.push(index);
            }
        }
        (SyntaxKind::MEMBER_EXPR, Some(of)) => {
            add_path(&of, name, indices);
            let text = node.text().to_string();
            let member = &text[usize::from(of.text_range().len())..];
            name.extend(member.split_whitespace());
        }
        _ => name.extend(node.text().to_string().split_whitespace()),
    }
}

type Found = (Vec<(i64, i64)>, Vec<Point>);

/// The elements of an array, or those of a part of a structure.
fn of_column(name: &str, scope: Scope<'_>) -> Result<Option<Found>, Problem> {
    let plain = name.strip_suffix("[]");
    let Some((before, tag)) = scope.find(name).or_else(|| scope.find(plain?)) else {
        return Ok(None);
    };
    let Type::Array { first, last, .. } = tag.ty else {
        return Ok(None);
    };
    if last.abs_diff(first) >= MOST_ELEMENTS {
        return Err(format!(
            "{} is too large for an expression with an index that is not a number",
            tag.name
        ));
    }
    let dimensions = tag
        .column
        .as_ref()
        .map_or_else(|| vec![(first, last)], |column| column.dimensions.to_vec());
    let points = (first..=last).map(|index| scope.resolve(&format!("{before}{}", tag.element_name(index))));
    Ok(Some((dimensions, points.collect::<Result<_, _>>()?)))
}

/// Members of timers, counters and blocks that are elements: each of these is a tag of its own, with the indices in its name.
fn of_states(name: &str, count: usize, scope: Scope<'_>) -> Option<Found> {
    let (state, member) = name.rsplit_once('.')?;
    let wanted = [Name::new(state), Name::new(name)];
    let mut found: BTreeMap<Vec<i64>, Point> = BTreeMap::new();
    for tag in &scope.simulation.program().tags {
        let Some((own, indices)) = with_numbers(tag).filter(|(_, indices)| indices.len() == count) else {
            continue;
        };
        let own = Name::new(&own);
        let text = match (own == wanted[0], own == wanted[1]) {
            (true, _) => format!("{}.{member}", tag.name),
            (_, true) => tag.name.clone(),
            _ => continue,
        };
        found.insert(indices, scope.resolve(&text).ok()?);
    }
    let (first, last) = (found.first_key_value()?.0, found.last_key_value()?.0);
    let dimensions: Vec<(i64, i64)> = first.iter().copied().zip(last.iter().copied()).collect();
    let all = dimensions.iter().map(|(first, last)| last.abs_diff(*first) + 1);
    let is_whole = all.product::<u64>() == found.len() as u64;
    is_whole.then(|| (dimensions, found.into_values().collect()))
}

/// The name of a tag without the numbers in its brackets, and these.
fn with_numbers(tag: &Tag) -> Option<(String, Vec<i64>)> {
    let (mut name, mut indices) = (String::new(), Vec::new());
    let mut rest = tag.name.as_str();
    while let Some((before, after)) = rest.split_once('[') {
        let (inside, after) = after.split_once(']')?;
        name.push_str(before);
        for index in inside.split(',') {
            indices.push(index.trim().parse().ok()?);
            name.push_str("[]");
        }
        rest = after;
    }
    name.push_str(rest);
    (!indices.is_empty()).then_some((name, indices))
}
