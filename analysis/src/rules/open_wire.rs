//! `open-wire`: no power can reach a wire, whatever the tags are.
//!
//! A line that begins without power and gets it later through a connector has a dead stretch before that. What
//! is after it on other lines is dead as well: the finding is at the place where the power is lost.

use super::form::Form;
use super::rung_not_powered;
use crate::findings::diagnostic::{Applicability, Diagnostic, Fix};
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::networks::NetworkAt;
use crate::program::Step;
use ladder_format::Edit;
use ladder_syntax::wiring::{PartKind, RungPart, Segment};
use ladder_syntax::{Parse, TextRange, TextSize};

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Wiring, "open-wire", Severity::Error).fixed(Applicability::Safe));

pub(super) fn check(form: &Form<'_>, out: &mut Vec<Diagnostic>) {
    let network = form.network;
    if network.broken {
        return;
    }
    let live = live_steps(network);
    if network.order.elements.iter().all(|&(_, _, step, _)| live[step]) {
        return;
    }
    let reach = Reach::new(form, &live);
    for rung in 0..network.wiring.rungs.len() {
        for segment in 0..network.wiring.rungs[rung].segments.len() {
            out.extend(reach.lost_at(rung, segment));
        }
    }
}

/// For each step whether power can come there.
fn live_steps(network: NetworkAt<'_>) -> Vec<bool> {
    let mut live = Vec::with_capacity(network.order.steps.len());
    for step in &network.order.steps {
        live.push(match *step {
            Step::Start { rail } => rail,
            Step::Block { en, .. } => live[en],
            Step::Join { upper, lower } => live[upper] || live[lower],
        });
    }
    live
}

struct Reach<'c> {
    parse: &'c Parse,
    network: NetworkAt<'c>,
    /// For each rung and part whether power can leave it.
    live: Vec<Vec<bool>>,
}

