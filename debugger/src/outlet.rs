//! Messages on their way out.

use std::io;

use serde_json::{Value as Json, json};

/// Takes a message to the client; an error if that is gone.
pub type Output = Box<dyn FnMut(&Json) -> io::Result<()> + Send>;

/// Where messages go out.
pub(crate) struct Outlet {
    output: Output,
    seq: i64,
    /// The client does not take anything any more.
    is_broken: bool,
}

impl Outlet {
    pub(crate) fn new(output: Output) -> Outlet {
        Outlet {
            output,
            seq: 0,
            is_broken: false,
        }
    }

    /// Whether the client still takes messages.
    pub(crate) fn is_broken(&self) -> bool {
        self.is_broken
    }

    pub(crate) fn answer(&mut self, request: i64, command: &str, outcome: Result<Json, String>) {
        let mut message = json!({
            "type": "response",
            "request_seq": request,
            "command": command,
            "success": outcome.is_ok(),
        });
        match outcome {
            Ok(Json::Null) => {}
            Ok(body) => message["body"] = body,
            Err(problem) => {
                // A client would take braces in the format for the names of variables.
                message["body"] = json!({"error": {
                    "id": 1, "format": "{problem}", "variables": {"problem": problem}, "showUser": true,
                }});
                message["message"] = problem.into();
            }
        }
        self.send(message);
    }

    pub(crate) fn event(&mut self, event: &str, body: Json) {
        let mut message = json!({"type": "event", "event": event});
        if !body.is_null() {
            message["body"] = body;
        }
        self.send(message);
    }

    fn send(&mut self, mut message: Json) {
        self.seq += 1;
        message["seq"] = self.seq.into();
        self.is_broken |= (self.output)(&message).is_err();
    }
}
