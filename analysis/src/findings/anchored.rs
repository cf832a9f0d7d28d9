//! A finding whose places stay true when text comes or goes above it.

use crate::context::Context;
use crate::diagnostic::{Diagnostic, Fix, Related};
use crate::networks::NetworkAt;
use crate::rule::{Rule, Severity};
use crate::scope::TagFacts;
use ladder_syntax::{TextRange, TextSize};
use std::borrow::Cow;

/// A finding. Its places count from the networks in which they lie.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Anchored {
    found: Kept,
    anchors: Anchors,
}

/// A [`Diagnostic`] in as little memory as it needs: of some programs there are ten thousands.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Kept {
    rule: Rule,
    severity: Severity,
    range: TextRange,
    message: Box<str>,
    help: Option<Cow<'static, str>>,
    related: Box<[Related]>,
    more_related: u32,
    fixes: Box<[Fix]>,
}

impl Kept {
    fn of(found: Diagnostic) -> Kept {
        let found = found.finished();
        Kept {
            rule: found.rule,
            severity: found.severity,
            range: found.range,
            message: found.message.into(),
            help: found.help,
            related: found.related.into(),
            more_related: found.more_related as u32,
            fixes: found.fixes.into(),
        }
    }

    fn diagnostic(&self) -> Diagnostic {
        Diagnostic {
            rule: self.rule,
            severity: self.severity,
            range: self.range,
            message: self.message.as_ref().into(),
            help: self.help.clone(),
            related: self.related.to_vec(),
            more_related: self.more_related as usize,
            fixes: self.fixes.to_vec(),
        }
    }
}

/// What the places of a finding count from.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Anchors {
    /// All from the start of the file.
    File,
    /// All from the start of the network that it is about, or of the line of a comment.
    Network,
    /// Each from another network or line of declarations. In the order of [`places`].
    Each(Box<[Home]>),
}

/// What a place counts from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Home {
    /// The start of a network, by its number.
    Network(u32),
    /// The start of a line of declarations, by its number.
    Declaration(u32),
}

impl Home {
    /// Where it starts.
    pub(crate) fn start(self, context: &Context) -> TextSize {
        match self {
            Home::Network(id) => context.networks.start_of(id),
            Home::Declaration(line) => context.declarations.start_of(line),
        }
    }

    /// The physical line on which it starts, counted from 0.
    fn first_line(self, context: &Context) -> u32 {
        match self {
            Home::Network(id) => {
                let first_line = context.networks.first_line_of(id);
                context.parse.lines().line_ends_above(first_line)
            }
            Home::Declaration(line) => context.physical_line(context.declarations.start_of(line)),
        }
    }
}

impl Anchored {
    /// Of a finding that is looked for anew after each edit: its places need not stay true.
    pub(crate) fn in_file(found: Diagnostic) -> Anchored {
        Anchored {
            found: Kept::of(found),
            anchors: Anchors::File,
        }
    }

    /// Of a finding whose places all count from `own`.
    pub(crate) fn from(mut found: Diagnostic, own: TextSize) -> Anchored {
        move_by(&mut found, -i64::from(u32::from(own)));
        Anchored {
            found: Kept::of(found),
            anchors: Anchors::Network,
        }
    }

    /// Of a finding about a network. One that names other places too counts from the start of the file: it is
    /// [volatile](Anchored::is_volatile).
    pub(crate) fn at_network(found: Diagnostic, network: NetworkAt<'_>) -> Anchored {
        if !found.lies_in(network.range) {
            return Anchored::in_file(found);
        }
        Anchored::from(found, network.range.start())
    }

    /// Whether its places are true for one text only.
    pub(crate) fn is_volatile(&self) -> bool {
        self.anchors == Anchors::File
    }

    /// Of a finding about a tag, with places in the networks that use it by whichever name, and on lines of declarations. One with other
    /// places is [volatile](Anchored::is_volatile).
    pub(crate) fn at_uses(mut found: Diagnostic, tag: &TagFacts, context: &Context) -> Anchored {
        let is_in = |tag: &TagFacts, id: u32| tag.uses.0.iter().any(|place| place.network == id);
        let uses_it =
            |id: u32| is_in(tag, id) || context.others_at_address(tag).any(|other| is_in(other, id));
        let home = |place: &mut TextRange| match network_around(context, *place) {
            Some(id) => uses_it(id).then_some(Home::Network(id)),
            None => on_declaration(context, *place).map(Home::Declaration),
        };
        // None: what an edit elsewhere does to the place is not known.
        let homes: Option<Box<[Home]>> = places(&mut found).map(home).collect();
        Anchored::each(found, homes, context)
    }

    /// Of a finding with places in networks, whichever they are. One with other places is [volatile](Anchored::is_volatile).
    pub(crate) fn in_networks(mut found: Diagnostic, context: &Context) -> Anchored {
        let home = |place: &mut TextRange| network_around(context, *place).map(Home::Network);
        let homes: Option<Box<[Home]>> = places(&mut found).map(home).collect();
        Anchored::each(found, homes, context)
    }

