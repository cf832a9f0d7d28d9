//! The lines in a file of git's attributes that are ours, between two comments.

const BEGIN: &str = "# ladder: begin, written by `ladder git install`";
const END: &str = "# ladder: end";

/// A text with these lines in the place of those that were ours, at the end if none were; without ours if there are no
/// lines.
pub(super) fn with_block(text: &str, lines: &[String]) -> String {
    let mut out = String::new();
    let mut inside = false;
    let mut put = false;
    let block = || -> String {
        let lines = lines.iter().map(|line| format!("{line}\n"));
        format!("{BEGIN}\n{}{END}\n", lines.collect::<String>())
    };
    for line in text.split_inclusive('\n') {
        match line.trim_end() {
            BEGIN if text.contains(END) => {
                inside = true;
                if !put && !lines.is_empty() {
                    out.push_str(&block());
                }
                put = true;
            }
            END if inside => inside = false,
            _ if inside => {}
            _ => out.push_str(line),
        }
    }
    if !put && !lines.is_empty() {
        if !out.is_empty() && !out.ends_with('\n') {
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
        // A line end that was missing is there afterwards.
        assert_eq!(
            with_block(&with_block("*.png binary", &one), &[]),
            "*.png binary\n"
        );
        // What is not closed may go on with lines of others.
        let open = format!("{BEGIN}\n*.txt text\n");
        assert_eq!(with_block(&open, &[]), open);
    }
}
