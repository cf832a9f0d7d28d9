--- The operand that the cursor means.
local sessions = require('ladder.session')

local M = {}

local function around(range, row, character)
  local from, to = range.start, range['end']
  local behind_start = row > from.line or (row == from.line and character >= from.character)
  -- The place just after it counts too: there the cursor is after typing.
  local before_end = row < to.line or (row == to.line and character <= to.character)
  return behind_start and before_end
end

--- The operand at the cursor of the current window; anywhere else in a block its first one.
--- @param session ladder.Session|nil
--- @return ladder.Operand|nil
function M.here(session)
  if not session or session.stale or vim.api.nvim_get_current_buf() ~= session.bufnr then
    return nil
  end
  local row, byte = vim.api.nvim_win_get_cursor(0)[1] - 1, vim.api.nvim_win_get_cursor(0)[2]
  local encoding = session.client.offset_encoding
  local character = vim.str_utfindex(vim.api.nvim_get_current_line(), encoding, byte, false)
  local in_block
  for _, operand in ipairs(session.operands[row] or {}) do
    if around(operand.range, row, character) then
      return operand
    end
    in_block = in_block or (around(operand.block, row, character) and operand or nil)
  end
  return in_block
end

--- The tag at the cursor; one of BOOL if that is wanted and there is one.
--- @param session ladder.Session|nil
--- @param wants_bool boolean|nil
--- @return string|nil
function M.tag_here(session, wants_bool)
  local operand = M.here(session)
  for _, name in ipairs(wants_bool and operand and operand.tags or {}) do
    local tag = sessions.tag(session, name)
    if tag and tag.type == 'BOOL' then
      return name
    end
  end
  return operand and operand.tags[1]
end

return M
