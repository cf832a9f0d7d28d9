//! A finding whose places stay true when text comes or goes above it.

use crate::diagnostic::{Diagnostic, Fix};
use crate::networks::{NetworkAt, Networks};
use crate::rule::{Rule, Severity};
use crate::scope::Uses;
use ladder_syntax::{TextRange, TextSize};

/// A finding. Its places count from the networks in which they lie.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Anchored {
    found: Diagnostic,
    anchors: Anchors,
}

/// What the places of a finding count from.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Anchors {
    /// All from the start of the file.
    File,
    /// All from the start of the network that it is about.
    Network,
    /// Each from another network, by its number, or from the start of the file. In the order of [`places`].
    Each(Box<[Option<u32>]>),
}

impl Anchored {
    /// Of a finding that is looked for anew after each edit: its places need not stay true.
    pub(crate) fn in_file(mut found: Diagnostic) -> Anchored {
        found.say_how_many_more();
        Anchored {
            found,
            anchors: Anchors::File,
        }
    }

    /// Of a finding about a network. One that names other places too counts from the start of the file: it is
    /// [volatile](Anchored::is_volatile).
    pub(crate) fn at_network(mut found: Diagnostic, network: NetworkAt<'_>) -> Anchored {
        if !found.lies_in(network.range) {
            return Anchored::in_file(found);
        }
        found.say_how_many_more();
        move_by(&mut found, -i64::from(u32::from(network.range.start())));
        Anchored {
            found,
            anchors: Anchors::Network,
        }
    }

    /// Whether its places are true for one text only.
    pub(crate) fn is_volatile(&self) -> bool {
        self.anchors == Anchors::File
    }

    /// Of a finding about a tag, with places in the networks that use it, and above all networks. One with other
    /// places is [volatile](Anchored::is_volatile).
    pub(crate) fn at_uses(mut found: Diagnostic, uses: &Uses, networks: &Networks) -> Anchored {
        let first = networks.first().map(|first| first.range.start());
        let uses_it = |index: usize| {
            let id = networks.id(index);
            uses.0.iter().any(|place| place.network == id)
        };
        // None: what an edit elsewhere does to the place is not known.
        let anchor = |place: &mut TextRange| {
            let behind = networks.partition_point(|network| network.range.start() <= place.start());
            let around = behind.checked_sub(1).map(|index| networks.at(index));
            match around.filter(|network| network.range.contains_range(*place)) {
                Some(network) => uses_it(network.index).then_some(Some(network.index)),
                None => first.is_none_or(|first| place.end() <= first).then_some(None),
            }
        };
        let anchors: Option<Vec<Option<usize>>> = places(&mut found).map(anchor).collect();
        let Some(anchors) = anchors else {
            return Anchored::in_file(found);
        };
        found.say_how_many_more();
        for (place, anchor) in places(&mut found).zip(&anchors) {
            if let Some(network) = anchor {
                *place = shifted(*place, -i64::from(u32::from(networks.at(*network).range.start())));
            }
        }
        let anchors = anchors.into_iter().map(|at| at.map(|index| networks.id(index)));
        Anchored {
            found,
            anchors: Anchors::Each(anchors.collect()),
        }
    }

    /// The rule that found it.
    pub(crate) fn rule(&self) -> Rule {
        self.found.rule
    }

    /// As the rule says.
    pub(crate) fn severity(&self) -> Severity {
        self.found.severity
    }

    /// Where it is, from the start of what its place counts from.
    pub(crate) fn anchored_range(&self) -> TextRange {
        self.found.range
    }

    /// The number of the network that its place counts from, of one that a tag owns; none if that is the file.
    pub(crate) fn home(&self) -> Option<u32> {
        match &self.anchors {
            Anchors::Each(anchors) => anchors.first().copied().flatten(),
            Anchors::File | Anchors::Network => None,
        }
    }

    /// See [`Finding::counts_from`](super::Finding::counts_from).
    pub(crate) fn counts_from(&self, own: TextSize, networks: &Networks) -> Option<Vec<TextSize>> {
        match &self.anchors {
            Anchors::File => None,
            Anchors::Network => Some(vec![own]),
            Anchors::Each(anchors) => {
                let networks = anchors.iter().flatten().map(|id| networks.start_of(*id));
                Some(networks.collect())
            }
        }
    }

    /// Whether one of its fixes may be made unasked.
    pub(crate) fn has_safe_fix(&self) -> bool {
        self.found.fixes.iter().any(Fix::is_safe)
    }

    /// Where it is now. `own`: where the network starts that it is about.
    pub(crate) fn range(&self, own: TextSize, networks: &Networks) -> TextRange {
        match &self.anchors {
            Anchors::File => self.found.range,
            Anchors::Network => self.found.range + own,
            Anchors::Each(anchors) => match anchors.first().copied().flatten() {
                Some(network) => self.found.range + networks.start_of(network),
                None => self.found.range,
            },
        }
    }

    /// The finding with its places as they are now. `own`: where the network starts that it is about.
    pub(crate) fn placed(&self, own: TextSize, networks: &Networks) -> Diagnostic {
        let mut found = self.found.clone();
        match &self.anchors {
            Anchors::File => {}
            Anchors::Network => move_by(&mut found, i64::from(u32::from(own))),
            Anchors::Each(anchors) => {
                for (place, anchor) in places(&mut found).zip(anchors) {
                    if let Some(network) = anchor {
                        *place += networks.start_of(*network);
                    }
                }
            }
        }
        found
    }
}

/// All places of this file that a finding names: its own first.
fn places(found: &mut Diagnostic) -> impl Iterator<Item = &mut TextRange> {
    let related = found.related.iter_mut().filter(|related| related.file.is_none());
    let edits = found.fixes.iter_mut().flat_map(|fix| &mut fix.edits);
    std::iter::once(&mut found.range)
        .chain(related.map(|related| &mut related.range))
        .chain(edits.map(|edit| &mut edit.range))
}

fn move_by(found: &mut Diagnostic, bytes: i64) {
    places(found).for_each(|place| *place = shifted(*place, bytes));
}

fn shifted(range: TextRange, bytes: i64) -> TextRange {
    let to = |at: TextSize| TextSize::new((i64::from(u32::from(at)) + bytes) as u32);
    TextRange::new(to(range.start()), to(range.end()))
}
