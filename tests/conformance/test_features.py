"""Every request that the server offers, answered in types that others wrote.

A reply that lsprotocol's types do not take ends the session, and with it the test.
"""

import asyncio

import pytest
from lsprotocol import types as t
from pytest_lsp import LanguageClient

from conftest import LIBRARY, MOTOR


def uri(client: LanguageClient, name: str = "motor.clad") -> str:
    return (client.plant / name).as_uri()


def open_file(client: LanguageClient, name: str = "motor.clad", text: str = MOTOR, language: str = "clad") -> str:
    item = t.TextDocumentItem(uri=uri(client, name), language_id=language, version=1, text=text)
    client.text_document_did_open(t.DidOpenTextDocumentParams(text_document=item))
    return item.uri


def document(of: str) -> t.TextDocumentIdentifier:
    return t.TextDocumentIdentifier(uri=of)


def place(text: str, words: str, plus: int = 0) -> t.Position:
    at = text.index(words) + plus
    before = text[:at]
    return t.Position(line=before.count("\n"), character=at - (before.rfind("\n") + 1))


def at(of: str, words: str, plus: int = 0, text: str = MOTOR) -> dict:
    return {"text_document": document(of), "position": place(text, words, plus)}


WHOLE = t.Range(start=t.Position(line=0, character=0), end=t.Position(line=17, character=0))
OPTIONS = t.FormattingOptions(tab_size=4, insert_spaces=True)


async def hover(client, of):
    found = await client.text_document_hover_async(t.HoverParams(**at(of, "[TON]", 2)))
    assert "TON" in found.contents.value


async def completion(client, of):
    params = t.CompletionParams(**at(of, "[/](", 1))
    found = await client.text_document_completion_async(params)
    items = found.items if isinstance(found, t.CompletionList) else found
    assert items
    if client.offered.completion_provider.resolve_provider:
        await client.completion_item_resolve_async(items[0])


async def signature_help(client, of):
    await client.text_document_signature_help_async(t.SignatureHelpParams(**at(of, "warmup, T", 8)))


async def definition(client, of):
    found = await client.text_document_definition_async(t.DefinitionParams(**at(of, "CALL>( count", 9)))
    first = found[0] if isinstance(found, list | tuple) else found
    target = first.target_uri if isinstance(first, t.LocationLink) else first.uri
    assert target == uri(client, "library.clad")


async def declaration(client, of):
    assert await client.text_document_declaration_async(t.DeclarationParams(**at(of, "( stop )", 3)))


async def type_definition(client, of):
    await client.text_document_type_definition_async(t.TypeDefinitionParams(**at(of, "warmup, T", 2)))


async def implementation(client, of):
    await client.text_document_implementation_async(t.ImplementationParams(**at(of, "CALL>( count", 9)))


async def references(client, of):
    context = t.ReferenceContext(include_declaration=True)
    found = await client.text_document_references_async(
        t.ReferenceParams(**at(of, "( run )", 3), context=context)
    )
    # Three in the program, and the row of its scenarios.
    assert sorted(place.uri.rsplit("/", 1)[-1] for place in found) == ["motor.clad"] * 3 + ["motor.ladder-test"]


async def highlight(client, of):
    assert await client.text_document_document_highlight_async(t.DocumentHighlightParams(**at(of, "( run )", 3)))


async def document_symbol(client, of):
    assert await client.text_document_document_symbol_async(t.DocumentSymbolParams(text_document=document(of)))


async def workspace_symbol(client, of):
    found = await client.workspace_symbol_async(t.WorkspaceSymbolParams(query="count"))
    assert found


async def code_action(client, of):
    start = place(MOTOR, "( strat )", 3)
    params = t.CodeActionParams(
        text_document=document(of),
        range=t.Range(start=start, end=start),
        context=t.CodeActionContext(diagnostics=[]),
    )
    found = await client.text_document_code_action_async(params)
    actions = [action for action in found or [] if isinstance(action, t.CodeAction)]
    if getattr(client.offered.code_action_provider, "resolve_provider", False):
        for action in actions:
            if action.edit is None:
                await client.code_action_resolve_async(action)


async def code_lens(client, of):
    found = await client.text_document_code_lens_async(t.CodeLensParams(text_document=document(of)))
    if client.offered.code_lens_provider.resolve_provider:
        for lens in found or []:
            await client.code_lens_resolve_async(lens)


async def inlay_hint(client, of):
    await client.text_document_inlay_hint_async(t.InlayHintParams(text_document=document(of), range=WHOLE))


