//! What a comment says.

/// The lines of a comment without its `#`, blanks at their ends, and blank lines around them.
pub(super) fn lines(comment: &str) -> Vec<&str> {
    let text = comment.strip_prefix('#').unwrap_or(comment);
    let text = text.strip_suffix('#').unwrap_or(text);
    let mut lines: Vec<&str> = text.split(['\n', '\r']).map(str::trim).collect();
    while lines.last().is_some_and(|line| line.is_empty()) {
        lines.pop();
    }
    let blank = lines.iter().take_while(|line| line.is_empty()).count();
    lines.drain(..blank);
    lines
}

/// The same on one line.
pub(super) fn on_one_line(comment: &str) -> String {
    lines(comment).join(" ")
}
