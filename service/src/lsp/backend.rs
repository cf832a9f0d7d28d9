//! The handlers, each a line: the framework's trait on one side, a file for each feature on the other.

use std::sync::Arc;

use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::CodeAction;
use tower_lsp::ls_types::request::{
    GotoDeclarationParams, GotoDeclarationResponse, GotoImplementationParams, GotoImplementationResponse,
    GotoTypeDefinitionParams, GotoTypeDefinitionResponse,
};
use tower_lsp::ls_types::{
    CallHierarchyIncomingCall, CallHierarchyIncomingCallsParams, CallHierarchyItem,
    CallHierarchyOutgoingCall, CallHierarchyOutgoingCallsParams, CallHierarchyPrepareParams, DocumentLink,
    DocumentLinkParams, DocumentSymbolParams, DocumentSymbolResponse, FoldingRange, FoldingRangeParams,
    SelectionRange, SelectionRangeParams, WillSaveTextDocumentParams, WorkspaceSymbolParams,
    WorkspaceSymbolResponse,
};
use tower_lsp::ls_types::{
    CodeActionParams, CodeActionResponse, DidChangeConfigurationParams, DidChangeTextDocumentParams,
    DidChangeWatchedFilesParams, DidChangeWorkspaceFoldersParams, DidCloseTextDocumentParams,
    DidOpenTextDocumentParams, DidSaveTextDocumentParams, DocumentDiagnosticParams,
    DocumentDiagnosticReportResult, DocumentFormattingParams, ExecuteCommandParams, Hover, HoverParams,
    InitializeParams, InitializeResult, InitializedParams, LSPAny, ServerInfo, TextEdit,
    WorkspaceDiagnosticParams, WorkspaceDiagnosticReportResult,
};
use tower_lsp::ls_types::{CodeLens, CodeLensParams, InlayHint, InlayHintParams};
use tower_lsp::ls_types::{CompletionItem, CompletionParams, CompletionResponse};
use tower_lsp::ls_types::{CreateFilesParams, DeleteFilesParams, RenameFilesParams, WorkspaceEdit};
use tower_lsp::ls_types::{
    DocumentHighlight, DocumentHighlightParams, GotoDefinitionParams, GotoDefinitionResponse, Location,
    ReferenceParams,
};
use tower_lsp::ls_types::{
    DocumentOnTypeFormattingParams, DocumentRangeFormattingParams, PrepareRenameResponse, RenameParams,
    TextDocumentPositionParams,
};
use tower_lsp::ls_types::{
    SemanticTokensDeltaParams, SemanticTokensFullDeltaResult, SemanticTokensParams,
    SemanticTokensRangeParams, SemanticTokensRangeResult, SemanticTokensResult,
};
use tower_lsp::ls_types::{SignatureHelp, SignatureHelpParams};
use tower_lsp::{Client, LanguageServer};

use crate::lsp::documents::{configuration, file_operations, folders, pull, sync, typed, watch};
#[cfg(feature = "review")]
use crate::lsp::features::compare;
use crate::lsp::features::{
    call_hierarchy, code_action, code_lens, comment, completion, cross_reference, debug, declarations,
    diagram, diagram_edit, diagram_text, edit, fence, folding,
    formatting::{self, DocumentRangesFormattingParams},
    goto, hover, inlay_hint, library_block, links, notations, palette, preview, prove, references, rename,
    rule_page, run_scenarios, scene, semantic_tokens, signature, simulate, symbols,
};
use crate::lsp::{
    capabilities,
    session::{agreed::Agreed, shared::Shared},
};
use ladder_host::Busy;
use ladder_host::Host;
use ladder_live::messages::{DebuggerMessage, OfSession};

/// The server as the framework sees it.
#[derive(Debug)]
pub(crate) struct Backend {
    shared: Arc<Shared>,
}

impl Backend {
    /// A server, which shows whether work is under way.
    pub(crate) fn new(client: Client, host: Arc<dyn Host>, busy: Busy) -> Self {
        Backend {
            shared: Shared::new(client, host, busy),
        }
    }

