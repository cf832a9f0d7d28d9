//! `textDocument/completion` and `completionItem/resolve`.

use std::path::Path;
use std::sync::Arc;

use ladder_analysis::context::Context;
use ladder_documents::{Kind, Revision};
use ladder_ide::{Completion, CompletionKind, Profile, Topic};
use ladder_picture::scene::THEME_VALUES;
use ladder_syntax::{TextRange, TextSize};
use ladder_workspace::is_program;
use serde_json::{Value, json};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{
    Command, CompletionItem, CompletionItemKind, CompletionItemLabelDetails, CompletionList,
    CompletionOptions, CompletionParams, CompletionResponse, CompletionTextEdit, Documentation,
    InsertTextFormat, InsertTextMode, Position, Range, TextEdit,
};

use super::of_scenarios::{about_scenarios, naming_at, scene_attributes};
use crate::lsp::session::commands::CUT;
use crate::lsp::transport::blocking::blocking;
use crate::lsp::{convert, markup, session::agreed::Agreed, session::shared::Shared};

/// The characters that open a list by themselves. Which of them do so in which place is for `ladder-ide` to say.
const TRIGGERS: [&str; 8] = ["[", "(", "<", ".", "$", "%", ",", ":"];

/// This many files of a folder are checked.
const MOST_FILES: usize = 10_000;

/// What the server offers. A client that cannot ask for documentation later is not asked to: some wait for the answer
/// before they insert what was accepted.
pub(crate) fn options(agreed: Agreed) -> CompletionOptions {
    CompletionOptions {
        trigger_characters: Some(TRIGGERS.map(str::to_owned).to_vec()),
        resolve_provider: Some(!agreed.documented_at_once),
        ..CompletionOptions::default()
    }
}

pub(crate) async fn completion(
    shared: &Arc<Shared>,
    params: CompletionParams,
) -> Result<Option<CompletionResponse>> {
    let place = params.text_document_position;
    let trigger = params.context.and_then(|context| context.trigger_character);
    let trigger = trigger.and_then(|trigger| trigger.chars().next());
    let agreed = shared.agreed();
    if let Some(revision) = naming_at(shared, &place.text_document.uri) {
        return in_scenarios(shared, revision, place.position, trigger).await;
    }
    let Some(revision) = shared.documents.get(place.text_document.uri.as_str()) else {
        return Ok(None);
    };
    let next_to = Arc::clone(shared);
    blocking(&*shared.host, move |_| {
        let (context, knows_others) = revision.first_context()?;
        let offset = revision.offset(convert::our_position(place.position));
        let found = ladder_ide::completions(context, offset, trigger);
        let mut proposed = Proposed::new(agreed, &revision, offset);
        let items = found.items.into_iter().map(|item| {
            let documentation = agreed
                .documented_at_once
                .then(|| card(agreed, &revision, context, &item.topic))
                .flatten();
            CompletionItem {
                documentation,
                ..proposed.item(item)
            }
        });
        let items = items.collect();
        // A list that may be longer is asked for again with each key, and is not shown before that is answered. Who types faster
        // than the answers come would never see one: what comes late is narrowed by the editor itself.
        let is_late = !next_to.documents.shows(&revision);
        Some(CompletionResponse::List(CompletionList {
            is_incomplete: (found.cut || !knows_others) && !is_late,
            items,
        }))
    })
    .await
}

