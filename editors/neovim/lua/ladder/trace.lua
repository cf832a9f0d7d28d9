--- The trace: a split below the program that draws chosen tags over time, with two cursors, and leads to any scan.
local chosen = require('ladder.remembered')('ladder-trace')
local drawing = require('ladder.trace.drawing')
local keys = require('ladder.trace.keys')
local server = require('ladder.server')
local sessions = require('ladder.session')
local side_buffer = require('ladder.side_buffer')
local simulation = require('ladder.simulation')
local view = require('ladder.view')

local M = {}

--- Ten seconds at 10 ms.
local span_at_first = 1000
local tags_at_first = 8

--- Traces by the buffer whose tags they show.
--- @type table<integer, ladder.Trace>
local traces = {}

--- Takes over the names that the program has now for the tags that were asked for: some may have been renamed while it runs.
--- @param source integer
--- @param trace ladder.Trace
--- @param asked string[]
local function take_names(source, trace, asked)
  local names = {}
  for _, tag in ipairs(trace.traced.tags) do
    if not vim.list_contains(names, tag.name) then
      table.insert(names, tag.name)
    end
  end
  if vim.deep_equal(trace.tags, asked) and not vim.deep_equal(names, asked) then
    trace.tags = names
    chosen.set(source, names)
  end
end

--- Asks for what is to be drawn; if an answer is awaited, again after that.
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
    return drawing.draw(source, trace)
  end
  if trace.is_asking == session.id then
    trace.is_stale = true
    return
  end
  drawing.divide(trace)
  if #trace.tags == 0 then
    trace.traced = nil
    return drawing.draw(source, trace)
  end
  trace.is_asking, trace.is_stale = session.id, false
  local cursors = vim.tbl_map(function(cursor)
    return cursor.scan
  end, drawing.cursor_list(trace))
  local argument = {
    session = session.id,
    tags = vim.deepcopy(trace.tags),
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
      take_names(source, trace, argument.tags)
      drawing.draw(source, trace)
    end
    if trace.is_stale then
      ask(source)
    end
  end)
end

view.on_change(ask)

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
  chosen.set(source, trace.tags)
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

--- Takes a tag out.
--- @param source integer
--- @param tag ladder.TraceTag
local function remove(source, tag)
  local trace = traces[source]
  trace.tags = vim.tbl_filter(function(name)
    return vim.fn.tolower(name) ~= vim.fn.tolower(tag.name)
  end, trace.tags)
  chosen.set(source, trace.tags)
  ask(source)
end

local function create(source)
  local bufnr = side_buffer.create('trace', source)
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
  if not trace or #drawing.windows(trace) == 0 then
    trace = {
      bufnr = create(source),
      tags = chosen.of(source) or {},
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
    keys.map(source, trace, {
      ask = function()
        ask(source)
      end,
      add_tag = function()
        ask_for_tag(source)
      end,
      remove_tag = function(tag)
        remove(source, tag)
      end,
      close = function()
        M.close(source)
      end,
    })
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
  for _, window in ipairs(trace and drawing.windows(trace) or {}) do
    vim.api.nvim_win_close(window, true)
  end
end

--- Opens the trace, or adds tags to it; without any it is closed if it is open.
--- @param source integer
--- @param names string[]
function M.toggle(source, names)
  local trace = traces[source]
  if trace and #names == 0 and #drawing.windows(trace) > 0 then
    M.close(source)
  else
    M.open(source, names)
  end
end

return M
