--- The trace as text: which scans are drawn in which columns, and what is in each line.
require('ladder.highlight')

local sessions = require('ladder.session')
local side_buffer = require('ladder.side_buffer')
local waves = require('ladder.waves')

local M = {}

local namespace = vim.api.nvim_create_namespace('ladder_trace')
local max_height = 16
local reading_width = 9

local keys = 'h l v o cursors  n N change  + - = zoom  <CR> go there  a d tags  r p run  q close'
local short_keys = 'h l v cursors  + - zoom  <CR> go  a d tags  q'

--- @class ladder.Trace
--- @field bufnr integer
--- @field tags string[]
--- @field span integer|nil how many scans are shown; all of them if it is nil
--- @field last integer|nil the last of them; the newest, whichever that is, if it is nil
--- @field cursors table<'A'|'B', integer> scans
--- @field active 'A'|'B'
--- @field traced table|nil what was drawn last
--- @field rows table<integer, ladder.TraceTag> the tag of each line
--- @field left integer columns before the drawing
--- @field width integer columns of the drawing
--- @field is_asking boolean
--- @field is_stale boolean

--- The windows that show a trace.
--- @param trace ladder.Trace
function M.windows(trace)
  return side_buffer.windows(trace.bufnr)
end

--- The cursors that are set, A first.
--- @param trace ladder.Trace
function M.cursor_list(trace)
  local list = {}
  for _, letter in ipairs({ 'A', 'B' }) do
    if trace.cursors[letter] then
      table.insert(list, { letter = letter, scan = trace.cursors[letter] })
    end
  end
  return list
end

--- The numbers of columns that are drawn.
--- @param trace ladder.Trace
--- @return ladder.TraceWindow
function M.columns_of(trace)
  local traced = trace.traced
  local first, last = math.floor(traced.first / traced.per), math.floor(traced.last / traced.per)
  return {
    first = first,
    count = trace.width,
    wide = math.max(math.floor(trace.width / (last - first + 1)), 1),
    newest = math.floor(traced.newest / traced.per),
    here = math.floor(traced.here / traced.per),
  }
end

--- Where a scan is in the drawing: in the middle of its column, from 0.
--- @param trace ladder.Trace
--- @param scan integer
local function place_of(trace, scan)
  local window = M.columns_of(trace)
  return waves.place(window, math.floor(scan / trace.traced.per)) - 1 + math.floor((window.wide - 1) / 2)
end

--- How the line is divided: name, drawing, what the tag holds now and at the cursors.
--- @param trace ladder.Trace
function M.divide(trace)
  local room = 80
  for _, window in ipairs(M.windows(trace)) do
    room = vim.api.nvim_win_get_width(window)
  end
  local names = 6
  for _, name in ipairs(trace.tags) do
    names = math.max(names, vim.fn.strdisplaywidth(name))
  end
  local set = #M.cursor_list(trace)
  local readings = 1 + set + (set == 2 and 1 or 0)
  trace.left = math.min(names, 18) + 2
  trace.width = math.max(room - trace.left - 1 - readings * reading_width, 10)
end

--- @param lines string[]
--- @param all_marks table[]
--- @param ... ladder.Cell[]
local function add_line(lines, all_marks, ...)
  local cells = {}
  for _, part in ipairs({ ... }) do
    vim.list_extend(cells, part)
  end
  local line, marks = waves.line(cells)
  table.insert(lines, (line:gsub('%s+$', '')))
  table.insert(all_marks, marks)
end

--- @param trace ladder.Trace
--- @param tag ladder.TraceTag
--- @return ladder.Cell[]
local function readings(trace, tag)
  local cells = waves.cells(' ' .. (tag.kind == 'unknown' and 'no tag' or tag.now or ''), reading_width, 'LadderValue')
  for index, cursor in ipairs(M.cursor_list(trace)) do
    local reading = (tag.readings or {})[index]
    local text = (reading == nil or reading == vim.NIL) and '-' or reading
    vim.list_extend(cells, waves.cells(' ' .. text, reading_width, 'LadderCursor' .. cursor.letter .. 'Value'))
  end
  return vim.list_extend(cells, waves.cells(' ' .. (tag.difference or ''), reading_width))
end

--- The range of a number, as its scale has it.
--- @param tag ladder.TraceTag
local function range_text(tag)
  local ticks = tag.ticks or {}
  if #ticks == 0 then
    return ''
  end
  return #ticks == 1 and ticks[1].text or ('%s … %s'):format(ticks[1].text, ticks[#ticks].text)
end

