//! Colours that a binding may name.

use super::allow::local;

/// The colours that follow the theme of the page, with what they are on paper.
pub const THEME: [(&str, &str); 4] = [
    ("--ladder-on", "#1a8f3c"),
    ("--ladder-off", "#8a8a8a"),
    ("--ladder-warning", "#c77700"),
    ("--ladder-alarm", "#c62828"),
];

/// The same as they are written in a binding.
pub const THEME_VALUES: [&str; 4] = [
    "var(--ladder-on)",
    "var(--ladder-off)",
    "var(--ladder-warning)",
    "var(--ladder-alarm)",
];

/// The names of CSS.
#[rustfmt::skip]
const NAMES: &str = " aliceblue antiquewhite aqua aquamarine azure beige bisque black blanchedalmond blue blueviolet brown \
burlywood cadetblue chartreuse chocolate coral cornflowerblue cornsilk crimson cyan darkblue darkcyan darkgoldenrod darkgray \
darkgreen darkgrey darkkhaki darkmagenta darkolivegreen darkorange darkorchid darkred darksalmon darkseagreen darkslateblue \
darkslategray darkslategrey darkturquoise darkviolet deeppink deepskyblue dimgray dimgrey dodgerblue firebrick floralwhite \
forestgreen fuchsia gainsboro ghostwhite gold goldenrod gray green greenyellow grey honeydew hotpink indianred indigo ivory \
khaki lavender lavenderblush lawngreen lemonchiffon lightblue lightcoral lightcyan lightgoldenrodyellow lightgray lightgreen \
lightgrey lightpink lightsalmon lightseagreen lightskyblue lightslategray lightslategrey lightsteelblue lightyellow lime \
limegreen linen magenta maroon mediumaquamarine mediumblue mediumorchid mediumpurple mediumseagreen mediumslateblue \
mediumspringgreen mediumturquoise mediumvioletred midnightblue mintcream mistyrose moccasin navajowhite navy oldlace olive \
olivedrab orange orangered orchid palegoldenrod palegreen paleturquoise palevioletred papayawhip peachpuff peru pink plum \
powderblue purple rebeccapurple red rosybrown royalblue saddlebrown salmon sandybrown seagreen seashell sienna silver skyblue \
slateblue slategray slategrey snow springgreen steelblue tan teal thistle tomato transparent turquoise violet wheat white \
whitesmoke yellow yellowgreen none currentcolor ";

/// Whether a text is a colour: a name, `#rgb`, `#rrggbb` with or without opacity, one of the theme, or a gradient of the file.
pub(super) fn is_colour(text: &str) -> bool {
    if let Some(digits) = text.strip_prefix('#') {
        return matches!(digits.len(), 3 | 4 | 6 | 8) && digits.chars().all(|c| c.is_ascii_hexdigit());
    }
    if let Some(name) = inside(text, "var(") {
        return THEME.iter().any(|(known, _)| *known == name.trim());
    }
    if let Some(name) = inside(text, "url(") {
        return local(name).is_some();
    }
    let is_word = !text.is_empty() && text.chars().all(|c| c.is_ascii_alphabetic());
    is_word && NAMES.contains(&format!(" {} ", text.to_ascii_lowercase()))
}

fn inside<'t>(text: &'t str, function: &str) -> Option<&'t str> {
    text.strip_prefix(function)?.strip_suffix(')')
}

/// A value with the colours of the theme as they are on paper.
pub(super) fn on_paper(value: &str) -> String {
    let mut paper = value.to_owned();
    for (name, colour) in THEME {
        paper = paper.replace(&format!("var({name})"), colour);
    }
    paper
}
