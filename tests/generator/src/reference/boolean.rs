//! Programs of contacts and coils, evaluated by the reference.

use super::{DrawnPart, evaluate, networks};
use std::collections::BTreeMap;

/// What a block of such a program does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Contact {
    /// `[ ]`
    Open,
    /// `[/]`
    Closed,
    /// `[NOT]`
    Not,
    /// `( )`
    Coil,
    /// `(/)`
    NegatedCoil,
    /// `(S)`
    Set,
    /// `(R)`
    Reset,
}

/// What a block is, and its tag in small letters.
type Block = (Contact, String);

/// A running program of contacts and coils.
#[derive(Debug)]
pub struct Boolean {
    networks: Vec<(Vec<Vec<DrawnPart>>, Vec<Block>)>,
    /// The tags by their names in small letters.
    pub tags: BTreeMap<String, bool>,
    /// The ENO of every block in the order of the text, of the last scan.
    pub power: Vec<bool>,
    /// The EN of every block likewise.
    pub enabled: Vec<bool>,
    /// What the tag of every block is after it, likewise.
    pub left: Vec<bool>,
}

impl Boolean {
    /// Reads a program. All tags are low.
    pub fn new(text: &str) -> Boolean {
        let mut tags = BTreeMap::new();
        let networks = networks(text)
            .into_iter()
            .map(|(rungs, blocks)| {
                let blocks = blocks
                    .iter()
                    .map(|block| {
                        let (kind, tag) = contact(block);
                        tags.insert(tag.clone(), false);
                        (kind, tag)
                    })
                    .collect();
                (rungs, blocks)
            })
            .collect();
        tags.remove("");
        Boolean {
            networks,
            tags,
            power: Vec::new(),
            enabled: Vec::new(),
            left: Vec::new(),
        }
    }

    /// Runs one scan.
    pub fn scan(&mut self) {
        self.power.clear();
        self.enabled.clear();
        self.left.clear();
        for (rungs, blocks) in &self.networks {
            let mut power = vec![false; blocks.len()];
            let mut given = vec![false; blocks.len()];
            let mut left = vec![false; blocks.len()];
            let tags = &mut self.tags;
            evaluate(rungs, &mut |block, enabled| {
                let (kind, tag) = &blocks[block];
                let before = tags.get(tag).copied().unwrap_or_default();
                let (after, passed) = match kind {
                    Contact::Open => (before, enabled && before),
                    Contact::Closed => (before, enabled && !before),
                    Contact::Not => (before, !enabled),
                    Contact::Coil => (enabled, enabled),
                    Contact::NegatedCoil => (!enabled, enabled),
                    Contact::Set => (before || enabled, before || enabled),
                    Contact::Reset => (before && !enabled, enabled),
                };
                if let Some(tag) = tags.get_mut(tag) {
                    *tag = after;
                }
                power[block] = passed;
                given[block] = enabled;
                left[block] = after;
                passed
            });
            self.power.extend(power);
            self.enabled.extend(given);
            self.left.extend(left);
        }
    }
}

fn contact(block: &str) -> Block {
    let bare: String = block.chars().filter(|c| !c.is_whitespace()).collect();
    let end = bare.find([']', ')', '>']).expect("the first part is closed") + 1;
    let kind = match bare[..end].to_ascii_uppercase().as_str() {
        "[]" => Contact::Open,
        "[/]" => Contact::Closed,
        "[NOT]" => Contact::Not,
        "()" => Contact::Coil,
        "(/)" => Contact::NegatedCoil,
        "(S)" => Contact::Set,
        "(R)" => Contact::Reset,
        other => panic!("the reference does not know {other}"),
    };
    (kind, bare[end..].trim_matches(['(', ')']).to_lowercase())
}
