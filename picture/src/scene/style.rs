//! Styles, as attributes: a page that shows a scene allows no style sheet in it, and needs none.
//!
//! `style="fill:#888"` becomes `fill="#888"`, and so do the rules of a `style` element, if what they are for is a class, an id
//! or an element alone, as drawing programs write it.

use super::allow;

/// A rule of a style sheet.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Rule {
    selector: String,
    declarations: String,
}

/// The rules of a style sheet.
///
/// # Errors
/// It loads something, or is not as simple as that.
pub(super) fn rules(sheet: &str) -> Result<Vec<Rule>, &'static str> {
    let mut text = String::new();
    let mut rest = sheet;
    while let Some((before, after)) = rest.split_once("/*") {
        text.push_str(before);
        rest = after.split_once("*/").map_or("", |(_, after)| after);
    }
    text.push_str(rest);
    if text.contains('@') || text.contains('\\') {
        return Err("a scene loads nothing, and has no @ rules: write the colours as attributes");
    }
    let mut rules = Vec::new();
    for rule in text.split('}') {
        let Some((selectors, declarations)) = rule.split_once('{') else {
            if rule.trim().is_empty() {
                continue;
            }
            return Err("the style sheet is not read: write the colours as attributes");
        };
        for selector in selectors.split(',').map(str::trim) {
            let name = selector.trim_start_matches(['.', '#']);
            let is_simple = !name.is_empty()
                && selector.len() - name.len() <= 1
                && name
                    .chars()
                    .all(|c| c.is_alphanumeric() || matches!(c, '_' | '-'));
            if !is_simple {
                return Err(
                    "only rules for one class, one id or one element are read, as in .lamp { fill: red }",
                );
            }
            rules.push(Rule {
                selector: selector.to_owned(),
                declarations: declarations.to_owned(),
            });
        }
    }
    Ok(rules)
}

/// The declarations for an element: those of the sheet, those of classes and ids after them, its own last.
pub(super) fn declarations<'r>(
    rules: &'r [Rule],
    (element, class, id): (&str, &str, &str),
    own: &'r str,
) -> Vec<(&'r str, &'r str)> {
    let mut found = Vec::new();
    let for_element = |rule: &&Rule| rule.selector == element;
    let for_class = |rule: &&Rule| {
        let name = rule.selector.strip_prefix('.');
        name.is_some_and(|name| class.split_whitespace().any(|it| it == name))
    };
    let for_id = |rule: &&Rule| rule.selector.strip_prefix('#') == Some(id);
    for rule in rules.iter().filter(for_element) {
        found.extend(pairs(&rule.declarations));
    }
    for rule in rules.iter().filter(for_class) {
        found.extend(pairs(&rule.declarations));
    }
    for rule in rules.iter().filter(for_id) {
        found.extend(pairs(&rule.declarations));
    }
    found.extend(pairs(own));
    found
}

/// The properties that are attributes too; others do not matter to a drawing.
fn pairs(declarations: &str) -> impl Iterator<Item = (&str, &str)> {
    let split = declarations.split(';').filter_map(|it| it.split_once(':'));
    let split = split.map(|(name, value)| {
        (
            name.trim(),
            value.trim().trim_end_matches("!important").trim_end(),
        )
    });
    split.filter(|(name, _)| allow::is_property(name) || matches!(*name, "filter" | "cursor"))
}
