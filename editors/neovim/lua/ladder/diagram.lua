--- The diagram next to the text: a split that shows the networks in sight drawn with characters, live while they are
--- simulated. What is drawn comes from the server.
require('ladder.highlight')

local cursor = require('ladder.diagram.cursor')
local draw = require('ladder.diagram.draw')
local keys = require('ladder.diagram.keys')
local picture = require('ladder.diagram.picture')
local server = require('ladder.server')
local sessions = require('ladder.session')
local side_buffer = require('ladder.side_buffer')
local simulation = require('ladder.simulation')
local spot = require('ladder.diagram.spot')
local status = require('ladder.status')
local view = require('ladder.view')

local M = {}

--- So many lines above and below those in sight are drawn as well.
local margin = 5

--- @class ladder.DrawnBlock
--- @field range lsp.Range
--- @field lines integer[] the first line that it is drawn in, and the one after the last, from 0
--- @field columns integer[]
--- @field tags string[]|nil

--- @class ladder.DrawnWire
--- @field at lsp.Position where it begins in the program
--- @field line integer that it is drawn in, from 0
--- @field columns integer[]

--- @class ladder.DrawnJoin
--- @field at lsp.Position of its lower connector
--- @field lines integer[]
--- @field column integer

--- @class ladder.Diagram
--- @field bufnr integer
--- @field drawn { line: integer, text: string, wire: boolean|nil, marks: any[][]|nil }[]
--- @field blocks ladder.DrawnBlock[]
--- @field wires ladder.DrawnWire[]
--- @field joins ladder.DrawnJoin[]
--- @field wanted { place: lsp.Position, tick: integer }|nil where its cursor goes when a text that is no older is drawn
--- @field lines { first: integer, last: integer } of the program, that were asked for
--- @field is_asking boolean
--- @field is_stale boolean
--- @field follows boolean the cursor in the program moves the one in the diagram

--- Diagrams by the buffer of their program.
--- @type table<integer, ladder.Diagram>
local diagrams = {}

local help = '<CR> text  t toggle  p pulse  c set  f force  u release  w why  F5 F6 F10 F8  q'
local short_help = '<CR> text  t toggle  p pulse  c f u  w why  q'

--- @param diagram ladder.Diagram
local function windows(diagram)
  return side_buffer.windows(diagram.bufnr)
end

--- The lines of the program that its windows show.
--- @param source integer
local function in_sight(source)
  local first, last = math.huge, -1
  for _, window in ipairs(vim.fn.win_findbuf(source)) do
    local info = vim.fn.getwininfo(window)[1]
    first = math.min(first, info.topline - 1)
    last = math.max(last, info.botline - 1, info.topline + info.height - 2)
  end
  if last < 0 then
    return nil
  end
  local count = vim.api.nvim_buf_line_count(source)
  return { first = math.max(first - margin, 0), last = math.min(last + margin, count - 1) }
end

--- @param source integer
--- @param diagram ladder.Diagram
local function title(source, diagram)
  local session = sessions.of(source)
  local name = vim.fn.fnamemodify(vim.api.nvim_buf_get_name(source), ':t')
  local text = session and status.text(session) or name .. ', at rest'
  for _, window in ipairs(windows(diagram)) do
    local room = vim.api.nvim_win_get_width(window) - vim.fn.strdisplaywidth(text) - 4
    local draws = ('  %s? draw'):format(vim.g.maplocalleader or '\\')
    local shown = vim.iter({ help .. draws, short_help .. draws, draws }):find(function(keys_shown)
      return vim.fn.strdisplaywidth(keys_shown) <= room
    end) or ''
    vim.wo[window][0].winbar = (' %s%%=%s '):format(text:gsub('%%', '%%%%'), (shown:gsub('%%', '%%%%')))
  end
end