impl<'c> Reach<'c> {
    fn new(form: &Form<'c>, steps: &[bool]) -> Reach<'c> {
        let (parse, network) = (form.parse, form.network);
        let rungs = &network.wiring.rungs;
        let mut live: Vec<Vec<bool>> = rungs.iter().map(|rung| vec![false; rung.parts.len()]).collect();
        for &(rung, part, step, _) in &network.order.elements {
            live[rung][part] = steps[step];
        }
        Reach { parse, network, live }
    }

    fn part(&self, rung: usize, part: usize) -> &RungPart {
        &self.network.wiring.rungs[rung].parts[part]
    }

    fn segments(&self, rung: usize) -> &[Segment] {
        &self.network.wiring.rungs[rung].segments
    }

    fn range(&self, rung: usize, first: usize, last: usize) -> TextRange {
        let range = self.part(rung, first).range.cover(self.part(rung, last).range);
        range + self.parse.line_start(self.network.line(rung))
    }

    /// The finding for a segment that begins without power, if the power is lost there.
    fn lost_at(&self, rung: usize, segment: usize) -> Option<Diagnostic> {
        let first = self.segments(rung)[segment].parts.start;
        if self.live[rung][first] {
            return None;
        }
        match self.part(rung, first).kind {
            PartKind::Down => self.lost_at_point(rung, segment),
            // Said at its partner on the line above, or where that line loses its power.
            PartKind::Up => None,
            // misplaced-rail says so.
            PartKind::StrayRail => None,
            _ => self.lost_at_start(rung, segment),
        }
    }

    /// A segment that begins with wire or a block.
    fn lost_at_start(&self, rung: usize, segment: usize) -> Option<Diagnostic> {
        let parts = &self.network.wiring.rungs[rung].parts;
        if parts.iter().any(|part| part.kind == PartKind::StrayRail) {
            // The line may begin at that rail.
            return None;
        }
        if segment > 0 {
            return self.cut_before(rung, segment);
        }
        let parts = self.segments(rung)[segment].parts.clone();
        let dead = parts.clone().take_while(|&part| !self.live[rung][part]).count();
        let range = self.range(rung, parts.start, parts.start + dead - 1);
        if !self.live[rung].contains(&true) {
            return Some(self.with_rail(rung, rung_not_powered::found(range)));
        }
        let found = Diagnostic::new(
            RULE,
            range,
            "no power can reach this wire: it begins neither at the left rail nor at a connector",
        )
        .help("begin the line with `+`, or join it to the line above with \\ and /");
        Some(self.with_rail(rung, found))
    }

    /// A pair of connectors that both of its lines begin with: nothing arrives along either.
    fn lost_at_point(&self, rung: usize, segment: usize) -> Option<Diagnostic> {
        let down = self.segments(rung)[segment].parts.start;
        let points = &self.network.wiring.points;
        let point = points.binary_search_by_key(&(rung, down), |point| (point.upper, point.down));
        let point = &points[point.ok()?];
        let below = rung + 1;
        let segment_below = self.part(below, point.up).segment? as usize;
        if self.segments(below)[segment_below].parts.start != point.up {
            return None;
        }
        if let Some(found) = self
            .wrong_way_round(rung, segment)
            .or_else(|| self.wrong_way_round(below, segment_below))
        {
            return Some(found);
        }
        for (rung, segment) in [(rung, segment), (below, segment_below)] {
            if segment > 0 {
                return self.cut_before(rung, segment);
            }
        }
        let message =
            "no power can reach this connector: nothing comes along its line, or along that of its partner";
        let found = Diagnostic::new(RULE, self.range(rung, down, down), message)
            .help("one of the two lines must come from the left rail or from a live wire")
            .related(self.range(below, point.up, point.up), "its partner");
        Some(self.with_rail(rung, found))
    }

    /// `\--/` where `/--\` is meant: the segment begins with a dead connector, and its next one is live and of the
    /// other kind.
    fn wrong_way_round(&self, rung: usize, segment: usize) -> Option<Diagnostic> {
        let parts = self.segments(rung)[segment].parts.clone();
        let first = parts.start;
        let is_connector = |part: usize| matches!(self.part(rung, part).kind, PartKind::Down | PartKind::Up);
        let next = parts.skip(1).find(|&part| is_connector(part))?;
        let (kind, next_kind) = (self.part(rung, first).kind, self.part(rung, next).kind);
        if next_kind == kind || !self.live[rung][next] {
            return None;
        }
        let (written, meant, from) = match kind {
            PartKind::Down => ("\\", "/", "above"),
            _ => ("/", "\\", "below"),
        };
        let mut found = Diagnostic::new(
            RULE,
            self.range(rung, first, next),
            format!(
                "this branch is drawn the wrong way round: power comes from the line {from} at its right end"
            ),
        )
        .help(format!(
            "power runs to the right: begin the branch with `{meant}` and end it with `{written}`"
        ));
        let edits = [(first, meant), (next, written)].map(|(part, text)| Edit {
            range: self.range(rung, part, part),
            text: text.to_owned(),
        });
        // Other lines may be drawn wrongly as well.
        let fix = Fix::new(Applicability::Unsafe, "Swap `\\` and `/`", edits.into());
        found.fixes.push(fix);
        Some(found)
    }

    /// The blank before a segment that cuts it off from a live wire. None if the wire before is dead too: it has
    /// its own finding.
    fn cut_before(&self, rung: usize, segment: usize) -> Option<Diagnostic> {
        let before = self.segments(rung)[segment - 1].parts.end - 1;
        let first = self.segments(rung)[segment].parts.start;
        let between = &self.network.wiring.rungs[rung].parts[before + 1..first];
        let told = between.iter().any(|part| part.kind == PartKind::StrayBar);
        if !self.live[rung][before] || told {
            return None;
        }
        let start = self.parse.line_start(self.network.line(rung));
        let gap = TextRange::new(
            self.part(rung, before).range.end(),
            self.part(rung, first).range.start(),
        );
        // Comments stay, as wire.
        let comments = between.iter().filter(|part| part.kind == PartKind::Comment);
        let mut edits = Vec::new();
        let mut at = gap.start();
        for end in comments
            .map(|part| part.range)
            .chain([TextRange::empty(gap.end())])
        {
            let blank = TextRange::new(at, end.start());
            if !blank.is_empty() {
                edits.push(Edit {
                    range: blank + start,
                    text: "-".repeat(blank.len().into()),
                });
            }
            at = end.end();
        }
        let mut found = Diagnostic::new(
            RULE,
            gap + start,
            "the wire is cut here: no power can reach what is after",
        )
        .help("a blank or a `|` breaks a wire: draw it through with `-`");
        // A single blank in a wire is a slip. Where more is missing, a connector may be missing.
        let starts_with_connector = matches!(self.part(rung, first).kind, PartKind::Down | PartKind::Up);
        let is_slip = gap.len() == TextSize::new(1) && between.is_empty() && !starts_with_connector;
        let applicability = if is_slip {
            Applicability::Safe
        } else {
            Applicability::Unsafe
        };
        // A bar is there for something: what, its drawing does not say.
        if between.iter().all(|part| part.kind == PartKind::Comment) {
            found.fixes.push(Fix::new(applicability, "Join the wire", edits));
        }
        Some(found)
    }

    /// Lets the line begin at the left rail. It may be meant to get its power through a connector, or none.
    fn with_rail(&self, rung: usize, found: Diagnostic) -> Diagnostic {
        let first = &self.network.wiring.rungs[rung].parts[self.segments(rung)[0].parts.start];
        let start = self.parse.line_start(self.network.line(rung));
        let title = "Begin at the left rail";
        let bar = &self.network.wiring.rungs[rung].parts[0];
        if bar.kind == PartKind::Bar {
            let before = TextRange::new(bar.range.start(), first.range.start());
            let dashes = usize::from(before.len()).saturating_sub(1).max(1);
            let text = format!("+{}", "-".repeat(dashes));
            return found.fix(Applicability::Unsafe, title, before + start, text);
        }
        let at: TextSize = first.range.start() + start;
        let rail = if first.kind == PartKind::Wire { "+" } else { "+--" };
        found.fix(Applicability::Unsafe, title, TextRange::empty(at), rail)
    }
}
