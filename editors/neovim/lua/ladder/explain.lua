--- The page of a rule, as the book has it: the server has the text, so that it is there without a network.
local M = {}

--- The findings of the server in a line, the one at the cursor first, then the most severe.
--- @return vim.Diagnostic[]
local function here()
  local row, column = vim.api.nvim_win_get_cursor(0)[1] - 1, vim.api.nvim_win_get_cursor(0)[2]
  local found = vim.tbl_filter(function(diagnostic)
    return diagnostic.source == 'ladder' and type(diagnostic.code) == 'string'
  end, vim.diagnostic.get(0, { lnum = row }))
  local function rank(diagnostic)
    local ends = diagnostic.end_lnum > row and math.huge or diagnostic.end_col
    return (diagnostic.col <= column and column < ends) and 0 or 1
  end
  table.sort(found, function(a, b)
    if rank(a) ~= rank(b) then
      return rank(a) < rank(b)
    end
    return a.severity < b.severity
  end)
  return found
end

--- The rule of the finding at the cursor, else of the most severe one in its line.
--- @return string|nil
function M.rule_here()
  local found = here()[1]
  return found and found.code --[[@as string]]
end

--- The rules that found something in the buffer, for completion.
--- @return string[]
function M.rules()
  local rules = {}
  for _, diagnostic in ipairs(vim.diagnostic.get(0)) do
    if diagnostic.source == 'ladder' and type(diagnostic.code) == 'string' then
      rules[diagnostic.code] = true
    end
  end
  local names = vim.tbl_keys(rules)
  table.sort(names)
  return names
end

--- Shows the page of a rule in a floating window, as a hover.
--- @param bufnr integer
--- @param rule string
function M.show(bufnr, rule)
  local server = require('ladder.server')
  local client = server.await(bufnr)
  if not client then
    return vim.notify('ladder: no language server is attached to this buffer.', vim.log.levels.ERROR)
  end
  server.command(client, bufnr, 'ladder.rulePage', { rule = rule }, function(err, page)
    if err then
      return vim.notify('ladder: ' .. err.message, vim.log.levels.ERROR)
    end
    local lines = vim.split(vim.trim(page.markdown), '\n')
    vim.lsp.util.open_floating_preview(lines, 'markdown', {
      border = 'rounded',
      focus_id = 'ladder.explain',
      max_width = 100,
      wrap = true,
    })
  end)
end

return M
