//! Code actions about properties: a run that violates one is written as a scenario, and what excludes each other in a program is
//! proposed as a property of its file of scenarios.

use std::sync::Arc;

use ladder_analysis::context::Context;
use ladder_documents::{Revision, address, position};
use ladder_ide::{Exclusive, exclusive_outputs, place_of_new_property};
use ladder_simulator::scenario::{self, Suite};
use ladder_simulator::value_text;
use ladder_syntax::{TextRange, TextSize};
use ropey::Rope;
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{
    CodeAction, CodeActionKind, CodeActionOrCommand, CodeActionParams, CodeActionResponse, CreateFile,
    DocumentChangeOperation, DocumentChanges, OneOf, OptionalVersionedTextDocumentIdentifier, ResourceOp,
    TextDocumentEdit, TextEdit, Uri, WorkspaceEdit,
};

use super::code_action::wanted;
use super::of_scenarios::{AskedScenarios, about_scenarios};
use crate::lsp::documents::companions::{compiled, violated};
use crate::lsp::session::agreed::Agreed;
use crate::lsp::session::proofs::ProgramText;
use crate::lsp::{convert, session::shared::Shared};
use crate::proof::PropertyProved;

/// The actions in a file of scenarios.
pub(super) async fn code_action(
    shared: &Arc<Shared>,
    revision: Arc<Revision>,
    params: CodeActionParams,
) -> Result<Option<CodeActionResponse>> {
    if !wanted(&params.context, &CodeActionKind::QUICKFIX) {
        return Ok(None);
    }
    let next_to = shared.clone();
    about_scenarios(shared, revision, move |asked| {
        let range = convert::our_range(params.range);
        let (first, last) = (range.start.line, range.end.line);
        let mut actions = counterexamples(&next_to, asked, first..=last);
        actions.extend(proposed_here(&next_to, asked, first..=last));
        Some(actions.into_iter().map(CodeActionOrCommand::CodeAction).collect())
    })
    .await
}

/// The runs of properties that are violated in these lines, each as a scenario at the end of the file.
fn counterexamples(
    shared: &Shared,
    asked: &AskedScenarios,
    lines: std::ops::RangeInclusive<u32>,
) -> Vec<CodeAction> {
    let scenarios = asked.read();
    let program = asked
        .program
        .as_ref()
        .and_then(|program| program.revision.place());
    let Some(place) = program else { return Vec::new() };
    let program = || {
        let file = address::path_of(&asked.revision.uri)?;
        let simulation = compiled(shared, &place.path, (&file, scenarios.suite)).ok()?;
        Some(ProgramText::of(&simulation))
    };
    let known = shared.proofs.of(&asked.revision, program);
    let here = known.iter().filter(|it| {
        !it.scenario.is_empty()
            && (it.range.start.line..=it.range.end.line + 1).any(|line| lines.contains(&line))
    });
    let action = |property: &PropertyProved| {
        let edit = TextEdit {
            range: convert::range_in(&asked.revision, TextRange::empty(TextSize::of(scenarios.text))),
            new_text: appended(scenarios.text, scenarios.suite, property)?,
        };
        let uri = convert::uri(&asked.revision.uri)?;
        Some(CodeAction {
            title: if property.is_refuted() {
                "Write the counterexample as a scenario".to_owned()
            } else {
                "Write the run as a scenario".to_owned()
            },
            kind: Some(CodeActionKind::QUICKFIX),
            diagnostics: property.is_refuted().then(|| vec![violated(property)]),
            edit: Some(
                shared
                    .agreed()
                    .edit_of_files([(uri, Some(asked.revision.version), vec![edit])]),
            ),
            ..CodeAction::default()
        })
    };
    here.filter_map(action).collect()
}

/// What is written after a text for the run of a property. Its columns are scans, whatever the steps of the file are.
fn appended(text: &str, suite: &Suite, property: &PropertyProved) -> Option<String> {
    let alone = scenario::parse(&property.scenario);
    let (found, (interval, _)) = (alone.scenarios.first()?, alone.interval?);
    let begin = usize::from(found.range.end());
    let mut rows = property.scenario[begin..].to_owned();
    if suite.step.is_some_and(|(step, _)| step != interval) {
        rows = with_times(&rows, &value_text::duration(interval), found.steps);
    }
    let is_taken = |name: &str| suite.scenarios.iter().any(|other| other.name == name);
    let numbered = (2..).map(|number| format!("{} {number}", found.name));
    let name = std::iter::once(found.name.clone())
        .chain(numbered)
        .find(|name| !is_taken(name))?;
    let scenario = scenario::layout(&format!("scenario \"{name}\"{rows}"));
    let between = match text {
        text if text.ends_with("\n\n") => "",
        text if text.ends_with('\n') => "\n",
        _ => "\n\n",
    };
    Some(format!("{between}{scenario}"))
}

