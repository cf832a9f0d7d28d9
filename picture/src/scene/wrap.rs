//! Where a group can be put around an element, which moves, hides and dims it and leaves what the drawing says of it alone.

/// What is drawn by itself.
const DRAWN: [&str; 11] = [
    "g", "use", "path", "rect", "circle", "ellipse", "line", "polyline", "polygon", "text", "svg",
];

/// Whether a group can be around an element of this name in one of that.
pub(super) fn can_be_wrapped(name: &str, parent: Option<&str>) -> bool {
    let takes_groups = |parent: &str| {
        matches!(
            parent,
            "svg" | "g" | "defs" | "symbol" | "mask" | "pattern" | "marker"
        )
    };
    DRAWN.contains(&name) && parent.is_some_and(takes_groups)
}
