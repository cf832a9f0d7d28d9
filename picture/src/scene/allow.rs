//! What of SVG may be in a scene. All else is left out.

/// The elements.
const ELEMENTS: [&str; 23] = [
    "svg",
    "g",
    "defs",
    "symbol",
    "use",
    "path",
    "rect",
    "circle",
    "ellipse",
    "line",
    "polyline",
    "polygon",
    "text",
    "tspan",
    "title",
    "desc",
    "linearGradient",
    "radialGradient",
    "stop",
    "clipPath",
    "mask",
    "pattern",
    "marker",
];

/// The attributes, whichever element has them.
#[rustfmt::skip]
const ATTRIBUTES: [&str; 103] = [
    // Where and how large.
    "x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "r", "rx", "ry", "dx", "dy", "width", "height", "d", "points",
    "transform", "viewBox", "preserveAspectRatio", "pathLength", "rotate", "textLength", "lengthAdjust",
    // Gradients, patterns, clips and markers.
    "offset", "gradientUnits", "gradientTransform", "spreadMethod", "fx", "fy", "fr", "patternUnits",
    "patternContentUnits", "patternTransform", "clipPathUnits", "maskUnits", "maskContentUnits",
    "markerWidth", "markerHeight", "markerUnits", "refX", "refY", "orient",
    // How it looks.
    "fill", "fill-opacity", "fill-rule", "stroke", "stroke-width", "stroke-opacity", "stroke-dasharray",
    "stroke-dashoffset", "stroke-linecap", "stroke-linejoin", "stroke-miterlimit", "opacity", "color", "display",
    "visibility", "overflow", "font-family", "font-size", "font-style", "font-weight", "font-variant",
    "font-stretch", "letter-spacing", "word-spacing", "text-anchor", "text-decoration", "dominant-baseline",
    "alignment-baseline", "baseline-shift", "writing-mode", "direction", "unicode-bidi", "clip-path",
    "clip-rule", "mask", "marker", "marker-start", "marker-mid", "marker-end", "stop-color", "stop-opacity",
    "vector-effect", "paint-order", "shape-rendering", "text-rendering", "color-interpolation",
    // What refers to it, and what it is for those who do not see it.
    "id", "href", "role", "aria-label", "aria-labelledby", "aria-describedby", "aria-hidden", "lang",
    // Set by us alone.
    "tabindex", "aria-pressed", "aria-checked", "aria-roledescription", "focusable", "xmlns",
];

/// Those that a file cannot give: we do.
const OWN: [&str; 6] = [
    "tabindex",
    "aria-pressed",
    "aria-checked",
    "aria-roledescription",
    "focusable",
    "xmlns",
];

/// What editors write and nobody misses.
const SILENT: [&str; 12] = [
    "version",
    "baseProfile",
    "class",
    "style",
    "space",
    "enable-background",
    "tabindex",
    "focusable",
    "zoomAndPan",
    "contentScriptType",
    "contentStyleType",
    "type",
];

/// What a part of a drawing may be for those who do not see it.
const ROLES: [&str; 8] = [
    "alert",
    "status",
    "img",
    "group",
    "presentation",
    "none",
    "meter",
    "graphics-symbol",
];

/// Properties that only shape a picture, which CSS has as attributes.
pub(super) fn is_property(name: &str) -> bool {
    let first = ATTRIBUTES.iter().position(|known| *known == "fill");
    let last = ATTRIBUTES
        .iter()
        .position(|known| *known == "color-interpolation");
    let at = ATTRIBUTES.iter().position(|known| *known == name);
    matches!((first, last, at), (Some(first), Some(last), Some(at)) if (first..=last).contains(&at))
}

/// The name of an element that may be there.
pub(super) fn element(name: &str) -> Option<&'static str> {
    ELEMENTS.into_iter().find(|known| *known == name)
}

/// Why an attribute is not taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Refused {
    /// Nobody misses it.
    Silently,
    /// It would run something.
    Script,
    /// It leads out of the file.
    Reference,
    /// A function of CSS that may load something, or hides what it is.
    Value,
    /// Not known.
    Unknown,
}

