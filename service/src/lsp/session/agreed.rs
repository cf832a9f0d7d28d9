//! What the client can take.

use ladder_documents::position::Encoding;
use tower_lsp::ls_types::{
    ClientCapabilities, ClientDiagnosticsTagOptions, DiagnosticTag, GotoCapability, MarkupKind,
    PositionEncodingKind, ResourceOperationKind, TextDocumentClientCapabilities,
    WorkspaceFileOperationsClientCapabilities,
};

use super::commands::{Commands, cuts_after, renames};

/// What the client can take, as plain answers to the questions that the handlers ask.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Agreed {
    /// The unit of positions.
    pub(crate) encoding: Encoding,
    /// Diagnostics may link other places.
    pub(crate) related_information: bool,
    /// Diagnostics may be tagged, so that text without effect is shown faded.
    pub(crate) unnecessary_tag: bool,
    /// Diagnostics may carry data.
    pub(crate) diagnostic_data: bool,
    /// The pages of rules that diagnostics link can be opened: the client asks for their text.
    pub(crate) rule_pages: bool,
    /// The addresses of the library's sources can be opened: the client asks for their text.
    pub(crate) library_blocks: bool,
    /// Edits may name the version of the document that they are for.
    pub(crate) versioned_edits: bool,
    /// An edit may make files.
    pub(crate) creates_files: bool,
    /// The edits of a code action may be asked for later.
    pub(crate) resolves_edits: bool,
    /// Code actions may be shown that cannot be done, with the reason.
    pub(crate) disabled_actions: bool,
    /// After a code action that makes up a name the client can ask for another one.
    pub(crate) renames: bool,
    /// Hovers may be Markdown.
    pub(crate) markdown: bool,
    /// A place that an editor is sent to may say how far it reaches.
    pub(crate) links: Links,
    /// The client asks what would be renamed before it asks for a new name.
    pub(crate) prepares_rename: bool,
    /// Completions may have tab stops.
    pub(crate) snippets: bool,
    /// Completions may have a few words in each row of the list.
    pub(crate) label_details: bool,
    /// The documentation of completions may be Markdown.
    pub(crate) completion_markdown: bool,
    /// The documentation of completions cannot be asked for later.
    pub(crate) documented_at_once: bool,
    /// Of a completion's edit the client replaces only what is before the cursor. What is after it the client
    /// cuts with a command.
    pub(crate) cuts_after: bool,
    /// Symbols of a document may hold others.
    pub(crate) nested_symbols: bool,
    /// How many stretches of a document the client wants to fold.
    pub(crate) fold_limit: Option<u32>,
    /// The commands of lenses that the client can run.
    pub(crate) lens_commands: Commands,
    /// A semantic token may span lines.
    pub(crate) multiline_tokens: bool,
    /// Parameters of signatures may be given by their place in the label.
    pub(crate) label_offsets: bool,
    /// The documentation of signatures may be Markdown.
    pub(crate) signature_markdown: bool,
    /// The client can be asked to report changed files.
    pub(crate) watches_files: bool,
    /// The operations on files that the client reports.
    pub(crate) file_operations: Reported,
    /// The client asks for diagnostics, so none are published.
    pub(crate) pulls_diagnostics: bool,
    /// The client takes diagnostics of other files next to those that it asks for.
    pub(crate) related_documents: bool,
    /// The client can be notified that diagnostics have changed.
    pub(crate) refreshes_diagnostics: bool,
    /// The client shows progress that the server begins.
    pub(crate) progress: bool,
    /// The client can be asked for its settings.
    pub(crate) configuration: bool,
    /// The client wants to be asked to report changed settings.
    pub(crate) registers_configuration: bool,
    /// The client can be notified that inlay hints have changed.
    pub(crate) refreshes_inlay_hints: bool,
    /// The client can be notified that semantic tokens have changed.
    pub(crate) refreshes_semantic_tokens: bool,
    /// The client can be notified that code lenses have changed.
    pub(crate) refreshes_code_lenses: bool,
}

/// To which of the questions where a thing is the answer may say how far it reaches.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Links {
    pub(crate) definition: bool,
    pub(crate) declaration: bool,
    pub(crate) type_definition: bool,
    pub(crate) implementation: bool,
}

