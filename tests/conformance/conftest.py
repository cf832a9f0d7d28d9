"""Sessions with the profiles of three editors, in a small workspace."""

import os
import pathlib

import pytest
import pytest_lsp
from lsprotocol import types
from pytest_lsp import ClientServerConfig, LanguageClient, client_capabilities, make_test_lsp_client

LADDER = os.environ["LADDER_BIN"]

# What each editor can, as pytest-lsp recorded it; VS Code has asked for diagnostics since 1.72, so it comes twice.
PROFILES = ["neovim", "visual_studio_code", "visual_studio_code, asking", "emacs"]

MOTOR = """\
# Start and stop, see motor.ladder-test #
VAR_INPUT
    start, stop : BOOL;
END_VAR
VAR
    warmup : TON;
END_VAR

# The seal-in #
+--\\--[ ]( start )--\\--[/]( stop )----------------( )( run )--+
|  |                |                                         |
|  /--[ ]( run )----/                                         |

+--[ ]( run )--[TON]( warmup, T#5s )--------------( )( ready )--+
+--[ ]( ready )--<CALL>( count )--+
+--[ ]( strat )--( )( lamp )--+
"""

LIBRARY = """\
VAR_GLOBAL
    pieces : DINT;
END_VAR
+--<FUN>( count )--[ADD]( pieces, pieces, 1 )--+
"""


def capabilities(profile: str) -> types.ClientCapabilities:
    name, _, asking = profile.partition(", ")
    found = client_capabilities(name)
    if asking:
        found.text_document.diagnostic = types.DiagnosticClientCapabilities(related_document_support=True)
        found.workspace.diagnostics = types.DiagnosticWorkspaceClientCapabilities(refresh_support=True)
    return found


@pytest.fixture
def plant(tmp_path: pathlib.Path) -> pathlib.Path:
    (tmp_path / "ladder.toml").write_text("[lint]\nopen-wires = \"off\"\n")
    (tmp_path / "motor.clad").write_text(MOTOR)
    (tmp_path / "library.clad").write_text(LIBRARY)
    (tmp_path / "motor.ladder-test").write_text(
        'program motor.clad\nstep 10ms\n\nscenario "runs"\nstart _-\nrun => _-\n'
    )
    return tmp_path


def make_client() -> LanguageClient:
    """A client that answers what editors answer, also where pytest-lsp leaves it to the test."""
    client = make_test_lsp_client()
    for method in (
        "client/registerCapability",
        "workspace/inlayHint/refresh",
        "workspace/codeLens/refresh",
        "workspace/semanticTokens/refresh",
    ):
        client.feature(method)(lambda params: None)
    return client


@pytest_lsp.fixture(
    params=PROFILES,
    config=ClientServerConfig(server_command=[LADDER, "lsp"], client_factory=make_client),
)
async def client(request, lsp_client: LanguageClient, plant: pathlib.Path):
    lsp_client.set_configuration({"inlayHints": {"enable": True}}, section="ladder")
    root = plant.as_uri()
    result = await lsp_client.initialize_session(
        types.InitializeParams(
            capabilities=capabilities(request.param),
            root_uri=root,
            workspace_folders=[types.WorkspaceFolder(uri=root, name="plant")],
        )
    )
    lsp_client.offered = result.capabilities
    lsp_client.plant = plant
    yield
    await lsp_client.shutdown_session()
