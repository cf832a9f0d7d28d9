--- Paints the power flow: one extmark on every wire, block and connector, recoloured when its power changes.
require('ladder.highlight')

local M = {}

local namespace = vim.api.nvim_create_namespace('ladder_power')
local next_namespace = vim.api.nvim_create_namespace('ladder_next')
-- Above semantic tokens (125), below the underline of a diagnostic (150).
local priority = 140

--- @class ladder.Mark
--- @field id integer
--- @field row integer
--- @field col integer
--- @field end_row integer
--- @field end_col integer
--- @field on boolean
--- @field range lsp.Range

--- What is painted now, in the order of the server's list.
--- @type table<integer, ladder.Mark[]>
local painted = {}

--- @param bufnr integer
--- @param position lsp.Position
--- @param encoding string
--- @return integer row, integer col in bytes
local function byte_position(bufnr, position, encoding)
  local line = vim.api.nvim_buf_get_lines(bufnr, position.line, position.line + 1, false)[1] or ''
  return position.line, vim.str_byteindex(line, encoding, position.character, false)
end

--- @param bufnr integer
--- @param mark ladder.Mark
local function put(bufnr, mark)
  mark.id = vim.api.nvim_buf_set_extmark(bufnr, namespace, mark.row, mark.col, {
    id = mark.id,
    end_row = mark.end_row,
    end_col = mark.end_col,
    hl_group = mark.on and 'LadderPowerOn' or 'LadderPowerOff',
    priority = priority,
    invalidate = true,
    undo_restore = false,
    strict = false,
  })
end

local function same_range(a, b)
  return a.start.line == b.start.line
    and a.start.character == b.start.character
    and a['end'].line == b['end'].line
    and a['end'].character == b['end'].character
end

--- @param bufnr integer
--- @param power { range: lsp.Range, on: boolean }[]
--- @param encoding string the position encoding of the server
function M.paint(bufnr, power, encoding)
  local marks = painted[bufnr] or {}
  if #marks ~= #power then
    M.clear(bufnr)
    marks = {}
  end
  painted[bufnr] = marks
  for index, item in ipairs(power) do
    local mark = marks[index]
    if not mark or not same_range(mark.range, item.range) then
      local row, col = byte_position(bufnr, item.range.start, encoding)
      local end_row, end_col = byte_position(bufnr, item.range['end'], encoding)
      mark = {
        id = mark and mark.id,
        row = row,
        col = col,
        end_row = end_row,
        end_col = end_col,
        on = item.on,
        range = item.range,
      }
      marks[index] = mark
      put(bufnr, mark)
    elseif mark.on ~= item.on then
      mark.on = item.on
      put(bufnr, mark)
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
  local row, col = byte_position(bufnr, range.start, encoding)
  local end_row, end_col = byte_position(bufnr, range['end'], encoding)
  vim.api.nvim_buf_set_extmark(bufnr, next_namespace, row, col, {
    end_row = end_row,
    end_col = end_col,
    hl_group = 'LadderNext',
    priority = priority + 1,
    strict = false,
  })
end

--- Greys what is painted, where it stands now: the marks have moved with the text.
--- @param bufnr integer
function M.grey(bufnr)
  painted[bufnr] = nil
  vim.api.nvim_buf_clear_namespace(bufnr, next_namespace, 0, -1)
  for _, mark in ipairs(vim.api.nvim_buf_get_extmarks(bufnr, namespace, 0, -1, { details = true })) do
    local id, row, col, details = mark[1], mark[2], mark[3], mark[4]
    if not details.invalid then
      vim.api.nvim_buf_set_extmark(bufnr, namespace, row, col, {
        id = id,
        end_row = details.end_row,
        end_col = details.end_col,
        hl_group = 'LadderStale',
        priority = priority,
        invalidate = true,
        undo_restore = false,
      })
    end
  end
end

--- @param bufnr integer
function M.clear(bufnr)
  painted[bufnr] = nil
  vim.api.nvim_buf_clear_namespace(bufnr, namespace, 0, -1)
  vim.api.nvim_buf_clear_namespace(bufnr, next_namespace, 0, -1)
end

return M
