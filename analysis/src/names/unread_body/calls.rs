//! What an unread part may call: the blocks and functions of its file that its text names, and what those name. With another text of
//! one of them it is another part.

use crate::program::without_blanks;
use crate::written::user_block::UserBlockFacts;
use ladder_syntax::{Parse, Structure};
use rustc_hash::{FxHashMap, FxHashSet, FxHasher};
use std::hash::{Hash, Hasher};
use std::ops::Range;
use std::sync::Arc;

/// Adds to the text of each unread part what it may call.
pub(in crate::names) fn with_calls(parse: &Parse, structure: &Structure, blocks: &mut [UserBlockFacts]) {
    if blocks.iter().all(|block| block.unread.is_none()) {
        return;
    }
    let called = Called::of(parse, structure, blocks);
    for (number, block) in blocks.iter_mut().enumerate() {
        let Some(unread) = &mut block.unread else { continue };
        let mut reached: Vec<usize> = called.reached_from(number).into_iter().collect();
        reached.sort_unstable();
        let mut hasher = FxHasher::default();
        let texts = reached.iter().filter(|other| **other != number);
        let texts: Vec<&str> = texts.map(|other| called.all[*other].text.as_str()).collect();
        if !texts.is_empty() {
            texts.hash(&mut hasher);
            let text = format!("{} calls {:x}", unread.text, hasher.finish());
            Arc::make_mut(unread).text = text;
        }
    }
}

/// A block, or a function.
struct Item {
    text: String,
    names: FxHashSet<String>,
}

/// What can be called in a file: the blocks by their numbers, then the functions.
struct Called {
    all: Vec<Item>,
    /// Those that a name in small letters may call: their own names, and those of what keeps the state of a block.
    by_name: FxHashMap<String, Vec<usize>>,
}

impl Called {
    fn of(parse: &Parse, structure: &Structure, blocks: &[UserBlockFacts]) -> Called {
        let mut called = Called {
            all: Vec::new(),
            by_name: FxHashMap::default(),
        };
        let text_of =
            |lines: Range<usize>| -> String { lines.map(|line| parse.lines()[line].text()).collect() };
        for (block, definition) in blocks.iter().zip(&structure.blocks) {
            let name = block.name.trim_start_matches('$');
            called.push(name, &text_of(definition.lines.clone()));
        }
        let mut function: Option<(String, String)> = None;
        for network in structure
            .networks
            .iter()
            .filter(|network| network.block.is_none())
        {
            let text = text_of(network.lines.clone());
            if let Some(name) = function_of(&text)
                && let Some((name, text)) = function.replace((name, String::new()))
            {
                called.push(&name, &text);
            }
            if let Some((_, all)) = &mut function {
                all.push_str(&text);
            }
        }
        if let Some((name, text)) = function {
            called.push(&name, &text);
        }
        for section in &structure.sections {
            for line in section.lines.clone() {
                let text = parse.lines()[line].text();
                let Some((names, ty)) = text.split_once(':').filter(|(_, ty)| ty.contains('$')) else {
                    continue;
                };
                let states: Vec<usize> = ty
                    .split('$')
                    .skip(1)
                    .filter_map(|rest| words(rest).next())
                    .filter_map(|block| called.by_name.get(&block)?.first().copied())
                    .collect();
                for name in words(names) {
                    called.by_name.entry(name).or_default().extend(&states);
                }
            }
        }
        called
    }

    fn push(&mut self, name: &str, text: &str) {
        self.by_name
            .entry(name.to_lowercase())
            .or_default()
            .push(self.all.len());
        self.all.push(Item {
            text: without_blanks(text),
            // A text of another system has `\h` for `#`.
            names: words(&text.replace("\\h", "#")).collect(),
        });
    }

    /// What one names, and what that names in turn.
    fn reached_from(&self, first: usize) -> FxHashSet<usize> {
        let mut reached = FxHashSet::from_iter([first]);
        let mut waiting = vec![first];
        while let Some(item) = waiting.pop() {
            let names = self.all[item].names.iter();
            for named in names.filter_map(|name| self.by_name.get(name)).flatten() {
                if reached.insert(*named) {
                    waiting.push(*named);
                }
            }
        }
        reached
    }
}

/// The function that a network begins.
fn function_of(text: &str) -> Option<String> {
    let at = text.to_ascii_uppercase().find("<FUN>")?;
    words(&text[at + "<FUN>".len()..]).next()
}

/// The words of a text in small letters.
fn words(text: &str) -> impl Iterator<Item = String> {
    text.split(|c: char| !c.is_alphanumeric() && c != '_')
        .filter(|word| !word.is_empty())
        .map(str::to_lowercase)
}

#[cfg(test)]
mod tests {
    use crate::names::context::Context;

    /// The texts of the unread parts of a program.
    fn texts(program: &str) -> Vec<String> {
        let parse = std::sync::Arc::new(ladder_syntax::parse(program));
        let analysis = crate::analyze(&parse, "test.clad");
        let context: &Context = &analysis.context;
        let parts = context
            .user_blocks
            .iter()
            .filter_map(|block| block.unread.as_ref());
        parts.map(|unread| unread.text.clone()).collect()
    }

    #[test]
    fn what_a_part_calls_makes_it_another_one() {
        let program = "FUNCTION_BLOCK [$Part]\n# ladder: unread #\n# \\hpump(go := TRUE); Rinse(); #\nEND_FUNCTION_BLOCK\n\n\
            FUNCTION_BLOCK [$Motor]\nVAR\n    inner : $Inner;\nEND_VAR\n+--[$Inner]( inner )--+\nEND_FUNCTION_BLOCK\n\n\
            FUNCTION_BLOCK [$Inner]\nVAR\n    n : INT;\nEND_VAR\n+--[MOV]( n, 1 )--+\nEND_FUNCTION_BLOCK\n\n\
            FUNCTION_BLOCK [$Other]\nVAR\n    n : INT;\nEND_VAR\n+--[MOV]( n, 3 )--+\nEND_FUNCTION_BLOCK\n\n\
            VAR\n    pump : $Motor;\n    k : INT;\nEND_VAR\n\n+--[$Part]--+\n\n+--<FUN>( Rinse )--+\n\n+--[MOV]( k, 5 )--+\n\n+--<FUN>( Last )--+\n\n+--[MOV]( k, 6 )--+\n";
        let before = texts(program);
        assert_eq!(before.len(), 1);
        assert_eq!(texts(&program.replace("[MOV]( n, 3 )", "[MOV]( n, 4 )")), before);
        assert_eq!(texts(&program.replace("[MOV]( k, 6 )", "[MOV]( k, 7 )")), before);
        assert_eq!(texts(&program.replace("[MOV]( n, 1 )", "[MOV](  n, 1)")), before);
        assert_ne!(texts(&program.replace("[MOV]( n, 1 )", "[MOV]( n, 2 )")), before);
        assert_ne!(texts(&program.replace("[MOV]( k, 5 )", "[MOV]( k, 6 )")), before);
    }
}
