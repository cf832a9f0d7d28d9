//! Giving something before a scan once.

use ladder_simulator::Session;

/// The scan for which something was given last.
#[derive(Debug, Default)]
pub(crate) struct Once {
    given_for: Option<u64>,
}

impl Once {
    /// Whether it is to be given before the next scan, from now on no more: not twice for one scan, and not where the
    /// history gives it again.
    pub(crate) fn is_due(&mut self, session: &Session) -> bool {
        let scan = session.simulation().scans();
        if session.scans_ahead() > 0 || self.given_for == Some(scan) {
            return false;
        }
        self.given_for = Some(scan);
        true
    }
}
