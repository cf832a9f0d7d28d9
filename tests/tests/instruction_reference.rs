//! The language reference shows every instruction as the table has it.
//!
//! After a change of the table, `UPDATE_EXPECT=1 cargo test -p ladder-tests` writes the pages anew.

use expect_test::expect_file;
use ladder_instructions::TABLE;
use ladder_tests::book::source;
use ladder_tests::instruction_pages::{PAGES, text};

#[test]
fn the_pages_are_up_to_date() {
    let folder = source().join("language/instructions");
    for page in &PAGES {
        expect_file![folder.join(page.file)].assert_eq(&text(page));
    }
}

#[test]
fn every_instruction_stands_on_a_page() {
    for row in TABLE {
        assert!(
            PAGES.iter().any(|page| page.group == row.group),
            "{}",
            row.signature()
        );
    }
}
