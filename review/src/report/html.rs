//! A comparison as one page for a browser: both forms of a network as pictures next to each other.
//!
//! The page holds all that it needs and asks nobody for anything. Nothing of a program is markup or script in it.

use super::{Compared, notes, of_whole, shown, summary};
use crate::comparison::{Change, Comparison};
use crate::drawing::{Drawn, changed_parts, draw, draw_both};
use crate::outline::{Entry, Kind, Outline};
use crate::verdict::Verdict;
use crate::words::{heading, reason};
use ladder_picture::excerpt::{Excerpts, style_sheet};
use ladder_picture::{Options, Theme, picture};
use ladder_syntax::xml::Escaped;
use std::fmt::Write;

/// What is not a picture is laid out in this width.
const WIDTH: u32 = 80;

/// The report of some files, and of settings files: their names, and lines with their signs.
pub fn report(files: &[Compared<'_>], settings: &[(&str, &[String])]) -> String {
    let mut out = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"generator\" content=\"ladder\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n\
         <title>What changed</title>\n<style>\n{}</style>\n</head>\n<body>\n\
         <h1>What changed</h1>\n\
         <p class=\"keys\"><kbd>n</kbd> goes to the next change, <kbd>p</kbd> to the one before.</p>\n",
        style(Theme::Auto),
    );
    for file in files {
        program(file, &mut out);
    }
    for (name, lines) in settings {
        // Writing to a String does not fail.
        let _ = write!(
            out,
            "<h2>{}</h2>\n<section class=\"change\" tabindex=\"0\">\n<pre>{}</pre>\n</section>\n",
            Escaped(name),
            Escaped(&lines.join("\n"))
        );
    }
    if files.is_empty() && settings.is_empty() {
        out.push_str("<p>No network, declaration or comment has changed.</p>\n");
    }
    out.push_str("<script>\n");
    out.push_str(include_str!("page.js"));
    out.push_str("</script>\n</body>\n</html>\n");
    out
}

/// The style sheet that the report has in these colours.
pub fn style(theme: Theme) -> String {
    style_sheet(theme) + include_str!("page.css")
}

/// What the report shows of each change: a heading, what is known of it, and both forms.
pub fn sections(comparison: &Comparison<'_>) -> Vec<String> {
    let (old, new) = (
        picture(&comparison.old.context, &Options::default()),
        picture(&comparison.new.context, &Options::default()),
    );
    let pictures = Pictures {
        old: Excerpts::new(&old),
        new: Excerpts::new(&new),
    };
    let section = |change| {
        let title = heading(comparison, change);
        let mut out = format!(
            "<section class=\"change\" tabindex=\"0\">\n<h3>{}</h3>\n",
            Escaped(&title)
        );
        if let Some(reason) = reason(change) {
            // Writing to a String does not fail.
            let _ = writeln!(out, "<p>{}</p>", Escaped(&reason));
        }
        out.push_str("<div class=\"forms\">\n");
        forms(comparison, change, &pictures, &mut out);
        out + "</div>\n</section>\n"
    };
    shown(comparison).map(section).collect()
}

fn program(file: &Compared<'_>, out: &mut String) {
    let comparison = &file.comparison;
    let names = match (file.old, file.new) {
        (Some(old), Some(new)) if old != new => format!("{old} → {new}"),
        (None, Some(new)) => format!("{new} (new file)"),
        (Some(old), None) => format!("{old} (gone)"),
        (_, name) => name.unwrap_or_default().to_owned(),
    };
    let _ = write!(
        out,
        "<h2>{}</h2>\n<p>{}</p>\n",
        Escaped(&names),
        Escaped(&summary(comparison))
    );
    for note in notes(comparison) {
        let _ = writeln!(out, "<p>{}</p>", Escaped(&note));
    }
    out.push_str(&sections(comparison).concat());
    if let Some((told, rows)) = of_whole(comparison) {
        let _ = write!(
            out,
            "<section class=\"change\" tabindex=\"0\">\n<h3>{}</h3>\n<pre>{}</pre>\n</section>\n",
            Escaped(&told),
            Escaped(&rows.join("\n"))
        );
    }
}

/// The pictures of both programs.
struct Pictures<'s> {
    old: Excerpts<'s>,
    new: Excerpts<'s>,
}

/// Which side a form is of.
#[derive(Clone, Copy)]
enum Side {
    Old,
    New,
}

fn forms(comparison: &Comparison<'_>, change: &Change<'_>, pictures: &Pictures<'_>, out: &mut String) {
    let (old, new) = (comparison.old, comparison.new);
    match (change.old, change.new) {
        (Some(was), Some(is)) if change.verdict == Verdict::Same => {
            let (_, drawn) = draw_both((old, was), (new, is), WIDTH);
            form(Side::New, (new, is), &drawn, &pictures.new, &[], out);
        }
        (Some(was), Some(is)) => {
            let (old_drawn, new_drawn) = draw_both((old, was), (new, is), WIDTH);
            let changed = changed_parts((old, was), (new, is));
            form(
                Side::Old,
                (old, was),
                &old_drawn,
                &pictures.old,
                &changed.gone,
                out,
            );
            form(
                Side::New,
                (new, is),
                &new_drawn,
                &pictures.new,
                &changed.added,
                out,
            );
        }
        (Some(was), None) => {
            form(
                Side::Old,
                (old, was),
                &draw(old, was, WIDTH),
                &pictures.old,
                &[],
                out,
            );
        }
        (None, Some(is)) => {
            form(
                Side::New,
                (new, is),
                &draw(new, is, WIDTH),
                &pictures.new,
                &[],
                out,
            );
        }
        (None, None) => {}
    }
}

fn form(
    side: Side,
    (outline, entry): (&Outline, &Entry),
    drawn: &Drawn,
    picture: &Excerpts<'_>,
    marked: &[(usize, usize)],
    out: &mut String,
) {
    let (class, name) = match side {
        Side::Old => ("old", "before"),
        Side::New => ("new", "after"),
    };
    let line = outline.line(entry);
    let _ = write!(
        out,
        "<figure class=\"{class}\">\n<figcaption>{name}, line {line}</figcaption>\n"
    );
    let network = entry.network.filter(|_| entry.kind == Kind::Network);
    let broken = network.is_some_and(|index| outline.context.networks.at(index).broken);
    let svg = network
        .filter(|_| !broken)
        .and_then(|index| picture.svg(index, marked));
    match svg {
        Some(svg) => {
            // The comments above; those inside are in the picture.
            let above = drawn
                .lines
                .iter()
                .take_while(|line| line.text.starts_with('#'))
                .count();
            lines(&drawn.lines[..above], out);
            out.push_str(&svg);
        }
        None => lines(&drawn.lines, out),
    }
    out.push_str("</figure>\n");
}

/// Lines with their marks.
fn lines(lines: &[crate::drawing::DrawnLine], out: &mut String) {
    if lines.is_empty() {
        return;
    }
    out.push_str("<pre>");
    for line in lines {
        let mut at = 0;
        for mark in &line.marks {
            let (before, marked) = (&line.text[at..mark.start], &line.text[mark.clone()]);
            let _ = write!(out, "{}<mark>{}</mark>", Escaped(before), Escaped(marked));
            at = mark.end;
        }
        let _ = writeln!(out, "{}", Escaped(&line.text[at..]));
    }
    out.push_str("</pre>\n");
}
