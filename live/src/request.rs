//! The commands, from their names and arguments.

use serde::de::DeserializeOwned;
use serde_json::Value;

use crate::messages::{
    Assign, Breakpoints, Debug, GoTo, OfSession, OfTag, Past, Record, Run, Search, Serve, Show, Speed, Start,
    StepBy, Trace, Unforce,
};

/// What a client can ask for with `workspace/executeCommand`.
pub const COMMANDS: [&str; 26] = [
    "ladder.simulate.start",
    "ladder.simulate.debug",
    "ladder.simulate.step",
    "ladder.simulate.stepBlock",
    "ladder.simulate.stepRung",
    "ladder.simulate.back",
    "ladder.simulate.goTo",
    "ladder.simulate.breakpoints",
    "ladder.simulate.why",
    "ladder.simulate.history",
    "ladder.simulate.trace",
    "ladder.simulate.record",
    "ladder.simulate.run",
    "ladder.simulate.speed",
    "ladder.simulate.pause",
    "ladder.simulate.set",
    "ladder.simulate.pulse",
    "ladder.simulate.force",
    "ladder.simulate.unforce",
    "ladder.simulate.serve",
    "ladder.simulate.state",
    "ladder.simulate.show",
    "ladder.simulate.tags",
    "ladder.simulate.reset",
    "ladder.simulate.warmRestart",
    "ladder.simulate.stop",
];

/// Why a command did not do what it was to do.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Failure {
    /// The command or its argument makes no sense.
    Invalid(String),
    /// It makes sense, but cannot be done: unknown session or tag, a program with errors.
    Failed(String),
}

/// A command with its argument.
#[derive(Debug, Clone, PartialEq)]
pub enum Request {
    /// Run a document.
    Start(Start),
    /// Run a document with a debugger, or lend one a simulation that is there.
    Debug(Debug),
    /// Do some scans.
    Step(StepBy),
    /// Go on to the next block.
    StepBlock(OfSession),
    /// Go on to the next rung.
    StepRung(OfSession),
    /// Go back some scans.
    Back(StepBy),
    /// Go to the state after a scan.
    GoTo(GoTo),
    /// Stop a run at lines and tags.
    Breakpoints(Breakpoints),
    /// Say why a tag holds what it holds.
    Why(OfTag),
    /// Say what tags held in the last scans.
    History(Past),
    /// Record tags, and say what is drawn of them.
    Trace(Trace),
    /// Make a scenario of what was done so far.
    Record(Record),
    /// Scan until another command comes.
    Run(Run),
    /// Run as fast as this from now on.
    Speed(Speed),
    /// Stop scanning.
    Pause(OfSession),
    /// Give a tag a value.
    Set(Assign),
    /// Give a tag of BOOL its other value for one scan.
    Pulse(OfTag),
    /// Hold a tag at a value.
    Force(Assign),
    /// Let a tag go, or all.
    Unforce(Unforce),
    /// Serve tags to clients on this computer, or no more.
    Serve(Serve),
    /// Only answer.
    State(OfSession),
    /// Tell only of this from now on.
    Show(Show),
    /// List tags.
    Tags(Search),
    /// Start again from cold.
    Reset(OfSession),
    /// Start again with what is retentive.
    WarmRestart(OfSession),
    /// End.
    Stop(OfSession),
}

