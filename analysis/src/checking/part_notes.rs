//! What the comments of a file's parts say that rules ask for: looked for once in each part, and kept while it stays.

use crate::asked::{asked, may_ask};
use crate::rules::commented_out_rung;
use ladder_syntax::{FileLines, LineKind, NodeOrToken, Part, TextRange, TextSize, Trees};
use std::ops::Range;
use std::sync::Arc;

/// The notes of all parts.
#[derive(Debug, Default)]
pub(super) struct PartNotes {
    /// In the order of the parts, each with its part, so that no other part has its address.
    notes: Vec<(Arc<Part>, Arc<Note>)>,
    /// How many lines have directives.
    asking: usize,
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
    /// Looks at the parts that are new. Gives which of them these are, and in the place of which earlier ones they are.
    pub(super) fn follow(&mut self, lines: &FileLines) -> (Range<usize>, Range<usize>) {
        let parts = lines.parts();
        let is_same = |(part, (noted, _)): &(&Arc<Part>, &(Arc<Part>, Arc<Note>))| Arc::ptr_eq(part, noted);
        let above = parts.iter().zip(&self.notes).take_while(is_same).count();
        let below = parts[above..].iter().rev().zip(self.notes[above..].iter().rev());
        let below = below.take_while(is_same).count();
        let (new, old) = (above..parts.len() - below, above..self.notes.len() - below);
        let notes = parts[new.clone()]
            .iter()
            .map(|part| (Arc::clone(part), Arc::new(Note::of(part))));
        let gone: Vec<_> = self.notes.splice(old.clone(), notes).collect();
        let asking = |notes: &[(Arc<Part>, Arc<Note>)]| -> usize {
            notes.iter().map(|(_, note)| note.asking.len()).sum()
        };
        self.asking = self.asking + asking(&self.notes[new.clone()]) - asking(&gone);
        (new, old)
    }

    /// Whether any comment is a directive.
    pub(super) fn ask(&self) -> bool {
        self.asking > 0
    }

    /// The lines with directives, from top to bottom.
    pub(super) fn asking(&self, lines: &FileLines) -> impl Iterator<Item = usize> {
        (0..self.notes.len()).flat_map(|part| self.asking_in(part, lines))
    }

    /// The lines of a part with directives, from top to bottom.
    pub(super) fn asking_in(&self, part: usize, lines: &FileLines) -> impl Iterator<Item = usize> {
        let base = lines.first_line(part);
        let (_, note) = &self.notes[part];
        note.asking.iter().map(move |line| base + *line as usize)
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
