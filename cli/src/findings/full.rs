//! Findings for people: the lines with the place marked, what has to do with it, and what to do.

use super::source::{Lines, Source};
use annotate_snippets::{Annotation, AnnotationKind, Group, Level, Origin, Patch, Renderer, Snippet};
use ladder_analysis::Severity;
use ladder_analysis::findings::fix;
use ladder_analysis::{Diagnostic, Fix, Related};
use ladder_notations::Mark;
use ladder_syntax::{TextRange, TextSize};
use ladder_workspace::shown;
use std::borrow::Cow;
use std::ops::Range;

/// Related places at most this many lines away are shown in one excerpt with the finding's own place.
const NEAR: usize = 8;

/// A finding with its excerpt, without a line end after it.
pub(crate) fn render(source: &Source, finding: &Diagnostic, renderer: &Renderer) -> String {
    let title = level(finding.severity)
        .primary_title(shown::line(&finding.message))
        .id(finding.rule.name());
    let mut group = Group::with_title(title);
    let (near, far) = near_and_far(source, finding);
    let excerpt = Excerpt::of(
        source,
        near.iter().fold(source.lines(finding.range), |lines, place| {
            lines.join(source.lines(place.range))
        }),
    );
    if excerpt.is_readable() {
        group = group.element(
            excerpt
                .snippet(source)
                .annotation(AnnotationKind::Primary.span(excerpt.span(finding.range)))
                .annotations(near.iter().map(|place| excerpt.mark(place))),
        );
    } else {
        group = group.element(origin(source, finding.range));
        for place in &near {
            group = group
                .element(Level::NOTE.message(shown::line(&place.message)))
                .element(origin(source, place.range));
        }
    }
    let others: Vec<Option<Source>> = far
        .iter()
        .map(|place| source.other(place.file.as_ref()?))
        .collect();
    for (place, other) in far.into_iter().zip(&others) {
        let source = match (other, &place.file) {
            (Some(other), _) => other,
            (None, None) => source,
            // A file that is gone.
            (None, Some(_)) => continue,
        };
        let excerpt = Excerpt::of(source, source.lines(place.range));
        group = if excerpt.is_readable() {
            group.element(excerpt.snippet(source).annotation(excerpt.mark(place)))
        } else {
            group
                .element(Level::NOTE.message(shown::line(&place.message)))
                .element(origin(source, place.range))
        };
    }
    if let Some(name) = source.name_of(finding.range) {
        group = group.element(Level::NOTE.message(shown::line(name)));
    }
    if let Some(help) = &finding.help {
        group = group.element(Level::HELP.message(shown::line(help)));
    }
    let mut report = vec![group];
    // The first is the best; editors offer the others too.
    report.extend(finding.fixes.first().and_then(|fix| suggestion(source, fix)));
    renderer.render(&report)
}

fn near_and_far<'d>(source: &Source, finding: &'d Diagnostic) -> (Vec<&'d Related>, Vec<&'d Related>) {
    let own = source.lines(finding.range);
    finding
        .related
        .iter()
        .partition(|place| place.file.is_none() && source.lines(place.range).distance(own) <= NEAR)
}

/// A remark on a program of another system, with its excerpt.
pub(super) fn remark(source: &Source, remark: &Mark, renderer: &Renderer) -> String {
    let title = level(remark.severity)
        .primary_title(shown::line(&remark.message))
        .id(remark.check);
    let excerpt = Excerpt::of(source, source.lines(remark.range));
    let group = Group::with_title(title);
    let group = if excerpt.is_readable() {
        let place = AnnotationKind::Primary.span(excerpt.span(remark.range));
        group.element(excerpt.snippet(source).annotation(place))
    } else {
        group.element(origin(source, remark.range))
    };
    let part = source.name_of(remark.range);
    let part = part.map(|part| Level::NOTE.message(shown::line(part)));
    let group = part.into_iter().fold(group, Group::element);
    renderer.render(&[group])
}

fn level(severity: Severity) -> Level<'static> {
    match severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
        Severity::Info => Level::INFO,
    }
}

/// A place without an excerpt.
fn origin(source: &Source, range: TextRange) -> Origin<'_> {
    let place = source.place(range.start());
    Origin::path(shown::line(&source.file))
        .line(place.line as usize)
        .char_column(place.column as usize)
}

/// In texts up to this length a fix is shown with the drawing laid out again: that reads the whole text for each.
const SHORT: usize = 64 << 10;

/// This many bytes are read again for the fixes of all findings together.
const MOST_READ: usize = 4 << 20;

/// Excerpts that are longer are not shown: nobody could see the place in them, and each is read as a whole.
const LONGEST_EXCERPT: usize = 16 << 10;