    pub(crate) fn shared(&self) -> Arc<Shared> {
        self.shared.clone()
    }

    /// `textDocument/rangesFormatting`, which the framework does not know yet.
    pub(crate) async fn ranges_formatting(
        &self,
        params: DocumentRangesFormattingParams,
    ) -> Result<Option<Vec<TextEdit>>> {
        formatting::ranges_formatting(&self.shared, params).await
    }

    /// `ladder/simulationShown`, a notification of the client.
    #[expect(clippy::unused_async, reason = "the framework asks for it")]
    pub(crate) async fn simulation_shown(&self, params: OfSession) {
        simulate::has_shown(&self.shared, params);
    }

    /// `ladder/toDebugger`, a notification of the client.
    #[expect(clippy::unused_async, reason = "the framework asks for it")]
    pub(crate) async fn to_debugger(&self, params: DebuggerMessage) {
        debug::receive(&self.shared, params);
    }
}

impl LanguageServer for Backend {
    async fn initialize(&self, params: InitializeParams) -> Result<InitializeResult> {
        let agreed = Agreed::with(&params.capabilities);
        self.shared.agree(agreed);
        folders::begin(&self.shared, &params);
        configuration::begin(&self.shared, params.initialization_options.as_ref());
        if let Some(process) = params.process_id {
            let (gone, shared) = (self.shared.host.gone(process), self.shared.clone());
            self.shared.spawn(async move {
                gone.await;
                shared.orphaned.give();
            });
        }
        Ok(InitializeResult {
            capabilities: capabilities::offered(agreed),
            server_info: Some(ServerInfo {
                name: "ladder".into(),
                version: Some(env!("CARGO_PKG_VERSION").into()),
            }),
            ..InitializeResult::default()
        })
    }

    async fn shutdown(&self) -> Result<()> {
        let host = &*self.shared.host;
        self.shared.sessions.stop_everything(host).await;
        Ok(())
    }

    async fn did_open(&self, params: DidOpenTextDocumentParams) {
        sync::opened(&self.shared, params);
    }

    async fn did_change(&self, params: DidChangeTextDocumentParams) {
        sync::changed(&self.shared, params);
    }

    async fn did_close(&self, params: DidCloseTextDocumentParams) {
        sync::closed(&self.shared, &params);
    }

    async fn initialized(&self, _: InitializedParams) {
        // Together, and in this order: a session that is played again asks the same questions.
        let shared = self.shared.clone();
        self.shared.spawn(async move {
            futures::join!(watch::register(&shared), configuration::register(&shared));
        });
        folders::index(&self.shared);
    }

    async fn will_save(&self, params: WillSaveTextDocumentParams) {
        sync::will_save(&self.shared, &params);
    }

    async fn did_save(&self, params: DidSaveTextDocumentParams) {
        sync::saved(&self.shared, &params);
    }

    async fn did_change_workspace_folders(&self, params: DidChangeWorkspaceFoldersParams) {
        folders::changed(&self.shared, &params);
    }

    async fn did_create_files(&self, params: CreateFilesParams) {
        file_operations::created(&self.shared, &params);
    }

    async fn did_rename_files(&self, params: RenameFilesParams) {
        file_operations::renamed(&self.shared, &params);
    }

    async fn did_delete_files(&self, params: DeleteFilesParams) {
        file_operations::deleted(&self.shared, &params);
    }

    async fn will_rename_files(&self, params: RenameFilesParams) -> Result<Option<WorkspaceEdit>> {
        file_operations::will_rename(&self.shared, params).await
    }

    async fn diagnostic(&self, params: DocumentDiagnosticParams) -> Result<DocumentDiagnosticReportResult> {
        pull::document(&self.shared, params).await
    }

    async fn workspace_diagnostic(
        &self,
        params: WorkspaceDiagnosticParams,
    ) -> Result<WorkspaceDiagnosticReportResult> {
        pull::workspace(&self.shared, params).await
    }