/// The rows of a scenario whose steps are scans, for a file that has other steps: how long each is, is reported.
fn with_times(rows: &str, scan: &str, steps: usize) -> String {
    let is_time = |line: &str| line.split_whitespace().next() == Some(scenario::TIME);
    if !rows.lines().any(is_time) {
        let durations = vec![scan; steps].join(" ");
        return format!("\n{} {durations}{rows}", scenario::TIME);
    }
    let told = |line: &str| {
        if !is_time(line) {
            return line.to_owned();
        }
        let cells = line.split_whitespace();
        let cells = cells.map(|cell| if cell == "." { scan } else { cell });
        cells.collect::<Vec<_>>().join(" ")
    };
    let lines: Vec<String> = rows.lines().map(told).collect();
    lines.join("\n") + "\n"
}

/// What the program's outputs propose, next to where the file names it and its properties.
fn proposed_here(
    shared: &Shared,
    asked: &AskedScenarios,
    lines: std::ops::RangeInclusive<u32>,
) -> Vec<CodeAction> {
    let scenarios = asked.read();
    let Some(program) = scenarios.program else {
        return Vec::new();
    };
    let properties = scenarios.suite.properties.iter().map(|property| property.place);
    let program_line = scenarios.suite.program.iter().map(|(_, range)| *range);
    let is_here = |range: TextRange| lines.contains(&asked.revision.range(range).start.line);
    if !properties.chain(program_line).any(is_here) {
        return Vec::new();
    }
    let file = Target {
        uri: asked.revision.uri.to_string(),
        version: Some(asked.revision.version),
        text: Some(scenarios.text.to_owned()),
    };
    proposed(shared.agreed(), exclusive_outputs(program, None), &file, "")
}

/// What is proposed for the outputs of a program that a range touches.
pub(super) fn of_program(
    shared: &Shared,
    revision: &Revision,
    context: &Context,
    touched: TextRange,
) -> Vec<CodeAction> {
    let found = exclusive_outputs(context, Some(touched));
    let Some(place) = revision.place().filter(|_| !found.is_empty()) else {
        return Vec::new();
    };
    let path = place.path.with_extension(ladder_workspace::SCENARIO_EXTENSION);
    let uri = address::uri_of(&path);
    let open = shared.companions.get(&uri);
    let file = Target {
        text: match &open {
            Some(open) => Some(open.text()),
            None => shared.world().disk.read_own(&path).ok(),
        },
        version: open.map(|open| open.version),
        uri,
    };
    let name = place.path.file_name().unwrap_or_default().to_string_lossy();
    proposed(shared.agreed(), found, &file, &name)
}

/// A file of scenarios, which may have to be made.
struct Target {
    uri: String,
    version: Option<i32>,
    text: Option<String>,
}

fn proposed(agreed: Agreed, found: Vec<Exclusive>, file: &Target, program: &str) -> Vec<CodeAction> {
    if file.text.is_none() && !agreed.creates_files {
        return Vec::new();
    }
    let text = file.text.clone().unwrap_or_default();
    let suite = scenario::parse(&text);
    let found = found.into_iter().filter(|pair| !pair.is_stated(&suite));
    let action = |pair: Exclusive| {
        let (at, before, after) = place_of_new_property(&text, &suite);
        let head = match file.text {
            Some(_) => String::new(),
            None => scenario::program_line(program),
        };
        let before = if head.is_empty() { before } else { "\n" };
        let edit = TextEdit {
            range: convert::range(position::range(
                &Rope::from_str(&text),
                agreed.encoding,
                at.into()..at.into(),
            )),
            new_text: format!("{head}{before}{}{after}", pair.property()),
        };
        Some(CodeAction {
            title: format!("Add the property: never {} and {}", pair.one, pair.other),
            kind: Some(CodeActionKind::QUICKFIX),
            edit: Some(edit_of(agreed, file, edit)?),
            ..CodeAction::default()
        })
    };
    found.filter_map(action).collect()
}

fn edit_of(agreed: Agreed, file: &Target, edit: TextEdit) -> Option<WorkspaceEdit> {
    let uri: Uri = convert::uri(&file.uri)?;
    if file.text.is_some() {
        return Some(agreed.edit_of_files([(uri, file.version, vec![edit])]));
    }
    let create = CreateFile {
        uri: uri.clone(),
        options: None,
        annotation_id: None,
    };
    let edit = TextDocumentEdit {
        text_document: OptionalVersionedTextDocumentIdentifier { uri, version: None },
        edits: vec![OneOf::Left(edit)],
    };
    Some(WorkspaceEdit {
        document_changes: Some(DocumentChanges::Operations(vec![
            DocumentChangeOperation::Op(ResourceOp::Create(create)),
            DocumentChangeOperation::Edit(edit),
        ])),
        ..WorkspaceEdit::default()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_that_are_scans_say_so_in_a_file_with_other_steps() {
        assert_eq!(with_times("\na _-\n", "10ms", 2), "\ntime 10ms 10ms\na _-\n");
        assert_eq!(
            with_times("\ntime . 5s\na   _ -\n", "10ms", 2),
            "\ntime 10ms 5s\na   _ -\n"
        );
    }
}
