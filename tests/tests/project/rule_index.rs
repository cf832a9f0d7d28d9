//! The book lists every rule.
//!
//! After a rule was added or its page changed, `UPDATE_EXPECT=1 cargo test -p ladder-tests` writes the list again.

use std::path::Path;

use expect_test::expect_file;
use ladder_notations::{NOTATIONS, by_name};
use ladder_tests::book::{pages, source};
use ladder_tests::rule_index;

#[test]
fn the_list_is_up_to_date() {
    expect_file![source().join("rules/index.md")].assert_eq(&rule_index::text());
}

/// What is written like a rule's name is one, or that of a notation, or of a check of that system's own.
#[test]
fn rules_that_the_book_names_exist() {
    let looks_like_a_rule = |code: &str| {
        code.contains('-')
            && code.chars().all(|c| c.is_ascii_lowercase() || c == '-')
            && !code.starts_with('-')
    };
    let is_foreign_check = |code: &str| {
        let mut words = NOTATIONS.iter().map(|notation| notation.name());
        words.any(|name| code.strip_prefix(name).is_some_and(|rest| rest.starts_with('-')))
    };
    // The protocol has words of its own, and so have other editors and packages.
    let has_own_words = |path: &Path| {
        ["protocol.md", "other-editors.md", "releasing.md"]
            .iter()
            .any(|name| path.ends_with(name))
    };
    for page in pages().iter().filter(|page| !has_own_words(&page.path)) {
        for code in page.content.codes.iter().filter(|code| looks_like_a_rule(code)) {
            assert!(
                ladder_analysis::rules::rule_named(code).is_some()
                    || by_name(code).is_some()
                    || is_foreign_check(code),
                "{}: there is no rule `{code}`",
                page.path.display()
            );
        }
    }
}
