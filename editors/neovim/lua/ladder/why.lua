--- Why a tag holds what it holds: asks the simulator and shows its words in a window at the cursor.
local M = {}

--- @param bufnr integer
--- @param tag string
function M.ask(bufnr, tag)
  require('ladder.simulation').ask(bufnr, 'why', { tag = tag }, M.show)
end

--- @param why { tag: string, text: string, blocks: lsp.Range[] }
function M.show(why)
  local lines = vim.split(why.text, '\n')
  vim.lsp.util.open_floating_preview(lines, 'text', { focus_id = 'ladder_why', wrap = true, max_width = 100 })
end

return M
