//! The fuzzer's dictionary has the name of every rule and of every instruction: a search that knows them gets further.
//!
//! After one was added, `UPDATE_EXPECT=1 cargo test -p ladder-tests` writes them again.

use expect_test::expect_file;
use ladder_analysis::rules;
use ladder_instructions::TABLE;
use ladder_tests::project;
use std::collections::BTreeSet;

const MADE: &str = "# The rules and the instructions, made from their lists.\n";

#[test]
fn the_dictionary_has_all_rules_and_instructions() {
    let path = project::root().join("fuzz/dictionaries/ladder.dict");
    let dictionary = project::read(&path);
    let (by_hand, _) = dictionary.split_once(MADE).expect("the line above what is made");
    let rules = rules::ALL.iter().map(|rule| rule.name());
    let instructions = TABLE.iter().flat_map(|row| {
        let others = row.synonyms.iter().chain(row.aliases).copied();
        others.chain([row.mnemonic])
    });
    // The open contact and the coil have none.
    let words: BTreeSet<String> = rules
        .chain(instructions)
        .filter(|word| !word.trim().is_empty())
        .map(|word| format!("\"{word}\"\n"))
        .collect();
    let made: String = words.into_iter().collect();
    expect_file![path].assert_eq(&format!("{by_hand}{MADE}{made}"));
}
