--- Coils, contacts in parallel, and branches from one place to another.
local change = require('ladder.change')
local here = require('ladder.diagram.here')
local pens = require('ladder.diagram.pen')

local M = {}

--- The place at the end of the line that the cursor is on.
--- @param diagram ladder.Diagram
--- @return lsp.Position|nil
local function end_of_line(diagram)
  local block, wire = here.block(diagram), here.wire(diagram)
  local line = block and here.row_of(diagram, block) - 1 or wire and wire.line
  local last
  for _, own in ipairs(diagram.wires) do
    if own.line == line and (not last or own.columns[1] > last.columns[1]) then
      last = own
    end
  end
  return last and last.at
end

--- Draws a coil at the end of the line; where something acts there already, below that.
function M.coil(pen, row)
  local last = end_of_line(pen.diagram)
  pen:place(function(target, offer)
    local acting = offer.acting
    if acting then
      target = { op = 'parallel', from = acting.from, to = acting.to, side = 'below' }
    elseif target.at then
      target.at = last or target.at
    end
    pen:write(row, target, offer)
  end)
end

--- Draws a contact in parallel to what is selected.
--- @param row table
--- @param side 'below'|'above'
function M.branch(pen, row, side)
  pen:blocks(function(offer)
    if not pens.is_refused(offer, side == 'below' and 'parallelBelow' or 'parallelAbove') then
      local points = offer.points
      pen:write(row, { op = 'parallel', from = points.before, to = points.behind, side = side }, offer)
    end
  end)
end

--- Whether a branch is begun that is not closed yet.
--- @return boolean
function M.is_begun(pen)
  return pen.begun ~= nil and pen.begun.tick == pen:tick()
end

--- Begins a branch before the block, or at the wire under the cursor; closes one that is begun. Where it begins it is given up.
--- @param row table
function M.from_to(pen, row)
  local block = here.block(pen.diagram)
  pen:place(function(target, offer)
    local from = block and offer.points.before or target.at
    if M.is_begun(pen) and vim.deep_equal(pen.begun.at, from) then
      pen.begun = nil
      return pens.tell('No branch begins here any more')
    end
    if M.is_begun(pen) then
      return M.close(pen, row)
    end
    pen.begun = { at = from, what = block and block.range['end'] or from, tick = pen:tick() }
    pens.tell('A branch begins here: go where it ends, and close it with /')
  end)
end

--- Closes the branch that was begun: on the same line with a contact in it; the loose end of a branch on the line above.
--- @param row table
function M.close(pen, row)
  local begun = pen.begun
  pen.begun = nil
  pen:place(function(target, offer)
    if target.at.line ~= begun.at.line then
      return pen:edit({ op = 'close', what = begun.what, to = target.at })
    end
    pen:write(row, { op = 'parallel', from = begun.at, to = target.at, side = 'below' }, offer)
  end)
end

--- Moves the end of a branch past the next thing of the line above it.
--- @param join ladder.DrawnJoin
--- @param is_right boolean
function M.move_end(pen, join, is_right)
  local beside = vim.tbl_filter(function(wire)
    local is_there = is_right and wire.columns[1] > join.column + 1 or not is_right and wire.columns[2] < join.column
    return wire.line == join.lines[1] and is_there
  end, pen.diagram.wires)
  table.sort(beside, function(one, two)
    return (one.columns[1] < two.columns[1]) == is_right
  end)
  if not beside[1] then
    return change.refuse('the line ends there')
  end
  local is_right_end = vim.iter(pen.diagram.joins):any(function(other)
    return other.at.line == join.at.line and other.column < join.column
  end)
  pen:edit({ op = 'branchEnd', what = join.at, to = beside[1].at }, function()
    pen:show(join.at, is_right_end)
  end)
end

return M
