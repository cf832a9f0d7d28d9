--- Paints the power flow: one extmark on every wire, block and connector that is shown, set again when it changes.
require('ladder.highlight')

local M = {}

local namespace = vim.api.nvim_create_namespace('ladder_power')
local next_namespace = vim.api.nvim_create_namespace('ladder_next')
-- Above semantic tokens (125), below the underline of a diagnostic (150).
local priority = 140

--- The marks by buffer, line and column of the server.
--- @type table<integer, table<integer, table<integer, integer>>>
local painted = {}

--- @param bufnr integer
--- @param position lsp.Position
--- @param encoding string
--- @return integer col in bytes
local function byte_column(bufnr, position, encoding)
  if encoding == 'utf-8' then
    return position.character
  end
  local line = vim.api.nvim_buf_get_lines(bufnr, position.line, position.line + 1, false)[1] or ''
  return vim.str_byteindex(line, encoding, position.character, false)
end

--- @param element ladder.Power
--- @return string group
local function group_of(element)
  if element.unknown then
    return 'LadderPowerUnknown'
  elseif element.contact == 'closed' then
    return element.on and 'LadderClosedOn' or 'LadderClosed'
  elseif element.contact == 'blocks' then
    return 'LadderBlocks'
  end
  return element.on and 'LadderPowerOn' or 'LadderPowerOff'
end

--- @param bufnr integer
--- @param power ladder.Power[] what has changed
--- @param encoding string the position encoding of the server
function M.paint(bufnr, power, encoding)
  painted[bufnr] = painted[bufnr] or {}
  for _, element in ipairs(power) do
    local from, to = element.range.start, element.range['end']
    local line = painted[bufnr][from.line] or {}
    painted[bufnr][from.line] = line
    line[from.character] = vim.api.nvim_buf_set_extmark(
      bufnr,
      namespace,
      from.line,
      byte_column(bufnr, from, encoding),
      {
        id = line[from.character],
        end_row = to.line,
        end_col = byte_column(bufnr, to, encoding),
        hl_group = group_of(element),
        priority = priority,
        invalidate = true,
        undo_restore = false,
        strict = false,
      }
    )
  end
end

--- Takes off what was painted in lines that are not shown any more.
--- @param bufnr integer
--- @param is_shown fun(line: integer): boolean
function M.forget(bufnr, is_shown)
  for line, marks in pairs(painted[bufnr] or {}) do
    if not is_shown(line) then
      for _, mark in pairs(marks) do
        vim.api.nvim_buf_del_extmark(bufnr, namespace, mark)
      end
      painted[bufnr][line] = nil
    end
  end
end

--- Marks the block that runs next, in the midst of a scan.
--- @param bufnr integer
--- @param range lsp.Range|nil
--- @param encoding string
function M.mark_next(bufnr, range, encoding)
  vim.api.nvim_buf_clear_namespace(bufnr, next_namespace, 0, -1)
  if not range then
    return
  end
  vim.api.nvim_buf_set_extmark(bufnr, next_namespace, range.start.line, byte_column(bufnr, range.start, encoding), {
    end_row = range['end'].line,
    end_col = byte_column(bufnr, range['end'], encoding),
    hl_group = 'LadderNext',
    priority = priority + 1,
    strict = false,
  })
end

--- @param bufnr integer
function M.clear(bufnr)
  painted[bufnr] = nil
  vim.api.nvim_buf_clear_namespace(bufnr, namespace, 0, -1)
  vim.api.nvim_buf_clear_namespace(bufnr, next_namespace, 0, -1)
end

return M
