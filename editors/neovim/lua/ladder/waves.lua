--- Traces drawn with characters: a column of the drawing is a column of the screen.
local M = {}

--- What is in one column of the screen, and how it is highlighted.
--- @class ladder.Cell
--- @field text string one column wide
--- @field group string|nil

--- @class ladder.TraceTag as docs/protocol.md of the project describes it
--- @field name string
--- @field type string|nil
--- @field kind 'bit'|'number'|'text'|'unknown'
--- @field now string|nil
--- @field range number[]|nil
--- @field columns any[][]|nil
--- @field readings any[]|nil
--- @field difference string|nil

local bars = { '▁', '▂', '▃', '▄', '▅', '▆', '▇', '█' }

--- Which part of a trace is drawn.
--- @class ladder.TraceWindow
--- @field first integer the number of the first column
--- @field count integer how many columns the screen has for them
--- @field wide integer how many columns of the screen each of them takes
--- @field newest integer the number of the last column that is known
--- @field here integer the number of the column that the simulation is at

--- Where a column begins on the screen, from 1.
--- @param window ladder.TraceWindow
--- @param column number
--- @return integer
function M.place(window, column)
  return math.floor((column - window.first) * window.wide) + 1
end

--- What each column shows, without the columns that nothing is known of.
--- @param tag ladder.TraceTag
--- @param window ladder.TraceWindow
--- @return table<integer, any[]> by place on the screen, from 1
local function spread(tag, window)
  local shown = {}
  for index, column in ipairs(tag.columns or {}) do
    local following = (tag.columns[index + 1] or { window.newest + 1 })[1]
    local from = M.place(window, math.max(column[1], window.first))
    local to = math.min(M.place(window, math.min(following - 1, window.newest) + 1) - 1, window.count)
    for place = from, to do
      shown[place] = column
    end
  end
  return shown
end

--- @param group string
--- @param window ladder.TraceWindow
--- @param place integer
local function faded(group, window, place)
  return place >= M.place(window, window.here + 1) and 'LadderPowerOff' or group
end

--- `▁▁╱▔▔╲▁`, and `▒` where more happened in one column than a line can show.
--- @param tag ladder.TraceTag
--- @param window ladder.TraceWindow
--- @return ladder.Cell[][] lines
local function bit(tag, window)
  local shown = spread(tag, window)
  local function level(place)
    return shown[place] and shown[place][2]
  end
  local cells, before = {}, nil
  for place = 1, window.count do
    local now, text = level(place), ' '
    if now == 2 then
      -- A single change leads from the level before to the one after.
      local after = level(place + 1)
      local is_edge = before and after and before ~= after and before ~= 2 and after ~= 2
      text = is_edge and (after == 1 and '╱' or '╲') or '▒'
      before = is_edge and after or 2
    elseif now then
      local is_edge = before and before ~= 2 and before ~= now
      text = now == 1 and (is_edge and '╱' or '▔') or (is_edge and '╲' or '▁')
      before = now
    else
      before = nil
    end
    cells[place] = { text = text, group = faded(now == 0 and 'LadderLow' or 'LadderValueOn', window, place) }
  end
  return { cells }
end

--- Bars, two lines high: sixteen steps from the least to the greatest value.
--- @param tag ladder.TraceTag
--- @param window ladder.TraceWindow
--- @return ladder.Cell[][] lines
local function number(tag, window)
  local shown = spread(tag, window)
  local least, greatest = unpack(tag.range or { 0, 0 })
  local top, bottom = {}, {}
  for place = 1, window.count do
    local value = shown[place] and shown[place][4]
    local step
    if value and greatest > least then
      step = math.floor((value - least) / (greatest - least) * 15 + 0.5)
    elseif value then
      step = value == 0 and 0 or 7
    end
    local group = faded('LadderValue', window, place)
    top[place] = { text = step and step > 7 and bars[step - 7] or ' ', group = group }
    bottom[place] = { text = step and bars[math.min(step, 7) + 1] or ' ', group = group }
  end
  return { top, bottom }
