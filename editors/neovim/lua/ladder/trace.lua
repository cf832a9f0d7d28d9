--- The trace: a split below the program that draws chosen tags over time, with two cursors, and leads to any scan.
require('ladder.highlight')

local server = require('ladder.server')
local sessions = require('ladder.session')
local side_buffer = require('ladder.side_buffer')
local simulation = require('ladder.simulation')
local waves = require('ladder.waves')

local M = {}

local namespace = vim.api.nvim_create_namespace('ladder_trace')
local max_height = 16
local fewest_scans = 8
--- Ten seconds at 10 ms.
local span_at_first = 1000
local tags_at_first = 8
local reading_width = 9

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

--- Traces by the buffer whose tags they show.
--- @type table<integer, ladder.Trace>
local traces = {}

--- The tags that were chosen for a program, also when its trace is closed.
--- @type table<integer, string[]>
local chosen = {}

local keys = 'h l v o cursors  n N change  + - = zoom  <CR> go there  a d tags  r p run  q close'
local short_keys = 'h l v cursors  + - zoom  <CR> go  a d tags  q'

--- @param trace ladder.Trace
local function windows(trace)
  return side_buffer.windows(trace.bufnr)
end

--- The cursors that are set, A first.
--- @param trace ladder.Trace
local function cursor_list(trace)
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
local function columns_of(trace)
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

--- Where a scan stands in the drawing: in the middle of its column, from 0.
--- @param trace ladder.Trace
--- @param scan integer
local function place_of(trace, scan)
  local window = columns_of(trace)
  return waves.place(window, math.floor(scan / trace.traced.per)) - 1 + math.floor((window.wide - 1) / 2)
end

