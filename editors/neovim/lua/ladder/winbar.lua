--- How the simulation is, above the program's windows: scan, time, forces and faults are always in sight there.
--- `vim.g.ladder_winbar = false` leaves the windows alone, for those who have `b:ladder_status` in their status line.
require('ladder.highlight')

local status = require('ladder.status')

local M = {}

local keys = 'F5 run  F6 pause  F10 step  F8 back  F4 toggle'

--- The windows' own bars, to give them back.
--- @type table<integer, string>
local before = {}

--- @param bufnr integer
--- @param session ladder.Session|nil
function M.show(bufnr, session)
  if vim.g.ladder_winbar == false then
    return
  end
  for _, window in ipairs(vim.fn.win_findbuf(bufnr)) do
    -- A bar of its own takes a line from a window, and one of a single line has none to give.
    if session and vim.api.nvim_win_get_height(window) > 2 then
      before[window] = before[window] or vim.wo[window].winbar
      local state = session.state
      local bad = state and (#state.faults > 0 or state.status == 'faulted')
      local group = (bad or state and state.stale) and '%#LadderForced#' or ''
      local text = status.text(session):gsub('%%', '%%%%')
      -- What has no room is cut off at the end.
      vim.wo[window][0].winbar = (' %s%s%%*%%=  %s %%<'):format(group, text, keys)
    elseif before[window] then
      vim.wo[window][0].winbar = before[window]
      before[window] = nil
    end
  end
end

return M
