//! The pages of the rules, as the book has them: they are part of the programs, so that they are there without a network.

use ladder_analysis::Rule;

include!(concat!(env!("OUT_DIR"), "/rule_pages.rs"));

/// The page of a rule, in Markdown. Its links are to the pages next to it in the book.
pub fn rule_page(rule: Rule) -> &'static str {
    let found = RULE_PAGES.iter().find(|(name, _)| *name == rule.name());
    found.map_or(rule.name(), |(_, page)| *page)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_rule_has_its_page() {
        for rule in ladder_analysis::rules::ALL {
            let page = rule_page(*rule);
            assert!(page.starts_with(&format!("# `{rule}`")), "{rule}");
        }
    }
}
