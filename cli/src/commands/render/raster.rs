//! An SVG document as pixels.
//!
//! Letters come from a font that is built in: a picture looks the same on every machine, also on one without
//! fonts.

use crate::output::SOFTWARE;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb};
use std::sync::Arc;

/// More pixels than this in one direction are refused: they would take gigabytes.
const LARGEST: f32 = 16_384.0;

/// The PNG of a document, with this many pixels for each of its units.
///
/// # Errors
/// The picture would be too large, in words for a person.
pub(super) fn png(svg: &str, scale: f32) -> Result<Vec<u8>, String> {
    let mut fonts = fontdb::Database::new();
    fonts.load_font_data(dejavu::sans_mono::regular().to_vec());
    fonts.load_font_data(dejavu::sans_mono::bold().to_vec());
    fonts.load_font_data(dejavu::sans_mono::oblique().to_vec());
    fonts.set_monospace_family("DejaVu Sans Mono");
    // A scene has the fonts of whoever drew it; which of them are missing here is written in this one.
    fonts.load_font_data(dejavu::sans::regular().to_vec());
    fonts.set_sans_serif_family("DejaVu Sans");
    fonts.set_serif_family("DejaVu Sans");
    let options = Options {
        font_family: "DejaVu Sans Mono".to_owned(),
        fontdb: Arc::new(fonts),
        ..Options::default()
    };
    let tree =
        Tree::from_str(svg, &options).map_err(|error| format!("the picture cannot be drawn: {error}"))?;
    let size = tree.size();
    let (width, height) = (size.width() * scale, size.height() * scale);
    if width.max(height) > LARGEST {
        return Err(format!(
            "the picture would be {width:.0} by {height:.0} pixels; make it smaller with --scale, or write an SVG"
        ));
    }
    let mut pixels = Pixmap::new(width.ceil() as u32, height.ceil() as u32)
        .ok_or_else(|| "the picture is too large; write an SVG".to_owned())?;
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixels.as_mut());
    pixels
        .encode_png()
        .map(signed)
        .map_err(|error| format!("the picture cannot be written as PNG: {error}"))
}

/// This many bytes a PNG begins with: its signature and its header.
const HEAD: usize = 8 + 25;

/// The picture with the name of the program that made it, as PNG has a place for it.
fn signed(mut png: Vec<u8>) -> Vec<u8> {
    let content = SOFTWARE;
    let mut chunk = ((content.len() - 4) as u32).to_be_bytes().to_vec();
    chunk.extend_from_slice(content);
    chunk.extend_from_slice(&crc32fast::hash(content).to_be_bytes());
    if png.len() >= HEAD {
        png.splice(HEAD..HEAD, chunk);
    }
    png
}

#[cfg(test)]
mod tests {
    use super::png;

    #[test]
    fn letters_are_drawn_whatever_their_font() {
        let drawn = |font: &str, text: &str| {
            let svg = format!(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 40 20\"><text y=\"15\" font-family=\"{font}\">{text}</text></svg>"
            );
            png(&svg, 1.0).unwrap()
        };
        for font in ["sans-serif", "serif", "monospace", "Arial", "none of these"] {
            assert_ne!(drawn(font, "stop"), drawn(font, ""), "{font}");
        }
    }
}
