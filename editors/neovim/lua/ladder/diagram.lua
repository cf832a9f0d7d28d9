--- The diagram beside the text: a split that shows the networks in sight drawn with characters, live while they are
--- simulated. What is drawn comes from the server.
require('ladder.highlight')

local server = require('ladder.server')
local sessions = require('ladder.session')
local side_buffer = require('ladder.side_buffer')
local simulation = require('ladder.simulation')
local status = require('ladder.status')
local value = require('ladder.value')

local M = {}

local namespace = vim.api.nvim_create_namespace('ladder_diagram')
--- So many lines above and below those in sight are drawn as well.
local margin = 5

local groups = {
  on = 'LadderPowerOn',
  off = 'LadderPowerOff',
  closed = 'LadderClosed',
  blocks = 'LadderBlocks',
  rail = 'LadderPowerOff',
  tag = 'LadderTagName',
  name = 'LadderBlockName',
  pin = 'LadderPowerOff',
  value = 'LadderValue',
  forced = 'LadderForced',
  comment = 'Comment',
  text = 'LadderPowerOff',
}

--- @class ladder.DrawnBlock
--- @field range lsp.Range
--- @field lines integer[] the first line that it is drawn in, and the one behind the last, from 0
--- @field columns integer[]
--- @field tags string[]|nil

--- @class ladder.Diagram
--- @field bufnr integer
--- @field drawn { line: integer, text: string, wire: boolean|nil, marks: any[][]|nil }[]
--- @field blocks ladder.DrawnBlock[]
--- @field lines { first: integer, last: integer } of the program, that were asked for
--- @field is_asking boolean
--- @field is_stale boolean
--- @field follows boolean the cursor in the program moves the one in the diagram

--- Diagrams by the buffer of their program.
--- @type table<integer, ladder.Diagram>
local diagrams = {}

local keys = '<CR> text  t toggle  p pulse  c set  f force  u release  w why  F5 F6 F10 F8  q'
local short_keys = '<CR> text  t toggle  p pulse  c f u  w why  q'

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
    local shown = #keys <= room and keys or #short_keys <= room and short_keys or ''
    vim.wo[window][0].winbar = (' %s%%=%s '):format(text:gsub('%%', '%%%%'), shown)
  end
end

--- The line of the diagram that shows a line of the program, or the last one before it: of a rung that of its wire.
--- @param diagram ladder.Diagram
--- @param line integer
--- @return integer|nil row from 1
local function row_of(diagram, line)
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
local function follow(source, diagram)
  local window = vim.fn.bufwinid(source)
  if window == -1 or #diagram.drawn == 0 then
    return
  end
  local line, at = unpack(vim.api.nvim_win_get_cursor(window))
  local row = row_of(diagram, line - 1)
  local block = block_at(source, diagram, line - 1, at)
  local column = block and math.floor((block.columns[1] + block.columns[2]) / 2) or 0
  for _, own in ipairs(row and windows(diagram) or {}) do
    if own ~= vim.api.nvim_get_current_win() then
      reveal(diagram, own, row, column)
    end
  end
end

--- @param line string
--- @param character integer
local function byte(line, character)
  return vim.str_byteindex(line, 'utf-32', character, false)
end

--- Draws the lines that have changed.
--- @param source integer
--- @param diagram ladder.Diagram
--- @param drawn table
local function draw(source, diagram, drawn)
  local before = diagram.drawn
  diagram.drawn, diagram.blocks = drawn.drawn, drawn.blocks
  local cursors = {}
  for _, window in ipairs(windows(diagram)) do
    local row = vim.api.nvim_win_get_cursor(window)[1]
    cursors[window] = before[row] and before[row].line
  end
  local bufnr = diagram.bufnr
  vim.bo[bufnr].modifiable = true
  if #before > #drawn.drawn then
    vim.api.nvim_buf_set_lines(bufnr, #drawn.drawn, -1, false, {})
  end
  for index, line in ipairs(drawn.drawn) do
    local old = before[index]
    if not old or old.text ~= line.text or not vim.deep_equal(old.marks, line.marks) then
      vim.api.nvim_buf_set_lines(bufnr, index - 1, index, false, { line.text })
      vim.api.nvim_buf_clear_namespace(bufnr, namespace, index - 1, index)
      for _, mark in ipairs(line.marks or {}) do
        if groups[mark[3]] then
          vim.api.nvim_buf_set_extmark(bufnr, namespace, index - 1, byte(line.text, mark[1]), {
            end_col = byte(line.text, mark[2]),
            hl_group = groups[mark[3]],
            strict = false,
          })
        end
      end
    end
  end
  if #drawn.drawn == 0 then
    vim.api.nvim_buf_set_lines(bufnr, 0, -1, false, { 'There is no network in sight.' })
  end
  vim.bo[bufnr].modifiable = false
  title(source, diagram)
  -- Other lines are shown: the cursor stays on its rung.
  local moved = #before ~= #drawn.drawn or (before[1] and drawn.drawn[1] and before[1].line ~= drawn.drawn[1].line)
  if moved then
    for window, line in pairs(cursors) do
      if window == vim.api.nvim_get_current_win() then
        local row = row_of(diagram, line)
        if row then
          vim.api.nvim_win_set_cursor(window, { row, vim.api.nvim_win_get_cursor(window)[2] })
        end
      end
    end
    follow(source, diagram)
  end
end

--- Asks for what is to be drawn; if an answer is awaited, again behind that.
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
      draw(source, diagram, drawn)
    end
    if diagram.is_stale then
      ask(source)
    end
  end, source)
  diagram.is_asking = sent and true or false