async def formatting(client, of):
    params = t.DocumentFormattingParams(text_document=document(of), options=OPTIONS)
    assert await client.text_document_formatting_async(params)


async def range_formatting(client, of):
    params = t.DocumentRangeFormattingParams(text_document=document(of), range=WHOLE, options=OPTIONS)
    await client.text_document_range_formatting_async(params)
    if getattr(client.offered.document_range_formatting_provider, "ranges_support", False):
        params = t.DocumentRangesFormattingParams(text_document=document(of), ranges=[WHOLE], options=OPTIONS)
        await client.text_document_ranges_formatting_async(params)


async def on_type_formatting(client, of):
    params = t.DocumentOnTypeFormattingParams(**at(of, "stop )--", 6), ch=")", options=OPTIONS)
    await client.text_document_on_type_formatting_async(params)


async def rename(client, of):
    if getattr(client.offered.rename_provider, "prepare_provider", False):
        assert await client.text_document_prepare_rename_async(t.PrepareRenameParams(**at(of, "( run )", 3)))
    edit = await client.text_document_rename_async(t.RenameParams(**at(of, "( run )", 3), new_name="running"))
    assert edit.changes or edit.document_changes


async def folding_range(client, of):
    assert await client.text_document_folding_range_async(t.FoldingRangeParams(text_document=document(of)))


async def selection_range(client, of):
    params = t.SelectionRangeParams(text_document=document(of), positions=[place(MOTOR, "( stop )", 3)])
    assert (await client.text_document_selection_range_async(params))[0].parent


async def document_link(client, of):
    await client.text_document_document_link_async(t.DocumentLinkParams(text_document=document(of)))


async def call_hierarchy(client, of):
    prepare = t.CallHierarchyPrepareParams(**at(of, "CALL>( count", 9))
    items = await client.text_document_prepare_call_hierarchy_async(prepare)
    for item in items or []:
        await client.call_hierarchy_incoming_calls_async(t.CallHierarchyIncomingCallsParams(item=item))
        await client.call_hierarchy_outgoing_calls_async(t.CallHierarchyOutgoingCallsParams(item=item))


async def semantic_tokens(client, of):
    full = await client.text_document_semantic_tokens_full_async(t.SemanticTokensParams(text_document=document(of)))
    assert full.data and len(full.data) % 5 == 0
    await client.text_document_semantic_tokens_range_async(
        t.SemanticTokensRangeParams(text_document=document(of), range=WHOLE)
    )
    if full.result_id is not None:
        await client.text_document_semantic_tokens_full_delta_async(
            t.SemanticTokensDeltaParams(text_document=document(of), previous_result_id=full.result_id)
        )


async def diagnostic(client, of):
    report = await client.text_document_diagnostic_async(t.DocumentDiagnosticParams(text_document=document(of)))
    assert any(it.code == "undeclared-tag" for it in report.items)
    again = await client.text_document_diagnostic_async(
        t.DocumentDiagnosticParams(text_document=document(of), previous_result_id=report.result_id)
    )
    assert again.kind == "unchanged"
    client.progress_reports["all"] = []
    params = t.WorkspaceDiagnosticParams(previous_result_ids=[], work_done_token="all")
    whole = await client.workspace_diagnostic_async(params)
    settings = next(it for it in whole.items if it.uri == uri(client, "ladder.toml"))
    assert settings.items[0].code == "bad-setting"
    assert client.diagnostics == {}, "none are sent to a client that asks"


async def execute_command(client, of):
    async def simulate(name, argument):
        params = t.ExecuteCommandParams(command=f"ladder.simulate.{name}", arguments=[argument])
        return await client.workspace_execute_command_async(params)

    # A program that has no errors.
    library = open_file(client, "library.clad", LIBRARY)
    started = await simulate("start", {"uri": library})
    session = started["session"] if isinstance(started, dict) else started.session
    await simulate("step", {"session": session, "scans": 3})
    await simulate("stop", {"session": session})


async def workspace(client, of):
    files = getattr(client.offered.workspace, "file_operations", None)
    if files is not None and files.will_rename is not None:
        renamed = t.FileRename(old_uri=of, new_uri=uri(client, "pump.clad"))
        edit = await client.workspace_will_rename_files_async(t.RenameFilesParams(files=[renamed]))
        assert "pump.clad" in repr(edit)
    event = t.WorkspaceFoldersChangeEvent(added=[], removed=[])
    client.workspace_did_change_workspace_folders(t.DidChangeWorkspaceFoldersParams(event=event))


