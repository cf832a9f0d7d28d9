//! The sheet that is drawn on: lines, arcs and texts as SVG elements.

use std::fmt::{Display, Write};

/// Where a text stands relative to its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// The elements drawn so far.
#[derive(Debug, Default)]
pub(super) struct Paper {
    out: String,
    /// The right end of the widest thing drawn.
    pub(super) width: i32,
}

impl Paper {
    pub(super) fn line(&mut self, class: &str, (x1, y1): (i32, i32), (x2, y2): (i32, i32)) {
        self.reach(x1.max(x2));
        self.element(format_args!(
            r#"<line class="{class}" x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}"/>"#
        ));
    }

    pub(super) fn path(&mut self, class: &str, commands: &str) {
        self.element(format_args!(r#"<path class="{class}" d="{commands}"/>"#));
    }

    pub(super) fn rect(&mut self, class: &str, (x, y): (i32, i32), width: i32, height: i32) {
        self.reach(x + width);
        self.element(format_args!(
            r#"<rect class="{class}" x="{x}" y="{y}" width="{width}" height="{height}" rx="2"/>"#
        ));
    }

    pub(super) fn dot(&mut self, class: &str, (x, y): (i32, i32)) {
        self.element(format_args!(
            r#"<circle class="{class}" cx="{x}" cy="{y}" r="3"/>"#
        ));
    }

    /// A text on one line; `width` is what it takes, in pixels.
    pub(super) fn text(&mut self, class: &str, (x, y): (i32, i32), anchor: Anchor, width: i32, text: &str) {
        if text.is_empty() {
            return;
        }
        let class = if class.is_empty() {
            String::new()
        } else {
            format!(r#" class="{class}""#)
        };
        let (anchor, right) = match anchor {
            Anchor::Start => ("", x + width),
            Anchor::Middle => (r#" text-anchor="middle""#, x + width / 2),
            Anchor::End => (r#" text-anchor="end""#, x),
        };
        self.reach(right);
        self.element(format_args!(
            r#"<text{class} x="{x}" y="{y}"{anchor}>{}</text>"#,
            Escaped(text)
        ));
    }

    /// A group with a name that a reader hears: what follows belongs to it until [`Self::end_group`].
    pub(super) fn begin_group(&mut self, title: &str) {
        self.element(format_args!("<g><title>{}</title>", Escaped(title)));
    }

    pub(super) fn end_group(&mut self) {
        self.element(format_args!("</g>"));
    }

    fn reach(&mut self, x: i32) {
        self.width = self.width.max(x);
    }

    fn element(&mut self, element: impl Display) {
        // Writing to a String does not fail.
        let _ = writeln!(self.out, "{element}");
    }

    /// The document: a sheet of this size, its style, and what was drawn.
    pub(super) fn document(self, width: i32, height: i32, style: &str) -> String {
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" role=\"img\">\n<style>\n{style}</style>\n\
             <rect class=\"paper\" width=\"{width}\" height=\"{height}\"/>\n{}</svg>\n",
            self.out
        )
    }
}

/// A text as XML takes it. Characters that XML 1.0 cannot hold become U+FFFD.
struct Escaped<'t>(&'t str);

impl Display for Escaped<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for c in self.0.chars() {
            match c {
                '&' => f.write_str("&amp;")?,
                '<' => f.write_str("&lt;")?,
                '>' => f.write_str("&gt;")?,
                '\t' => f.write_char(' ')?,
                '\0'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => f.write_char('\u{fffd}')?,
                _ => f.write_char(c)?,
            }
        }
        Ok(())
    }
}