--- How the line is divided: name, drawing, what the tag holds now and at the cursors.
--- @param trace ladder.Trace
local function divide(trace)
  local room = 80
  for _, window in ipairs(windows(trace)) do
    room = vim.api.nvim_win_get_width(window)
  end
  local names = 6
  for _, name in ipairs(trace.tags) do
    names = math.max(names, vim.fn.strdisplaywidth(name))
  end
  local set = #cursor_list(trace)
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
  for index, cursor in ipairs(cursor_list(trace)) do
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
  for _, cursor in ipairs(cursor_list(trace)) do
    local column = place_of(trace, cursor.scan)
    if column >= 0 and column < trace.width then
      for row, line in ipairs(lines) do
        local at = vim.str_byteindex(line, 'utf-32', trace.left + column, false)
        local behind = vim.str_byteindex(line, 'utf-32', trace.left + column + 1, false)
        if row == 1 then
          vim.api.nvim_buf_set_extmark(trace.bufnr, namespace, 0, at, {
            virt_text = { { cursor.letter, 'LadderCursor' .. cursor.letter } },
            virt_text_win_col = trace.left + column,
            priority = cursor.letter == trace.active and 210 or 205,
          })
        elseif behind > at then
          vim.api.nvim_buf_set_extmark(trace.bufnr, namespace, row - 1, at, {
            end_col = behind,
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
  for index, cursor in ipairs(cursor_list(trace)) do
    text = text .. ('  %s %s'):format(cursor.letter, times[index] or '')
  end
  if traced and traced.cursors and traced.cursors.difference then
    text = text .. '  B-A ' .. traced.cursors.difference
  end
  for _, window in ipairs(windows(trace)) do
    local room = vim.api.nvim_win_get_width(window) - vim.fn.strdisplaywidth(text) - 4
    local shown = #keys <= room and keys or #short_keys <= room and short_keys or ''
    vim.wo[window][0].winbar = (' %s%%=%s '):format(text:gsub('%%', '%%%%'), shown)
  end
end

--- @param source integer
--- @param trace ladder.Trace
local function draw(source, trace)
  local lines, marks = {}, {}
  trace.rows = {}
  local session = sessions.of(source)
  if session and trace.traced then
    local window = columns_of(trace)
    local heads = waves.cells(' now', reading_width, 'LadderAxis')
    for _, cursor in ipairs(cursor_list(trace)) do
      vim.list_extend(heads, waves.cells(' ' .. cursor.letter, reading_width, 'LadderAxis'))
    end
    vim.list_extend(heads, waves.cells(#cursor_list(trace) == 2 and ' B-A' or '', reading_width, 'LadderAxis'))
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
  for _, window in ipairs(windows(trace)) do
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

--- Asks for what is to be drawn; if an answer is awaited, again behind that.
--- @param source integer
local function ask(source)
  local trace = traces[source]
  if not trace or not vim.api.nvim_buf_is_valid(trace.bufnr) then
    traces[source] = nil
    return
  end
  local session = sessions.of(source)
  if not session or not session.id then
    trace.traced, trace.is_asking = nil, false
    return draw(source, trace)
  end
  if trace.is_asking == session.id then
    trace.is_stale = true
    return
  end
  divide(trace)
  if #trace.tags == 0 then
    trace.traced = nil
    return draw(source, trace)
  end
  trace.is_asking, trace.is_stale = session.id, false
  local cursors = vim.tbl_map(function(cursor)
    return cursor.scan
  end, cursor_list(trace))
  local argument = {
    session = session.id,
    tags = trace.tags,
    span = trace.span,
    last = trace.last,
    columns = trace.width,
    ticks = math.max(math.floor(trace.width / 12), 1),
    -- An empty table would be sent as an object.
    cursors = #cursors > 0 and cursors or nil,
  }
  server.command(session.client, session.bufnr, 'ladder.simulate.trace', argument, function(err, traced)
    if traces[source] ~= trace or trace.is_asking ~= session.id then
      return
    end
    trace.is_asking = false
    if not err and vim.api.nvim_buf_is_valid(trace.bufnr) then
      trace.traced = traced
      draw(source, trace)
    end
    if trace.is_stale then
      ask(source)
    end
  end)
end

simulation.on_change(ask)

--- @param trace ladder.Trace
--- @param scan integer
local function recorded(trace, scan)
  return math.max(math.min(scan, trace.traced.newest), trace.traced.oldest)
end

--- Moves the cursor that is active, and the window with it.
--- @param source integer
--- @param scan integer
local function move_to(source, scan)
  local trace = traces[source]
  local traced = trace.traced
  if not traced then
    return
  end
  scan = recorded(trace, scan)
  trace.cursors[trace.active] = scan
  local span = traced.last - traced.first + 1
  if scan < traced.first then
    trace.span, trace.last = span, scan + span - 1
  elseif scan > traced.last then
    trace.span, trace.last = span, scan
  end
  ask(source)
end

--- @param source integer
--- @param columns integer
local function move_by(source, columns)
  local trace = traces[source]
  if trace.traced then
    local from = trace.cursors[trace.active]
    -- The first key shows the cursor where the simulation is.
    move_to(source, from and from + columns * trace.traced.per or trace.traced.here)
  end
end

--- @param source integer
--- @param factor number
local function zoom(source, factor)
  local trace = traces[source]
  local traced = trace.traced
  if not traced then
    return
  end
  local before = traced.last - traced.first + 1
  local span = math.max(math.floor(before * factor + 0.5), fewest_scans)
  local at = trace.cursors[trace.active]
  local is_in_sight = at and traced.first <= at and at <= traced.last
  trace.span = span
  if is_in_sight then
    local last = math.floor(at - (at - traced.first) / before * span + 0.5) + span - 1
    trace.last = last < traced.newest and math.max(last, traced.oldest + span - 1) or nil
  end
  ask(source)
end

--- @param source integer
--- @param way 1|-1
local function jump(source, way)
  local trace = traces[source]
  local tag = trace.rows[vim.api.nvim_win_get_cursor(0)[1]]
  if not tag or not trace.traced then
    return
  end
  local per = trace.traced.per
  local column = math.floor((trace.cursors[trace.active] or trace.traced.here) / per)
  local edge = waves.edge(tag, column, way)
  if edge then
    move_to(source, edge * per)
  end
end

--- Goes to the scan of the cursor.
--- @param source integer
local function go(source)
  local trace = traces[source]
  local session = sessions.of(source)
  local scan = trace.cursors[trace.active]
  if not scan or not session or not session.state then
    return
  end
  if session.state.status == 'running' then
    return vim.notify('ladder: pause the simulation to go to a scan of the past ("p").', vim.log.levels.WARN)
  end
  simulation.command(source, 'goTo', { scan = scan })
end

--- The scan at the column of the editor's own cursor, where the mouse has put it.
--- @param source integer
local function take_mouse(source)
  local trace = traces[source]
  if not trace.traced then
    return
  end
  local row, byte = unpack(vim.api.nvim_win_get_cursor(0))
  local line = vim.api.nvim_buf_get_lines(trace.bufnr, row - 1, row, false)[1]
  local column = vim.str_utfindex(line, 'utf-32', byte, false) - trace.left
  if column >= 0 and column < trace.width then
    local window = columns_of(trace)
    move_to(source, (window.first + math.floor(column / window.wide)) * trace.traced.per)
  end
end

--- @param source integer
--- @param names string[]
local function add(source, names)
  local trace = traces[source]
  for _, name in ipairs(names) do
    local is_there = vim.iter(trace.tags):any(function(tag)
      return vim.fn.tolower(tag) == vim.fn.tolower(name)
    end)
    if not is_there then
      table.insert(trace.tags, name)
    end
  end
  chosen[source] = trace.tags
  ask(source)
end

--- What completes the question for a tag.
--- @param lead string
function M.complete(lead)
  local source = vim.b.ladder_source or vim.api.nvim_get_current_buf()
  return vim.tbl_map(function(tag)
    return tag.name
  end, simulation.search(source, lead))
end

--- @param source integer
local function ask_for_tag(source)
  local completion = "customlist,v:lua.require'ladder.trace'.complete"
  vim.ui.input({ prompt = 'Add to the trace: ', completion = completion }, function(name)
    if name and name ~= '' then
      add(source, vim.split(vim.trim(name), '%s+'))
    end
  end)
end

--- Takes the tag of the line out.
--- @param source integer
local function remove(source)
  local trace = traces[source]
  local tag = trace.rows[vim.api.nvim_win_get_cursor(0)[1]]
  if tag then
    trace.tags = vim.tbl_filter(function(name)
      return vim.fn.tolower(name) ~= vim.fn.tolower(tag.name)
    end, trace.tags)
    chosen[source] = trace.tags
    ask(source)
  end
end

local function map_keys(bufnr, source)
  local function trace()
    return traces[source]
  end
  local actions = {
    h = function()
      move_by(source, -vim.v.count1)
    end,
    l = function()
      move_by(source, vim.v.count1)
    end,
    H = function()
      move_by(source, -10 * vim.v.count1)
    end,
    L = function()
      move_by(source, 10 * vim.v.count1)
    end,
    n = function()
      jump(source, 1)
    end,
    N = function()
      jump(source, -1)
    end,
    ['0'] = function()
      if trace().traced then
        move_to(source, trace().traced.oldest)
      end
    end,
    ['$'] = function()
      trace().last = nil
      if trace().traced then
        move_to(source, trace().traced.newest)
      end
    end,
    v = function()
      local at = trace().cursors[trace().active] or trace().traced and trace().traced.here
      trace().cursors = { A = at, B = at }
      trace().active = 'B'
      ask(source)
    end,
    o = function()
      trace().active = trace().active == 'A' and trace().cursors.B and 'B' or 'A'
      ask(source)
    end,
    ['<Esc>'] = function()
      trace().cursors, trace().active = {}, 'A'
      ask(source)
    end,
    ['+'] = function()
      zoom(source, 0.5)
    end,
    ['-'] = function()
      zoom(source, 2)
    end,
    ['='] = function()
      trace().span, trace().last = nil, nil
      ask(source)
    end,
    ['<CR>'] = function()
      go(source)
    end,
    a = function()
      ask_for_tag(source)
    end,
    d = function()
      remove(source)
    end,
    s = function()
      simulation.command(source, 'step', { scans = vim.v.count1 })
    end,
    b = function()
      simulation.command(source, 'back', { scans = vim.v.count1 })
    end,
    r = function()
      simulation.run(source)
    end,
    p = function()
      simulation.pause(source)
    end,
    q = function()
      M.close(source)
    end,
    ['<LeftRelease>'] = function()
      take_mouse(source)
    end,
  }
  actions['<Left>'], actions['<Right>'] = actions.h, actions.l
  side_buffer.map(bufnr, actions)
end

local function create(source)
  local bufnr = side_buffer.create('trace', source)
  map_keys(bufnr, source)
  vim.api.nvim_create_autocmd({ 'WinResized', 'VimResized' }, {
    group = vim.api.nvim_create_augroup(('ladder_trace_%d'):format(bufnr), {}),
    callback = function()
      if not vim.api.nvim_buf_is_valid(bufnr) then
        return true
      end
      ask(source)
    end,
  })
  return bufnr
end

--- The tags that the world gives and takes, until others are chosen.
--- @param tags ladder.Tag[]
local function at_first(tags)
  local names = {}
  for _, role in ipairs({ 'input', 'output' }) do
    for _, tag in ipairs(tags) do
      if tag.role == role and not tag.readOnly and #names < tags_at_first then
        table.insert(names, tag.name)
      end
    end
  end
  return names
end

--- @param source integer
--- @param names string[] tags that are added
function M.open(source, names)
  local trace = traces[source]
  if not trace or #windows(trace) == 0 then
    trace = {
      bufnr = create(source),
      tags = chosen[source] or {},
      span = span_at_first,
      cursors = {},
      active = 'A',
      rows = {},
      left = 8,
      width = 60,
      is_asking = false,
      is_stale = false,
    }
    traces[source] = trace
    vim.api.nvim_open_win(trace.bufnr, true, { split = 'below', height = 4, style = 'minimal' })
    local window = vim.api.nvim_get_current_win()
    vim.wo[window][0].wrap = false
    vim.wo[window][0].winfixheight = true
    vim.wo[window][0].cursorline = false
  end
  add(source, names)
  if #trace.tags == 0 and sessions.of(source) then
    simulation.ask(source, 'tags', {}, function(found)
      if traces[source] == trace and #trace.tags == 0 then
        trace.tags = at_first(found.tags)
        ask(source)
      end
    end)
  end
end

--- @param source integer
function M.close(source)
  local trace = traces[source]
  traces[source] = nil
  for _, window in ipairs(trace and windows(trace) or {}) do
    vim.api.nvim_win_close(window, true)
  end
end

--- Opens the trace, or adds tags to it; without any it is closed if it is open.
--- @param source integer
--- @param names string[]
function M.toggle(source, names)
  local trace = traces[source]
  if trace and #names == 0 and #windows(trace) > 0 then
    M.close(source)
  else
    M.open(source, names)
  end
end

return M
