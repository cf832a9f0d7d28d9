//! Colours, sizes and the style sheet.

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

struct Colours {
    paper: &'static str,
    ink: &'static str,
    /// Lines without power, beside live ones.
    faint: &'static str,
    live: &'static str,
    comment: &'static str,
    value: &'static str,
    box_: &'static str,
}

// Live and dead lines differ in weight as well: nobody has to tell colours apart.
const LIGHT: Colours = Colours {
    paper: "#ffffff",
    ink: "#1f2328",
    faint: "#8b949e",
    live: "#0a7d33",
    comment: "#57606a",
    value: "#0550ae",
    box_: "#f6f8fa",
};

const DARK: Colours = Colours {
    paper: "#0d1117",
    ink: "#e6edf3",
    faint: "#6e7681",
    live: "#4ade80",
    comment: "#9da7b3",
    value: "#79c0ff",
    box_: "#161b22",
};

/// The style sheet of a picture.
pub(super) fn sheet(theme: Theme) -> String {
    match theme {
        Theme::Light => rules(&LIGHT),
        Theme::Dark => rules(&DARK),
        Theme::Auto => format!(
            "{}@media (prefers-color-scheme: dark) {{\n{}}}\n",
            rules(&LIGHT),
            rules(&DARK)
        ),
    }
}

fn rules(colours: &Colours) -> String {
    let Colours {
        paper,
        ink,
        faint,
        live,
        comment,
        value,
        box_,
    } = colours;
    format!(
        "\
.paper {{ fill: {paper}; }}
.line {{ stroke: {ink}; stroke-width: 1.5; stroke-linecap: square; fill: none; }}
.dead {{ stroke: {faint}; stroke-width: 1.5; stroke-linecap: square; fill: none; }}
.live {{ stroke: {live}; stroke-width: 3.5; stroke-linecap: round; fill: none; }}
.rail {{ stroke: {ink}; stroke-width: 3; fill: none; }}
.box {{ stroke: {ink}; stroke-width: 1.5; fill: {box_}; }}
.dot {{ fill: {ink}; }}
.dot-dead {{ fill: {faint}; }}
.dot-live {{ fill: {live}; }}
text {{ font-family: 'DejaVu Sans Mono', ui-monospace, Menlo, Consolas, monospace; font-size: 13px; fill: {ink}; white-space: pre; }}
.name {{ font-weight: bold; }}
.pin {{ font-size: 11px; fill: {comment}; }}
.comment {{ font-style: italic; fill: {comment}; }}
.value {{ fill: {value}; }}
"
    )
}