/// As for a program, but that tags are documented at once: they are those of another file.
async fn in_scenarios(
    shared: &Arc<Shared>,
    revision: Arc<Revision>,
    position: Position,
    trigger: Option<char>,
) -> Result<Option<CompletionResponse>> {
    let agreed = shared.agreed();
    about_scenarios(shared, revision, move |asked| {
        let offset = asked.offset(position);
        let found = if asked.revision.kind() == Kind::Scene {
            let asking = (THEME_VALUES.as_slice(), trigger);
            ladder_ide::scene_completions(&asked.read(), offset, &scene_attributes(), asking)
        } else {
            let programs = programs_next_to(&asked.revision);
            ladder_ide::scenario_completions(&asked.read(), offset, &programs, trigger)
        };
        let mut proposed = Proposed::new(agreed, &asked.revision, offset);
        let items = found.items.into_iter().map(|item| {
            let documentation = match (&item.topic, &asked.program) {
                (Topic::Words(words), _) => Some(markup::documentation(
                    agreed.completion_markdown,
                    (*words).to_owned(),
                )),
                (topic, Some(program)) => program
                    .revision
                    .context()
                    .and_then(|context| card(agreed, &program.revision, context, topic)),
                _ => None,
            };
            CompletionItem {
                documentation,
                data: None,
                ..proposed.item(item)
            }
        });
        Some(CompletionResponse::List(CompletionList {
            is_incomplete: found.cut,
            items: items.collect(),
        }))
    })
    .await
}

/// The programs in the folder of a scenario file, by name.
fn programs_next_to(revision: &Revision) -> Vec<String> {
    let Some(place) = revision.place() else {
        return Vec::new();
    };
    let folder = place.path.parent().unwrap_or(Path::new(""));
    let names = place.neighbours.disk().names_in(folder, MOST_FILES).into_iter();
    let mut programs: Vec<String> = names.filter(|name| is_program(Path::new(name))).collect();
    programs.sort_unstable();
    programs
}

/// Proposals on their way to the protocol.
struct Proposed<'r> {
    agreed: Agreed,
    revision: &'r Revision,
    cursor: TextSize,
    count: usize,
    /// The last range, and the same in the protocol's terms: nearly all proposals replace the same one.
    last_range: Option<(TextRange, Range)>,
}

impl Proposed<'_> {
    fn new(agreed: Agreed, revision: &Revision, cursor: TextSize) -> Proposed<'_> {
        Proposed {
            agreed,
            revision,
            cursor,
            count: 0,
            last_range: None,
        }
    }

    fn range(&mut self, range: TextRange) -> Range {
        if let Some((last, converted)) = self.last_range
            && last == range
        {
            return converted;
        }
        let converted = convert::range_in(self.revision, range);
        self.last_range = Some((range, converted));
        converted
    }

    /// The next one in the list.
    fn item(&mut self, item: Completion) -> CompletionItem {
        let Proposed {
            agreed,
            revision,
            cursor,
            ..
        } = *self;
        let as_snippet = agreed.snippets && !item.text.is_word();
        let new_text = if as_snippet {
            item.text.snippet()
        } else {
            item.text.plain()
        };
        let several_lines = new_text.contains('\n');
        let after = TextRange::new(cursor, item.range.end());
        let cut = agreed.cuts_after && !after.is_empty();
        let range = if cut {
            TextRange::new(item.range.start(), cursor)
        } else {
            item.range
        };
        let index = self.count;
        self.count += 1;
        CompletionItem {
            command: cut.then(|| Command {
                title: "Take the place of what is after".to_owned(),
                command: CUT.to_owned(),
                arguments: Some(vec![what_to_cut(revision, after)]),
            }),
            kind: Some(kind(item.kind)),
            // Where it is known, each row of the list shows it, not only the one that is selected.
            label_details: agreed.label_details.then(|| CompletionItemLabelDetails {
                description: Some(item.detail.clone()),
                ..CompletionItemLabelDetails::default()
            }),
            detail: Some(item.detail).filter(|detail| !detail.is_empty()),
            sort_text: Some(format!("{index:03}")),
            filter_text: Some(item.filter),
            insert_text_format: as_snippet.then_some(InsertTextFormat::SNIPPET),
            insert_text_mode: several_lines.then_some(InsertTextMode::AS_IS),
            text_edit: Some(CompletionTextEdit::Edit(TextEdit {
                range: self.range(range),
                new_text,
            })),
            data: data(revision, &item.topic),
            label: item.label,
            ..CompletionItem::default()
        }
    }
}

/// A stretch of a line, and what is after it.
fn what_to_cut(revision: &Revision, range: TextRange) -> Value {
    let after = revision.rest_of_line(range.end());
    json!({ "cut": revision.stretch(range.into()), "before": after })
}

