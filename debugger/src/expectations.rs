//! Expectations of a scenario that are not met: the program is shown at the block that wrote the wrong value.

use ladder_analysis::program::Location;
use ladder_simulator::{Cause, Point, Session, Stepped};
use ladder_syntax::TextRange;

use crate::adapter::Adapter;
use crate::running::{EXPECTATIONS, Stopped};
use crate::target::Target;

impl Adapter {
    /// After a step of a scenario: what did not come out as expected.
    pub(crate) fn check_expectations(&mut self) -> Option<Stopped> {
        let target = self.target.as_mut()?;
        let unmet = target.play.as_mut()?.unmet(&target.session);
        let play = target.play.as_ref()?;
        let first = unmet.first()?.clone();
        let scans = target.simulation().scans();
        let step = play.step(scans.saturating_sub(1));
        let lines: Vec<(String, TextRange)> = unmet
            .into_iter()
            .map(|unmet| (format!("step {step}: {}\n", unmet.message), unmet.range))
            .collect();
        let description = format!(
            "{} in step {step} ({})",
            first.message,
            play.file.place_name(first.range)
        );
        for (line, range) in lines {
            self.write_in(&line, range, |target| target.play.as_ref().map(|play| &play.file));
        }
        if !self.stops_at_expectations || self.configuration.no_debug {
            return None;
        }
        let target = self.target.as_mut()?;
        let place = target.session.find(&first.tag).ok().and_then(|point| {
            let writer = writer_of(&mut target.session, &point)?;
            go_after(target, writer, &point);
            Some(writer)
        });
        self.judged = Some(scans);
        Some(Stopped {
            exception: Some(EXPECTATIONS),
            place,
            ..Stopped::because("exception", description)
        })
    }
}

/// The block that wrote a point last; of a point that none has written the last one that could. None where the value is
/// not the program's.
fn writer_of(session: &mut Session, point: &Point) -> Option<Location> {
    let why = session.why(point);
    match (why.now, why.cause) {
        (Some(write), _) | (None, Cause::Block(write)) => Some(write.block),
        (None, Cause::Initial | Cause::Unknown) => session.writers_of(point).pop(),
        (None, Cause::Given | Cause::Forced | Cause::System) => None,
    }
}

/// Runs the scan that has ended again, up to right after a block that wrote a point. Where the scan is not kept, or the block
/// was not run in it, the program stays at the end of the scan.
fn go_after(target: &mut Target, writer: Location, point: &Point) {
    if target.session.step_back(1) == 0 {
        return;
    }
    // Of a body that runs for several instances the one that has the point counts.
    let (mut own, mut any) = (None, None);
    while let Stepped::At(_) = target.session.step_block() {
        let activations = target.activations();
        let Some(innermost) = activations.first().filter(|it| it.location == writer) else {
            continue;
        };
        let here = Some((target.simulation().blocks_done(), activations.len()));
        let is_own = target.instance_of(innermost).is_none_or(|instance| {
            let member = point.name.strip_prefix(&instance.name);
            member.is_some_and(|member| member.starts_with('.'))
        });
        any = here;
        own = if is_own { here } else { own };
    }
    let Some((done, depth)) = own.or(any) else {
        return;
    };
    target.session.step_back(1);
    while let Stepped::At(_) = target.session.step_block() {
        if target.simulation().blocks_done() > done && target.activations().len() <= depth {
            return;
        }
    }
}
