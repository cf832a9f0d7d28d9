//! Answers in words.

use crate::answer::{Answer, Times, Verdict};
use ladder_simulator::value_text::duration;
use ladder_syntax::numeral::counted;

impl Verdict {
    /// The word for it.
    pub const fn word(&self) -> &'static str {
        match self {
            Verdict::Proved(_) => "proved",
            Verdict::Violated(_) => "violated",
            Verdict::Possible(_) => "possible",
            Verdict::Impossible(_) => "impossible",
            Verdict::Unknown(_) => "unknown",
            Verdict::Vacuous => "vacuous",
        }
    }

    /// For which times it is proved: `any` or `exact`.
    pub const fn times(&self) -> Option<&'static str> {
        match self {
            Verdict::Proved(Times::Any) | Verdict::Impossible(Times::Any) => Some("any"),
            Verdict::Proved(Times::Exact) | Verdict::Impossible(Times::Exact) => Some("exact"),
            _ => None,
        }
    }

    /// The scan that violates or has it, from 0.
    pub fn scan(&self) -> Option<usize> {
        match self {
            Verdict::Violated(shown) | Verdict::Possible(shown) => shown.scans().checked_sub(1),
            _ => None,
        }
    }
}

impl Answer {
    /// The text next to the name. `interval`: between two scans, in nanoseconds.
    pub fn note(&self, interval: i64) -> String {
        match &self.verdict {
            Verdict::Proved(Times::Any) | Verdict::Impossible(Times::Any) => "for any times".into(),
            Verdict::Proved(Times::Exact) | Verdict::Impossible(Times::Exact) => {
                format!("for an interval of {}", duration(interval))
            }
            Verdict::Violated(_) | Verdict::Possible(_) => {
                let scan = self.verdict.scan().unwrap_or(0);
                let time = interval.saturating_mul(scan as i64);
                format!("in scan {scan}, at {}", duration(time))
            }
            Verdict::Unknown(0) => String::new(),
            Verdict::Unknown(scans) => format!("no such run in {}", counted(*scans, "scan")),
            Verdict::Vacuous => "what is assumed cannot hold in the first scan".into(),
        }
    }
}

/// The rows of a [run](crate::found_scenario), without its name.
pub fn drawn(scenario: &str) -> String {
    scenario.lines().skip(1).collect::<Vec<&str>>().join("\n")
}
