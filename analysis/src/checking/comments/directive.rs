//! Directives, which are comments for the tools: `# ladder: allow(double-coil): two modes, only one is wired #`.

use crate::asked::{Asked, asked};
use crate::findings::diagnostic::Diagnostic;
use crate::findings::did_you_mean::closest;
use crate::findings::rule::Rule;
use crate::profile;
use crate::program::UnreadDirective;
use crate::rules;
use ladder_instructions::Profile;
use ladder_syntax::{TextRange, TextSize};

/// What a comment asks for.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Directive {
    /// Switch rules off for what is next, or for the file.
    Allow { rules: Vec<Rule>, file: bool },
    /// Say something of the file: counts before its first network, and once.
    Says(Word),
    /// The block in whose definition it is has no counterpart in the language.
    Unread,
    /// Something else that the tools know: `fmt off`.
    Known,
}

/// What a comment says of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Word {
    Profile,
    Cycle,
}

impl Word {
    const fn text(self) -> &'static str {
        match self {
            Word::Profile => "profile",
            Word::Cycle => "cycle",
        }
    }
}

/// Reads a comment that is at `at`. None: it is not a directive. What is wrong goes to `out`.
pub(super) fn read(comment: &str, at: TextSize, out: &mut Vec<Diagnostic>) -> Option<Directive> {
    let Asked { word: name, after } = asked(comment)?;
    let place = TextRange::at(at, TextSize::of(comment));
    let file = match name {
        "allow" => false,
        "allow-file" => true,
        "fmt" if matches!(after, "on" | "off") => return Some(Directive::Known),
        "fmt" => {
            out.push(bad(place, "`fmt` is followed by `on` or `off`"));
            return None;
        }
        "cycle" if profile::cycle_time(after).is_some() => return Some(Directive::Says(Word::Cycle)),
        "cycle" => {
            out.push(
                bad(place, "`cycle` is followed by the time from one scan to the next")
                    .help("write it as in `# ladder: cycle 10ms #`; it is a day at most"),
            );
            return None;
        }
        "unread" if UnreadDirective::read(after).is_some() => return Some(Directive::Unread),
        "unread" => {
            out.push(bad(place, "after `unread` nothing of this is known").help(
                "write `unread`, `unread, writes a, b`, `unread, at any time` or `unread, at any time, writes a, b`",
            ));
            return None;
        }
        "profile" => return selected(after, place, out),
        _ => {
            out.push(unknown(name, place));
            return None;
        }
    };
    let rules = rules(after, place, out)?;
    Some(Directive::Allow { rules, file })
}

/// `(double-coil, never-read): the second belongs to the panel`
fn rules(text: &str, place: TextRange, out: &mut Vec<Diagnostic>) -> Option<Vec<Rule>> {
    const FORM: &str = "write it as in `# ladder: allow(double-coil): reason #`";
    let Some((names, reason)) = text.strip_prefix('(').and_then(|text| text.split_once(')')) else {
        out.push(bad(place, "the rules to switch off belong in parentheses").help(FORM));
        return None;
    };
    let mut rules = Vec::new();
    for name in names.split(',').map(str::trim) {
        match rules::rule_named(name) {
            Some(rule) => rules.push(rule),
            None => out.push(no_rule(name, place)),
        }
    }
    let reason = reason.trim_start().strip_prefix(':').unwrap_or_default();
    if reason.trim().is_empty() {
        out.push(bad(place, "this comment does not say why a rule is switched off").help(FORM));
    }
    Some(rules)
}

fn selected(name: &str, place: TextRange, out: &mut Vec<Diagnostic>) -> Option<Directive> {
    match Profile::from_name(name) {
        Some(_) => Some(Directive::Says(Word::Profile)),
        None => {
            let names = Profile::ALL.map(|profile| format!("`{profile}`"));
            out.push(
                bad(place, format!("there is no profile `{name}`"))
                    .help(format!("the profiles are {}", and_list(&names))),
            );
            None
        }
    }
}

/// `a`, `b` and `c`
fn and_list(words: &[String]) -> String {
    match words {
        [rest @ .., last] if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
        _ => words.concat(),
    }
}

fn unknown(name: &str, place: TextRange) -> Diagnostic {
    const WORDS: [&str; 6] = ["allow", "allow-file", "cycle", "fmt", "profile", "unread"];
    let found = bad(place, format!("`{name}` is nothing that a comment can ask for"));
    found.help(match closest(name, WORDS.into_iter()) {
        Some(near) => format!("did you mean `{near}`?"),
        None => {
            "comments can say `allow`, `allow-file`, `fmt off`, `fmt on`, `profile`, `cycle` and `unread`"
                .to_owned()
        }
    })
}

fn no_rule(name: &str, place: TextRange) -> Diagnostic {
    let found = bad(place, format!("there is no rule `{name}`"));
    found.help(match closest(name, rules::ALL.iter().map(|rule| rule.name())) {
        Some(near) => format!("did you mean `{near}`?"),
        None => "the reference of the rules lists them all".to_owned(),
    })
}

/// A comment that says something of the file, and comes too late for it.
pub(super) fn too_late(word: Word, place: TextRange) -> Diagnostic {
    let word = word.text();
    bad(
        place,
        format!("`{word}` counts above the first network only: here it changes nothing"),
    )
    .help("move it to the beginning of the file, or remove it")
}

/// A comment that says once more what another one says of the file.
pub(super) fn said_before(word: Word, place: TextRange, first: TextRange, line: usize) -> Diagnostic {
    let word = word.text();
    bad(
        place,
        format!("`{word}` is on line {line} already, and the first one counts: this changes nothing"),
    )
    .help("remove the one that is not meant")
    .related(first, "this one counts")
}

/// A comment that makes a block an unread part, and is in none, or in one that another comment made it already.
pub(super) fn no_unread_block(place: TextRange) -> Diagnostic {
    bad(
        place,
        "`unread` counts in the definition of a block, once: here it changes nothing",
    )
    .help("write it on a line of its own between FUNCTION_BLOCK and END_FUNCTION_BLOCK, or remove it")
}

/// Names in the list of an unread part that mean no tag.
pub(super) fn no_tags(names: &[&str], place: TextRange) -> Diagnostic {
    let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    let are = if names.len() == 1 {
        "is no tag"
    } else {
        "are no tags"
    };
    bad(place, format!("{} {are} of this block, nor where it is used", and_list(&names)))
        .help("write the names of tags that it may write, or leave out the list: then it may write all that it sees")
}

fn bad(place: TextRange, message: impl Into<String>) -> Diagnostic {
    Diagnostic::new(crate::rules::bad_directive::RULE, place, message)
}
