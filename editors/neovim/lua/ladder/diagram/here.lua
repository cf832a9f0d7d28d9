--- What the cursor of a diagram is on.
local M = {}

--- The row of the cursor, from 0, and its column.
--- @param mark string|nil as for `getpos`
local function cursor(mark)
  local place = vim.fn.getpos(mark or '.')
  return place[2] - 1, math.max(vim.fn.virtcol(mark or '.') - 1, 0)
end

--- The block under the cursor, or the comment in a wire.
--- @param diagram ladder.Diagram
--- @return ladder.DrawnBlock|nil
function M.block(diagram)
  local row, column = cursor()
  return vim.iter(diagram.blocks):find(function(block)
    local is_on_row = block.lines[1] <= row and row < block.lines[2]
    return is_on_row and block.columns[1] <= column and column < block.columns[2]
  end)
end

--- The wire under the cursor.
--- @param diagram ladder.Diagram
--- @return ladder.DrawnWire|nil
function M.wire(diagram)
  local row, column = cursor()
  return vim.iter(diagram.wires):find(function(wire)
    return wire.line == row and wire.columns[1] <= column and column < wire.columns[2]
  end)
end

--- The line from rung to rung under the cursor; where two meet the one that comes from above.
--- @param diagram ladder.Diagram
--- @return ladder.DrawnJoin|nil
function M.join(diagram)
  local row, column = cursor()
  local found
  for _, join in ipairs(diagram.joins) do
    if join.column == column and join.lines[1] <= row and row < join.lines[2] then
      found = join.lines[1] < row and join or found or join
    end
  end
  return found
end

--- The line of the program that the cursor is on.
--- @param diagram ladder.Diagram
--- @return integer|nil
function M.line(diagram)
  local block = M.block(diagram)
  local drawn = diagram.drawn[vim.api.nvim_win_get_cursor(0)[1]]
  return block and block.range.start.line or drawn and drawn.line
end

--- The blocks that are selected in visual mode, else the one under the cursor.
--- @param diagram ladder.Diagram
--- @return ladder.DrawnBlock[]
function M.selected(diagram)
  local mode = vim.fn.mode()
  if not mode:match('^[vV\22]') then
    return { M.block(diagram) }
  end
  local first, left = cursor('v')
  local last, right = cursor()
  if mode == 'V' then
    left, right = 0, math.huge
  end
  first, last = math.min(first, last), math.max(first, last)
  left, right = math.min(left, right), math.max(left, right)
  return vim.tbl_filter(function(block)
    local is_on_rows = block.lines[1] <= last and first < block.lines[2]
    return is_on_rows and block.columns[1] <= right and left < block.columns[2]
  end, diagram.blocks)
end

--- @param blocks ladder.DrawnBlock[]
--- @return lsp.Range[]
function M.ranges(blocks)
  return vim.tbl_map(function(block)
    return block.range
  end, blocks)
end

--- The row from 1 with the wire of a block.
--- @param diagram ladder.Diagram
--- @param block ladder.DrawnBlock
--- @return integer
function M.row_of(diagram, block)
  for row = block.lines[1] + 1, block.lines[2] do
    if diagram.drawn[row].wire then
      return row
    end
  end
  return block.lines[1] + 1
end

--- Puts the cursor of the current window on a column.
--- @param row integer from 1
--- @param column integer
function M.go(row, column)
  vim.api.nvim_win_set_cursor(0, { row, math.max(vim.fn.virtcol2col(0, row, column + 1) - 1, 0) })
end

--- Selects things in visual mode.
--- @param diagram ladder.Diagram
--- @param ranges lsp.Range[] of the program
function M.select(diagram, ranges)
  local first, last, left, right
  for _, block in ipairs(diagram.blocks) do
    local is_meant = vim.iter(ranges):any(function(range)
      return vim.deep_equal(range, block.range)
    end)
    if is_meant then
      local row = M.row_of(diagram, block)
      first, last = math.min(first or row, row), math.max(last or row, row)
      left = math.min(left or block.columns[1], block.columns[1])
      right = math.max(right or block.columns[2], block.columns[2])
    end
  end
  if first then
    vim.cmd('normal! \27')
    M.go(first, left)
    vim.cmd('normal! \22')
    M.go(last, right - 1)
  end
end

--- Goes to the next thing or wire, from left to right and from top to bottom.
--- @param diagram ladder.Diagram
--- @param by 1|-1
function M.step(diagram, by)
  local places = {}
  for _, block in ipairs(diagram.blocks) do
    table.insert(places, { row = M.row_of(diagram, block) - 1, columns = block.columns })
  end
  for _, wire in ipairs(diagram.wires) do
    if wire.columns[1] < wire.columns[2] then
      table.insert(places, { row = wire.line, columns = wire.columns })
    end
  end
  table.sort(places, function(one, two)
    return one.row < two.row or (one.row == two.row and one.columns[1] < two.columns[1])
  end)
  local row, column = cursor()
  local block = M.block(diagram)
  row = block and M.row_of(diagram, block) - 1 or row
  local function is_beyond(place)
    if by > 0 then
      return place.row > row or (place.row == row and place.columns[1] > column)
    end
    return place.row < row or (place.row == row and place.columns[2] <= column)
  end
  local sorted = vim.iter(places)
  local found = (by > 0 and sorted or sorted:rev()):find(is_beyond)
  if found then
    M.go(found.row + 1, math.floor((found.columns[1] + found.columns[2] - 1) / 2))
  end
end

return M