impl Links {
    fn with(document: Option<&TextDocumentClientCapabilities>) -> Self {
        let Some(document) = document else {
            return Links::default();
        };
        let takes = |it: &Option<GotoCapability>| it.and_then(|it| it.link_support).unwrap_or(false);
        Links {
            definition: takes(&document.definition),
            declaration: takes(&document.declaration),
            type_definition: takes(&document.type_definition),
            implementation: takes(&document.implementation),
        }
    }
}

impl Agreed {
    /// What follows from the client's capabilities. Bytes are the cheapest unit for the server, scalar values
    /// the next; UTF-16 is what a client has that names nothing.
    pub(crate) fn with(client: &ClientCapabilities) -> Self {
        let document = client.text_document.as_ref();
        let pull = document.and_then(|document| document.diagnostic.as_ref());
        let push = document.and_then(|document| document.publish_diagnostics.as_ref());
        let hover = document.and_then(|document| document.hover.as_ref());
        let workspace = client.workspace.as_ref();
        let edit = workspace.and_then(|workspace| workspace.workspace_edit.as_ref());
        let signature = document
            .and_then(|document| document.signature_help.as_ref())
            .and_then(|help| help.signature_information.as_ref());
        let completion = document
            .and_then(|document| document.completion.as_ref())
            .and_then(|completion| completion.completion_item.as_ref());
        let markdown = |formats: Option<&Vec<MarkupKind>>| {
            formats.is_some_and(|formats| formats.contains(&MarkupKind::Markdown))
        };
        let actions = document.and_then(|document| document.code_action.as_ref());
        let encodings = client
            .general
            .as_ref()
            .and_then(|general| general.position_encodings.as_deref());
        let offers = |encoding| encodings.is_some_and(|offered| offered.contains(&encoding));
        Agreed {
            encoding: if offers(PositionEncodingKind::UTF8) {
                Encoding::Utf8
            } else if offers(PositionEncodingKind::UTF32) {
                Encoding::Utf32
            } else {
                Encoding::Utf16
            },
            related_information: push
                .and_then(|it| it.related_information)
                .or(pull.and_then(|it| it.related_information))
                .unwrap_or(false),
            unnecessary_tag: push
                .and_then(|it| it.tag_support.as_ref())
                .is_some_and(|tags| tags.value_set.contains(&DiagnosticTag::UNNECESSARY))
                || pull
                    .and_then(|it| it.tag_support.as_ref())
                    .is_some_and(takes_unnecessary),
            diagnostic_data: push
                .and_then(|it| it.data_support)
                .or(pull.and_then(|it| it.data_support))
                .unwrap_or(false),
            rule_pages: says(client, "rulePages"),
            library_blocks: says(client, "libraryBlocks"),
            versioned_edits: edit.and_then(|it| it.document_changes).unwrap_or(false),
            creates_files: edit.is_some_and(|it| {
                let operations = it.resource_operations.as_deref().unwrap_or_default();
                it.document_changes == Some(true) && operations.contains(&ResourceOperationKind::Create)
            }),
            file_operations: Reported::by(workspace.and_then(|workspace| workspace.file_operations.as_ref())),
            pulls_diagnostics: pull.is_some(),
            related_documents: pull.and_then(|it| it.related_document_support).unwrap_or(false),
            refreshes_diagnostics: workspace
                .and_then(|workspace| workspace.diagnostics.as_ref())
                .and_then(|it| it.refresh_support)
                .unwrap_or(false),
            progress: client
                .window
                .as_ref()
                .and_then(|window| window.work_done_progress)
                .unwrap_or(false),
            configuration: workspace
                .and_then(|workspace| workspace.configuration)
                .unwrap_or(false),
            registers_configuration: workspace
                .and_then(|workspace| workspace.did_change_configuration.as_ref())
                .and_then(|it| it.dynamic_registration)
                .unwrap_or(false),
            refreshes_semantic_tokens: workspace
                .and_then(|workspace| workspace.semantic_tokens.as_ref())
                .and_then(|it| it.refresh_support)
                .unwrap_or(false),
            refreshes_inlay_hints: workspace
                .and_then(|workspace| workspace.inlay_hint.as_ref())
                .and_then(|it| it.refresh_support)
                .unwrap_or(false),
            refreshes_code_lenses: workspace
                .and_then(|workspace| workspace.code_lens.as_ref())
                .and_then(|it| it.refresh_support)
                .unwrap_or(false),
            nested_symbols: document
                .and_then(|document| document.document_symbol.as_ref())
                .and_then(|symbols| symbols.hierarchical_document_symbol_support)
                .unwrap_or(false),
            fold_limit: document
                .and_then(|document| document.folding_range.as_ref())
                .and_then(|folding| folding.range_limit),
            links: Links::with(document),
            prepares_rename: document
                .and_then(|document| document.rename.as_ref())
                .and_then(|rename| rename.prepare_support)
                .unwrap_or(false),
            watches_files: workspace
                .and_then(|workspace| workspace.did_change_watched_files.as_ref())
                .and_then(|watched| watched.dynamic_registration)
                .unwrap_or(false),
            markdown: markdown(hover.and_then(|it| it.content_format.as_ref())),
            lens_commands: Commands::of(client),
            multiline_tokens: document
                .and_then(|it| it.semantic_tokens.as_ref())
                .and_then(|it| it.multiline_token_support)
                .unwrap_or(false),
            label_offsets: signature
                .and_then(|it| it.parameter_information.as_ref())
                .and_then(|it| it.label_offset_support)
                .unwrap_or(false),
            signature_markdown: markdown(signature.and_then(|it| it.documentation_format.as_ref())),
            snippets: completion.and_then(|it| it.snippet_support).unwrap_or(false),
            label_details: completion
                .and_then(|it| it.label_details_support)
                .unwrap_or(false),
            completion_markdown: markdown(completion.and_then(|it| it.documentation_format.as_ref())),
            documented_at_once: completion.is_some_and(|it| {
                // A client from before this capability existed resolves it.
                let resolved = it.resolve_support.as_ref();
                resolved.is_some_and(|it| it.properties.iter().all(|name| name != "documentation"))
            }),
            renames: renames(client),
            cuts_after: cuts_after(client),
            resolves_edits: actions.is_some_and(|it| {
                let resolved = it.resolve_support.as_ref();
                let edits = resolved.is_some_and(|it| it.properties.iter().any(|name| name == "edit"));
                edits && it.data_support == Some(true)
            }),
            disabled_actions: actions.and_then(|it| it.disabled_support).unwrap_or(false),
        }
    }
}

