//! The blocks that do nothing and show what stood in their place.

use ladder_format::program::Item;
use std::collections::BTreeMap;

/// So many characters of what it stands for a block shows at most.
const MOST_CHARACTERS: usize = 254;

/// Those that a program uses: the name and the text of each, by the name in small letters.
#[derive(Debug, Default)]
pub(super) struct Idle(BTreeMap<String, (String, String)>);

impl Idle {
    /// One, as it is on a rung. `is_taken` says which names other blocks have.
    pub(super) fn block(&mut self, name: &str, shown: &str, is_taken: impl Fn(&str) -> bool) -> String {
        let mut word = crate::scope::block_name(name);
        if is_taken(&word) {
            word.push_str("Idle");
        }
        let said: String = name.chars().filter(|c| !c.is_control() && *c != '#').collect();
        let text = format!(
            "# {said} is not run here: the block does nothing, and power passes. #\nFUNCTION_BLOCK [{word}]\nVAR_INPUT\n    \
             shown : STRING[{MOST_CHARACTERS}] := '';\nEND_VAR\nEND_FUNCTION_BLOCK\n"
        );
        let block = self.0.entry(word.to_lowercase()).or_insert((word, text));
        let shown: String = shown.chars().take(MOST_CHARACTERS / 4).collect();
        let shown = shown
            .replace('$', "$$")
            .replace('\'', "$'")
            .replace(char::is_control, " ");
        format!("[{}]( '{shown}' )", block.0)
    }

    /// Their definitions.
    pub(super) fn items(&self) -> impl Iterator<Item = Item> {
        let texts = self.0.values();
        texts.flat_map(|(_, text)| [Item::Blank, Item::Text(text.clone())])
    }
}