impl Refused {
    /// In words, of an attribute.
    pub(super) fn help(self) -> &'static str {
        match self {
            Refused::Script => {
                "a scene runs nothing: take the attribute out, and bind with l:press, l:toggle or l:set"
            }
            Refused::Reference => "a scene refers only to what is in its own file, as in #arrow",
            Refused::Value => "write a plain value: a colour, a number, url(#name), or a transformation",
            Refused::Silently | Refused::Unknown => "the picture is drawn without it",
        }
    }
}

/// The name of an attribute with its value, if it may be there.
pub(super) fn attribute(name: &str, value: &str) -> Result<&'static str, Refused> {
    if name
        .get(..2)
        .is_some_and(|begin| begin.eq_ignore_ascii_case("on"))
    {
        return Err(Refused::Script);
    }
    if name.starts_with("data-") || SILENT.contains(&name) || OWN.contains(&name) {
        return Err(Refused::Silently);
    }
    let known = ATTRIBUTES.into_iter().find(|known| *known == name);
    let known = known.ok_or(match name {
        "src" | "base" | "cursor" | "filter" => Refused::Reference,
        _ => Refused::Unknown,
    })?;
    match known {
        "href" if local(value).is_none() => Err(Refused::Reference),
        "id" | "href" | "aria-label" | "aria-labelledby" | "aria-describedby" => Ok(known),
        "role" if !ROLES.contains(&value.trim()) => Err(Refused::Unknown),
        _ => plain(value).map(|()| known),
    }
}

/// The name that a reference within the file is to.
pub(super) fn local(value: &str) -> Option<&str> {
    let name = value.trim().strip_prefix('#')?;
    let is_part = |c: char| c.is_alphanumeric() || matches!(c, '_' | '-' | '.' | ':');
    (!name.is_empty() && name.chars().all(is_part)).then_some(name)
}

/// The names that a value refers to with `url(#name)`.
pub(super) fn urls(value: &str) -> impl Iterator<Item = &str> {
    let parts = value
        .match_indices("url(")
        .map(|(at, found)| &value[at + found.len()..]);
    parts.filter_map(|rest| local(unquoted(&rest[..rest.find(')')?])))
}

fn unquoted(text: &str) -> &str {
    text.trim().trim_matches(['"', '\''])
}

/// The functions that a value may call.
const FUNCTIONS: [&str; 12] = [
    "url",
    "rgb",
    "rgba",
    "hsl",
    "hsla",
    "matrix",
    "translate",
    "scale",
    "rotate",
    "skewX",
    "skewY",
    "var",
];

/// Whether a value of a property loads nothing. It is read by a parser of CSS: what that would read otherwise than we do, as escapes
/// and comments, is refused.
pub(super) fn plain(value: &str) -> Result<(), Refused> {
    if value.contains(['\\', '@', '{', '}', ';', '<']) || value.contains("/*") {
        return Err(Refused::Value);
    }
    for (at, _) in value.match_indices('(') {
        let before = value[..at].trim_end();
        let start = before
            .rfind(|c: char| !(c.is_ascii_alphanumeric() || matches!(c, '-' | '_')))
            .map_or(0, |end| {
                end + before[end..].chars().next().map_or(1, char::len_utf8)
            });
        let function = &before[start..];
        let is_local = || {
            let rest = &value[at + 1..];
            rest.find(')')
                .is_some_and(|end| local(unquoted(&rest[..end])).is_some())
        };
        let is_theme = || value[at + 1..].trim_start().starts_with("--ladder-");
        match function {
            "url" if !is_local() => return Err(Refused::Reference),
            "var" if !is_theme() => return Err(Refused::Value),
            // The rest is as in CSS, where case does not count.
            _ if FUNCTIONS.contains(&function) => {}
            _ => return Err(Refused::Value),
        }
    }
    Ok(())
}

/// What is drawn by itself.
const DRAWN: [&str; 11] = [
    "g", "use", "path", "rect", "circle", "ellipse", "line", "polyline", "polygon", "text", "svg",
];

/// Whether a group can be around an element of this name in one of that.
/// Whether a group can be put around an element of this name in one of that: it moves, hides and dims it, and leaves what the drawing says of it alone.
pub(super) fn can_be_wrapped(name: &str, parent: Option<&str>) -> bool {
    let takes_groups = |parent: &str| {
        matches!(
            parent,
            "svg" | "g" | "defs" | "symbol" | "mask" | "pattern" | "marker"
        )
    };
    DRAWN.contains(&name) && parent.is_some_and(takes_groups)
}