--- Asks for what is to be drawn; if an answer is awaited, again after that.
--- @param source integer
local function ask(source)
  local diagram = diagrams[source]
  if not diagram or #windows(diagram) == 0 or not vim.api.nvim_buf_is_loaded(source) then
    diagrams[source] = nil
    return
  end
  if diagram.is_asking then
    diagram.is_stale = true
    return
  end
  local client = server.of(source)
  local lines = in_sight(source) or diagram.lines
  if not client or not lines then
    return title(source, diagram)
  end
  diagram.is_asking, diagram.is_stale = true, false
  diagram.lines = lines
  local session = sessions.of(source)
  local room = 80
  for _, window in ipairs(windows(diagram)) do
    room = vim.api.nvim_win_get_width(window)
  end
  local argument = {
    uri = vim.uri_from_bufnr(source),
    session = session and session.id,
    lines = lines,
    rail = math.min(math.max(room - 2, 40), 100),
  }
  local params = { command = 'ladder.diagramText', arguments = { argument } }
  local sent = client:request('workspace/executeCommand', params, function(err, drawn)
    if diagrams[source] ~= diagram then
      return
    end
    diagram.is_asking = false
    if not err and #windows(diagram) > 0 then
      picture.draw(source, diagram, drawn)
      spot.show(diagram, vim.api.nvim_get_current_buf() == diagram.bufnr)
      title(source, diagram)
    end
    if diagram.is_stale then
      ask(source)
    end
  end, source)
  diagram.is_asking = sent and true or false
end

view.on_change(ask)

--- Shows what the program shows, and follows its cursor, as long as the buffer of the diagram is there.
--- @param source integer
--- @param bufnr integer
local function watch(source, bufnr)
  local group = vim.api.nvim_create_augroup(('ladder_diagram_%d'):format(source), {})
  local function again()
    -- A window that scrolls does not say where to before it is drawn.
    vim.schedule(function()
      ask(source)
    end)
  end
  vim.api.nvim_create_autocmd({ 'WinScrolled', 'WinResized' }, { group = group, callback = again })
  vim.api.nvim_create_autocmd({ 'TextChanged', 'TextChangedI' }, { group = group, buffer = source, callback = again })
  vim.api.nvim_create_autocmd({ 'CursorMoved', 'CursorMovedI' }, {
    group = group,
    buffer = source,
    callback = function()
      local diagram = diagrams[source]
      if diagram then
        cursor.follow(source, diagram)
      end
    end,
  })
  vim.api.nvim_create_autocmd({ 'CursorMoved', 'BufEnter', 'BufLeave' }, {
    group = group,
    buffer = bufnr,
    callback = function(event)
      local diagram = diagrams[source]
      if diagram then
        spot.show(diagram, event.event ~= 'BufLeave')
      end
    end,
  })
  vim.api.nvim_create_autocmd('BufWipeout', {
    group = group,
    buffer = bufnr,
    callback = function()
      vim.api.nvim_clear_autocmds({ group = group })
    end,
  })
end

--- @param source integer
function M.open(source)
  local diagram = {
    bufnr = side_buffer.create('diagram', source),
    drawn = {},
    blocks = {},
    wires = {},
    joins = {},
    is_asking = false,
    is_stale = false,
  }
  diagrams[source] = diagram
  keys.map(source, diagram, function()
    M.close(source)
  end)
  draw.map(source, diagram, function()
    ask(source)
  end)
  watch(source, diagram.bufnr)
  -- Next to the text where both have room, else below it.
  local is_wide = vim.api.nvim_win_get_width(0) >= 160
  local window = vim.api.nvim_open_win(diagram.bufnr, false, { split = is_wide and 'right' or 'below', style = 'minimal' })
  vim.wo[window][0].wrap = false
  vim.wo[window][0].cursorline = true
  vim.wo[window][0].sidescrolloff = 0
  ask(source)
end

--- @param source integer
function M.close(source)
  local diagram = diagrams[source]
  diagrams[source] = nil
  for _, window in ipairs(diagram and windows(diagram) or {}) do
    vim.api.nvim_win_close(window, true)
  end
end

--- @param source integer
function M.toggle(source)
  local diagram = diagrams[source]
  if diagram and #windows(diagram) > 0 then
    M.close(source)
  else
    M.open(source)
  end
end

return M
