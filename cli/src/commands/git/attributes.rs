//! The lines in a file of git's attributes that are ours, between two comments.

const BEGIN: &str = "# ladder: begin, written by `ladder git install`";
const END: &str = "# ladder: end";

/// In the block if the line above it had no end before.
const NO_END: &str = "# ladder: the line above had no end";

/// Begins the lines that say what settings of git were before.
const WAS: &str = "# ladder: was ";

/// A line that says what a setting was before. None: no line holds the value.
pub(super) fn was_line(name: &str, value: &str) -> Option<String> {
    (!value.contains(['\n', '\r'])).then(|| format!("{WAS}{name} = {value}"))
}

/// The settings that were there before, as the lines in the block say. None: there is no block.
pub(super) fn was(text: &str) -> Option<Vec<(&str, &str)>> {
    let lines = ours(text)?;
    let lines = lines.filter_map(|line| line.strip_prefix(WAS)?.split_once(" = "));
    Some(lines.collect())
}

/// The lines that are ours.
fn ours(text: &str) -> Option<impl Iterator<Item = &str>> {
    let is = |mark: &'static str| move |line: &&str| line.trim_end() == mark;
    if !text.lines().any(|line| is(BEGIN)(&line)) || !text.contains(END) {
        return None;
    }
    let lines = text.lines().skip_while(move |line| !is(BEGIN)(line)).skip(1);
    Some(lines.take_while(move |line| !is(END)(line)).map(str::trim_end))
}

/// A text with these lines in the place of those that were ours, at the end if none were; without ours, as it was before, if there
/// are no lines.
pub(super) fn with_block(text: &str, lines: &[String]) -> String {
    let had_no_end = match ours(text) {
        Some(mut lines) => lines.any(|line| line == NO_END),
        None => !text.is_empty() && !text.ends_with('\n'),
    };
    let mut out = String::new();
    let mut inside = false;
    let mut put = false;
    let block = || -> String {
        let no_end = had_no_end.then_some(NO_END).into_iter();
        let all = [BEGIN].into_iter().chain(no_end);
        let all = all.chain(lines.iter().map(String::as_str)).chain([END, ""]);
        all.collect::<Vec<_>>().join("\n")
    };
    let mut rest = text;
    for line in text.split_inclusive('\n') {
        rest = &rest[line.len()..];
        match line.trim_end() {
            BEGIN if text.contains(END) => {
                inside = true;
                if !put && !lines.is_empty() {
                    out.push_str(&block());
                }
                put = true;
            }
            END if inside => {
                inside = false;
                if had_no_end && lines.is_empty() && rest.is_empty() {
                    out.truncate(out.strip_suffix('\n').map_or(out.len(), str::len));
                }
            }
            _ if inside => {}
            _ => out.push_str(line),
        }
    }
    if !put && !lines.is_empty() {
        if had_no_end {
            out.push('\n');
        }
        out.push_str(&block());
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_ours_stays() {
        let one = ["*.clad diff=ladder".to_owned()];
        let other = ["*.clad merge=ladder".to_owned()];
        for text in ["", "*.png binary\n", "*.png binary\n# ladder: end\n"] {
            let with = with_block(text, &one);
            assert!(with.starts_with(text), "{with}");
            assert_eq!(with_block(&with, &one), with);
            assert_eq!(with_block(&with, &other), with.replace("diff", "merge"));
            assert_eq!(with_block(&with, &[]), text);
            let more = format!("{with}*.txt text\n");
            assert_eq!(with_block(&more, &[]), format!("{text}*.txt text\n"));
        }
        // A line end that was missing is missing afterwards, unless something came after it.
        let with = with_block(&with_block("*.png binary", &one), &other);
        assert_eq!(with_block(&with, &[]), "*.png binary");
        assert_eq!(
            with_block(&format!("{with}*.txt text\n"), &[]),
            "*.png binary\n*.txt text\n"
        );
        // What is not closed may go on with lines of others.
        let open = format!("{BEGIN}\n*.txt text\n");
        assert_eq!(with_block(&open, &[]), open);
    }
}
