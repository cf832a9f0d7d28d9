--- Shows what the keys of a diagram work on: the block, wire or line from rung to rung under its cursor.
require('ladder.highlight')

local here = require('ladder.diagram.here')

local M = {}

local namespace = vim.api.nvim_create_namespace('ladder_diagram_here')

--- The rows that are marked, from 1, and the columns.
--- @param diagram ladder.Diagram
--- @return integer|nil first, integer|nil last, integer[]|nil columns
local function area(diagram)
  local block = here.block(diagram)
  if block then
    local row = here.row_of(diagram, block)
    return row, row, block.columns
  end
  local wire = here.wire(diagram)
  if wire then
    return wire.line + 1, wire.line + 1, wire.columns
  end
  local join = here.join(diagram)
  if join then
    return join.lines[1] + 1, join.lines[2], { join.column, join.column + 1 }
  end
end

--- @param diagram ladder.Diagram
--- @param has_focus boolean
function M.show(diagram, has_focus)
  vim.api.nvim_buf_clear_namespace(diagram.bufnr, namespace, 0, -1)
  if not has_focus then
    return
  end
  local first, last, columns = area(diagram)
  for row = first or 1, last or 0 do
    local line = vim.api.nvim_buf_get_lines(diagram.bufnr, row - 1, row, false)[1] or ''
    local function byte(column)
      return vim.str_byteindex(line, 'utf-32', column, false)
    end
    vim.api.nvim_buf_set_extmark(diagram.bufnr, namespace, row - 1, byte(columns[1]), {
      end_col = byte(columns[2]),
      hl_group = 'LadderHere',
      priority = 200,
      strict = false,
    })
  end
end

return M
