--- Where values are: above their operands where nothing else does, else below them, else between the lines. Never between
--- the characters of a line, which would push the drawing apart.
local M = {}

--- @class ladder.Label
--- @field row integer of the operand, from 0
--- @field column integer of the operand, in cells from 0
--- @field text string
--- @field room integer cells that are kept free for it at least

--- How many cells a value of a type mostly takes, so that it can grow without moving.
--- @param type string
--- @return integer
function M.room(type)
  if type == 'BOOL' then
    return 1
  end
  return (type == 'TIME' or type:match('REAL$')) and 7 or 5
end

--- @param line string|nil nil past the ends of the text
--- @param taken table<integer, boolean>
--- @param from integer
--- @param to integer the first cell behind it
local function is_free(line, taken, from, to)
  if not line then
    return false
  end
  -- A cell on each side, so that two things do not look like one.
  for cell = math.max(from - 1, 0), to do
    local character = vim.fn.strcharpart(line, cell, 1)
    if taken[cell] or not (character == '' or character == ' ') then
      return false
    end
  end
  return true
end

--- @param labels ladder.Label[] in the order of the text
--- @param line_at fun(row: integer): string|nil
--- @return { [1]: 'above'|'below'|'between', [2]: integer }[] places and columns
function M.place(labels, line_at)
  --- Cells of each line, by row and column.
  local taken = {}
  --- The first free cell between a line and the one above it.
  local free_between = {}
  local places = {}
  for index, label in ipairs(labels) do
    local width = math.max(vim.fn.strdisplaywidth(label.text), label.room)
    local to = label.column + width
    for _, side in ipairs({ { 'above', label.row - 1 }, { 'below', label.row + 1 } }) do
      local row = side[2]
      if not places[index] and is_free(line_at(row), taken[row] or {}, label.column, to) then
        places[index] = { side[1], label.column }
        taken[row] = taken[row] or {}
        for cell = label.column, to - 1 do
          taken[row][cell] = true
        end
      end
    end
    if not places[index] then
      local column = math.max(label.column, free_between[label.row] or 0)
      places[index] = { 'between', column }
      free_between[label.row] = column + width + 1
    end
  end
  return places
end

return M