impl Request {
    /// Reads a command.
    ///
    /// # Errors
    /// There is no such command, or these are not its arguments.
    pub fn read(command: &str, arguments: Vec<Value>) -> Result<Self, Failure> {
        let argument = |arguments| argument(command, arguments);
        match command.strip_prefix("ladder.simulate.") {
            Some("start") => Ok(Request::Start(read(command, argument(arguments)?)?)),
            Some("debug") => Ok(Request::Debug(read(command, argument(arguments)?)?)),
            Some("step") => Ok(Request::Step(read(command, argument(arguments)?)?)),
            Some("stepBlock") => Ok(Request::StepBlock(read(command, argument(arguments)?)?)),
            Some("stepRung") => Ok(Request::StepRung(read(command, argument(arguments)?)?)),
            Some("back") => Ok(Request::Back(read(command, argument(arguments)?)?)),
            Some("goTo") => Ok(Request::GoTo(read(command, argument(arguments)?)?)),
            Some("breakpoints") => Ok(Request::Breakpoints(read(command, argument(arguments)?)?)),
            Some("why") => Ok(Request::Why(read(command, argument(arguments)?)?)),
            Some("history") => Ok(Request::History(read(command, argument(arguments)?)?)),
            Some("trace") => Ok(Request::Trace(read(command, argument(arguments)?)?)),
            Some("record") => Ok(Request::Record(read(command, argument(arguments)?)?)),
            Some("run") => Ok(Request::Run(read(command, argument(arguments)?)?)),
            Some("speed") => Ok(Request::Speed(read(command, argument(arguments)?)?)),
            Some("pause") => Ok(Request::Pause(read(command, argument(arguments)?)?)),
            Some("set") => Ok(Request::Set(read(command, argument(arguments)?)?)),
            Some("pulse") => Ok(Request::Pulse(read(command, argument(arguments)?)?)),
            Some("force") => Ok(Request::Force(read(command, argument(arguments)?)?)),
            Some("unforce") => Ok(Request::Unforce(read(command, argument(arguments)?)?)),
            Some("serve") => Ok(Request::Serve(read(command, argument(arguments)?)?)),
            Some("state") => Ok(Request::State(read(command, argument(arguments)?)?)),
            Some("show") => Ok(Request::Show(read(command, argument(arguments)?)?)),
            Some("tags") => Ok(Request::Tags(read(command, argument(arguments)?)?)),
            Some("reset") => Ok(Request::Reset(read(command, argument(arguments)?)?)),
            Some("warmRestart") => Ok(Request::WarmRestart(read(command, argument(arguments)?)?)),
            Some("stop") => Ok(Request::Stop(read(command, argument(arguments)?)?)),
            _ => Err(Failure::Invalid(format!(
                "there is no command {command}; the commands are {}",
                COMMANDS.join(", ")
            ))),
        }
    }
}

fn argument(command: &str, arguments: Vec<Value>) -> Result<Value, Failure> {
    match <[Value; 1]>::try_from(arguments) {
        Ok([argument @ Value::Object(_)]) => Ok(argument),
        _ => Err(Failure::Invalid(format!(
            "{command} takes exactly one argument, an object"
        ))),
    }
}

/// The one object that a command takes.
///
/// # Errors
/// It is not one object, or another one.
pub fn argument_of<T: DeserializeOwned>(command: &str, arguments: Vec<Value>) -> Result<T, Failure> {
    read(command, argument(command, arguments)?)
}

fn read<T: DeserializeOwned>(command: &str, argument: Value) -> Result<T, Failure> {
    serde_json::from_value(argument).map_err(|error| Failure::Invalid(format!("{command}: {error}")))
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn every_command_is_read() {
        for command in COMMANDS {
            let argument = match command {
                "ladder.simulate.start" => json!({"uri": "file:///a.clad"}),
                "ladder.simulate.debug" => json!({"options": {}}),
                _ => json!({"session": "s1"}),
            };
            match Request::read(command, vec![argument]) {
                Ok(_) => {}
                Err(Failure::Invalid(message)) => assert!(message.contains("missing field"), "{message}"),
                Err(failure) => panic!("{command}: {failure:?}"),
            }
        }
    }

    #[test]
    fn errors_are_named() {
        let says = |command: &str, arguments: Value| match Request::read(
            command,
            serde_json::from_value(arguments).unwrap(),
        ) {
            Err(Failure::Invalid(message)) => message,
            other => panic!("{other:?}"),
        };
        assert!(says("ladder.simulate.jump", json!([{}])).contains("the commands are ladder.simulate.start"));
        assert!(says("ladder.simulate.step", json!([])).contains("exactly one argument"));
        assert!(says("ladder.simulate.step", json!(["s1"])).contains("an object"));
        assert!(
            says("ladder.simulate.step", json!([{"session": "s1", "scan": 2}]))
                .contains("unknown field `scan`")
        );
        assert!(says("ladder.simulate.step", json!([{"session": "s1", "scans": -1}])).contains("-1"));
    }
}
