//! How a simulation is, in one line of words for status bars.

use ladder_simulator::chart::duration;

use crate::action::Pace;
use crate::messages::{State, Status};

const STALE: &str = ", before the errors in the text";

/// `running, scan 12, 1.2s, 0.1x speed, 2 forced, 1 fault, before the errors in the text`
pub fn status_text(state: &State, pace: Pace) -> String {
    let status = match state.status {
        Status::Paused => "paused",
        Status::Running => "running",
        Status::Ended => "ended",
        Status::Faulted => "faulted",
    };
    if let Some(controller) = &state.controller {
        let status = if state.status == Status::Running {
            "online"
        } else {
            status
        };
        let mut text = format!("{status} {}, {}", controller.name, controller.text);
        if state.stale {
            text.push_str(STALE);
        }
        return text;
    }
    let time = duration((state.time_ms * 1e6).round() as i64);
    let mut text = format!("{status}, scan {}, {time}", state.scan);
    match pace {
        Pace::Full => text.push_str(", full speed"),
        pace if pace == Pace::default() => {}
        Pace::Times(speed) => text.push_str(&format!(", {speed}x speed")),
    }
    if state.forced > 0 {
        text.push_str(&format!(", {} forced", state.forced));
    }
    if let Some(served) = &state.served {
        text.push_str(&format!(", {served}"));
    }
    match state.faults.len() {
        0 => {}
        1 => text.push_str(", 1 fault"),
        more => text.push_str(&format!(", {more} faults")),
    }
    if state.stale {
        text.push_str(STALE);
    }
    text
}
