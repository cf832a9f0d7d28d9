--- Changes of a program that the server works out: each is one step of undo.
local server = require('ladder.server')

local M = {}

--- Says why something is not done.
--- @param why string
function M.refuse(why)
  vim.notify('ladder: ' .. why, vim.log.levels.WARN)
end

--- Asks the server about a program. What it refuses is shown, with the reason.
--- @param source integer the buffer of the program
--- @param command string
--- @param argument table
--- @param answer fun(result: any, client: vim.lsp.Client)
function M.ask(source, command, argument, answer)
  local client = server.of(source)
  if not client then
    return M.refuse('no language server is attached')
  end
  argument.uri = vim.uri_from_bufnr(source)
  server.command(client, source, command, argument, function(err, result)
    if err then
      return M.refuse(err.message)
    end
    if vim.api.nvim_buf_is_loaded(source) then
      answer(result, client)
    end
  end)
end

--- Makes a change, unless the text becomes another one meanwhile.
--- @param source integer
--- @param command string
--- @param argument table
--- @param done fun(made: table, client: vim.lsp.Client)
function M.make(source, command, argument, done)
  local tick = vim.api.nvim_buf_get_changedtick(source)
  M.ask(source, command, argument, function(made, client)
    if vim.api.nvim_buf_get_changedtick(source) ~= tick then
      return M.refuse('the text was changed meanwhile')
    end
    -- What is typed in another window ends no step of undo here.
    vim.bo[source].undolevels = vim.bo[source].undolevels
    -- Neovim would make one line too many of a text behind the last line.
    local last = vim.api.nvim_buf_line_count(source)
    for _, edit in ipairs(made.edits) do
      if edit.range.start.line >= last then
        edit.newText = edit.newText:gsub('\r?\n$', '')
      end
    end
    local own = { uri = argument.uri, version = made.version, edits = made.edits }
    local changes = vim.tbl_map(function(file)
      return { textDocument = { uri = file.uri, version = file.version }, edits = file.edits }
    end, vim.list_extend({ own }, made.also or {}))
    vim.lsp.util.apply_workspace_edit({ documentChanges = changes }, client.offset_encoding)
    done(made, client)
  end)
end

return M
