--- `:Ladder convert`: shows the program of a buffer in another notation, in a new buffer that is not a file yet.
local server = require('ladder.server')

local M = {}

--- @class ladder.Converted
--- @field to string
--- @field extension string
--- @field text string
--- @field translated integer
--- @field approximated integer
--- @field refused integer
--- @field remarks { line: integer|nil, column: integer|nil, outcome: string, element: string, reason: string }[]
--- @field notes string[]|nil

--- The language server of the buffer, or any: a program of another system has none of its own.
--- @param bufnr integer
--- @return vim.lsp.Client
local function client(bufnr)
  local found = server.of(bufnr) or vim.lsp.get_clients({ name = 'ladder' })[1]
  if not found then
    local config = vim.tbl_extend('force', vim.lsp.config.ladder, { name = 'ladder' })
    -- A function there is for `vim.lsp.enable`.
    config.root_dir = nil
    local id = vim.lsp.start(config, { attach = false })
    found = id and vim.lsp.get_client_by_id(id)
  end
  local runs = found and vim.wait(2000, function()
    return found.initialized
  end, 10)
  if not runs then
    error('the language server does not run; ":checkhealth ladder" says more.', 0)
  end
  return found
end

--- The names of the notations, if a server runs that knows them.
--- @param bufnr integer
--- @return string[]
function M.notations(bufnr)
  local found = server.of(bufnr) or vim.lsp.get_clients({ name = 'ladder' })[1]
  local params = { command = 'ladder.notations', arguments = { vim.empty_dict() } }
  local answer = found and found:request_sync('workspace/executeCommand', params, 1000, bufnr)
  local names = vim.tbl_map(function(notation)
    return notation.name
  end, answer and answer.result and answer.result.notations or {})
  table.insert(names, 'clad')
  return names
end

--- What there is to say about single elements, as entries of the quickfix list.
--- @param bufnr integer
--- @param converted ladder.Converted
--- @return table[]
function M.entries(bufnr, converted)
  local types = { refused = 'E', error = 'E', approximated = 'W', warning = 'W' }
  local entries = vim.tbl_map(function(remark)
    return {
      bufnr = remark.line and bufnr or nil,
      lnum = remark.line,
      col = remark.column,
      type = types[remark.outcome] or 'I',
      text = ('%s: %s: %s'):format(remark.outcome, remark.element, remark.reason),
    }
  end, converted.remarks)
  for _, note in ipairs(converted.notes or {}) do
    table.insert(entries, { type = 'I', text = note })
  end
  return entries
end

--- The name of a file next to the program's that is not there yet; none for a program without a file.
--- @param bufnr integer
--- @param extension string
--- @return string|nil
local function fresh_name(bufnr, extension)
  local program = vim.api.nvim_buf_get_name(bufnr)
  if program == '' then
    return nil
  end
  local stem = vim.fn.fnamemodify(program, ':p:r')
  local name, number = ('%s.%s'):format(stem, extension), 2
  while vim.uv.fs_stat(name) or vim.fn.bufexists(name) == 1 do
    name, number = ('%s-%d.%s'):format(stem, number, extension), number + 1
  end
  return name
end

--- @param bufnr integer
--- @param converted ladder.Converted
local function show(bufnr, converted)
  local entries = M.entries(bufnr, converted)
  local text, returns = converted.text:gsub('\r\n', '\n')
  local lines = vim.split(text, '\n', { plain = true })
  if lines[#lines] == '' then
    table.remove(lines)
  end
  local name = fresh_name(bufnr, converted.extension)
  vim.cmd.new()
  if name then
    vim.api.nvim_buf_set_name(0, name)
  end
  vim.api.nvim_buf_set_lines(0, 0, -1, false, lines)
  if returns > 0 then
    vim.bo.fileformat = 'dos'
  end
  if converted.to == 'clad' then
    vim.bo.filetype = 'clad'
  end
  vim.fn.setqflist({}, ' ', { title = 'Ladder convert', items = entries })
  if #entries > 0 then
    vim.cmd('botright copen | wincmd p')
  end
  local message = 'ladder: %d translated, %d approximated, %d refused'
  local level = converted.refused > 0 and vim.log.levels.WARN or vim.log.levels.INFO
  vim.notify(message:format(converted.translated, converted.approximated, converted.refused), level)
end

--- Converts the program of a buffer, as the buffer has it.
--- @param bufnr integer
--- @param to string|nil the notation; without one ladder text
function M.run(bufnr, to)
  local argument = { uri = vim.uri_from_bufnr(bufnr), to = to or 'clad' }
  -- Ladder text that is open the server has already, with what it knows of it.
  local file = vim.api.nvim_buf_get_name(bufnr)
  local is_known = server.of(bufnr) ~= nil and vim.bo[bufnr].filetype == 'clad'
  if not is_known and (vim.bo[bufnr].modified or not vim.uv.fs_stat(file)) then
    argument.text = table.concat(vim.api.nvim_buf_get_lines(bufnr, 0, -1, false), '\n') .. '\n'
  end
  server.command(client(bufnr), bufnr, 'ladder.convert', argument, function(err, converted)
    if err then
      return vim.notify('ladder: ' .. err.message, vim.log.levels.ERROR)
    end
    show(bufnr, converted)
  end)
end

return M
