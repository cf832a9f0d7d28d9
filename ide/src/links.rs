//! Links in comments: addresses on the web, and names of files in the same folder.

use crate::comments;
use ladder_analysis::context::Context;
use ladder_syntax::{TextRange, TextSize};

/// A link.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Link {
    /// Where it is.
    pub range: TextRange,
    /// Where it leads.
    pub to: LinkTarget,
}

/// Where a link leads.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LinkTarget {
    /// An address on the web.
    Web(String),
    /// What may be a file: its path from the folder of this one. Whether there is such a file is for others to say.
    File(String),
}

/// The links of a file in the order of the text.
pub fn links(context: &Context) -> Vec<Link> {
    let parse = &context.parse;
    let mut links = Vec::new();
    for line in 0..parse.lines().len() {
        for (range, text) in comments::of_line(parse, line) {
            for (start, word) in words(&text) {
                if let Some(to) = target(word) {
                    let start = range.start() + TextSize::new(start as u32);
                    let range = TextRange::at(start, TextSize::of(word));
                    links.push(Link { range, to });
                }
            }
        }
    }
    links
}

/// The words of a comment without the signs of punctuation around them, and where they begin.
fn words(comment: &str) -> impl Iterator<Item = (usize, &str)> {
    let split = |c: char| c.is_whitespace() || matches!(c, '#' | '"' | '<' | '>' | '`' | '\'');
    comment.split(split).filter_map(move |word| {
        let start = word.as_ptr() as usize - comment.as_ptr() as usize;
        let trimmed = word.trim_start_matches(['(', '[', '{']);
        let start = start + word.len() - trimmed.len();
        let mut trimmed = trimmed.trim_end_matches(['.', ',', ';', ':', '!', '?']);
        // A closing bracket belongs to the word only if it opens there.
        for (open, close) in [('(', ')'), ('[', ']'), ('{', '}')] {
            while trimmed.ends_with(close) && trimmed.matches(close).count() > trimmed.matches(open).count() {
                trimmed = trimmed[..trimmed.len() - 1].trim_end_matches(['.', ',', ';', ':', '!', '?']);
            }
        }
        (!trimmed.is_empty()).then_some((start, trimmed))
    })
}

fn target(word: &str) -> Option<LinkTarget> {
    let scheme = |scheme: &str| {
        let head = word.get(..scheme.len());
        head.is_some_and(|head| head.eq_ignore_ascii_case(scheme)) && word.len() > scheme.len()
    };
    if scheme("https://") || scheme("http://") || scheme("mailto:") {
        return Some(LinkTarget::Web(word.to_owned()));
    }
    // An absolute path is another one on each machine; `and/or` and `3.5` are not files.
    if word.starts_with(['/', '\\']) || word.contains([':', '|', '*', '?']) {
        return None;
    }
    let name = word.rsplit(['/', '\\']).next()?;
    let (stem, ending) = name.rsplit_once('.')?;
    let is_name = !stem.is_empty()
        && ending.chars().next().is_some_and(char::is_alphabetic)
        && ending
            .chars()
            .all(|c| c.is_alphanumeric() || matches!(c, '-' | '_'));
    is_name.then(|| LinkTarget::File(word.replace('\\', "/")))
}

#[cfg(test)]
mod tests {
    use super::links;
    use crate::fixture::Fixture;
    use expect_test::{Expect, expect};

    fn check(text: &str, expected: Expect) {
        let fixture = Fixture::new(text);
        let context = &fixture.files[0].0.context;
        let shown = links(context)
            .into_iter()
            .map(|link| format!("{} {:?}\n", fixture.show("main.clad", link.range), link.to));
        expected.assert_eq(&shown.collect::<Vec<_>>().concat());
    }

    #[test]
    fn what_leads_somewhere() {
        check(
            "# ö see https://example.com/a?b=(c), (http://x.y). and docs/motor.pdf; ../lib.clad! #\n\
             +--[ ]( a )--# plan.svg #--( )( b )--+  # <mailto:a@b.de> `x.clad` #\n\
             # no links: 3.5 and/or /etc/passwd e.g. ... https:// C:\\a.txt a.clad:3 .x #\n\
             VAR a : INT; # notes\\a.md #\nEND_VAR\n",
            expect![[r#"
                main.clad:1:9 https://example.com/a?b=(c) Web("https://example.com/a?b=(c)")
                main.clad:1:39 http://x.y Web("http://x.y")
                main.clad:1:56 docs/motor.pdf File("docs/motor.pdf")
                main.clad:1:72 ../lib.clad File("../lib.clad")
                main.clad:2:16 plan.svg File("plan.svg")
                main.clad:2:44 mailto:a@b.de Web("mailto:a@b.de")
                main.clad:2:60 x.clad File("x.clad")
                main.clad:3:36 e.g File("e.g")
                main.clad:4:16 notes\a.md File("notes/a.md")
            "#]],
        );
        check(
            "# https://open.example",
            expect![[r#"
            main.clad:1:3 https://open.example Web("https://open.example")
        "#]],
        );
        check("+--( )( 'https://a.b' )--+\n", expect![[""]]);
    }
}
