//! What the adapter can do, as it says at the beginning.

use serde_json::{Value as Json, json};

use crate::running::{EXPECTATIONS, FAULTS, PROPERTIES};

/// The answer to `initialize`.
pub(crate) fn capabilities() -> Json {
    json!({
        "supportsConfigurationDoneRequest": true,
        "supportsConditionalBreakpoints": true,
        "supportsHitConditionalBreakpoints": true,
        "supportsLogPoints": true,
        "supportsBreakpointLocationsRequest": true,
        "supportsDataBreakpoints": true,
        "supportsStepBack": true,
        "supportsSteppingGranularity": true,
        "supportsRestartRequest": true,
        "supportsTerminateRequest": true,
        "supportsSetVariable": true,
        "supportsSetExpression": true,
        "supportsEvaluateForHovers": true,
        "supportsClipboardContext": true,
        "supportsCompletionsRequest": true,
        "completionTriggerCharacters": [".", "$"],
        "supportsExceptionInfoRequest": true,
        "supportsExceptionFilterOptions": true,
        "exceptionBreakpointFilters": [
            {
                "filter": FAULTS,
                "label": "Faults",
                "description": "Stops after a block that meets a fault: a division by zero, an index outside its array",
                "default": true,
            },
            {
                "filter": EXPECTATIONS,
                "label": "Failed expectations",
                "description": "Stops after the first step of a scenario that does not come out as expected",
                "default": true,
            },
            {
                "filter": PROPERTIES,
                "label": "Violated properties",
                "description": "Stops after a scan that violates a property, if the one before it did not",
                "default": true,
            },
        ],
    })
}
