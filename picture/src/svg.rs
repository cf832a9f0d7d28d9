//! A picture as an SVG document.

use super::shapes::{Anchor, BlockKind, Form, PathStep, Picture, Shape};
use super::style::{DOT, Look, Theme, sheet};
use ladder_syntax::xml::Escaped;
use std::fmt::Write;

/// Writes the document. Text stays text; each network is a group with a name that a reader hears.
pub fn svg(picture: &Picture, theme: Theme) -> String {
    let Picture { width, height, .. } = picture;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" role=\"img\">\n<style>\n{}</style>\n\
         <rect class=\"paper\" width=\"{width}\" height=\"{height}\"/>\n",
        sheet(theme)
    );
    for block in &picture.blocks {
        let shapes = &picture.shapes[block.shapes.clone()];
        let network = match block.kind {
            BlockKind::Network { line, .. } => Some(line),
            _ => None,
        };
        if let Some(line) = network {
            out.push_str(&format!("<g><title>Line {line}</title>\n"));
        }
        for shape in shapes {
            write(shape, "", &mut out);
        }
        if network.is_some() {
            out.push_str("</g>\n");
        }
    }
    out.push_str("</svg>\n");
    out
}

/// Writes a shape, with these attributes besides.
pub(super) fn write(shape: &Shape, attributes: &str, out: &mut String) {
    let class = shape.look.class();
    // Writing to a String does not fail.
    let _ = match &shape.form {
        Form::Line((x1, y1), (x2, y2)) => {
            writeln!(
                out,
                r#"<line class="{class}"{attributes} x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}"/>"#
            )
        }
        Form::Path(steps) => {
            let steps: Vec<String> = steps.iter().map(|&step| command(step)).collect();
            writeln!(
                out,
                r#"<path class="{class}"{attributes} d="{}"/>"#,
                steps.join(" ")
            )
        }
        Form::Rect {
            at: (x, y),
            width,
            height,
        } => writeln!(
            out,
            r#"<rect class="{class}"{attributes} x="{x}" y="{y}" width="{width}" height="{height}" rx="2"/>"#
        ),
        Form::Dot((x, y)) => writeln!(
            out,
            r#"<circle class="{class}"{attributes} cx="{x}" cy="{y}" r="{DOT}"/>"#
        ),
        Form::Text {
            at: (x, y),
            anchor,
            text,
            ..
        } => {
            let class = match shape.look {
                Look::Text => String::new(),
                _ => format!(r#" class="{class}""#),
            };
            let anchor = match anchor {
                Anchor::Start => "",
                Anchor::Middle => r#" text-anchor="middle""#,
                Anchor::End => r#" text-anchor="end""#,
            };
            writeln!(
                out,
                r#"<text{class}{attributes} x="{x}" y="{y}"{anchor}>{}</text>"#,
                Escaped(text)
            )
        }
    };
}

fn command(step: PathStep) -> String {
    match step {
        PathStep::Move((x, y)) => format!("M {x} {y}"),
        PathStep::Line((x, y)) => format!("L {x} {y}"),
        PathStep::Bow((by_x, by_y), (x, y)) => format!("Q {by_x} {by_y} {x} {y}"),
        PathStep::Close => "Z".to_owned(),
    }
}
