//! The requests about breakpoints and exceptions.

use std::path::Path;

use serde_json::{Value as Json, json};

use crate::adapter::{Adapter, no_program};
use crate::breakpoint_places;
use crate::messages::{
    BreakpointLocations, DataBreakpointInfo, SetBreakpoints, SetDataBreakpoints, SetExceptionBreakpoints,
    SourceBreakpoint,
};
use crate::running::{EXPECTATIONS, FAULTS, PROPERTIES};
use crate::variables;

/// The answer to breakpoints that are asked for by the name of a function or by an address.
pub(crate) fn not_by_name(arguments: &Json) -> Json {
    let asked = arguments["breakpoints"].as_array().map_or(0, Vec::len);
    let refused = json!({
        "verified": false,
        "message": "a breakpoint is in a line: set one at the first rung of the function or block",
    });
    json!({"breakpoints": vec![refused; asked]})
}

impl Adapter {
    /// Sets the places for the engine where it is to stop.
    pub(crate) fn arm(&mut self) {
        let Some(target) = &mut self.target else {
            return;
        };
        if self.configuration.no_debug {
            target.session.clear_breakpoints();
        } else {
            self.table.arm(target);
        }
    }

    pub(crate) fn set_breakpoints(&mut self, arguments: &SetBreakpoints) -> Result<Json, String> {
        let of_line = |&line: &i64| SourceBreakpoint {
            line,
            ..SourceBreakpoint::default()
        };
        let wanted = match &arguments.breakpoints {
            Some(breakpoints) => breakpoints.clone(),
            None => arguments.lines.iter().map(of_line).collect(),
        };
        let target = self.target.as_ref().ok_or_else(no_program)?;
        let path = arguments.source.path.as_deref().unwrap_or_default();
        let Some(file) = target.file_of(Path::new(path)) else {
            let reported = wanted.iter().map(|wanted| {
                json!({
                    "verified": false, "line": wanted.line,
                    "message": "the program that runs uses nothing of this file",
                })
            });
            return Ok(json!({"breakpoints": reported.collect::<Vec<_>>()}));
        };
        let reported = self.table.set_in_file(target, file, wanted, self.counting);
        self.arm();
        Ok(json!({"breakpoints": reported}))
    }

    pub(crate) fn breakpoint_locations(&mut self, arguments: &BreakpointLocations) -> Result<Json, String> {
        let counting = self.counting;
        let target = self.target()?;
        let path = arguments.source.path.as_deref().unwrap_or_default();
        let Some(file) = target.file_of(Path::new(path)) else {
            return Ok(json!({"breakpoints": []}));
        };
        let last = target.source(file).line_count();
        let first = counting.line(arguments.line);
        let end = arguments
            .end_line
            .map_or(first, |line| counting.line(line))
            .min(last);
        Ok(json!({"breakpoints": breakpoint_places::lines(target, file, first..=end.max(first), counting)}))
    }

    pub(crate) fn data_breakpoint_info(&mut self, arguments: &DataBreakpointInfo) -> Result<Json, String> {
        let point = match arguments.variables_reference.filter(|&reference| reference > 0) {
            // A client asks before it opens a menu. Where the next stop has come meanwhile that is not an error to tell a person.
            Some(reference) => match self.handles.get(reference) {
                Ok(container) => variables::point_in(self.target()?, &container, &arguments.name),
                Err(problem) => Err(problem),
            },
            None => self.target()?.scope(arguments.frame_id).resolve(&arguments.name),
        };
        Ok(match point {
            Ok(point) => json!({
                "dataId": point.name,
                "description": format!("{} changes", point.name),
                "accessTypes": ["write"],
                "canPersist": true,
            }),
            Err(problem) => json!({"dataId": null, "description": problem}),
        })
    }

    pub(crate) fn set_data_breakpoints(&mut self, arguments: &SetDataBreakpoints) -> Result<Json, String> {
        let target = self.target.as_ref().ok_or_else(no_program)?;
        let reported = self.table.set_data(target, arguments.breakpoints.clone());
        self.arm();
        Ok(json!({"breakpoints": reported}))
    }

    pub(crate) fn set_exception_breakpoints(
        &mut self,
        arguments: &SetExceptionBreakpoints,
    ) -> Result<Json, String> {
        let options = arguments
            .filter_options
            .iter()
            .map(|option| option.filter_id.as_str());
        let filters: Vec<&str> = arguments
            .filters
            .iter()
            .map(String::as_str)
            .chain(options)
            .collect();
        if let Some(unknown) = filters
            .iter()
            .find(|filter| ![FAULTS, EXPECTATIONS, PROPERTIES].contains(filter))
        {
            return Err(format!(
                "there is no filter `{unknown}`: there are {FAULTS}, {EXPECTATIONS} and {PROPERTIES}"
            ));
        }
        self.stops_at_faults = filters.contains(&FAULTS);
        self.stops_at_expectations = filters.contains(&EXPECTATIONS);
        self.stops_at_violations = filters.contains(&PROPERTIES);
        Ok(Json::Null)
    }

    pub(crate) fn exception_info(&mut self) -> Result<Json, String> {
        let exception = self
            .stopped
            .as_ref()
            .and_then(|stopped| Some((stopped.exception?, &stopped.description)));
        let (kind, description) = exception.ok_or("the program did not stop for a fault")?;
        let id = match kind {
            FAULTS => "Fault",
            PROPERTIES => "Property violated",
            _ => "Expectation failed",
        };
        Ok(json!({"exceptionId": id, "description": description, "breakMode": "always"}))
    }
}
