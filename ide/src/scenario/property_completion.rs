//! Completion in properties and assumptions: forms, how soon an answer comes, and what expressions name.

use super::completion::{Proposals, best_first, nameable, word};
use super::file::Scenarios;
use super::forms::{PAST, form, in_property, snippets};
use super::members::after_point;
use super::row::Files;
use crate::completion::{CompletionKind, Snippet, Topic};
use ladder_analysis::program::SystemTag;
use ladder_simulator::scenario::{FORMS, PROPERTY, TextLine};
use ladder_syntax::{Name, TextRange, TextSize};

/// The words between two values, and the one before a value.
const OPERATORS: [(&str, &str); 3] = [
    ("and", "both"),
    ("or", "one of them or both"),
    ("xor", "one of them, not both"),
];

/// What begins a property, at the beginning of a line.
pub(super) fn begun(out: &mut Proposals) {
    let text = Snippet::default()
        .text("property \"")
        .stop("what must hold")
        .text("\"\n")
        .end();
    word(PROPERTY, text, out);
    word(
        "assume",
        Snippet::default().text("assume ").stop("condition"),
        out,
    );
    forms(out);
}

/// The forms.
pub(super) fn forms(out: &mut Proposals) {
    for (label, text) in snippets() {
        let first = label.split(' ').next().unwrap_or(label);
        let topic = form(first).map_or(Topic::Nothing, Topic::Words);
        out.add(CompletionKind::Keyword, label, "property", text, topic);
    }
}

/// Whether the line above, but for blank ones and comments, names a property that says nothing yet.
pub(super) fn is_named_above(text: &str, start: TextSize) -> bool {
    let above = text[..usize::from(start)].lines().rev();
    let mut lines = above
        .map(|line| TextLine::read(line, "", 0))
        .filter(|line| !line.words.is_empty());
    let Some(line) = lines.next() else { return false };
    matches!(&*line.words, [first, name] if first.text == PROPERTY && name.text.starts_with('"') && !name.unclosed)
}

/// What can be written in a line of a property, of which this is before the cursor.
pub(super) fn in_line(
    scenarios: &Scenarios<'_>,
    (start, text): (TextSize, &str),
    trigger: Option<char>,
    out: &mut Proposals,
) {
    let is_part = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '[' | ']' | '$' | '#' | '%');
    let from = text
        .rfind(|c| !is_part(c))
        .map_or(0, |at| at + text[at..].chars().next().map_or(1, char::len_utf8));
    let at = |place: usize| start + TextSize::new(place as u32);
    out.word = TextRange::new(at(from), at(text.len()));
    let before = TextLine::read(&text[..from], "", 0);
    let words: Vec<&str> = before.words.iter().map(|word| word.text).collect();
    let words = match &*words {
        // The form may be on the line of the name.
        [PROPERTY, _, form @ ..]
            if !before.words[1].unclosed && before.text.ends_with(char::is_whitespace) =>
        {
            form
        }
        [PROPERTY, ..] => return,
        words => words,
    };
    match words {
        [] if trigger.is_none() => forms(out),
        [] => {}
        ["no"] => out.value("faults", "no block records a fault"),
        ["no", ..] => {}
        ["within"] | ["possible", .., "within"] => {
            for (span, words) in [
                ("500ms", "a time"),
                ("1s", "a time"),
                ("3 scans", "a number of scans"),
            ] {
                out.value(span, words);
            }
        }
        ["within", number] if number.parse::<u64>().is_ok() => out.value("scans of", "so many scans"),
        ["within", _] | ["within", _, "scan" | "scans"] => continuation("of", out),
        [first, ..] if FORMS.contains(first) => {
            in_expression(scenarios, &text[..from], (first, &text[from..]), trigger, out);
        }
        _ => {}
    }
}

fn continuation(label: &'static str, out: &mut Proposals) {
    let topic = in_property(label).map_or(Topic::Nothing, Topic::Words);
    out.add(
        CompletionKind::Keyword,
        label,
        "",
        Snippet::plain_text(format!("{label} ")),
        topic,
    );
}

/// What can be written in an expression: a value, or what joins it to another.
pub(super) fn in_expression(
    scenarios: &Scenarios<'_>,
    before: &str,
    (form, written): (&str, &str),
    trigger: Option<char>,
    out: &mut Proposals,
) {
    if wants_value(before) {
        return values(scenarios, written, (trigger, form), out);
    }
    if trigger.is_some() {
        return;
    }
    for (label, detail) in OPERATORS {
        out.add(
            CompletionKind::Operator,
            label,
            detail,
            Snippet::plain_text(format!("{label} ")),
            Topic::Nothing,
        );
    }
    match form {
        "when" if before.contains(':') => continuation("until", out),
        "possible" => continuation("within", out),
        _ => {}
    }
}

/// Whether a value is next: after an operator, a bracket, a colon, or a word of the form.
fn wants_value(before: &str) -> bool {
    let before = before.trim_end();
    let Some(last) = before.chars().next_back() else {
        return true;
    };
    if !(last.is_alphanumeric() || matches!(last, '_' | ')' | ']' | '\'')) {
        return true;
    }
    let start = before.rfind(|c: char| !(c.is_alphanumeric() || c == '_'));
    let word = start.map_or(before, |at| &before[at..]).trim_start();
    let word = word.to_ascii_lowercase();
    let is_operator = ["and", "or", "xor", "not", "mod", "of", "until"].contains(&&*word);
    is_operator || FORMS.contains(&before.trim_start())
}

fn values(
    scenarios: &Scenarios<'_>,
    written: &str,
    (trigger, form): (Option<char>, &str),
    out: &mut Proposals,
) {
    if let Some(members) = Files::of(scenarios).and_then(|files| after_point(files, written)) {
        for it in members {
            out.add(
                it.kind,
                &it.name,
                &it.detail,
                Snippet::plain_text(&*it.name),
                it.topic,
            );
        }
        return;
    }
    if trigger.is_none() {
        // A scene shows what is, and has no form.
        for name in PAST.iter().filter(|_| !form.is_empty()) {
            let text = Snippet::default()
                .text(name)
                .text("(")
                .stop("condition")
                .text(")");
            let topic = in_property(name).map_or(Topic::Nothing, Topic::Words);
            out.add(CompletionKind::Function, &format!("{name}("), "", text, topic);
        }
        out.add(
            CompletionKind::Operator,
            "not",
            "the opposite",
            Snippet::plain_text("not "),
            Topic::Nothing,
        );
    }
    if Name::new(written).as_str().starts_with("sys") {
        for tag in SystemTag::ALL {
            let name = format!("SYS.{}", tag.name());
            let topic = Topic::Words(tag.about());
            out.add(
                CompletionKind::Constant,
                &name,
                tag.ty().name(),
                Snippet::plain_text(&*name),
                topic,
            );
        }
    }
    let mut found = nameable(scenarios);
    best_first(&mut found, written);
    for it in found {
        out.add(
            it.kind,
            &it.name,
            &it.detail,
            Snippet::plain_text(&*it.name),
            it.topic,
        );
    }
}
