//! Pages as a PDF document.
//!
//! The letters are embedded, as far as they are used, so that every printer has them and text can be searched and
//! copied. Nothing in the document depends on the day or the machine: the same program gives the same bytes.

mod content;
mod font;

use content::content;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use font::Fonts;
use ladder_picture::sheet::Sheet;
use ladder_picture::style::Theme;
use pdf_writer::{Filter, Finish, Pdf, Rect, Ref, TextStr};
use std::io::Write;

/// A document, and the letters that the built-in fonts do not have.
pub(super) struct Document {
    pub(super) bytes: Vec<u8>,
    pub(super) missing: Vec<char>,
}

/// Writes the pages.
///
/// # Errors
/// The fonts cannot be read, in words for a person.
pub(super) fn document(sheets: &[Sheet], title: &str, theme: Theme) -> Result<Document, String> {
    let mut fonts = Fonts::new()?;
    let mut numbers = (1..).map(Ref::new);
    let mut next = || numbers.next().unwrap_or(Ref::new(i32::MAX));
    let (catalog, tree, info) = (next(), next(), next());
    let mut pdf = Pdf::new();
    pdf.catalog(catalog).pages(tree);
    pdf.document_info(info)
        .title(TextStr(title))
        .producer(TextStr("ladder"));
    let font_refs = fonts.each().map(|_| next());
    let mut pages = Vec::with_capacity(sheets.len());
    for sheet in sheets {
        let (page, stream) = (next(), next());
        pages.push(page);
        let drawn = compressed(&content(sheet, theme, &mut fonts));
        pdf.stream(stream, &drawn).filter(Filter::FlateDecode);
        let mut page = pdf.page(page);
        page.parent(tree)
            .media_box(Rect::new(0.0, 0.0, sheet.width, sheet.height))
            .contents(stream);
        let mut resources = page.resources();
        let mut names = resources.fonts();
        for (font, id) in fonts.each().into_iter().zip(font_refs) {
            names.pair(font.name(), id);
        }
        names.finish();
        resources.finish();
    }
    let count = i32::try_from(pages.len()).unwrap_or(i32::MAX);
    pdf.pages(tree).kids(pages).count(count);
    for (font, id) in fonts.each().into_iter().zip(font_refs) {
        font.write(&mut pdf, id, &mut next)?;
    }
    Ok(Document {
        bytes: pdf.finish(),
        missing: fonts.missing(),
    })
}

fn compressed(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
    // Writing to a Vec does not fail.
    let _ = encoder.write_all(bytes);
    encoder.finish().unwrap_or_default()
}