/// The lines as they would be.
fn suggestion<'a>(source: &'a Source, fix: &'a Fix) -> Option<Group<'a>> {
    let findings = source.analyze().diagnostics().len();
    let edits = if source.text.len() <= SHORT && source.text.len() * findings <= MOST_READ {
        fix::aligned(&source.text, fix, &source.format_options())
    } else {
        fix.edits.clone()
    };
    let whole = edits.iter().map(|edit| edit.range).reduce(TextRange::cover)?;
    let excerpt = Excerpt::of(source, source.lines(whole));
    let patches = edits
        .into_iter()
        .map(|edit| Patch::new(excerpt.span(edit.range), shown::text(&edit.text).into_owned()));
    let title = Level::HELP.secondary_title(shown::line(&fix.title));
    if !excerpt.is_readable() {
        return Some(Group::with_title(title));
    }
    Some(title.element(excerpt.snippet(source).patches(patches)))
}

/// Some lines of the text. Only they are given to the renderer: it reads all it is given, for each finding.
pub(super) struct Excerpt<'a> {
    text: Cow<'a, str>,
    start: TextSize,
    first_line: usize,
    /// How many bytes longer than the source the text has become, after each character that is written out.
    grown: Vec<(usize, usize)>,
}

impl<'a> Excerpt<'a> {
    pub(super) fn of(source: &'a Source, lines: Lines) -> Excerpt<'a> {
        let (text, start) = source.excerpt(lines);
        let (text, grown) = written_out(text);
        Excerpt {
            text,
            start,
            first_line: lines.first + 1,
            grown,
        }
    }

    fn is_readable(&self) -> bool {
        self.text.len() <= LONGEST_EXCERPT
    }

    pub(super) fn snippet<T: Clone>(&self, source: &'a Source) -> Snippet<'a, T> {
        Snippet::source(self.text.clone())
            .path(shown::line(&source.file))
            .line_start(self.first_line)
    }

    fn mark<'d>(&self, place: &'d Related) -> Annotation<'d> {
        AnnotationKind::Context
            .span(self.span(place.range))
            .label(shown::line(&place.message))
    }

    pub(super) fn span(&self, range: TextRange) -> Range<usize> {
        let within = |offset: TextSize| {
            let offset = offset.checked_sub(self.start).map_or(0, usize::from);
            let before = self.grown.partition_point(|(at, _)| *at <= offset);
            let more = before.checked_sub(1).map_or(0, |last| self.grown[last].1);
            (offset + more).min(self.text.len())
        };
        within(range.start())..within(range.end())
    }
}

