//! What a person can ask an assistant for with a word.

use super::given::Given;
use rmcp::model::{GetPromptResult, Prompt, PromptArgument, PromptMessage, Role};

struct Template {
    name: &'static str,
    about: &'static str,
    /// The names of what is filled in, with what each is.
    arguments: &'static [(&'static str, &'static str)],
    text: &'static str,
}

const TEMPLATES: [Template; 3] = [
    Template {
        name: "review_change",
        about: "Review a change of a program: what does it do now that it did not?",
        arguments: &[
            ("old", "the old program, as in HEAD:motor.clad"),
            ("new", "the new program"),
        ],
        text: "Review the change from {old} to {new} of a ladder program.\n\
               1. `diff` them; for each edited network say in one sentence what it does otherwise, in the words of the machine.\n\
               2. Run the scenarios and proofs next to it (`test`, `prove`).\n\
               3. Name what could hurt a person or the machine: an output that stays on, a stop that does not win, a lock between two contactors \
               that is gone, a delay that begins again. Try each with `simulate` before you claim it, and give the inputs that show it.\n\
               Do not praise, and do not change files.",
    },
    Template {
        name: "write_scenarios",
        about: "Write scenarios for a program",
        arguments: &[("path", "the program")],
        text: "Write scenarios for {path} in a file of the same name that ends in .ladder-test.\n\
               Read the program and the resource ladder://guide first. Write what the machine is to do, and not what the rungs happen to do: \
               starting, stopping, what wins when both are pressed, timers at their ends, and what happens after a fault. Add properties for \
               what must never happen. Align it with `format`, run `test` and `prove`, and where one fails decide whether the scenario or \
               the program is wrong, and say so.",
    },
    Template {
        name: "explain_rung",
        about: "Explain a rung in the words of the machine",
        arguments: &[("path", "the program"), ("line", "the line of the rung")],
        text: "Explain the rung at line {line} of {path} to an electrician who knows relays and has not seen this program.\n\
               Draw it (`render`), look up what you are not sure of (`explain`), and run it in a `session` with the inputs that make its output \
               come and go. Say what makes it come, what keeps it, what takes it away, and what wins.",
    },
];

/// As clients list them.
pub(super) fn all() -> Vec<Prompt> {
    let prompt = |template: &Template| {
        let arguments = template.arguments.iter().map(|(name, about)| {
            PromptArgument::new(*name)
                .with_description(*about)
                .with_required(true)
        });
        Prompt::new(template.name, Some(template.about), Some(arguments.collect()))
    };
    TEMPLATES.iter().map(prompt).collect()
}

/// One of them, filled in.
///
/// # Errors
/// There is none of this name, or something is missing.
pub(super) fn of(name: &str, given: &Given) -> Result<GetPromptResult, String> {
    let template = TEMPLATES.iter().find(|template| template.name == name);
    let template = template.ok_or_else(|| format!("there is no prompt `{name}`"))?;
    let mut text = template.text.to_owned();
    for (name, _) in template.arguments {
        text = text.replace(&format!("{{{name}}}"), given.needed(name)?);
    }
    let message = PromptMessage::new_text(Role::User, text);
    Ok(GetPromptResult::new(vec![message]).with_description(template.about))
}
