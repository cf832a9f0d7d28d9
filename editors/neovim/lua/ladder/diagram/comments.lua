--- Comments in the diagram.
local change = require('ladder.change')
local here = require('ladder.diagram.here')

local M = {}

--- @param range lsp.Range
--- @param text string
function M.write(pen, range, text)
  vim.ui.input({ prompt = 'Comment: ', default = text }, function(new)
    if new and new ~= text then
      pen:edit({ op = 'comment', what = range, text = new })
    end
  end)
end

--- Writes a comment above the network; of a line that is a comment another text.
function M.above(pen)
  local line = here.line(pen.diagram)
  if not line then
    return change.refuse('there is no network under the cursor')
  end
  local written = vim.api.nvim_buf_get_lines(pen.source, line, line + 1, false)[1] or ''
  local own = written:match('^%s*#%s*([^#]-)%s*#%s*$')
  if own then
    local first, last = written:find('#.*#')
    local range = { start = { line = line, character = first - 1 }, ['end'] = { line = line, character = last } }
    return M.write(pen, range, own)
  end
  vim.ui.input({ prompt = 'Comment above the network: ' }, function(text)
    if text and text ~= '' then
      pen:edit({ op = 'comment', network = line, text = text })
    end
  end)
end

return M
