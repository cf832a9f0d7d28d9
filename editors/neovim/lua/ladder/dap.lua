--- Tells nvim-dap how ladder programs and their scenarios are debugged.
local M = {}

--- The name of the adapter, and the type of its configurations.
local NAME = 'ladder'

--- The program `ladder`: the one that the language server is started from, if that says it.
local function program()
  local config = vim.lsp.config[NAME]
  local command = config and config.cmd
  if type(command) == 'table' and command[1] then
    return command[1]
  end
  return require('ladder.program').command('ladder')
end

--- The language server, if one runs: of this buffer, or of any.
local function server()
  return require('ladder.server').of(0) or vim.lsp.get_clients({ name = NAME })[1]
end

--- The names of the scenarios of a file, in their order.
--- @param lines string[]
--- @return string[]
function M.scenarios(lines)
  local names = {}
  for _, line in ipairs(lines) do
    local name = line:match('^%s*scenario%s+"([^"]*)"')
    if name then
      table.insert(names, name)
    end
  end
  return names
end

--- The name of the scenario that the cursor is in.
--- @return string|nil
function M.scenario_here()
  local above = vim.api.nvim_buf_get_lines(0, 0, vim.fn.line('.'), false)
  local names = M.scenarios(above)
  return names[#names]
end

local programs = {
  {
    type = NAME,
    request = 'launch',
    name = 'Run this program, from before its first scan',
    program = '${file}',
    stopOnEntry = true,
  },
  { type = NAME, request = 'launch', name = 'Run this program up to its breakpoints', program = '${file}' },
}

local scenarios = {
  {
    type = NAME,
    request = 'launch',
    name = 'Run the scenario at the cursor',
    scenarioFile = '${file}',
    scenarioLine = function()
      return vim.fn.line('.')
    end,
  },
}

--- @param known table[]|nil
--- @param ours table[]
local function with(known, ours)
  local configurations = {}
  for _, configuration in ipairs(known or {}) do
    if configuration.type ~= NAME or not configuration.ladder_default then
      table.insert(configurations, configuration)
    end
  end
  for _, configuration in ipairs(ours) do
    table.insert(configurations, vim.tbl_extend('force', configuration, { ladder_default = true }))
  end
  return configurations
end

--- Registers the adapter and its configurations. Again does no harm; an adapter of this name that a person has
--- made stays.
--- @return boolean registered false if there is no nvim-dap
function M.register()
  local there, dap = pcall(require, 'dap')
  if not there then
    return false
  end
  if not dap.adapters[NAME] then
    dap.adapters[NAME] = function(callback, configuration)
      local client = server()
      if client then
        return require('ladder.debugging').begin(client, configuration, function(pipe)
          callback({ type = 'pipe', pipe = pipe })
        end)
      end
      callback({
        type = 'executable',
        command = program(),
        args = { 'dap' },
        -- Not in the folder that is open, where Windows would look for libraries.
        options = { cwd = vim.uv.os_homedir() },
      })
    end
  end
  dap.configurations.clad = with(dap.configurations.clad, programs)
  dap.configurations.laddertest = with(dap.configurations.laddertest, scenarios)
  return true
end

--- The same, if nvim-dap is installed: for the first ladder file.
function M.register_if_there()
  local is_loaded = package.loaded.dap or package.preload.dap
  if is_loaded or #vim.api.nvim_get_runtime_file('lua/dap.lua', false) > 0 then
    M.register()
  end
end

return M
