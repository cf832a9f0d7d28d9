//! Colours, sizes, and what each thing drawn looks like: one table for every kind of document.

use std::fmt;

/// The colours of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Theme {
    /// As the reader's screen has it; light where that is not known.
    #[default]
    Auto,
    /// Dark lines on white.
    Light,
    /// Light lines on black.
    Dark,
}

/// The width of a letter, and so of a column, in pixels.
pub(super) const UNIT: i32 = 8;
/// Blank border around everything.
pub(super) const MARGIN: i32 = 16;
/// Height of a line of text.
pub(super) const LINE: i32 = 17;
/// Half the height of contacts and coils.
pub(super) const HALF: i32 = 10;
/// The radius of a dot where wires meet.
pub const DOT: i32 = 3;

/// What a shape looks like. Lines with and without power differ in weight as well as in colour: nobody has to see
/// colours, and a printer needs none.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Look {
    /// A line of a symbol, and every wire of a program at rest.
    Line,
    /// A wire without power.
    Dead,
    /// A wire with power.
    Live,
    /// A rail.
    Rail,
    /// A fine line between the rows of a table.
    Rule,
    /// A box of an instruction.
    Box,
    /// Where wires meet, in a program at rest.
    Dot,
    /// The same without power.
    DotDead,
    /// The same with power.
    DotLive,
    /// A tag or another operand.
    Text,
    /// The name of an instruction, a heading.
    Name,
    /// The name of an operand.
    Pin,
    /// A comment.
    Comment,
    /// The value that a tag has.
    Value,
    /// The gap of a contact or the inside of a coil: in a live drawing it is filled or not.
    Gate,
}

/// A colour by its purpose.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Hue {
    /// What is drawn on.
    Paper,
    /// Lines and text.
    Ink,
    /// Lines without power, next to live ones.
    Faint,
    /// Lines with power.
    Live,
    /// Comments and names of operands.
    Comment,
    /// Values.
    Value,
    /// The inside of boxes.
    Inside,
}

/// Red, green, blue.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Colour(pub u8, pub u8, pub u8);

impl fmt::Display for Colour {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Colour(red, green, blue) = self;
        write!(f, "#{red:02x}{green:02x}{blue:02x}")
    }
}

/// How a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stroke {
    /// Its colour.
    pub hue: Hue,
    /// Its width, in pixels.
    pub width: f32,
    /// How it ends.
    pub cap: Cap,
}

/// How a line ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cap {
    /// At its point.
    Butt,
    /// Half its width after its point.
    Square,
    /// The same, round.
    Round,
}

/// How text is set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Lettering {
    /// Its colour.
    pub hue: Hue,
    /// Its size, in pixels.
    pub size: u8,
    /// Its style.
    pub font: Font,
}

/// The styles of the letters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Font {
    /// Upright.
    Regular,
    /// Heavy.
    Bold,
    /// Slanted.
    Italic,
}

impl Look {
    /// Those of a picture.
    const ALL: [Look; 13] = [
        Look::Line,
        Look::Dead,
        Look::Live,
        Look::Rail,
        Look::Box,
        Look::Dot,
        Look::DotDead,
        Look::DotLive,
        Look::Text,
        Look::Name,
        Look::Pin,
        Look::Comment,
        Look::Value,
    ];

    /// Its name in a style sheet.
    pub const fn class(self) -> &'static str {
        match self {
            Look::Line => "line",
            Look::Dead => "dead",
            Look::Live => "live",
            Look::Rail => "rail",
            Look::Rule => "rule",
            Look::Box => "box",
            Look::Dot => "dot",
            Look::DotDead => "dot-dead",
            Look::DotLive => "dot-live",
            Look::Text => "text",
            Look::Name => "name",
            Look::Pin => "pin",
            Look::Comment => "comment",
            Look::Value => "value",
            Look::Gate => "gate",
        }
    }

    /// Its line, if it has one.
    pub const fn stroke(self) -> Option<Stroke> {
        let (hue, width, cap) = match self {
            Look::Line => (Hue::Ink, 1.5, Cap::Square),
            Look::Dead => (Hue::Faint, 1.5, Cap::Square),
            Look::Live => (Hue::Live, 3.5, Cap::Round),
            Look::Rail => (Hue::Ink, 3.0, Cap::Butt),
            Look::Rule => (Hue::Faint, 0.75, Cap::Butt),
            Look::Box => (Hue::Ink, 1.5, Cap::Butt),
            _ => return None,
        };
        Some(Stroke { hue, width, cap })
    }

    /// The colour that fills it, if one does.
    pub const fn fill(self) -> Option<Hue> {
        match self {
            Look::Box => Some(Hue::Inside),
            Look::Dot => Some(Hue::Ink),
            Look::DotDead => Some(Hue::Faint),
            Look::DotLive => Some(Hue::Live),
            _ => None,
        }
    }

    /// Its letters, if it is text.
    pub const fn lettering(self) -> Option<Lettering> {
        let (hue, size, font) = match self {
            Look::Text => (Hue::Ink, 13, Font::Regular),
            Look::Name => (Hue::Ink, 13, Font::Bold),
            Look::Pin => (Hue::Comment, 11, Font::Regular),
            Look::Comment => (Hue::Comment, 13, Font::Italic),
            Look::Value => (Hue::Value, 13, Font::Regular),
            _ => return None,
        };
        Some(Lettering { hue, size, font })
    }
}

