--- The keys of the trace: cursors, zoom, and the way to a scan.
local drawing = require('ladder.trace.drawing')
local sessions = require('ladder.session')
local side_buffer = require('ladder.side_buffer')
local simulation = require('ladder.simulation')
local waves = require('ladder.waves')

local M = {}

local fewest_scans = 8

--- What keys do with a trace besides looking at it.
--- @class ladder.TraceHands
--- @field ask function shows what is to be seen now
--- @field add_tag function asks for a tag
--- @field remove_tag fun(tag: ladder.TraceTag)
--- @field close function

--- @param trace ladder.Trace
--- @param scan integer
local function recorded(trace, scan)
  return math.max(math.min(scan, trace.traced.newest), trace.traced.oldest)
end

--- Moves the cursor that is active, and the window with it.
--- @param trace ladder.Trace
--- @param hands ladder.TraceHands
--- @param scan integer
local function move_to(trace, hands, scan)
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
  hands.ask()
end

--- @param trace ladder.Trace
--- @param hands ladder.TraceHands
--- @param columns integer
local function move_by(trace, hands, columns)
  if trace.traced then
    local from = trace.cursors[trace.active]
    -- The first key shows the cursor where the simulation is.
    move_to(trace, hands, from and from + columns * trace.traced.per or trace.traced.here)
  end
end

--- @param trace ladder.Trace
--- @param hands ladder.TraceHands
--- @param factor number
local function zoom(trace, hands, factor)
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
  hands.ask()
end

--- @param trace ladder.Trace
--- @param hands ladder.TraceHands
--- @param way 1|-1
local function jump(trace, hands, way)
  local tag = trace.rows[vim.api.nvim_win_get_cursor(0)[1]]
  if not tag or not trace.traced then
    return
  end
  local per = trace.traced.per
  local column = math.floor((trace.cursors[trace.active] or trace.traced.here) / per)
  local edge = waves.edge(tag, column, way)
  if edge then
    move_to(trace, hands, edge * per)
  end
end

--- Goes to the scan of the cursor.
--- @param source integer
--- @param trace ladder.Trace
local function go(source, trace)
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
--- @param trace ladder.Trace
--- @param hands ladder.TraceHands
local function take_mouse(trace, hands)
  if not trace.traced then
    return
  end
  local row, byte = unpack(vim.api.nvim_win_get_cursor(0))
  local line = vim.api.nvim_buf_get_lines(trace.bufnr, row - 1, row, false)[1]
  local column = vim.str_utfindex(line, 'utf-32', byte, false) - trace.left
  if column >= 0 and column < trace.width then
    local window = drawing.columns_of(trace)
    move_to(trace, hands, (window.first + math.floor(column / window.wide)) * trace.traced.per)
  end
end

--- Gives the buffer of a trace its keys.
--- @param source integer
--- @param trace ladder.Trace
--- @param hands ladder.TraceHands
function M.map(source, trace, hands)
  local actions = {
    h = function()
      move_by(trace, hands, -vim.v.count1)
    end,
    l = function()
      move_by(trace, hands, vim.v.count1)
    end,
    H = function()
      move_by(trace, hands, -10 * vim.v.count1)
    end,
    L = function()
      move_by(trace, hands, 10 * vim.v.count1)
    end,
    n = function()
      jump(trace, hands, 1)
    end,
    N = function()
      jump(trace, hands, -1)
    end,
    ['0'] = function()
      if trace.traced then
        move_to(trace, hands, trace.traced.oldest)
      end
    end,
    ['$'] = function()
      trace.last = nil
      if trace.traced then
        move_to(trace, hands, trace.traced.newest)
      end
    end,
    v = function()
      local at = trace.cursors[trace.active] or trace.traced and trace.traced.here
      trace.cursors = { A = at, B = at }
      trace.active = 'B'
      hands.ask()
    end,
    o = function()
      trace.active = trace.active == 'A' and trace.cursors.B and 'B' or 'A'
      hands.ask()
    end,
    ['<Esc>'] = function()
      trace.cursors, trace.active = {}, 'A'
      hands.ask()
    end,
    ['+'] = function()
      zoom(trace, hands, 0.5)
    end,
    ['-'] = function()
      zoom(trace, hands, 2)
    end,
    ['='] = function()
      trace.span, trace.last = nil, nil
      hands.ask()
    end,
    ['<CR>'] = function()
      go(source, trace)
    end,
    a = function()
      hands.add_tag()
    end,
    d = function()
      local tag = trace.rows[vim.api.nvim_win_get_cursor(0)[1]]
      if tag then
        hands.remove_tag(tag)
      end
    end,
    q = function()
      hands.close()
    end,
    ['<LeftRelease>'] = function()
      take_mouse(trace, hands)
    end,
  }
  side_buffer.on_double_click(actions, function()
    take_mouse(trace, hands)
    go(source, trace)
  end)
  actions['<Left>'], actions['<Right>'] = actions.h, actions.l
  side_buffer.map(trace.bufnr, side_buffer.with_run(source, actions))
end

return M