--- Highlights the columns of the cursors, over whatever is drawn there.
--- @param trace ladder.Trace
--- @param lines string[]
local function mark_cursors(trace, lines)
  for _, cursor in ipairs(M.cursor_list(trace)) do
    local column = place_of(trace, cursor.scan)
    if column >= 0 and column < trace.width then
      for row, line in ipairs(lines) do
        local at = vim.str_byteindex(line, 'utf-32', trace.left + column, false)
        local finish = vim.str_byteindex(line, 'utf-32', trace.left + column + 1, false)
        if row == 1 then
          vim.api.nvim_buf_set_extmark(trace.bufnr, namespace, 0, at, {
            virt_text = { { cursor.letter, 'LadderCursor' .. cursor.letter } },
            virt_text_win_col = trace.left + column,
            priority = cursor.letter == trace.active and 210 or 205,
          })
        elseif finish > at then
          vim.api.nvim_buf_set_extmark(trace.bufnr, namespace, row - 1, at, {
            end_col = finish,
            hl_group = 'LadderCursor' .. cursor.letter,
            priority = cursor.letter == trace.active and 210 or 205,
          })
        end
      end
    end
  end
end

--- @param source integer
--- @param trace ladder.Trace
local function title(source, trace)
  local session = sessions.of(source)
  local traced = trace.traced
  local text = session and require('ladder.status').text(session) or 'not simulated'
  if traced and traced.here < traced.newest then
    text = text .. (', %d ahead'):format(traced.newest - traced.here)
  end
  local times = traced and traced.cursors and traced.cursors.times or {}
  for index, cursor in ipairs(M.cursor_list(trace)) do
    text = text .. ('  %s %s'):format(cursor.letter, times[index] or '')
  end
  if traced and traced.cursors and traced.cursors.difference then
    text = text .. '  B-A ' .. traced.cursors.difference
  end
  for _, window in ipairs(M.windows(trace)) do
    local room = vim.api.nvim_win_get_width(window) - vim.fn.strdisplaywidth(text) - 4
    local shown = #keys <= room and keys or #short_keys <= room and short_keys or ''
    vim.wo[window][0].winbar = (' %s%%=%s '):format(text:gsub('%%', '%%%%'), shown)
  end
end

--- Shows what was drawn last.
--- @param source integer
--- @param trace ladder.Trace
function M.draw(source, trace)
  local lines, marks = {}, {}
  trace.rows = {}
  local session = sessions.of(source)
  if session and trace.traced then
    local window = M.columns_of(trace)
    local heads = waves.cells(' now', reading_width, 'LadderAxis')
    for _, cursor in ipairs(M.cursor_list(trace)) do
      vim.list_extend(heads, waves.cells(' ' .. cursor.letter, reading_width, 'LadderAxis'))
    end
    vim.list_extend(heads, waves.cells(#M.cursor_list(trace) == 2 and ' B-A' or '', reading_width, 'LadderAxis'))
    local axis = waves.axis(trace.traced.ticks, window, trace.traced.per)
    add_line(lines, marks, waves.cells('', trace.left), axis, heads)
    for _, tag in ipairs(trace.traced.tags) do
      for index, drawn in ipairs(waves.draw(tag, window)) do
        local label = index == 1 and tag.name or range_text(tag)
        local name = waves.cells(label, trace.left - 1, index == 1 and 'LadderTagName' or 'LadderAxis')
        for place = 1, trace.width do
          drawn[place] = drawn[place] or { text = ' ' }
        end
        table.insert(name, { text = ' ' })
        add_line(lines, marks, name, drawn, index == 1 and readings(trace, tag) or {})
        trace.rows[#lines] = tag
      end
    end
  else
    lines = { 'Nothing is simulated: ":Ladder start" in the program starts a simulation.' }
  end
  if #trace.tags == 0 and session then
    lines = { 'No tags are chosen: "a" adds one.' }
  end
  local cursors = {}
  for _, window in ipairs(M.windows(trace)) do
    cursors[window] = vim.api.nvim_win_get_cursor(window)[1]
  end
  vim.bo[trace.bufnr].modifiable = true
  vim.api.nvim_buf_set_lines(trace.bufnr, 0, -1, false, lines)
  vim.bo[trace.bufnr].modifiable = false
  vim.api.nvim_buf_clear_namespace(trace.bufnr, namespace, 0, -1)
  for row, of_line in ipairs(marks) do
    for _, mark in ipairs(of_line) do
      vim.api.nvim_buf_set_extmark(trace.bufnr, namespace, row - 1, mark[1], {
        end_col = math.min(mark[2], #(lines[row] or '')),
        hl_group = mark[3],
        strict = false,
      })
    end
  end
  if session and trace.traced and #trace.tags > 0 then
    mark_cursors(trace, lines)
  end
  for window, row in pairs(cursors) do
    local at = trace.cursors[trace.active]
    local line = lines[math.min(row, #lines)]
    local column = trace.left
    if at and trace.traced then
      column = trace.left + math.min(math.max(place_of(trace, at), 0), trace.width - 1)
    end
    local byte = vim.str_byteindex(line, 'utf-32', column, false)
    vim.api.nvim_win_set_cursor(window, { math.min(row, #lines), byte })
    local height = math.min(math.max(#lines, 3) + 1, max_height)
    if vim.api.nvim_win_get_height(window) ~= height and trace.height ~= height then
      vim.api.nvim_win_set_height(window, height)
    end
    trace.height = height
  end
  title(source, trace)
end

return M
