//! What an element sees of the scan before: a tag holds what a block left, where its instance doesn't.

use super::blocks::{Class, is_enable_out, power_output};
use super::body::Body;
use super::draw::Target;
use crate::graph::{End, Kind};
use crate::model::UnitKind;
use crate::standard::StandardBlock;
use ladder_format::program::Path;

impl Body<'_> {
    /// Tags for what feeds back, before anything reads it.
    pub(super) fn hold_what_feeds_back(&mut self) {
        let mut ends: Vec<End> = self.graph.feedback.iter().map(|(_, end)| *end).collect();
        ends.sort_unstable();
        ends.dedup();
        for end in ends {
            let Some(tag) = self.held_back(end) else { continue };
            self.tags.holders.insert(end, tag.clone());
            self.tags.fed_back.push((end, tag));
        }
    }

    fn held_back(&mut self, end: End) -> Option<Path> {
        let Kind::Block { name, .. } = &self.graph.nodes[end.node].kind else {
            return None;
        };
        let output = &self.graph.nodes[end.node].outputs[end.output].name;
        let is_power = power_output(self, end.node) == Some(end.output);
        match self.class(end.node)? {
            Class::Gate(_) | Class::Compare(_) => {
                Some(self.helper("decided", "BOOL", "what a condition decided"))
            }
            Class::Standard(_) if is_enable_out(output) => self
                .enable_taken(end.node)
                .map(|_| self.helper("enabled", "BOOL", "what comes to EN")),
            Class::Standard(StandardBlock::Stateful(..)) => None,
            Class::Unit(UnitKind::FunctionBlock) if !is_power => None,
            _ if is_power => Some(self.holder(end)),
            _ => {
                let comment = format!("the result of {name}");
                let ty = self.out_type(end).or_else(|| self.type_taken(end))?;
                let ty = self.type_text(&ty).ok()?;
                Some(self.helper(&name.to_lowercase(), &ty, &comment))
            }
        }
    }

    /// What a condition decides that feeds back goes into its tag, once in a scan.
    pub(super) fn decide(&mut self, node: usize) {
        if self.class(node).is_none_or(Class::acts) {
            return;
        }
        let output = power_output(self, node).unwrap_or(0);
        let end = End { node, output };
        let Some(tag) = self.tags.holders.get(&end).cloned() else {
            return;
        };
        if self.tags.results.contains_key(&end) || self.is_refused(node) {
            return;
        }
        self.flush();
        self.take_turns(node);
        self.prepare(node);
        self.put_power(Target::End(end, tag));
    }
}