# By the capability that offers it. One that is offered and not here fails the test.
ASKED = {
    "hover_provider": hover,
    "completion_provider": completion,
    "signature_help_provider": signature_help,
    "definition_provider": definition,
    "declaration_provider": declaration,
    "type_definition_provider": type_definition,
    "implementation_provider": implementation,
    "references_provider": references,
    "document_highlight_provider": highlight,
    "document_symbol_provider": document_symbol,
    "workspace_symbol_provider": workspace_symbol,
    "code_action_provider": code_action,
    "code_lens_provider": code_lens,
    "inlay_hint_provider": inlay_hint,
    "document_formatting_provider": formatting,
    "document_range_formatting_provider": range_formatting,
    "document_on_type_formatting_provider": on_type_formatting,
    "rename_provider": rename,
    "folding_range_provider": folding_range,
    "selection_range_provider": selection_range,
    "document_link_provider": document_link,
    "call_hierarchy_provider": call_hierarchy,
    "semantic_tokens_provider": semantic_tokens,
    "diagnostic_provider": diagnostic,
    "execute_command_provider": execute_command,
    "workspace": workspace,
}
NO_REQUESTS = {"position_encoding", "text_document_sync"}


async def test_every_request_that_is_offered(client: LanguageClient):
    of = open_file(client)
    offered = {
        name
        for name in dir(client.offered)
        if not name.startswith("_") and getattr(client.offered, name) not in (None, False)
    }
    unknown = offered - set(ASKED) - NO_REQUESTS
    assert not unknown, f"offered, but not tried here: {sorted(unknown)}"
    for name in sorted(offered - NO_REQUESTS):
        try:
            await ASKED[name](client, of)
        except Exception as error:
            raise AssertionError(f"{name}: {error}") from error


async def test_everything_on_half_written_text(client: LanguageClient):
    """Answers without a meaning are still answers of the right type."""
    half = "+--[ ]( \n+--\\--[TON](\n# open\n"
    of = open_file(client, "half.clad", half)
    here = {"text_document": document(of), "position": t.Position(line=0, character=8)}
    everywhere = t.Range(start=t.Position(line=0, character=0), end=t.Position(line=9, character=9))
    for asked in (
        client.text_document_hover_async(t.HoverParams(**here)),
        client.text_document_completion_async(t.CompletionParams(**here)),
        client.text_document_signature_help_async(t.SignatureHelpParams(**here)),
        client.text_document_definition_async(t.DefinitionParams(**here)),
        client.text_document_document_symbol_async(t.DocumentSymbolParams(text_document=document(of))),
        client.text_document_semantic_tokens_full_async(t.SemanticTokensParams(text_document=document(of))),
        client.text_document_inlay_hint_async(t.InlayHintParams(text_document=document(of), range=everywhere)),
        client.text_document_folding_range_async(t.FoldingRangeParams(text_document=document(of))),
        client.text_document_formatting_async(
            t.DocumentFormattingParams(text_document=document(of), options=OPTIONS)
        ),
    ):
        await asyncio.wait_for(asked, 10)


async def test_diagnostics_come_one_way_only(client: LanguageClient):
    asking = client.offered.diagnostic_provider is not None
    of = open_file(client)
    settings = uri(client, "ladder.toml")
    for _ in range(300):
        if asking or {of, settings} <= set(client.diagnostics):
            break
        await asyncio.sleep(0.02)
    if asking:
        await asyncio.sleep(0.3)
        assert client.diagnostics == {}
        report = await client.text_document_diagnostic_async(t.DocumentDiagnosticParams(text_document=document(of)))
        assert {it.code for it in report.items} >= {"undeclared-tag"}
    else:
        assert {it.code for it in client.diagnostics[of]} >= {"undeclared-tag"}
        assert [it.code for it in client.diagnostics[settings]] == ["bad-setting"]


@pytest.mark.parametrize("language", ["toml", "ladder-test", "python"])
async def test_other_texts_may_come_along(client: LanguageClient, language: str):
    name = {"toml": "Cargo.toml", "ladder-test": "motor.ladder-test", "python": "x.py"}[language]
    of = open_file(client, name, "[format]\nwidth = 1\n", language)
    await client.text_document_hover_async(
        t.HoverParams(text_document=document(of), position=t.Position(line=0, character=2))
    )
    client.text_document_did_close(t.DidCloseTextDocumentParams(text_document=document(of)))
