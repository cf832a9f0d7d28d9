--- The lines of the diagram in its buffer: what is drawn, and how it looks.
local cursor = require('ladder.diagram.cursor')
local side_buffer = require('ladder.side_buffer')

local M = {}

local namespace = vim.api.nvim_create_namespace('ladder_diagram')

local groups = {
  on = 'LadderPowerOn',
  off = 'LadderPowerOff',
  closed = 'LadderClosed',
  blocks = 'LadderBlocks',
  rail = 'LadderPowerOff',
  tag = 'LadderTagName',
  name = 'LadderBlockName',
  pin = 'LadderPowerOff',
  value = 'LadderValue',
  forced = 'LadderForced',
  comment = 'Comment',
  text = 'LadderPowerOff',
}

--- @param line string
--- @param character integer
local function byte(line, character)
  return vim.str_byteindex(line, 'utf-32', character, false)
end

--- Draws the lines that have changed.
--- @param source integer
--- @param diagram ladder.Diagram
--- @param drawn table
function M.draw(source, diagram, drawn)
  local before = diagram.drawn
  diagram.drawn, diagram.blocks = drawn.drawn, drawn.blocks
  diagram.wires, diagram.joins = drawn.wires, drawn.joins
  local cursors = {}
  for _, window in ipairs(side_buffer.windows(diagram.bufnr)) do
    local row, at = unpack(vim.api.nvim_win_get_cursor(window))
    if before[row] then
      local column = vim.str_utfindex(before[row].text, 'utf-32', at, false)
      cursors[window] = { line = before[row].line, row = row, column = column }
    end
  end
  local bufnr = diagram.bufnr
  vim.bo[bufnr].modifiable = true
  if #before > #drawn.drawn then
    vim.api.nvim_buf_set_lines(bufnr, #drawn.drawn, -1, false, {})
  end
  for index, line in ipairs(drawn.drawn) do
    local old = before[index]
    if not old or old.text ~= line.text or not vim.deep_equal(old.marks, line.marks) then
      vim.api.nvim_buf_set_lines(bufnr, index - 1, index, false, { line.text })
      vim.api.nvim_buf_clear_namespace(bufnr, namespace, index - 1, index)
      for _, mark in ipairs(line.marks or {}) do
        if groups[mark[3]] then
          vim.api.nvim_buf_set_extmark(bufnr, namespace, index - 1, byte(line.text, mark[1]), {
            end_col = byte(line.text, mark[2]),
            hl_group = groups[mark[3]],
            strict = false,
          })
        end
      end
    end
  end
  if #drawn.drawn == 0 then
    vim.api.nvim_buf_set_lines(bufnr, 0, -1, false, { 'There is no network in sight.' })
  end
  vim.bo[bufnr].modifiable = false
  -- Other lines are shown: the cursor stays on its rung.
  local moved = #before ~= #drawn.drawn or (before[1] and drawn.drawn[1] and before[1].line ~= drawn.drawn[1].line)
  for window, was in pairs(cursors) do
    local row = was.row
    if moved then
      row = window == vim.api.nvim_get_current_win() and cursor.row_of(diagram, was.line) or nil
    end
    -- A wire with power is longer in bytes: the cursor stays on its character.
    if row and drawn.drawn[row] then
      local place = { row, byte(drawn.drawn[row].text, was.column) }
      if not vim.deep_equal(place, vim.api.nvim_win_get_cursor(window)) then
        vim.api.nvim_win_set_cursor(window, place)
      end
    end
  end
  if moved then
    cursor.follow(source, diagram)
  end
  cursor.reach(diagram, drawn.version)
end

return M
