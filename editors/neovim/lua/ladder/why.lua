--- Why a tag holds what it holds: asks the simulator and shows its words in a window at the cursor.
local M = {}

--- The tag under the cursor: `run`, `t1.ET`, `a[3]`, `%IX0.1`; of a timer or counter the first of its members.
--- @param state ladder.State|nil
--- @return string|nil
function M.tag_here(state)
  local line = vim.api.nvim_get_current_line()
  local column = vim.api.nvim_win_get_cursor(0)[2] + 1
  local found
  for from, word, to in line:gmatch('()([%w_%.%%\128-\255]+%[?%d*%]?)()') do
    if from <= column and column < to then
      found = word
    end
  end
  if not found or require('ladder.session').tag(state, found) then
    return found
  end
  local prefix = vim.fn.tolower(found) .. '.'
  for _, tag in ipairs(state and state.tags or {}) do
    if vim.startswith(vim.fn.tolower(tag.name), prefix) then
      return tag.name
    end
  end
  return found
end

--- @param why { tag: string, text: string, blocks: lsp.Range[] }
function M.show(why)
  local lines = vim.split(why.text, '\n')
  vim.lsp.util.open_floating_preview(lines, 'text', { focus_id = 'ladder_why', wrap = true, max_width = 100 })
end

return M
