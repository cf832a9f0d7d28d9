//! Comments that name the steps below them: `#       0  1  2  3 s`.

use super::width;

/// A comment, with its words over the steps that they were over: `moves` has where each step was and where it goes. A
/// comment that begins to the left of the first step is not a ruler, and stays.
pub(super) fn moved(comment: &str, moves: &[(usize, usize)]) -> String {
    let stays = comment.trim_start().to_owned();
    let Some(&(first, _)) = moves.first() else {
        return stays;
    };
    let Some(words) = comment.strip_prefix('#').filter(|_| !comment.contains('\t')) else {
        return stays;
    };
    let blanks = words.len() - words.trim_start_matches(' ').len();
    if blanks + 1 < first || words.trim().is_empty() {
        return stays;
    }
    let mut line = "#".to_owned();
    let mut rest = words;
    let mut old = 1;
    loop {
        let blanks = rest.len() - rest.trim_start_matches(' ').len();
        old += blanks;
        rest = &rest[blanks..];
        if rest.is_empty() {
            return line;
        }
        let word = &rest[..rest.find(' ').unwrap_or(rest.len())];
        let goes = place(old, moves);
        let missing = goes.saturating_sub(width(&line)).max(1);
        line.extend(std::iter::repeat_n(' ', missing));
        line.push_str(word);
        old += width(word);
        rest = &rest[word.len()..];
    }
}

/// Where a column goes: it stays as far right of the step that it is over.
fn place(column: usize, moves: &[(usize, usize)]) -> usize {
    let step = moves.partition_point(|(old, _)| *old <= column);
    let (old, goes) = moves[step.saturating_sub(1)];
    goes + column - old.min(column)
}