impl Theme {
    /// The colour for a purpose, where the reader's screen has no say in it.
    pub const fn colour(self, hue: Hue) -> Colour {
        match self {
            Theme::Auto | Theme::Light => match hue {
                Hue::Paper => Colour(0xff, 0xff, 0xff),
                Hue::Ink => Colour(0x1f, 0x23, 0x28),
                Hue::Faint => Colour(0x8b, 0x94, 0x9e),
                Hue::Live => Colour(0x0a, 0x7d, 0x33),
                Hue::Comment => Colour(0x57, 0x60, 0x6a),
                Hue::Value => Colour(0x05, 0x50, 0xae),
                Hue::Inside => Colour(0xf6, 0xf8, 0xfa),
            },
            Theme::Dark => match hue {
                Hue::Paper => Colour(0x0d, 0x11, 0x17),
                Hue::Ink => Colour(0xe6, 0xed, 0xf3),
                Hue::Faint => Colour(0x6e, 0x76, 0x81),
                Hue::Live => Colour(0x4a, 0xde, 0x80),
                Hue::Comment => Colour(0x9d, 0xa7, 0xb3),
                Hue::Value => Colour(0x79, 0xc0, 0xff),
                Hue::Inside => Colour(0x16, 0x1b, 0x22),
            },
        }
    }
}

/// The style sheet of a picture.
pub(super) fn sheet(theme: Theme) -> String {
    match theme {
        Theme::Light | Theme::Dark => rules(theme),
        Theme::Auto => format!(
            "{}@media (prefers-color-scheme: dark) {{\n{}}}\n",
            rules(Theme::Light),
            rules(Theme::Dark)
        ),
    }
}

/// The letters that a document asks for. What is drawn without a reader's own fonts has the first.
const FAMILY: &str = "'DejaVu Sans Mono', ui-monospace, Menlo, Consolas, monospace";

fn rules(theme: Theme) -> String {
    let mut out = format!(".paper {{ fill: {}; }}\n", theme.colour(Hue::Paper));
    for look in Look::ALL {
        if let Some(lettering) = look.lettering() {
            out.push_str(&text_rule(look, lettering, theme));
            continue;
        }
        out.push_str(&format!(".{} {{", look.class()));
        if let Some(Stroke { hue, width, cap }) = look.stroke() {
            out.push_str(&format!(" stroke: {}; stroke-width: {width};", theme.colour(hue)));
            match cap {
                Cap::Butt => {}
                Cap::Square => out.push_str(" stroke-linecap: square;"),
                Cap::Round => out.push_str(" stroke-linecap: round;"),
            }
        }
        match look.fill() {
            Some(hue) => out.push_str(&format!(" fill: {}; }}\n", theme.colour(hue))),
            None => out.push_str(" fill: none; }\n"),
        }
    }
    out
}

/// Plain text is the rule of every text; the others say where they differ from it.
fn text_rule(look: Look, lettering: Lettering, theme: Theme) -> String {
    let Lettering { hue, size, font } = lettering;
    let colour = theme.colour(hue);
    if look == Look::Text {
        return format!(
            "text {{ font-family: {FAMILY}; font-size: {size}px; fill: {colour}; white-space: pre; }}\n"
        );
    }
    let mut rule = format!(".{} {{", look.class());
    match font {
        Font::Regular => {}
        Font::Bold => rule.push_str(" font-weight: bold;"),
        Font::Italic => rule.push_str(" font-style: italic;"),
    }
    if size != 13 {
        rule.push_str(&format!(" font-size: {size}px;"));
    }
    if hue != Hue::Ink {
        rule.push_str(&format!(" fill: {colour};"));
    }
    rule + " }\n"
}
