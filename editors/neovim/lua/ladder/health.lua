--- `:checkhealth ladder`.
local M = {}

local health = vim.health
local program = require('ladder.program')
local versions = require('ladder.version')

local function check_neovim()
  if vim.fn.has('nvim-0.11') == 1 then
    health.ok('Neovim ' .. tostring(vim.version()))
  else
    health.error('Neovim 0.11 or later is needed')
  end
end

local function check_server()
  local config = vim.lsp.config.ladder
  local command = config and config.cmd
  if type(command) ~= 'table' then
    return health.info('The language server is started by a function of your own')
  end
  local advice = {
    'Install it: "pip install ladder-logic", "npm install --global ladder-logic" or "cargo install ladder-cli"',
    'It is looked for on your PATH and in ~/.cargo/bin, but never in the current folder.',
    "Or name its place: vim.lsp.config('ladder', { cmd = { '/path/to/ladder', 'lsp' } })",
  }
  if program.is_nowhere(command[1]) then
    return health.error('There is no language server: no program "ladder" was found', advice)
  end
  local printed = program.version(command[1])
  if not printed then
    return health.error(('The language server "%s" does not start'):format(command[1]), advice)
  end
  local misfit = versions.misfit(printed:match('^ladder (%S+)$') or printed:match('^ladder (%S+) %(.*%)$') or printed)
  if misfit then
    return health.warn(('%s (%s)'):format(misfit, command[1]), advice)
  end
  health.ok(('Language server: %s (%s)'):format(printed, vim.fn.exepath(command[1])))
end

local function check_formatter()
  local version = program.version(program.command('ldfmt'))
  if version then
    health.ok('Formatter for the command line: ' .. version)
  else
    health.info(
      '"ldfmt" is not on your PATH; formatting in Neovim goes through the language server and does not need it'
    )
  end
end

local function check_filetype()
  if vim.filetype.match({ filename = 'x.clad' }) == 'clad' then
    health.ok('Files that end in .clad have the file type "clad"')
  else
    health.error('Files that end in .clad are not recognised', { 'Is the plugin on your runtimepath or packpath?' })
  end
end

local function check_clients()
  if not vim.lsp.is_enabled('ladder') then
    health.warn('The language server is not enabled', { "Put vim.lsp.enable('ladder') into your init.lua" })
  end
  local clients = vim.lsp.get_clients({ name = 'ladder' })
  if #clients == 0 then
    return health.info('No language server runs now; one starts with the first ladder file')
  end
  for _, client in ipairs(clients) do
    local provider = client.server_capabilities.executeCommandProvider
    local commands = provider and provider.commands or {}
    local place = client.root_dir or 'no folder'
    health.ok(('Running for %s, positions in %s'):format(place, client.offset_encoding))
    if not vim.list_contains(commands, 'ladder.simulate.start') then
      health.warn('This server cannot simulate', { 'It is older than this plugin: update it' })
    end
  end
end

function M.check()
  health.start('ladder')
  check_neovim()
  check_server()
  check_formatter()
  check_filetype()
  check_clients()
end

return M
