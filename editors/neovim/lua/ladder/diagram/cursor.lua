--- Where the cursor of the program is in the diagram, and the other way round.
local server = require('ladder.server')
local side_buffer = require('ladder.side_buffer')

local M = {}

--- The line of the diagram that shows a line of the program, or the last one before it: of a rung that of its wire.
--- @param diagram ladder.Diagram
--- @param line integer
--- @return integer|nil row from 1
function M.row_of(diagram, line)
  local found
  for row, drawn in ipairs(diagram.drawn) do
    if drawn.line > line and found then
      break
    end
    local is_better = not found or drawn.line > diagram.drawn[found].line or drawn.wire
    if drawn.text ~= '' and is_better then
      found = row
    end
  end
  return found
end

--- Scrolls a window of the diagram as little as brings the network of a line into sight.
--- @param diagram ladder.Diagram
--- @param window integer
--- @param row integer from 1
--- @param column integer that the cursor is put on
local function reveal(diagram, window, row, column)
  local first, last = row, row
  while first > 1 and diagram.drawn[first - 1].text ~= '' do
    first = first - 1
  end
  while diagram.drawn[last + 1] and diagram.drawn[last + 1].text ~= '' do
    last = last + 1
  end
  vim.api.nvim_win_call(window, function()
    local height = vim.api.nvim_win_get_height(window) - 1
    local top = vim.fn.winsaveview().topline
    top = math.max(top, last - height + 1)
    -- Of a network that is too high the rung itself is seen.
    top = math.max(math.min(top, first), row - height + 1)
    local at = vim.str_byteindex(diagram.drawn[row].text, 'utf-32', column, false)
    vim.fn.winrestview({ lnum = row, col = at, curswant = column, topline = top, leftcol = 0 })
  end)
end

--- The block at a place of the program.
--- @param source integer
--- @param diagram ladder.Diagram
--- @param line integer
--- @param at integer in bytes
--- @return ladder.DrawnBlock|nil
local function block_at(source, diagram, line, at)
  local client = server.of(source)
  local text = vim.api.nvim_buf_get_lines(source, line, line + 1, false)[1] or ''
  local character = client and vim.str_utfindex(text, client.offset_encoding, math.min(at, #text), false) or at
  for _, block in ipairs(diagram.blocks) do
    local from, to = block.range.start, block.range['end']
    if from.line == line and to.line == line and from.character <= character and character < to.character then
      return block
    end
  end
end

--- Brings what shows the cursor's line of the program into sight, and puts the cursor on the same block.
--- @param source integer
--- @param diagram ladder.Diagram
function M.follow(source, diagram)
  local window = vim.fn.bufwinid(source)
  if window == -1 or #diagram.drawn == 0 then
    return
  end
  local line, at = unpack(vim.api.nvim_win_get_cursor(window))
  local row = M.row_of(diagram, line - 1)
  local block = block_at(source, diagram, line - 1, at)
  local column = block and math.floor((block.columns[1] + block.columns[2]) / 2) or 0
  for _, own in ipairs(row and side_buffer.windows(diagram.bufnr) or {}) do
    if own ~= vim.api.nvim_get_current_win() then
      reveal(diagram, own, row, column)
    end
  end
end

--- The block under the cursor of the diagram.
--- @param diagram ladder.Diagram
--- @return ladder.DrawnBlock|nil
function M.block_here(diagram)
  local row, at = unpack(vim.api.nvim_win_get_cursor(0))
  local line = vim.api.nvim_get_current_line()
  local column = vim.fn.strdisplaywidth(line:sub(1, at))
  local found, distance
  for _, block in ipairs(diagram.blocks) do
    local is_here = block.lines[1] < row and row <= block.lines[2]
    if is_here and block.columns[1] <= column and column < block.columns[2] then
      -- The one whose wire is nearest, where the rooms of two rungs overlap.
      local middle = (block.lines[1] + block.lines[2]) / 2
      if not found or math.abs(middle - row) < distance then
        found, distance = block, math.abs(middle - row)
      end
    end
  end
  return found
end

--- The line of the program that the cursor of the diagram is on.
--- @param diagram ladder.Diagram
--- @return integer|nil
function M.line_here(diagram)
  local block = M.block_here(diagram)
  local drawn = diagram.drawn[vim.api.nvim_win_get_cursor(0)[1]]
  return block and block.range.start.line or drawn and drawn.line
end

--- Goes to the place in the program of what the cursor is on.
--- @param source integer
--- @param diagram ladder.Diagram
function M.open_text(source, diagram)
  local block, line = M.block_here(diagram), M.line_here(diagram)
  local window = vim.fn.bufwinid(source)
  if window == -1 or not line then
    return
  end
  local client = server.of(source)
  local text = vim.api.nvim_buf_get_lines(source, line, line + 1, false)[1] or ''
  local at = 0
  if block and client then
    at = vim.str_byteindex(text, client.offset_encoding, block.range.start.character, false)
  end
  vim.api.nvim_set_current_win(window)
  vim.cmd("normal! m'")
  vim.api.nvim_win_set_cursor(window, { math.min(line + 1, vim.api.nvim_buf_line_count(source)), at })
end

return M
