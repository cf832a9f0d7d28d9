//! The file's tree over its lines' nodes, in chunks: a flat root would copy its whole child list at every edit.

use crate::SyntaxKind;
use crate::line::Line;
use rowan::{GreenNode, GreenNodeData, NodeOrToken};
use std::ops::Range;

/// How many lines a chunk of a newly parsed text holds. Edits let it grow to twice as many.
const CHUNK_LINES: usize = 256;

/// The file's node.
pub(crate) fn root(lines: &[Line]) -> GreenNode {
    source_file(lines.chunks(CHUNK_LINES).map(chunk).collect())
}

/// The file's node after an edit: `lines` are the new ones, of which `new` took the place of `old` among those of
/// which `root` was made. Chunks without a changed line are taken over.
pub(crate) fn edited_root(
    root: &GreenNodeData,
    lines: &[Line],
    old: &Range<usize>,
    new: &Range<usize>,
) -> GreenNode {
    let mut chunks = Vec::with_capacity(root.children().len() + 1);
    // The lines of the chunks that the edit touches, as numbers of the new lines.
    let mut touched: Option<Range<usize>> = None;
    let mut start = 0;
    for node in root.children().filter_map(NodeOrToken::into_node) {
        let end = start + node.children().len();
        if end < old.start {
            chunks.push(node.to_owned());
        } else if start > old.end {
            chunks.extend(
                touched
                    .take()
                    .into_iter()
                    .flat_map(|lines_of| split(&lines[lines_of])),
            );
            chunks.push(node.to_owned());
        } else {
            // The edit may begin in an earlier chunk and end in a later one.
            let first = touched.as_ref().map_or(start, |t| t.start);
            touched = Some(first..(end + new.end).saturating_sub(old.end).max(new.end));
        }
        start = end;
    }
    let rest = touched.unwrap_or(if chunks.is_empty() { 0..lines.len() } else { 0..0 });
    chunks.extend(split(&lines[rest]));
    source_file(chunks)
}

/// Chunks for some lines: one, unless they are too many.
fn split(lines: &[Line]) -> impl Iterator<Item = GreenNode> + '_ {
    let size = if lines.len() > 2 * CHUNK_LINES {
        CHUNK_LINES
    } else {
        2 * CHUNK_LINES
    };
    lines.chunks(size).map(chunk)
}

fn chunk(lines: &[Line]) -> GreenNode {
    let nodes = lines.iter().map(|line| NodeOrToken::Node(line.node.clone()));
    GreenNode::new(SyntaxKind::CHUNK.into(), nodes)
}

fn source_file(chunks: Vec<GreenNode>) -> GreenNode {
    GreenNode::new(
        SyntaxKind::SOURCE_FILE.into(),
        chunks.into_iter().map(NodeOrToken::Node),
    )
}