/// The text with what a terminal would interpret escaped, and how much longer that makes it.
fn written_out(text: Cow<'_, str>) -> (Cow<'_, str>, Vec<(usize, usize)>) {
    if !text.contains(shown::is_obeyed) {
        return (text, Vec::new());
    }
    let mut out = String::with_capacity(text.len() + 16);
    let mut grown = Vec::new();
    let mut rest = text.char_indices();
    while let Some((at, c)) = rest.next() {
        if shown::is_obeyed_in_text(c, rest.clone().next().map(|(_, next)| next)) {
            out.push_str(&shown::escape(c));
            let after = at + c.len_utf8();
            grown.push((after, out.len() - after));
        } else {
            out.push(c);
        }
    }
    (Cow::Owned(out), grown)
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::{Expect, expect};
    use ladder_analysis::Applicability;

    /// A finding at the first `«..»`, related places at the others; the marks are taken out of the text. A fix
    /// replaces the first place by `fix`.
    fn check(marked: &str, fix: Option<&str>, expected: Expect) {
        let mut text = String::new();
        let mut places = Vec::new();
        for (index, part) in marked.split(['«', '»']).enumerate() {
            let start = TextSize::of(&text);
            text.push_str(part);
            if index % 2 == 1 {
                places.push(TextRange::new(start, TextSize::of(&text)));
            }
        }
        let mut finding = Diagnostic::new(
            ladder_analysis::rules::rule_named("duplicate-timer").expect("a rule"),
            places[0],
            "something is wrong here",
        );
        for place in &places[1..] {
            finding = finding.related(*place, "this has to do with it");
        }
        if let Some(fix) = fix {
            finding = finding
                .help("do this")
                .fix(Applicability::Safe, "Do it", places[0], fix);
        }
        let source = Source::new("a.clad".to_owned(), text);
        expected.assert_eq(&(render(&source, &finding, &Renderer::plain()) + "\n"));
    }

    #[test]
    fn the_line_the_place_and_the_way_out() {
        check(
            "\n+--[«TOM»]( t )--+\n",
            Some("TON"),
            expect![[r#"
                error[duplicate-timer]: something is wrong here
                 --> a.clad:2:5
                  |
                2 | +--[TOM]( t )--+
                  |     ^^^
                  |
                  = help: do this
                help: Do it
                  |
                2 - +--[TOM]( t )--+
                2 + +------------------------------------------------------------------[TON]( t )--+
                  |
            "#]],
        );
    }

    #[test]
    fn an_insertion() {
        check(
            "+--[ ]( a )«»( )( b )--+\n",
            Some("--"),
            expect![[r#"
                error[duplicate-timer]: something is wrong here
                 --> a.clad:1:12
                  |
                1 | +--[ ]( a )( )( b )--+
                  |            ^
                  |
                  = help: do this
                help: Do it
                  |
                1 | +--[ ]( a )----------------------------------------------------------( )( b )--+
                  |            ++++++++++++++++++++++++++++++++++++++++++++++++++++++++++
            "#]],
        );
    }

    #[test]
    fn related_places_near_by_share_the_excerpt() {
        check(
            "+--[ ]( «a» )--+\n\n|\n+--[ ]( «a» )--+\n",
            None,
            expect![[r#"
            error[duplicate-timer]: something is wrong here
             --> a.clad:1:9
              |
            1 | +--[ ]( a )--+
              |         ^
            ...
            4 | +--[ ]( a )--+
              |         - this has to do with it
        "#]],
        );
    }

    #[test]
    fn related_places_far_away_have_their_own() {
        let text = format!("+--[ ]( «a» )--+\n{}+--[ ]( «b» )--+\n", "|\n".repeat(40));
        check(
            &text,
            None,
            expect![[r#"
            error[duplicate-timer]: something is wrong here
              --> a.clad:1:9
               |
             1 | +--[ ]( a )--+
               |         ^
               |
              ::: a.clad:42:9
               |
            42 | +--[ ]( b )--+
               |         - this has to do with it
        "#]],
        );
    }

    #[test]
    fn a_place_of_several_lines() {
        check(
            "VAR «a\n: BOOL\n»END_VAR\n",
            None,
            expect![[r#"
            error[duplicate-timer]: something is wrong here
             --> a.clad:1:5
              |
            1 |   VAR a
              |  _____^
            2 | | : BOOL
              | |_______^
        "#]],
        );
    }

    #[test]
    fn the_end_of_the_text() {
        check(
            "+--( )( a )--+\n«»",
            None,
            expect![[r#"
            error[duplicate-timer]: something is wrong here
             --> a.clad:2:1
              |
            2 |
              | ^
        "#]],
        );
        check(
            "«»",
            None,
            expect![[r#"
            error[duplicate-timer]: something is wrong here
             --> a.clad:1:1
              |
            1 |
              | ^
        "#]],
        );
    }

    #[test]
    fn lone_carriage_returns_and_a_byte_order_mark() {
        check(
            "\u{feff}«+»--+\r+--+\r",
            None,
            expect![[r#"
            error[duplicate-timer]: something is wrong here
             --> a.clad:1:1
              |
            1 | +--+
              | ^
        "#]],
        );
        check(
            "\u{feff}+--+\r+-«-»+\r",
            None,
            expect![[r#"
            error[duplicate-timer]: something is wrong here
             --> a.clad:2:3
              |
            2 | +--+
              |   ^
        "#]],
        );
    }

    #[test]
    fn a_very_long_line_is_not_shown() {
        let text = format!("# {} # +--[ ]( «温度» )--( )( «b» )--+\n", "ü".repeat(9000));
        check(
            &text,
            Some("t"),
            expect![[r#"
                error[duplicate-timer]: something is wrong here
                --> a.clad:1:9014
                 = note: this has to do with it
                ::: a.clad:1:9025
                 = help: do this
                help: Do it
            "#]],
        );
    }

    #[test]
    fn what_a_terminal_would_obey() {
        check(
            "# \u{1b}]0;x\u{7} # +--[ ]( «\u{9b}2Ja\u{202e}» )--+ #\u{2028}#\n",
            Some("b\u{1b}[1m"),
            expect![[r#"
                error[duplicate-timer]: something is wrong here
                 --> a.clad:1:29
                  |
                1 | # \u{1b}]0;x\u{7} # +--[ ]( \u{9b}2Ja\u{202e} )--+ #\u{2028}#
                  |                             ^^^^^^^^^^^^^^^^^
                  |
                  = help: do this
                help: Do it
                  |
                1 - # \u{1b}]0;x\u{7} # +--[ ]( \u{9b}2Ja\u{202e} )--+ #\u{2028}#
                1 + # \u{1b}]0;x\u{7} # +--[ ]( b\u{1b}[1m )--+ #\u{2028}#
                  |
            "#]],
        );
    }

    #[test]
    fn tabs_and_wide_letters() {
        check(
            "\t# 温度 # +--[ ]( «温度» )--+\n",
            None,
            expect![[r#"
            error[duplicate-timer]: something is wrong here
             --> a.clad:1:17
              |
            1 |     # 温度 # +--[ ]( 温度 )--+
              |                      ^^^^
        "#]],
        );
    }
}