    async fn did_change_configuration(&self, params: DidChangeConfigurationParams) {
        configuration::changed(&self.shared, &params);
    }

    async fn did_change_watched_files(&self, params: DidChangeWatchedFilesParams) {
        sync::watched(&self.shared, &params);
    }

    async fn hover(&self, params: HoverParams) -> Result<Option<Hover>> {
        hover::hover(&self.shared, params).await
    }

    async fn goto_definition(&self, params: GotoDefinitionParams) -> Result<Option<GotoDefinitionResponse>> {
        goto::goto(&self.shared, params, ladder_ide::definition, |it| it.definition).await
    }

    async fn goto_declaration(
        &self,
        params: GotoDeclarationParams,
    ) -> Result<Option<GotoDeclarationResponse>> {
        goto::goto(&self.shared, params, ladder_ide::declaration, |it| it.declaration).await
    }

    async fn goto_type_definition(
        &self,
        params: GotoTypeDefinitionParams,
    ) -> Result<Option<GotoTypeDefinitionResponse>> {
        goto::goto(&self.shared, params, ladder_ide::type_definition, |it| {
            it.type_definition
        })
        .await
    }

    async fn goto_implementation(
        &self,
        params: GotoImplementationParams,
    ) -> Result<Option<GotoImplementationResponse>> {
        goto::goto(&self.shared, params, ladder_ide::implementation, |it| {
            it.implementation
        })
        .await
    }

    async fn references(&self, params: ReferenceParams) -> Result<Option<Vec<Location>>> {
        references::references(&self.shared, params).await
    }

    async fn document_highlight(
        &self,
        params: DocumentHighlightParams,
    ) -> Result<Option<Vec<DocumentHighlight>>> {
        references::highlight(&self.shared, params).await
    }

    async fn completion(&self, params: CompletionParams) -> Result<Option<CompletionResponse>> {
        completion::completion(&self.shared, params).await
    }

    async fn signature_help(&self, params: SignatureHelpParams) -> Result<Option<SignatureHelp>> {
        signature::signature_help(&self.shared, params).await
    }

    async fn code_lens(&self, params: CodeLensParams) -> Result<Option<Vec<CodeLens>>> {
        code_lens::code_lens(&self.shared, params).await
    }

    async fn code_lens_resolve(&self, lens: CodeLens) -> Result<CodeLens> {
        code_lens::resolve(&self.shared, lens).await
    }

    async fn inlay_hint(&self, params: InlayHintParams) -> Result<Option<Vec<InlayHint>>> {
        inlay_hint::inlay_hint(&self.shared, params).await
    }

    async fn semantic_tokens_full(
        &self,
        params: SemanticTokensParams,
    ) -> Result<Option<SemanticTokensResult>> {
        semantic_tokens::full(&self.shared, params).await
    }

    async fn semantic_tokens_full_delta(
        &self,
        params: SemanticTokensDeltaParams,
    ) -> Result<Option<SemanticTokensFullDeltaResult>> {
        semantic_tokens::delta(&self.shared, params).await
    }

    async fn semantic_tokens_range(
        &self,
        params: SemanticTokensRangeParams,
    ) -> Result<Option<SemanticTokensRangeResult>> {
        semantic_tokens::range(&self.shared, params).await
    }

    async fn completion_resolve(&self, item: CompletionItem) -> Result<CompletionItem> {
        completion::resolve(&self.shared, item).await
    }

    async fn document_symbol(&self, params: DocumentSymbolParams) -> Result<Option<DocumentSymbolResponse>> {
        symbols::document_symbols(&self.shared, params).await
    }

    async fn symbol(&self, params: WorkspaceSymbolParams) -> Result<Option<WorkspaceSymbolResponse>> {
        symbols::symbols(&self.shared, params).await
    }

    async fn folding_range(&self, params: FoldingRangeParams) -> Result<Option<Vec<FoldingRange>>> {
        folding::folding_ranges(&self.shared, params).await
    }

    async fn selection_range(&self, params: SelectionRangeParams) -> Result<Option<Vec<SelectionRange>>> {
        folding::selection_ranges(&self.shared, params).await
    }

