//! What is drawn on a page.

use super::font::Fonts;
use ladder_picture::shapes::{Anchor, At, Form, PathStep, Shape};
use ladder_picture::sheet::{Piece, Sheet};
use ladder_picture::style::{Cap, Colour, DOT, Hue, Look, Theme};
use pdf_writer::types::LineCapStyle;
use pdf_writer::{Content, Name, Str, TextStr};

/// Pixels around a window in which the ends of its lines are still seen.
const BLEED: i32 = 2;
/// How far the handles of a bow lie outwards that makes a quarter of a circle.
const QUARTER: f32 = 0.552_285;

/// The drawing of a page.
pub(super) fn content(sheet: &Sheet, theme: Theme, fonts: &mut Fonts) -> Vec<u8> {
    let mut content = Content::new();
    if theme == Theme::Dark {
        fill(&mut content, theme.colour(Hue::Paper));
        content.rect(0.0, 0.0, sheet.width, sheet.height).fill_nonzero();
    }
    for piece in &sheet.pieces {
        piece_on(&mut content, sheet.height, piece, theme, fonts);
    }
    content.finish().to_vec()
}

fn piece_on(content: &mut Content, height: f32, piece: &Piece, theme: Theme, fonts: &mut Fonts) {
    let Piece {
        shapes,
        window,
        at: (x, y),
        scale,
    } = piece;
    content.save_state();
    // Pixels count downwards, points upwards.
    content.transform([
        *scale,
        0.0,
        0.0,
        -scale,
        x - window.left as f32 * scale,
        height - y + window.top as f32 * scale,
    ]);
    let (left, top) = (window.left - BLEED, window.top - BLEED);
    let (wide, high) = (window.right + BLEED - left, window.bottom + BLEED - top);
    content
        .rect(left as f32, top as f32, wide as f32, high as f32)
        .clip_nonzero()
        .end_path();
    let mut look = None;
    for shape in shapes {
        if look != Some(shape.look) {
            look = Some(shape.look);
            take_up(content, shape.look, theme);
        }
        draw(content, shape, fonts);
    }
    content.restore_state();
}

fn fill(content: &mut Content, Colour(red, green, blue): Colour) {
    content.set_fill_rgb(part(red), part(green), part(blue));
}

fn part(of_colour: u8) -> f32 {
    f32::from(of_colour) / 255.0
}

/// The colours and lines of a look.
fn take_up(content: &mut Content, look: Look, theme: Theme) {
    if let Some(stroke) = look.stroke() {
        let Colour(red, green, blue) = theme.colour(stroke.hue);
        content.set_stroke_rgb(part(red), part(green), part(blue));
        content.set_line_width(stroke.width);
        content.set_line_cap(match stroke.cap {
            Cap::Butt => LineCapStyle::ButtCap,
            Cap::Square => LineCapStyle::ProjectingSquareCap,
            Cap::Round => LineCapStyle::RoundCap,
        });
    }
    let hue = look
        .fill()
        .or_else(|| look.lettering().map(|lettering| lettering.hue));
    if let Some(hue) = hue {
        fill(content, theme.colour(hue));
    }
}

fn draw(content: &mut Content, shape: &Shape, fonts: &mut Fonts) {
    match &shape.form {
        Form::Line(from, to) => {
            move_to(content, *from);
            line_to(content, *to);
            content.stroke();
        }
        Form::Path(steps) => {
            let mut here = (0, 0);
            for step in steps {
                here = follow(content, here, *step);
            }
            paint(content, shape.look);
        }
        Form::Rect { at, width, height } => {
            content.rect(at.0 as f32, at.1 as f32, *width as f32, *height as f32);
            paint(content, shape.look);
        }
        Form::Dot(at) => dot(content, *at),
        Form::Text { at, anchor, text, .. } => letters(content, shape.look, *at, *anchor, text, fonts),
    }
}

fn paint(content: &mut Content, look: Look) {
    match look.fill() {
        Some(_) => content.fill_nonzero_and_stroke(),
        None => content.stroke(),
    };
}

fn move_to(content: &mut Content, (x, y): At) {
    content.move_to(x as f32, y as f32);
}

fn line_to(content: &mut Content, (x, y): At) {
    content.line_to(x as f32, y as f32);
}

/// A step of a path from `here`; returns where it leads.
fn follow(content: &mut Content, here: At, step: PathStep) -> At {
    match step {
        PathStep::Move(to) => {
            move_to(content, to);
            to
        }
        PathStep::Line(to) => {
            line_to(content, to);
            to
        }
        PathStep::Bow(by, to) => {
            // A bow with one handle, as one with two.
            let handle = |end: At| {
                let towards = |end: i32, by: i32| end as f32 + 2.0 / 3.0 * (by - end) as f32;
                (towards(end.0, by.0), towards(end.1, by.1))
            };
            let (first, second) = (handle(here), handle(to));
            content.cubic_to(first.0, first.1, second.0, second.1, to.0 as f32, to.1 as f32);
            to
        }
        PathStep::Close => {
            content.close_path();
            here
        }
    }
}

fn dot(content: &mut Content, (x, y): At) {
    let (x, y, r) = (x as f32, y as f32, DOT as f32);
    let h = r * QUARTER;
    content
        .move_to(x + r, y)
        .cubic_to(x + r, y + h, x + h, y + r, x, y + r)
        .cubic_to(x - h, y + r, x - r, y + h, x - r, y)
        .cubic_to(x - r, y - h, x - h, y - r, x, y - r)
        .cubic_to(x + h, y - r, x + r, y - h, x + r, y)
        .fill_nonzero();
}

fn letters(content: &mut Content, look: Look, at: At, anchor: Anchor, text: &str, fonts: &mut Fonts) {
    let Some(lettering) = look.lettering() else {
        return;
    };
    let size = f32::from(lettering.size);
    let (font, set) = fonts.set(lettering.font, text);
    let width = set.width * size;
    let left = match anchor {
        Anchor::Start => at.0 as f32,
        Anchor::Middle => at.0 as f32 - width / 2.0,
        Anchor::End => at.0 as f32 - width,
    };
    if !set.is_exact {
        let mut span = content.begin_marked_content_with_properties(Name(b"Span"));
        span.properties().actual_text(TextStr(text));
    }
    content
        .begin_text()
        .set_font(font, size)
        .set_text_matrix([1.0, 0.0, 0.0, -1.0, left, at.1 as f32])
        .show(Str(&set.glyphs))
        .end_text();
    if !set.is_exact {
        content.end_marked_content();
    }
}
