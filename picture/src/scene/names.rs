//! The names of a scene's elements, and what refers to them.

/// What the names of a scene's elements begin with, so that they are none of the page's.
const OWN: &str = "scene-";

/// A text on one line.
pub(super) fn one_line(text: &str) -> String {
    text.replace(['\n', '\r', '\t'], " ")
}

/// A value whose names of elements are those of the scene's own.
pub(super) fn own_names(attribute: &str, value: &str) -> String {
    match attribute {
        "id" => format!("{OWN}{}", value.trim()),
        "href" => value.trim().replacen('#', &format!("#{OWN}"), 1),
        "aria-labelledby" | "aria-describedby" => {
            let names = value.split_whitespace().map(|name| format!("{OWN}{name}"));
            names.collect::<Vec<_>>().join(" ")
        }
        _ if value.contains("url(") => {
            let mut out = String::new();
            let mut rest = value;
            while let Some((before, after)) = rest.split_once("url(") {
                let (name, after) = after.split_once(')').unwrap_or((after, ""));
                let name = name.trim().trim_matches(['"', '\'']).trim_start_matches('#');
                out.push_str(&format!("{before}url(#{OWN}{name})"));
                rest = after;
            }
            out + rest
        }
        _ => one_line(value),
    }
}
