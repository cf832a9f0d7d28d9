//! The built-in fonts, as far as a document uses them.

use super::compressed;
use ladder_picture::style;
use pdf_writer::types::{CidFontType, FontFlags, SystemInfo, UnicodeCmap};
use pdf_writer::{Filter, Name, Pdf, Rect, Ref, Str};
use skrifa::instance::{LocationRef, Size};
use skrifa::{FontRef, MetadataProvider};
use std::collections::{BTreeMap, BTreeSet};
use subsetter::GlyphRemapper;

/// What stands for a letter that a font does not have.
const NO_LETTER: char = '\u{fffd}';
/// How a font numbers its letters in the document: as they are in it.
const IDENTITY: SystemInfo<'static> = SystemInfo {
    registry: Str(b"Adobe"),
    ordering: Str(b"Identity"),
    supplement: 0,
};

/// The fonts of a document.
pub(super) struct Fonts {
    fonts: [Font; 3],
    missing: BTreeSet<char>,
}

/// One font and the letters that are used of it.
pub(super) struct Font {
    name: &'static str,
    data: &'static [u8],
    face: FontRef<'static>,
    /// The width of every letter, in its size.
    advance: f32,
    glyphs: GlyphRemapper,
    /// What each glyph of the document stands for.
    letters: BTreeMap<u16, char>,
}

/// A text in the letters of a font.
pub(super) struct Set {
    /// The glyphs, two bytes each.
    pub(super) glyphs: Vec<u8>,
    /// Its width, in the size of its letters.
    pub(super) width: f32,
    /// Every glyph stands for its own letter, so that the text can be read back.
    pub(super) is_exact: bool,
}

impl Fonts {
    pub(super) fn new() -> Result<Fonts, String> {
        Ok(Fonts {
            fonts: [
                Font::new("F0", dejavu::sans_mono::regular())?,
                Font::new("F1", dejavu::sans_mono::bold())?,
                Font::new("F2", dejavu::sans_mono::oblique())?,
            ],
            missing: BTreeSet::new(),
        })
    }

    pub(super) fn each(&self) -> [&Font; 3] {
        self.fonts.each_ref()
    }

    /// The letters that were asked for and are in none of them.
    pub(super) fn missing(&self) -> Vec<char> {
        self.missing.iter().copied().collect()
    }

    /// A text in a style, and the name of the font that it is set in.
    pub(super) fn set(&mut self, style: style::Font, text: &str) -> (Name<'static>, Set) {
        let font = match style {
            style::Font::Regular => &mut self.fonts[0],
            style::Font::Bold => &mut self.fonts[1],
            style::Font::Italic => &mut self.fonts[2],
        };
        (font.name(), font.set(text, &mut self.missing))
    }
}

impl Font {
    fn new(name: &'static str, data: &'static [u8]) -> Result<Font, String> {
        let font = FontRef::new(data).map_err(|error| format!("a built-in font cannot be read: {error}"))?;
        let glyph = font.charmap().map('0').unwrap_or_default();
        // In the font's own units: any size would be rounded to whole pixels.
        let advance = font
            .glyph_metrics(Size::unscaled(), LocationRef::default())
            .advance_width(glyph);
        let units = font
            .metrics(Size::unscaled(), LocationRef::default())
            .units_per_em;
        Ok(Font {
            name,
            data,
            advance: advance.map_or(0.6, |advance| advance / f32::from(units.max(1))),
            face: font,
            glyphs: GlyphRemapper::new(),
            letters: BTreeMap::new(),
        })
    }

    pub(super) fn name(&self) -> Name<'static> {
        Name(self.name.as_bytes())
    }

    fn set(&mut self, text: &str, missing: &mut BTreeSet<char>) -> Set {
        let mut set = Set {
            glyphs: Vec::with_capacity(2 * text.len()),
            width: 0.0,
            is_exact: true,
        };
        let map = self.face.charmap();
        for letter in text.chars() {
            let found = map.map(letter).filter(|glyph| glyph.to_u32() != 0);
            if found.is_none() {
                missing.insert(letter);
            }
            let (glyph, stands_for) = match found {
                Some(glyph) => (glyph, letter),
                None => (map.map(NO_LETTER).unwrap_or_default(), NO_LETTER),
            };
            let glyph = self.glyphs.remap(glyph.to_u32() as u16);
            let first = *self.letters.entry(glyph).or_insert(stands_for);
            set.is_exact &= first == letter;
            set.glyphs.extend(glyph.to_be_bytes());
            set.width += self.advance;
        }
        set
    }

    /// Puts the font into the document, with the letters that are used.
    pub(super) fn write(&self, pdf: &mut Pdf, id: Ref, next: &mut impl FnMut() -> Ref) -> Result<(), String> {
        let (cid, descriptor, file, cmap) = (next(), next(), next(), next());
        let subset = subsetter::subset(self.data, 0, &self.glyphs)
            .map_err(|error| format!("a built-in font cannot be taken apart: {error}"))?;
        let metrics = self.face.metrics(Size::new(1000.0), LocationRef::default());
        let bounds = metrics.bounds.unwrap_or_default();
        let base = format!("LADDER+DejaVuSansMono-{}", self.name);
        let base = Name(base.as_bytes());
        let advance = self.advance * 1000.0;
        pdf.type0_font(id)
            .base_font(base)
            .encoding_predefined(Name(b"Identity-H"))
            .descendant_font(cid)
            .to_unicode(cmap);
        pdf.cid_font(cid)
            .subtype(CidFontType::Type2)
            .base_font(base)
            .system_info(IDENTITY)
            .font_descriptor(descriptor)
            // Readers take only whole numbers here; the widths themselves may be any.
            .default_width(advance.round())
            .cid_to_gid_map_predefined(Name(b"Identity"))
            .widths()
            .same(0, self.glyphs.num_gids().saturating_sub(1), advance);
        let mut flags = FontFlags::SYMBOLIC | FontFlags::FIXED_PITCH;
        if metrics.italic_angle != 0.0 {
            flags |= FontFlags::ITALIC;
        }
        pdf.font_descriptor(descriptor)
            .name(base)
            .flags(flags)
            .bbox(Rect::new(bounds.x_min, bounds.y_min, bounds.x_max, bounds.y_max))
            .italic_angle(metrics.italic_angle)
            .ascent(metrics.ascent)
            .descent(metrics.descent)
            .cap_height(metrics.cap_height.unwrap_or(metrics.ascent))
            .stem_v(90.0)
            .font_file2(file);
        let length = i32::try_from(subset.len()).unwrap_or(i32::MAX);
        pdf.stream(file, &compressed(&subset))
            .filter(Filter::FlateDecode)
            .pair(Name(b"Length1"), length);
        let mut letters: UnicodeCmap = UnicodeCmap::new(Name(b"Custom"), IDENTITY);
        for (&glyph, &letter) in &self.letters {
            letters.pair(glyph, letter);
        }
        let letters = letters.finish();
        pdf.cmap(cmap, letters.as_slice())
            .name(Name(b"Custom"))
            .system_info(IDENTITY);
        Ok(())
    }
}
