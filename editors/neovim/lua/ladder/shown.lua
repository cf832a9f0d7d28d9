--- Which part of the program is shown: the lines in its windows, and the tags in its panel. The server tells of nothing
--- else.
local sessions = require('ladder.session')

local M = {}

-- So many lines above and below a window are kept ready for scrolling.
local margin = 10

--- The tags that are shown besides, by buffer: what a panel lists.
--- @type table<integer, fun(): string[]>
local tags_of = {}

--- @param bufnr integer
--- @param tags (fun(): string[])|nil
function M.tags(bufnr, tags)
  tags_of[bufnr] = tags
end

--- What the windows of a buffer show, as the server takes it.
--- @param bufnr integer
--- @return { lines: { first: integer, last: integer }[], tags: string[] }
function M.of(bufnr)
  local lines = {}
  local count = vim.api.nvim_buf_line_count(bufnr)
  for _, window in ipairs(vim.fn.win_findbuf(bufnr)) do
    local info = vim.fn.getwininfo(window)[1]
    -- The window may not have been drawn since it was opened; with folds it shows more lines than it is high.
    local last = math.max(info.botline, info.topline + info.height)
    table.insert(lines, {
      first = math.max(info.topline - 1 - margin, 0),
      last = math.min(last - 1 + margin, count - 1),
    })
  end
  return { lines = lines, tags = tags_of[bufnr] and tags_of[bufnr]() or {} }
end

--- @param shown { lines: { first: integer, last: integer }[] }
--- @return fun(line: integer): boolean
function M.is_shown(shown)
  return function(line)
    for _, lines in ipairs(shown.lines) do
      if lines.first <= line and line <= lines.last then
        return true
      end
    end
    return false
  end
end

--- Calls back when a session shows something else.
--- @param callback fun(session: ladder.Session)
function M.on_change(callback)
  vim.api.nvim_create_autocmd({ 'WinScrolled', 'WinResized', 'BufWinEnter', 'WinClosed' }, {
    group = vim.api.nvim_create_augroup('ladder_shown', {}),
    callback = function()
      -- A window that closes still is there.
      vim.schedule(function()
        for _, session in ipairs(sessions.all()) do
          callback(session)
        end
      end)
    end,
  })
end

return M
