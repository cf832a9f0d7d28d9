--- A debugger works on the session that the buffer shows: the one that runs, or one that is started for it.
local bridge = require('ladder.bridge')
local server = require('ladder.server')
local sessions = require('ladder.session')
local shown = require('ladder.shown')
local simulation = require('ladder.simulation')

local M = {}

--- The buffer of a program, loaded, so that the server sees its text.
local function loaded(bufnr)
  vim.fn.bufload(bufnr)
  return bufnr
end

--- The session that the debugger has, and what becomes of it when the debugger leaves.
local function taken(client, started, what)
  local bufnr = loaded(vim.uri_to_bufnr(started.state.uri))
  local there = sessions.of(bufnr)
  if started.joined and there and there.id == started.session then
    there.debugged = true
    return function()
      there.debugged = nil
      simulation.send_breakpoints(bufnr)
    end
  end
  local session = simulation.adopt(bufnr, client, started, what)
  return function()
    if sessions.of(bufnr) == session then
      simulation.stop(bufnr)
    end
  end
end

--- @param client vim.lsp.Client
--- @param configuration table of the launch
--- @param ready fun(pipe: string) called with the pipe where the debugger is waited for
function M.begin(client, configuration, ready)
  local program = configuration.program
  local what = { lines = {}, tags = {} }
  if type(program) == 'string' and vim.endswith(program, '.clad') then
    what = shown.of(loaded(vim.fn.bufadd(program)))
  end
  local argument = { launch = configuration, options = { show = what } }
  server.command(client, vim.api.nvim_get_current_buf(), 'ladder.simulate.debug', argument, function(err, started)
    if err then
      return vim.notify('ladder: ' .. err.message, vim.log.levels.ERROR)
    end
    ready(bridge.open(client, started.session, taken(client, started, what)))
  end)
end

return M
