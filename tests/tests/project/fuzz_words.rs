//! The fuzzer's dictionary holds the name of every rule and every mnemonic: a search that knows them gets further.

use ladder_tests::project;

#[test]
fn the_dictionary_has_all_rules_and_mnemonics() {
    let path = project::root().join("fuzz/dictionaries/ladder.dict");
    let dictionary = std::fs::read_to_string(&path).expect("the dictionary");
    let rules = ladder_analysis::rules::ALL.iter().map(|rule| rule.name());
    let missing: Vec<&str> = rules
        .chain(ladder_instructions::TABLE.iter().map(|row| row.mnemonic))
        .filter(|word| !word.is_empty() && !dictionary.contains(word))
        .collect();
    assert!(missing.is_empty(), "add to {}: {missing:?}", path.display());
}
