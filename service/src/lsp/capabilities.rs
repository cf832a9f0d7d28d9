//! What client and server agree on, once, at `initialize`.

use ladder_documents::position::Encoding;
use ladder_ide::TRIGGERS;
use ladder_live::COMMANDS;
use tower_lsp::ls_types::{
    CallHierarchyServerCapability, DocumentLinkOptions, DocumentOnTypeFormattingOptions,
    FoldingRangeProviderCapability, RenameOptions, SelectionRangeProviderCapability, WorkDoneProgressOptions,
};
use tower_lsp::ls_types::{
    CodeActionOptions, CodeActionProviderCapability, DeclarationCapability, ExecuteCommandOptions,
    HoverProviderCapability, ImplementationProviderCapability, OneOf, PositionEncodingKind, SaveOptions,
    ServerCapabilities, TextDocumentSyncCapability, TextDocumentSyncKind, TextDocumentSyncOptions,
    TextDocumentSyncSaveOptions, TypeDefinitionProviderCapability, WorkspaceFoldersServerCapabilities,
    WorkspaceServerCapabilities,
};

use crate::lsp::documents::{file_operations, pull, typed};
use crate::lsp::features::{
    code_action::KINDS, comment, completion, cross_reference, declarations, diagram, diagram_edit,
    diagram_text, edit, fence, library_block, notations, palette, preview, rule_page, run_scenarios, scene,
    semantic_tokens, signature,
};
use crate::lsp::session::agreed::Agreed;

/// What the server offers to such a client.
pub(crate) fn offered(agreed: Agreed) -> ServerCapabilities {
    ServerCapabilities {
        position_encoding: Some(match agreed.encoding {
            Encoding::Utf8 => PositionEncodingKind::UTF8,
            Encoding::Utf16 => PositionEncodingKind::UTF16,
            Encoding::Utf32 => PositionEncodingKind::UTF32,
        }),
        text_document_sync: Some(TextDocumentSyncCapability::Options(TextDocumentSyncOptions {
            open_close: Some(true),
            change: Some(TextDocumentSyncKind::INCREMENTAL),
            will_save: Some(true),
            save: Some(TextDocumentSyncSaveOptions::SaveOptions(SaveOptions {
                include_text: Some(false),
            })),
            ..TextDocumentSyncOptions::default()
        })),
        code_lens_provider: agreed.lens_commands.options(),
        inlay_hint_provider: Some(OneOf::Left(true)),
        semantic_tokens_provider: Some(semantic_tokens::options()),
        signature_help_provider: Some(signature::options()),
        completion_provider: Some(completion::options(agreed)),
        diagnostic_provider: agreed.pulls_diagnostics.then(pull::options),
        workspace: Some(WorkspaceServerCapabilities {
            workspace_folders: Some(WorkspaceFoldersServerCapabilities {
                supported: Some(true),
                change_notifications: Some(OneOf::Left(true)),
            }),
            file_operations: file_operations::options(agreed.file_operations),
        }),
        hover_provider: Some(HoverProviderCapability::Simple(true)),
        definition_provider: Some(OneOf::Left(true)),
        declaration_provider: Some(DeclarationCapability::Simple(true)),
        type_definition_provider: Some(TypeDefinitionProviderCapability::Simple(true)),
        implementation_provider: Some(ImplementationProviderCapability::Simple(true)),
        references_provider: Some(OneOf::Left(true)),
        document_highlight_provider: Some(OneOf::Left(true)),
        document_range_formatting_provider: Some(OneOf::Left(true)),
        document_on_type_formatting_provider: Some(on_type_formatting()),
        rename_provider: Some(if agreed.prepares_rename {
            OneOf::Right(RenameOptions {
                prepare_provider: Some(true),
                work_done_progress_options: WorkDoneProgressOptions::default(),
            })
        } else {
            OneOf::Left(true)
        }),
        document_symbol_provider: Some(OneOf::Left(true)),
        workspace_symbol_provider: Some(OneOf::Left(true)),
        folding_range_provider: Some(FoldingRangeProviderCapability::Simple(true)),
        selection_range_provider: Some(SelectionRangeProviderCapability::Simple(true)),
        document_link_provider: Some(DocumentLinkOptions {
            resolve_provider: Some(false),
            work_done_progress_options: WorkDoneProgressOptions::default(),
        }),
        call_hierarchy_provider: Some(CallHierarchyServerCapability::Simple(true)),
        document_formatting_provider: Some(OneOf::Left(true)),
        code_action_provider: Some(CodeActionProviderCapability::Options(CodeActionOptions {
            code_action_kinds: Some(KINDS.iter().map(|(_, kind)| kind.clone()).collect()),
            resolve_provider: Some(agreed.resolves_edits),
            ..CodeActionOptions::default()
        })),
        execute_command_provider: Some(ExecuteCommandOptions {
            commands: COMMANDS
                .iter()
                .chain(&notations::COMMANDS)
                .chain(&[
                    preview::PREVIEW,
                    cross_reference::CROSS_REFERENCE,
                    diagram::DIAGRAM,
                    diagram_text::DIAGRAM_TEXT,
                    diagram_edit::DIAGRAM_EDIT,
                    diagram_edit::DIAGRAM_OFFER,
                    declarations::DECLARATIONS,
                    palette::PALETTE,
                    fence::FENCE,
                    scene::SCENE,
                    typed::CURSOR,
                    edit::EDIT,
                    comment::COMMENT,
                    rule_page::RULE_PAGE,
                    run_scenarios::RUN_SCENARIOS,
                    library_block::LIBRARY_BLOCK,
                ])
                .chain(IF_BUILT_IN)
                .map(ToString::to_string)
                .collect(),
            ..ExecuteCommandOptions::default()
        }),
        ..ServerCapabilities::default()
    }
}

/// What needs the prover, where that is built in.
const IF_BUILT_IN: &[&str] = &[
    #[cfg(feature = "prove")]
    crate::lsp::features::prove::PROVE_PROPERTIES,
    #[cfg(feature = "review")]
    crate::lsp::features::compare::COMPARE,
];

fn on_type_formatting() -> DocumentOnTypeFormattingOptions {
    let mut triggers = TRIGGERS.iter().map(ToString::to_string);
    DocumentOnTypeFormattingOptions {
        first_trigger_character: triggers.next().unwrap_or_default(),
        more_trigger_character: Some(triggers.collect()),
    }
}
