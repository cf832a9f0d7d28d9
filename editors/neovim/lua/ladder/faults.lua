--- Faults of a running program (a division by zero, the watchdog), as diagnostics at their places.
local M = {}

local namespace = vim.api.nvim_create_namespace('ladder_faults')

--- What is shown, by buffer: most states have the faults of the one before.
--- @type table<integer, table[]>
local shown = {}

--- @param bufnr integer
--- @param faults { message: string, range: lsp.Range, scan: integer }[]
--- @param encoding string the position encoding of the server
function M.show(bufnr, faults, encoding)
  if vim.deep_equal(shown[bufnr] or {}, faults) then
    return
  end
  shown[bufnr] = faults
  local diagnostics = {}
  for _, fault in ipairs(faults) do
    local from, to = fault.range.start, fault.range['end']
    local first = vim.api.nvim_buf_get_lines(bufnr, from.line, from.line + 1, false)[1] or ''
    local last = vim.api.nvim_buf_get_lines(bufnr, to.line, to.line + 1, false)[1] or ''
    table.insert(diagnostics, {
      lnum = from.line,
      col = vim.str_byteindex(first, encoding, from.character, false),
      end_lnum = to.line,
      end_col = vim.str_byteindex(last, encoding, to.character, false),
      message = ('%s (scan %d)'):format(fault.message, fault.scan),
      severity = vim.diagnostic.severity.ERROR,
      source = 'ladder simulation',
    })
  end
  vim.diagnostic.set(namespace, bufnr, diagnostics)
end

--- @param bufnr integer
function M.clear(bufnr)
  shown[bufnr] = nil
  vim.diagnostic.reset(namespace, bufnr)
end

return M