/// Which operations the client reports.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Reported {
    /// Files that were made.
    pub(crate) created: bool,
    /// Files that are about to be renamed.
    pub(crate) will_rename: bool,
    /// Files that were renamed.
    pub(crate) renamed: bool,
    /// Files that were deleted.
    pub(crate) deleted: bool,
}

impl Reported {
    /// By what the client says it can.
    pub(crate) fn by(client: Option<&WorkspaceFileOperationsClientCapabilities>) -> Reported {
        client.map_or_else(Reported::default, |it| Reported {
            created: it.did_create.unwrap_or(false),
            will_rename: it.will_rename.unwrap_or(false),
            renamed: it.did_rename.unwrap_or(false),
            deleted: it.did_delete.unwrap_or(false),
        })
    }
}

/// The framework's type keeps its list to itself.
fn takes_unnecessary(tags: &ClientDiagnosticsTagOptions) -> bool {
    let tags = serde_json::to_value(tags).unwrap_or_default();
    let unnecessary = serde_json::to_value(DiagnosticTag::UNNECESSARY).unwrap_or_default();
    tags["valueSet"]
        .as_array()
        .is_some_and(|tags| tags.contains(&unnecessary))
}

/// Whether a client says that it can do something which the protocol has no word for.
fn says(client: &ClientCapabilities, what: &str) -> bool {
    client.experimental.as_ref().is_some_and(|it| it[what] == true)
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::*;

    fn agreed(client: Value) -> Agreed {
        Agreed::with(&serde_json::from_value(client).unwrap())
    }

    #[test]
    fn the_cheapest_encoding_wins_whatever_the_order() {
        let encoding = |offered: &[&str]| agreed(json!({"general": {"positionEncodings": offered}})).encoding;
        assert_eq!(encoding(&["utf-16", "utf-32", "utf-8"]), Encoding::Utf8);
        assert_eq!(encoding(&["utf-16", "utf-32"]), Encoding::Utf32);
        assert_eq!(encoding(&["utf-16"]), Encoding::Utf16);
        assert_eq!(encoding(&[]), Encoding::Utf16);
        assert_eq!(encoding(&["utf-7"]), Encoding::Utf16);
        assert_eq!(agreed(json!({})).encoding, Encoding::Utf16);
    }

    #[test]
    fn a_client_that_says_nothing_gets_the_plain_forms() {
        assert_eq!(agreed(json!({})), Agreed::default());
    }

    #[test]
    fn a_rich_client_gets_everything() {
        let client = json!({
            "textDocument": {
                "diagnostic": {"relatedDocumentSupport": true},
                "publishDiagnostics": {
                    "relatedInformation": true,
                    "tagSupport": {"valueSet": [1, 2]},
                    "dataSupport": true
                },
                "hover": {"contentFormat": ["markdown", "plaintext"]},
                "definition": {"linkSupport": true},
                "rename": {"prepareSupport": true},
                "completion": {"completionItem": {
                    "snippetSupport": true, "labelDetailsSupport": true, "documentationFormat": ["markdown"],
                    "resolveSupport": {"properties": ["command"]}
                }},
                "documentSymbol": {"hierarchicalDocumentSymbolSupport": true},
                "foldingRange": {"rangeLimit": 5000},
                "codeAction": {
                    "dataSupport": true,
                    "disabledSupport": true,
                    "resolveSupport": {"properties": ["edit"]}
                },
                "semanticTokens": {
                    "requests": {}, "tokenTypes": [], "tokenModifiers": [], "formats": ["relative"],
                    "multilineTokenSupport": true
                },
                "signatureHelp": {"signatureInformation": {
                    "parameterInformation": {"labelOffsetSupport": true}, "documentationFormat": ["markdown"]
                }}
            },
            "window": {"workDoneProgress": true},
            "workspace": {
                "workspaceEdit": {"documentChanges": true, "resourceOperations": ["create"]},
                "didChangeWatchedFiles": {"dynamicRegistration": true},
                "diagnostics": {"refreshSupport": true},
                "fileOperations": {"didCreate": true, "willRename": true, "didRename": true, "didDelete": true},
                "configuration": true,
                "didChangeConfiguration": {"dynamicRegistration": true},
                "inlayHint": {"refreshSupport": true}, "semanticTokens": {"refreshSupport": true},
                "codeLens": {"refreshSupport": true}
            },
            "general": {"positionEncodings": ["utf-8"]},
            "experimental": {"commands": ["ladder.completion.cut", "ladder.rename"], "rulePages": true, "libraryBlocks": true}
        });
        assert_eq!(
            agreed(client),
            Agreed {
                encoding: Encoding::Utf8,
                related_information: true,
                unnecessary_tag: true,
                diagnostic_data: true,
                rule_pages: true,
                library_blocks: true,
                versioned_edits: true,
                creates_files: true,
                resolves_edits: true,
                disabled_actions: true,
                markdown: true,
                label_details: true,
                watches_files: true,
                file_operations: Reported {
                    created: true,
                    will_rename: true,
                    renamed: true,
                    deleted: true
                },
                pulls_diagnostics: true,
                related_documents: true,
                refreshes_diagnostics: true,
                progress: true,
                configuration: true,
                registers_configuration: true,
                refreshes_semantic_tokens: true,
                refreshes_inlay_hints: true,
                refreshes_code_lenses: true,
                links: Links {
                    definition: true,
                    ..Links::default()
                },
                prepares_rename: true,
                lens_commands: Commands::default(),
                multiline_tokens: true,
                label_offsets: true,
                signature_markdown: true,
                snippets: true,
                completion_markdown: true,
                documented_at_once: true,
                renames: true,
                cuts_after: true,
                nested_symbols: true,
                fold_limit: Some(5000),
            }
        );
    }
}