const fn kind(kind: CompletionKind) -> CompletionItemKind {
    match kind {
        CompletionKind::Instruction | CompletionKind::Function => CompletionItemKind::FUNCTION,
        CompletionKind::UserBlock => CompletionItemKind::CLASS,
        CompletionKind::Tag => CompletionItemKind::VARIABLE,
        CompletionKind::Constant => CompletionItemKind::CONSTANT,
        CompletionKind::Member => CompletionItemKind::FIELD,
        CompletionKind::Label => CompletionItemKind::REFERENCE,
        CompletionKind::Keyword => CompletionItemKind::KEYWORD,
        CompletionKind::Type => CompletionItemKind::STRUCT,
        CompletionKind::Operand => CompletionItemKind::PROPERTY,
        CompletionKind::Operator => CompletionItemKind::OPERATOR,
        CompletionKind::Value => CompletionItemKind::VALUE,
        CompletionKind::Drawing => CompletionItemKind::SNIPPET,
    }
}

/// What leads to the documentation, once the proposal is looked at.
fn data(revision: &Revision, topic: &Topic) -> Option<Value> {
    let uri = &*revision.uri;
    Some(match topic {
        Topic::Nothing => return None,
        Topic::Instruction(op, Profile::Iec) => json!({ "instruction": *op as usize }),
        Topic::Instruction(op, profile) => json!({ "instruction": *op as usize, "profile": profile.name() }),
        Topic::UserBlock(name) => json!({ "uri": uri, "block": name }),
        Topic::Tag(scope, name) => json!({ "uri": uri, "scope": scope, "tag": name }),
        Topic::Keyword(word) => json!({ "keyword": word }),
        Topic::Words(words) => json!({ "words": words }),
    })
}

pub(crate) async fn resolve(shared: &Arc<Shared>, mut item: CompletionItem) -> Result<CompletionItem> {
    let Some(data) = item.data.take() else {
        return Ok(item);
    };
    item.documentation = documentation(shared, data).await?;
    Ok(item)
}

async fn documentation(shared: &Arc<Shared>, data: Value) -> Result<Option<Documentation>> {
    let markdown = shared.agreed().completion_markdown;
    if let Some(words) = data["words"].as_str() {
        return Ok(Some(markup::documentation(markdown, words.to_owned())));
    }
    let text = |name: &str| data[name].as_str().map(str::to_owned);
    let number = |name: &str| {
        data[name]
            .as_u64()
            .and_then(|number| usize::try_from(number).ok())
    };
    let profile = text("profile").and_then(|name| Profile::from_name(&name));
    let instruction =
        number("instruction").and_then(|number| Topic::instruction(number, profile.unwrap_or_default()));
    let topic = if let Some(topic) = instruction {
        topic
    } else if let Some(word) = text("keyword") {
        Topic::Keyword(word)
    } else if let Some(name) = text("block") {
        Topic::UserBlock(name)
    } else if let (Some(name), Some(scope)) = (text("tag"), number("scope")) {
        Topic::Tag(scope, name)
    } else {
        return Ok(None);
    };
    if let Topic::Instruction(..) | Topic::Keyword(_) = topic {
        let card = ladder_ide::card(&topic);
        return Ok(card.map(|card| markup::documentation(markdown, card)));
    }
    let Some(revision) = text("uri").and_then(|uri| shared.documents.get(&uri)) else {
        return Ok(None);
    };
    let agreed = shared.agreed();
    blocking(&*shared.host, move |_| {
        let (context, _) = revision.first_context()?;
        card(agreed, &revision, context, &topic)
    })
    .await
}

/// What a topic of a text is documented by.
fn card(agreed: Agreed, revision: &Revision, context: &Context, topic: &Topic) -> Option<Documentation> {
    let card = ladder_ide::documentation(context, topic)?;
    Some(markup::documentation(
        agreed.completion_markdown,
        markup::linked(card, &revision.uri),
    ))
}
