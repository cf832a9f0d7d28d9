//! The book lists every rule.
//!
//! After a rule was added or its page changed, `UPDATE_EXPECT=1 cargo test -p ladder-tests` writes the list anew.

use expect_test::expect_file;
use ladder_tests::book::source;
use ladder_tests::rule_index;

#[test]
fn the_list_is_up_to_date() {
    expect_file![source().join("rules/index.md")].assert_eq(&rule_index::text());
}
