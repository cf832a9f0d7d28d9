//! What the comments of a file's parts say that rules ask for: looked for once in each part, and kept while it stays.

use crate::asked::{asked, may_ask};
use crate::rules::commented_out_rung;
use ladder_syntax::{FileLines, LineKind, NodeOrToken, Part, TextRange, TextSize, Trees};
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// The notes of all parts.
#[derive(Debug, Default)]
pub(super) struct PartNotes {
    /// In the order of the parts, each with its part, so that no other part has its address.
    notes: Vec<(Arc<Part>, Arc<Note>)>,
}

/// What is of interest in the comments of one part.
#[derive(Debug, Default)]
struct Note {
    /// Comments that are rungs, from the start of the part.
    rungs: Vec<TextRange>,
    /// The lines with directives, from the first of the part.
    asking: Vec<u32>,
}

impl PartNotes {
    /// Looks at the parts that are new.
    pub(super) fn follow(&mut self, lines: &FileLines) {
        let known: FxHashMap<*const Part, Arc<Note>> = self
            .notes
            .iter()
            .map(|(part, note)| (Arc::as_ptr(part), Arc::clone(note)))
            .collect();
        let note = |part: &Arc<Part>| {
            let kept = known.get(&Arc::as_ptr(part)).cloned();
            (Arc::clone(part), kept.unwrap_or_else(|| Arc::new(Note::of(part))))
        };
        self.notes = lines.parts().iter().map(note).collect();
    }

    /// Whether any comment is a directive.
    pub(super) fn ask(&self) -> bool {
        self.notes.iter().any(|(_, note)| !note.asking.is_empty())
    }

    /// The lines with directives, from top to bottom.
    pub(super) fn asking(&self, lines: &FileLines) -> impl Iterator<Item = usize> {
        let noted = self.notes.iter().enumerate();
        noted.flat_map(|(part, (_, note))| {
            let base = lines.first_line(part);
            note.asking.iter().map(move |line| base + *line as usize)
        })
    }

    /// The comments that are rungs, from top to bottom.
    pub(super) fn rungs(&self, lines: &FileLines) -> impl Iterator<Item = TextRange> {
        let noted = self.notes.iter().enumerate();
        noted.flat_map(|(part, (_, note))| {
            let base = lines.first_byte(part);
            note.rungs.iter().map(move |range| *range + base)
        })
    }
}

impl Note {
    fn of(part: &Part) -> Note {
        let mut found = Note::default();
        if !part.is_commented() {
            return found;
        }
        let mut trees = Trees::default();
        for (number, line) in part.lines().iter().enumerate() {
            let mut at = TextSize::new(part.line_start(number));
            let may_be_rung = matches!(line.kind, LineKind::Comment | LineKind::Rail);
            // A tree is dear.
            if !line.is_commented() || !may_be_rung && !may_ask(line.text()) {
                continue;
            }
            let mut asks = false;
            for child in trees.of(line).children() {
                let NodeOrToken::Token(token) = child else {
                    at += match child {
                        NodeOrToken::Node(node) => node.text_len(),
                        NodeOrToken::Token(token) => token.text_len(),
                    };
                    continue;
                };
                let text = token.text();
                if text.starts_with('#') {
                    asks |= asked(text).is_some();
                    if may_be_rung && commented_out_rung::is_rung(text.trim_matches('#')) {
                        found.rungs.push(TextRange::at(at, TextSize::of(text)));
                    }
                }
                at += TextSize::of(text);
            }
            if asks {
                found.asking.push(number as u32);
            }
        }
        found
    }
}
