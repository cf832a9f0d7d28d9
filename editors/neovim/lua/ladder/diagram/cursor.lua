--- Where the cursor of the program is in the diagram, and the other way round.
local here = require('ladder.diagram.here')
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

--- Puts the cursor of the program on a place.
--- @param source integer
--- @param window integer that shows it
--- @param place lsp.Position
local function put_on(source, window, place)
  local client = server.of(source)
  local text = vim.api.nvim_buf_get_lines(source, place.line, place.line + 1, false)[1] or ''
  local at = client and vim.str_byteindex(text, client.offset_encoding, place.character, false) or 0
  local last = vim.api.nvim_buf_line_count(source)
  vim.api.nvim_win_set_cursor(window, { math.min(place.line + 1, last), at })
end

--- Brings a place into sight in both windows, as soon as a text that is no older than this one is drawn.
--- @param source integer
--- @param diagram ladder.Diagram
--- @param place lsp.Position
--- @param is_right_end boolean|nil of the branch on that line its right end, or its left one
function M.want(source, diagram, place, is_right_end)
  local window = vim.fn.bufwinid(source)
  if window ~= -1 then
    put_on(source, window, place)
  end
  local tick = vim.api.nvim_buf_get_changedtick(source)
  diagram.wanted = { place = place, tick = tick, is_right_end = is_right_end }
end

--- The end of the branch that a line of the program is.
--- @param diagram ladder.Diagram
--- @param line integer
--- @param is_right boolean
--- @return ladder.DrawnJoin|nil
local function end_of_branch(diagram, line, is_right)
  local found
  for _, join in ipairs(diagram.joins) do
    if join.at.line == line and (not found or (join.column > found.column) == is_right) then
      found = join
    end
  end
  return found
end

--- Puts the cursor of the diagram on what is wanted, if that is drawn now.
--- @param diagram ladder.Diagram
--- @param version integer of what is drawn
function M.reach(diagram, version)
  local wanted = diagram.wanted
  if not wanted or version < wanted.tick then
    return
  end
  local line, character = wanted.place.line, wanted.place.character
  local block = vim.iter(diagram.blocks):find(function(block)
    local from, to = block.range.start, block.range['end']
    return from.line == line and from.character <= character and character < to.character
  end)
  local wire = vim.iter(diagram.wires):find(function(wire)
    return wire.at.line == line and wire.at.character == character
  end)
  local row = block and here.row_of(diagram, block) or wire and wire.line + 1 or M.row_of(diagram, line)
  local columns = block and block.columns or wire and wire.columns or { 0, 1 }
  if wanted.is_right_end ~= nil then
    local join = end_of_branch(diagram, line, wanted.is_right_end)
    if join then
      row, columns = join.lines[1] + 1, { join.column, join.column + 1 }
    end
  end
  for _, window in ipairs(row and side_buffer.windows(diagram.bufnr) or {}) do
    reveal(diagram, window, row, math.floor((columns[1] + columns[2] - 1) / 2))
  end
  if block or wire then
    diagram.wanted = nil
  end
end

--- Goes to the place in the program of what the cursor is on.
--- @param source integer
--- @param diagram ladder.Diagram
function M.open_text(source, diagram)
  local block, line = here.block(diagram), here.line(diagram)
  local window = vim.fn.bufwinid(source)
  if window == -1 or not line then
    return
  end
  vim.api.nvim_set_current_win(window)
  vim.cmd("normal! m'")
  put_on(source, window, block and block.range.start or { line = line, character = 0 })
end

return M