    async fn document_link(&self, params: DocumentLinkParams) -> Result<Option<Vec<DocumentLink>>> {
        links::document_links(&self.shared, params).await
    }

    async fn prepare_call_hierarchy(
        &self,
        params: CallHierarchyPrepareParams,
    ) -> Result<Option<Vec<CallHierarchyItem>>> {
        call_hierarchy::prepare(&self.shared, params).await
    }

    async fn incoming_calls(
        &self,
        params: CallHierarchyIncomingCallsParams,
    ) -> Result<Option<Vec<CallHierarchyIncomingCall>>> {
        call_hierarchy::incoming(&self.shared, params).await
    }

    async fn outgoing_calls(
        &self,
        params: CallHierarchyOutgoingCallsParams,
    ) -> Result<Option<Vec<CallHierarchyOutgoingCall>>> {
        call_hierarchy::outgoing(&self.shared, params).await
    }

    async fn formatting(&self, params: DocumentFormattingParams) -> Result<Option<Vec<TextEdit>>> {
        formatting::formatting(&self.shared, params).await
    }

    async fn range_formatting(&self, params: DocumentRangeFormattingParams) -> Result<Option<Vec<TextEdit>>> {
        formatting::range_formatting(&self.shared, params).await
    }

    async fn on_type_formatting(
        &self,
        params: DocumentOnTypeFormattingParams,
    ) -> Result<Option<Vec<TextEdit>>> {
        formatting::on_type_formatting(&self.shared, params).await
    }

    async fn prepare_rename(
        &self,
        params: TextDocumentPositionParams,
    ) -> Result<Option<PrepareRenameResponse>> {
        rename::prepare(&self.shared, params).await
    }

    async fn rename(&self, params: RenameParams) -> Result<Option<WorkspaceEdit>> {
        rename::rename(&self.shared, params).await
    }

    async fn code_action(&self, params: CodeActionParams) -> Result<Option<CodeActionResponse>> {
        code_action::code_action(&self.shared, params).await
    }

    async fn code_action_resolve(&self, action: CodeAction) -> Result<CodeAction> {
        code_action::resolve(&self.shared, action).await
    }

    async fn execute_command(&self, params: ExecuteCommandParams) -> Result<Option<LSPAny>> {
        let answer = match params.command.as_str() {
            cross_reference::CROSS_REFERENCE => cross_reference::execute(&self.shared, params).await,
            diagram::DIAGRAM => diagram::execute(&self.shared, params).await,
            fence::FENCE => fence::execute(&self.shared, params).await,
            scene::SCENE => scene::execute(&self.shared, params).await,
            diagram_text::DIAGRAM_TEXT => diagram_text::execute(&self.shared, params).await,
            declarations::DECLARATIONS => declarations::execute(&self.shared, params).await,
            palette::PALETTE => palette::execute(&self.shared, params).await,
            preview::PREVIEW => preview::execute(&self.shared, params).await,
            typed::CURSOR => typed::execute(&self.shared, params).await,
            edit::EDIT => edit::execute(&self.shared, params).await,
            diagram_edit::DIAGRAM_EDIT => diagram_edit::edit(&self.shared, params).await,
            diagram_edit::DIAGRAM_OFFER => diagram_edit::offered(&self.shared, params).await,
            comment::COMMENT => comment::execute(&self.shared, params).await,
            rule_page::RULE_PAGE => rule_page::execute(params),
            run_scenarios::RUN_SCENARIOS => run_scenarios::execute(&self.shared, params).await,
            #[cfg(feature = "review")]
            compare::COMPARE => compare::execute(&self.shared, params).await,
            prove::PROVE_PROPERTIES => prove::execute(&self.shared, params).await,
            library_block::LIBRARY_BLOCK => library_block::execute(params),
            command if notations::COMMANDS.contains(&command) => {
                notations::execute(&self.shared, params).await
            }
            _ => return simulate::execute(&self.shared, params).await,
        };
        answer.map(Some)
    }
}
