"""`ladder mcp` next to the protocol's own client: an assistant that has nothing but the tools repairs a program."""

import asyncio
import os

from mcp import Client, StdioServerParameters
from mcp_types import ListRootsResult, Root

LADDER = os.environ["LADDER_BIN"]

# Three errors: a block that is not closed, a branch that ends beside its partner, and a stop that does not win.
BROKEN = """\
VAR_INPUT
    start, stop : BOOL;
END_VAR
VAR_OUTPUT
    run : BOOL;
END_VAR

+--\\--[ ]( start )--\\--[ ]( stop )--( )( run --+
|  /--[ ]( run )--/   |
"""

SCENARIOS = """\
program motor.clad
never run and stop
scenario "it seals in, and stop wins"
start   _-__-_
stop    ___--_
run  => _--___
"""


def talk(folder, job, **options):
    """What comes of a job with a client whose server is in a folder."""

    async def run():
        server = StdioServerParameters(command=LADDER, args=["mcp"], cwd=str(folder))
        async with Client(server, read_timeout_seconds=60, **options) as client:
            return await job(client)

    return asyncio.run(run())


async def call(client, tool, **arguments):
    result = await client.call_tool(tool, arguments)
    assert not result.is_error, result.content
    # The client itself holds it against the output schema.
    return result.structured_content


def test_a_broken_program_is_repaired_by_tools_alone(tmp_path):
    (tmp_path / "motor.clad").write_text(BROKEN)
    (tmp_path / "motor.ladder-test").write_text(SCENARIOS)

    async def repair(client):
        assert {tool.name for tool in (await client.list_tools()).tools} >= {"check", "fix", "format", "test", "prove"}
        found = await call(client, "check", path="motor.clad")
        assert not found["ok"]
        assert {"unclosed-block"} <= {finding["rule"] for finding in found["findings"]}
        await call(client, "fix", path="motor.clad", write=True)
        await call(client, "format", path="motor.clad", write=True)
        left = await call(client, "check", path="motor.clad")
        assert [it for it in left["findings"] if it["severity"] == "error"] == [], left
        tested = await call(client, "test", path="motor.ladder-test")
        assert [it["passed"] for it in tested["scenarios"]] == [False]
        proved = await call(client, "prove", path="motor.ladder-test")
        assert proved["properties"][0]["verdict"] == "violated"
        # What the assistant itself writes, as it would with its own editor.
        text = (tmp_path / "motor.clad").read_text()
        (tmp_path / "motor.clad").write_text(text.replace("[ ]( stop )", "[/]( stop )"))
        assert (await call(client, "test", path="."))["ok"]
        assert (await call(client, "prove", path="."))["properties"][0]["verdict"] == "proved"
        drawn = await call(client, "render", path="motor.clad")
        return drawn["text"]

    assert "stop" in talk(tmp_path, repair)


def test_the_client_says_which_folders_are_open(tmp_path):
    for name in ["here", "there"]:
        (tmp_path / name).mkdir()
        (tmp_path / name / f"{name}.clad").write_text("+--[ ]( a )--( )( b )--+\n")

    async def roots(context):
        return ListRootsResult(roots=[Root(uri=(tmp_path / "there").as_uri())])

    async def ask(client):
        assert (await call(client, "check", path="there.clad"))["ok"]
        refused = await client.call_tool("check", {"path": "here.clad"})
        return refused.is_error

    assert talk(tmp_path / "here", ask, list_roots_callback=roots, mode="legacy")


def test_resources_and_prompts_are_there(tmp_path):
    async def read(client):
        listed = await client.list_resources()
        guide = await client.read_resource(str(listed.resources[0].uri))
        prompts = await client.list_prompts()
        return guide.contents[0].text, [prompt.name for prompt in prompts.prompts]

    guide, prompts = talk(tmp_path, read)
    assert "A column is a step" in guide
    assert prompts == ["review_change", "write_scenarios", "explain_rung"]