    /// Of a finding with places in networks and on lines of declarations, whichever they are. One with other places is
    /// [volatile](Anchored::is_volatile).
    pub(crate) fn anywhere(mut found: Diagnostic, context: &Context) -> Anchored {
        let declaration = |place| {
            let line = declaration_around(context, place)?;
            Some(Home::Declaration(context.declarations.number(line)))
        };
        let network = |place| network_around(context, place).map(Home::Network);
        let home = |place: &mut TextRange| network(*place).or_else(|| declaration(*place));
        let homes: Option<Box<[Home]>> = places(&mut found).map(home).collect();
        Anchored::each(found, homes, context)
    }

    /// Of a finding each of whose places has another home.
    fn each(mut found: Diagnostic, homes: Option<Box<[Home]>>, context: &Context) -> Anchored {
        let Some(homes) = homes else {
            return Anchored::in_file(found);
        };
        for (place, home) in places(&mut found).zip(&homes) {
            *place = shifted(*place, -i64::from(u32::from(home.start(context))));
        }
        Anchored {
            found: Kept::of(found),
            anchors: Anchors::Each(homes),
        }
    }

    /// Of a finding about a line of declarations, with places that count from the start of that line, and related ones on
    /// another line of them.
    pub(crate) fn on_line(mut found: Diagnostic, line: u32, related: u32) -> Anchored {
        let elsewhere = found.related.len();
        let home = |(number, _)| {
            let is_related = (1..=elsewhere).contains(&number);
            Home::Declaration(if is_related { related } else { line })
        };
        let homes = places(&mut found).enumerate().map(home).collect();
        Anchored {
            found: Kept::of(found),
            anchors: Anchors::Each(homes),
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

    /// What its own place counts from, of one that a tag owns; none if its places are true for one text only.
    pub(crate) fn home(&self) -> Option<Home> {
        match &self.anchors {
            Anchors::Each(homes) => homes.first().copied(),
            Anchors::File | Anchors::Network => None,
        }
    }

    /// See [`Finding::first_lines`](super::Finding::first_lines).
    pub(crate) fn first_lines(&self, own: TextSize, context: &Context, lines: &mut Vec<u32>) -> bool {
        match &self.anchors {
            Anchors::File => return false,
            Anchors::Network => lines.push(context.physical_line(own)),
            Anchors::Each(homes) => lines.extend(homes.iter().map(|home| home.first_line(context))),
        }
        true
    }

    /// Whether one of its fixes may be made unasked.
    pub(crate) fn has_safe_fix(&self) -> bool {
        self.found.fixes.iter().any(Fix::is_safe)
    }

    /// Where it is now. `own`: where the network starts that it is about.
    pub(crate) fn range(&self, own: TextSize, context: &Context) -> TextRange {
        match &self.anchors {
            Anchors::File => self.found.range,
            Anchors::Network => self.found.range + own,
            Anchors::Each(homes) => {
                let home = homes.first().map(|home| home.start(context));
                self.found.range + home.unwrap_or_default()
            }
        }
    }

    /// The finding with its places as they are now. `own`: where the network starts that it is about.
    pub(crate) fn placed(&self, own: TextSize, context: &Context) -> Diagnostic {
        let mut found = self.found.diagnostic();
        match &self.anchors {
            Anchors::File => {}
            Anchors::Network => move_by(&mut found, i64::from(u32::from(own))),
            Anchors::Each(homes) => {
                for (place, home) in places(&mut found).zip(homes) {
                    *place += home.start(context);
                }
            }
        }
        found.fixes.retain_mut(|fix| {
            let Some(declares) = fix.declares.take() else {
                return true;
            };
            let edits = declares.edits(context);
            fix.edits = edits.unwrap_or_default();
            !fix.edits.is_empty()
        });
        found
    }
}

/// The number of the network in which a place lies.
fn network_around(context: &Context, place: TextRange) -> Option<u32> {
    let networks = &context.networks;
    let behind = networks.partition_point(|network| network.range.start() <= place.start());
    let around = networks.at(behind.checked_sub(1)?);
    let is_it = around.range.contains_range(place);
    is_it.then(|| networks.id(around.index))
}

/// The line of declarations on which a place above all networks lies.
fn on_declaration(context: &Context, place: TextRange) -> Option<u32> {
    // Below a network the order of networks says nothing of its place.
    let first = context.networks.first().map(|first| first.range.start());
    let is_above = first.is_none_or(|first| place.end() <= first);
    let line = declaration_around(context, place).filter(|_| is_above)?;
    Some(context.declarations.number(line))
}

/// The line of declarations on which a place lies, by its place among them.
fn declaration_around(context: &Context, place: TextRange) -> Option<usize> {
    let line = context.declarations.last_before(place.start())?;
    let around = context.parse.line_at(place.start())?;
    let range = context.parse.line_range(around);
    let is_it = range.start() == context.declarations.start(line) && range.contains_range(place);
    is_it.then_some(line)
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

#[cfg(test)]
mod tests {
    use super::Anchored;

    /// With what counts its owners it fits in 128 bytes.
    #[test]
    fn what_there_are_many_of_is_small() {
        assert!(size_of::<Anchored>() <= 112, "{}", size_of::<Anchored>());
    }
}