end

--- A text: the words from where they hold on.
--- @param tag ladder.TraceTag
--- @param window ladder.TraceWindow
--- @return ladder.Cell[][] lines
local function words(tag, window)
  local shown = spread(tag, window)
  local cells, before, rest = {}, nil, {}
  for place = 1, window.count do
    local column = shown[place]
    if column ~= before then
      rest = column and vim.fn.split('│' .. tostring(column[2]), '\\zs') or {}
      before = column
    end
    local text = table.remove(rest, 1) or ' '
    -- What takes two columns would shift the rest.
    text = vim.fn.strdisplaywidth(text) == 1 and text or '?'
    cells[place] = { text = text, group = faded('LadderValue', window, place) }
  end
  return { cells }
end

--- @param tag ladder.TraceTag
--- @param window ladder.TraceWindow
--- @return ladder.Cell[][] lines
function M.draw(tag, window)
  if tag.kind == 'bit' then
    return bit(tag, window)
  elseif tag.kind == 'number' then
    return number(tag, window)
  elseif tag.kind == 'text' then
    return words(tag, window)
  end
  return { {} }
end

--- The times: each with a line at its place, where it does not cover the one before.
--- @param ticks { at: number, text: string }[]
--- @param window ladder.TraceWindow
--- @param per integer scans in a column
--- @return ladder.Cell[]
function M.axis(ticks, window, per)
  local cells = {}
  for place = 1, window.count do
    cells[place] = { text = ' ', group = 'LadderAxis' }
  end
  local free = 1
  for _, tick in ipairs(ticks) do
    local place = M.place(window, window.wide > 1 and tick.at / per or math.floor(tick.at / per))
    local letters = vim.fn.split('│' .. tick.text, '\\zs')
    if place >= free and place + #letters - 1 <= window.count then
      for index, letter in ipairs(letters) do
        cells[place + index - 1].text = letter
      end
      free = place + #letters + 1
    end
  end
  local here = M.place(window, window.here)
  if window.here < window.newest and cells[here] then
    cells[here] = { text = '▾', group = 'LadderValueOn' }
  end
  return cells
end

--- The column of the next change after one, or before it.
--- @param tag ladder.TraceTag
--- @param column integer
--- @param way 1|-1
--- @return integer|nil
function M.edge(tag, column, way)
  local found
  for index = 2, #(tag.columns or {}) do
    local start = tag.columns[index][1]
    if way == 1 and start > column then
      return start
    elseif way == -1 and start < column then
      found = start
    end
  end
  return found
end

--- Joins cells to a line.
--- @param cells ladder.Cell[]
--- @return string line, { [1]: integer, [2]: integer, [3]: string }[] marks first byte, end, group
function M.line(cells)
  local parts, marks, at = {}, {}, 0
  for index, cell in ipairs(cells) do
    parts[index] = cell.text
    local last = marks[#marks]
    if cell.group and last and last[3] == cell.group and last[2] == at then
      last[2] = at + #cell.text
    elseif cell.group then
      table.insert(marks, { at, at + #cell.text, cell.group })
    end
    at = at + #cell.text
  end
  return table.concat(parts), marks
end

--- A text as cells, in this many columns; what is too long ends in `…`.
--- @param text string
--- @param width integer
--- @param group string|nil
--- @return ladder.Cell[]
function M.cells(text, width, group)
  local letters = vim.fn.split(text, '\\zs')
  local cells, used = {}, 0
  for index, letter in ipairs(letters) do
    local wide = vim.fn.strdisplaywidth(letter)
    if used + wide > width or (used + wide == width and index < #letters) then
      table.insert(cells, { text = used < width and '…' or '', group = group })
      used = math.min(used + 1, width)
      break
    end
    table.insert(cells, { text = letter, group = group })
    used = used + wide
  end
  if used < width then
    table.insert(cells, { text = (' '):rep(width - used) })
  end
  return cells
end

return M
