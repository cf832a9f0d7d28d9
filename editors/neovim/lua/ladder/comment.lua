--- Turns lines into comments and back. A comment cannot hold a `#`, so the editor's own `gc` would break a rung with a
--- duration in it: what is to be written the server knows.
local M = {}

--- In milliseconds. The operator waits for the answer: what is typed next is about the new text.
local PATIENCE = 2000

local function warn(message)
  vim.notify('ladder: ' .. message, vim.log.levels.WARN)
end

--- The operator's function: `gc` sets it as 'operatorfunc'.
function M.operate()
  local bufnr = vim.api.nvim_get_current_buf()
  local client = require('ladder.server').await(bufnr)
  if not client then
    return warn('no language server is attached')
  end
  local first, last = vim.api.nvim_buf_get_mark(0, '[')[1], vim.api.nvim_buf_get_mark(0, ']')[1]
  local argument = { uri = vim.uri_from_bufnr(bufnr), lines = { { first = first - 1, last = last - 1 } } }
  local params = { command = 'ladder.comment', arguments = { argument } }
  local answer, why = client:request_sync('workspace/executeCommand', params, PATIENCE, bufnr)
  if not answer or answer.err then
    return warn(answer and answer.err.message or 'no answer to the comment: ' .. why)
  end
  vim.lsp.util.apply_text_edits(answer.result.edits, bufnr, client.offset_encoding)
end

--- For a mapping with `expr`: begins the operator.
--- @return string
function M.start()
  vim.o.operatorfunc = "v:lua.require'ladder.comment'.operate"
  return 'g@'
end

return M