end

simulation.on_change(ask)

--- The block under the cursor of the diagram.
--- @param diagram ladder.Diagram
--- @return ladder.DrawnBlock|nil
local function block_here(diagram)
  local row, at = unpack(vim.api.nvim_win_get_cursor(0))
  local line = vim.api.nvim_get_current_line()
  local column = vim.fn.strdisplaywidth(line:sub(1, at))
  local found, distance
  for _, block in ipairs(diagram.blocks) do
    local is_here = block.lines[1] < row and row <= block.lines[2]
    if is_here and block.columns[1] <= column and column < block.columns[2] then
      -- The one whose wire is nearest, where the rooms of two rungs overlap.
      local middle = (block.lines[1] + block.lines[2]) / 2
      if not found or math.abs(middle - row) < distance then
        found, distance = block, math.abs(middle - row)
      end
    end
  end
  return found
end

--- @param source integer
--- @param wants_bool boolean|nil
--- @return string|nil
local function tag_here(source, wants_bool)
  local diagram = diagrams[source]
  local block = block_here(diagram)
  local session = sessions.of(source)
  if not session then
    vim.notify('ladder: nothing is simulated; ":Ladder start" starts a simulation.', vim.log.levels.WARN)
    return nil
  end
  for _, name in ipairs(block and block.tags or {}) do
    local tag = sessions.tag(session, name)
    if not wants_bool or (tag and type(tag.value) == 'boolean' and not tag.readOnly) then
      return name
    end
  end
  vim.notify('ladder: there is no tag under the cursor.', vim.log.levels.WARN)
  return nil
end

--- @param source integer
--- @param command 'set'|'force'
local function assign(source, command)
  local name = tag_here(source)
  if not name then
    return
  end
  simulation.with_tag(source, name, function(tag)
    if not tag then
      return
    end
    local prompt = ('%s %s (%s): '):format(command, tag.name, tag.type)
    vim.ui.input({ prompt = prompt, default = value.show(tag) }, function(text)
      if text and text ~= '' then
        simulation.command(source, command, { tag = tag.name, value = value.parse(tag.type, text) })
      end
    end)
  end)
end

--- The place in the program of what the cursor is on.
--- @param source integer
local function open_text(source)
  local diagram = diagrams[source]
  local block = block_here(diagram)
  local drawn = diagram.drawn[vim.api.nvim_win_get_cursor(0)[1]]
  local window = vim.fn.bufwinid(source)
  if window == -1 or not (block or drawn) then
    return
  end
  local client = server.of(source)
  local line = block and block.range.start.line or drawn.line
  local text = vim.api.nvim_buf_get_lines(source, line, line + 1, false)[1] or ''
  local at = 0
  if block and client then
    at = vim.str_byteindex(text, client.offset_encoding, block.range.start.character, false)
  end
  vim.api.nvim_set_current_win(window)
  vim.cmd("normal! m'")
  vim.api.nvim_win_set_cursor(window, { math.min(line + 1, vim.api.nvim_buf_line_count(source)), at })
end

local function map_keys(bufnr, source)
  local function of_tag(run, wants_bool)
    return function()
      local name = tag_here(source, wants_bool)
      if name then
        run(name)
      end
    end
  end
  local toggle = of_tag(function(name)
    require('ladder').toggle(name, source)
  end, true)
  local why = of_tag(function(name)
    require('ladder.why').ask(source, name)
  end)
  local function send(command)
    return function()
      simulation.command(source, command, { scans = vim.v.count1 })
    end
  end
  local actions = {
    ['<CR>'] = function()
      open_text(source)
    end,
    t = toggle,
    ['<F4>'] = toggle,
    p = of_tag(function(name)
      simulation.command(source, 'pulse', { tag = name })
    end, true),
    c = function()
      assign(source, 'set')
    end,
    f = function()
      assign(source, 'force')
    end,
    u = of_tag(function(name)
      simulation.command(source, 'unforce', { tag = name })
    end),
    w = why,
    ['<S-F4>'] = why,
    ['<F5>'] = function()
      simulation.run(source)
    end,
    ['<F6>'] = function()
      simulation.pause(source)
    end,
    ['<F10>'] = send('step'),
    ['<F8>'] = send('back'),
    q = function()
      M.close(source)
    end,
  }
  side_buffer.map(bufnr, actions)
end

local function create(source)
  local bufnr = side_buffer.create('diagram', source)
  map_keys(bufnr, source)
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
        follow(source, diagram)
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
  return bufnr
end

--- @param source integer
function M.open(source)
  local diagram = {
    bufnr = create(source),
    drawn = {},
    blocks = {},
    is_asking = false,
    is_stale = false,
  }
  diagrams[source] = diagram
  -- Beside the text where both have room, else below it.
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
