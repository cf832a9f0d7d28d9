//! Styles, as attributes: a page that shows a scene allows no style sheet in it, and needs none.
//!
//! `style="fill:#888"` becomes `fill="#888"`, and so do the rules of a `style` element, if what they are for is a class, an id
//! or an element alone, as drawing programs write it.

use super::allow;
use std::collections::{HashMap, HashSet};

/// Larger sheets, in bytes, are not those of a drawing program.
const MOST_BYTES: usize = 64 * 1024;

/// What style sheets say, by what it is for: a scene has many elements, and a sheet many rules.
#[derive(Debug, Default)]
pub(super) struct Sheet {
    /// In the order of the sheets.
    declarations: Vec<String>,
    /// For each selector its declarations.
    of: HashMap<String, Vec<usize>>,
    /// How long the sheets are, in bytes.
    bytes: usize,
}

impl Sheet {
    /// Takes the rules of a style sheet.
    ///
    /// # Errors
    /// It loads something, is not as simple as that, or is too large. Nothing of it is taken then.
    pub(super) fn add(&mut self, sheet: &str) -> Result<(), &'static str> {
        self.bytes = self.bytes.saturating_add(sheet.len());
        if self.bytes > MOST_BYTES {
            return Err("a scene has at most 64 KiB of style sheets: write the colours as attributes");
        }
        for (selector, declarations) in rules(sheet)? {
            self.of.entry(selector).or_default().push(self.declarations.len());
            self.declarations.push(declarations);
        }
        Ok(())
    }

    /// The declarations for an element: those of the sheet, those of classes and ids after them, its own last.
    pub(super) fn declarations<'r>(
        &'r self,
        (element, class, id): (&str, &str, &str),
        own: &'r str,
    ) -> Vec<(&'r str, &'r str)> {
        let of = |selector: &str| self.of.get(selector).map_or(&[][..], Vec::as_slice);
        let classes: HashSet<&str> = class.split_whitespace().collect();
        let classes = classes.iter().flat_map(|class| of(&format!(".{class}")));
        let mut of_classes: Vec<usize> = classes.copied().collect();
        of_classes.sort_unstable();
        let id = format!("#{id}");
        let all = of(element).iter().chain(&of_classes).chain(of(&id));
        let sheet = all.flat_map(|at| pairs(&self.declarations[*at]));
        sheet.chain(pairs(own)).collect()
    }
}

/// The rules of a style sheet: selectors, each with its declarations.
fn rules(sheet: &str) -> Result<Vec<(String, String)>, &'static str> {
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
            rules.push((selector.to_owned(), declarations.to_owned()));
        }
    }
    Ok(rules)
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
