--- The tag panel: a split below the drawing that lists every tag with its value, and takes keys to change them. Of a
--- long list only the lines that its window shows are kept up to date.
require('ladder.highlight')

local assign = require('ladder.assign')
local sessions = require('ladder.session')
local shown = require('ladder.shown')
local side_buffer = require('ladder.side_buffer')
local simulation = require('ladder.simulation')
local status = require('ladder.status')
local view = require('ladder.view')
local watched = require('ladder.remembered')('ladder-watched')

local M = {}

local namespace = vim.api.nvim_create_namespace('ladder_panel')
local max_height = 14

--- @class ladder.Panel
--- @field bufnr integer
--- @field session string|nil whose tags are listed
--- @field program integer which of its programs they are of
--- @field wanted string what the names of those hold that are shown
--- @field tags ladder.Tag[] the rows, as they were when they were listed
--- @field listed ladder.Tag[] those of the program, of which those that open are one each
--- @field watched ladder.Tag[] those that are listed first, with a mark, and once more in their place
--- @field opened table<string, ladder.Tag[]> what the tags that are open open into
--- @field depths table<integer, integer> how many tags a row is in that are open, by its line from 1; nothing for none
--- @field drawn table<integer, string> what is in the lines that were drawn, by line from 1
--- @field names integer the width of the names
--- @field types integer the width of the types

--- Panels by the buffer whose tags they show.
--- @type table<integer, ladder.Panel>
local panels = {}

local keys = '<CR> toggle  c change  f force  u release  w why  * watch  F filter  s step  b back  r run  p pause  q close'

--- @param panel ladder.Panel
--- @param tag ladder.Tag
--- @param is_watched boolean it is a row of the watch list
--- @param depth integer
--- @return string line, table[] marks { first column, end column, group }
local function render(panel, tag, is_watched, depth)
  local mark = ('  '):rep(depth) .. (is_watched and '* ' or tag.parts and (panel.opened[tag.name] and '▾ ' or '▸ ') or '')
  local pad = (' '):rep(panel.names - vim.fn.strdisplaywidth(mark .. tag.name))
  local name = mark .. tag.name .. pad .. '  '
  local role = tag.readOnly and 'constant' or tag.role
  local kind = ('%-' .. panel.types .. 's  %-8s  '):format(tag.type, role)
  local text = tag.text
  local line = name .. kind .. text .. (tag.forced and '  forced' or '')
  local at = #name + #kind
  local marks = { { 0, #mark + #tag.name, 'LadderTagName' }, { #name, at, 'LadderTagType' } }
  if tag.value == true then
    table.insert(marks, { at, at + #text, 'LadderValueOn' })
  end
  if tag.forced then
    table.insert(marks, { at + #text, #line, 'LadderForced' })
  end
  return line, marks
end

--- @param panel ladder.Panel
--- @return integer first, integer last the lines that its windows show, from 1
local function lines_shown(panel)
  local first, last = math.huge, 0
  for _, window in ipairs(vim.fn.win_findbuf(panel.bufnr)) do
    local info = vim.fn.getwininfo(window)[1]
    first = math.min(first, info.topline)
    last = math.max(last, info.botline, info.topline + info.height)
  end
  return first == math.huge and 1 or first, math.min(last, #panel.tags)
end

--- Draws the lines that are shown, where they have changed.
--- @param source integer
--- @param panel ladder.Panel
local function draw(source, panel)
  local session = sessions.of(source)
  local first, last = lines_shown(panel)
  vim.bo[panel.bufnr].modifiable = true
  for index = first, last do
    local tag = sessions.tag(session, panel.tags[index].name) or panel.tags[index]
    local line, marks = render(panel, tag, index <= #panel.watched, panel.depths[index] or 0)
    local key = line .. (tag.forced and '!' or '')
    if panel.drawn[index] ~= key then
      panel.drawn[index] = key
      vim.api.nvim_buf_set_lines(panel.bufnr, index - 1, index, false, { line })
      vim.api.nvim_buf_clear_namespace(panel.bufnr, namespace, index - 1, index)
      for _, mark in ipairs(marks) do
        vim.api.nvim_buf_set_extmark(panel.bufnr, namespace, index - 1, mark[1], {
          end_col = mark[2],
          hl_group = mark[3],
        })
      end
    end
  end
  vim.bo[panel.bufnr].modifiable = false
end

--- @param panel ladder.Panel
--- @param source integer
local function title(panel, source)
  local name = vim.fn.fnamemodify(vim.api.nvim_buf_get_name(source), ':t')
  local session = sessions.of(source)
  local text = ('%s: %s'):format(name, session and status.text(session) or 'not simulated')
  for _, window in ipairs(vim.fn.win_findbuf(panel.bufnr)) do
    vim.wo[window][0].winbar = (text .. '  %=' .. keys):gsub('%%([^=])', '%%%%%1')
  end
end

--- Adds a row, and below it what it opens into, if it is open.
--- @param panel ladder.Panel
--- @param tag ladder.Tag
--- @param depth integer
local function add(panel, tag, depth)
  table.insert(panel.tags, tag)
  panel.depths[#panel.tags] = depth
  for _, part in ipairs(panel.opened[tag.name] or {}) do
    add(panel, part, depth + 1)
  end
end

--- @param panel ladder.Panel
--- @param listed ladder.Tag[]
local function list(panel, listed)
  local sought = vim.fn.tolower(panel.wanted)
  panel.listed, panel.tags, panel.depths, panel.drawn = listed, vim.list_slice(panel.watched), {}, {}
  panel.names, panel.types = 4, 4
  for _, tag in ipairs(listed) do
    if vim.fn.tolower(tag.name .. ' : ' .. tag.type):find(sought, 1, true) then
      add(panel, tag, 0)
    end
  end
  local tags, names = panel.tags, {}
  for index, tag in ipairs(tags) do
    names[index] = tag.name
    local mark = 2 * (panel.depths[index] or 0) + ((tag.parts or index <= #panel.watched) and 2 or 0)
    panel.names = math.max(panel.names, mark + vim.fn.strdisplaywidth(tag.name))
    panel.types = math.max(panel.types, #tag.type)
  end
  vim.bo[panel.bufnr].modifiable = true
  vim.api.nvim_buf_set_lines(panel.bufnr, 0, -1, false, names)
  vim.bo[panel.bufnr].modifiable = false
  for _, window in ipairs(vim.fn.win_findbuf(panel.bufnr)) do
    -- One line more for the title.
    vim.api.nvim_win_set_height(window, math.min(math.max(#tags, 3) + 1, max_height))
  end
end

local refresh

--- Lists tags of a program, unless another one runs meanwhile, below those that are watched.
--- @param source integer
--- @param panel ladder.Panel
--- @param listed ladder.Tag[]
local function list_with_watched(source, panel, listed)
  local id, program = panel.session, panel.program
  local function with(tags)
    local is_still = panels[source] == panel and panel.session == id and panel.program == program
    if is_still and vim.api.nvim_buf_is_valid(panel.bufnr) then
      panel.watched = tags
      list(panel, listed)
      simulation.look(source)
      refresh(source)
    end
  end
  local names = watched.of(source) or {}
  if #names == 0 then
    return with({})
  end
  simulation.ask(source, 'tags', { names = names }, function(found)
    with(found.tags)
  end)
end

--- @param source integer
function refresh(source)
  local panel = panels[source]
  if not panel or not vim.api.nvim_buf_is_valid(panel.bufnr) then
    panels[source] = nil
    shown.tags(source, nil)
    return
  end
  local session = sessions.of(source)
  local id = session and session.id
  local program = session and session.state and session.state.program or 0
  if panel.session ~= id or panel.program ~= program then
    panel.opened = {}
    if panel.session ~= id then
      panel.watched = {}
      list(panel, {})
    end
    panel.session, panel.program = id, program
    if id then
      simulation.ask(source, 'tags', { of = '' }, function(found)
        if panel.session == id and panel.program == program then
          list_with_watched(source, panel, found.tags)
        end
      end)
    end
  end
  draw(source, panel)
  title(panel, source)
end

view.on_change(refresh)

--- The tag in the cursor's line.
local function tag_here(source)
  local panel = panels[source]
  local listed = panel and panel.tags[vim.api.nvim_win_get_cursor(0)[1]]
  return listed and (sessions.tag(sessions.of(source), listed.name) or listed)
end

--- Opens a tag, or closes it.
--- @param source integer
--- @param tag ladder.Tag
local function open_or_close(source, tag)
  local panel = panels[source]
  local function with(parts)
    if panels[source] == panel and vim.api.nvim_buf_is_valid(panel.bufnr) then
      panel.opened[tag.name] = parts
      list(panel, panel.listed)
      simulation.look(source)
      refresh(source)
    end
  end
  if panel.opened[tag.name] then
    return with(nil)
  end
  local session, program = panel.session, panel.program
  simulation.ask(source, 'tags', { of = tag.name }, function(found)
    if panel.session == session and panel.program == program then
      with(found.tags)
    end
  end)
end

--- @param source integer
--- @param command 'set'|'force'
local function ask(source, command)
  local tag = tag_here(source)
  if tag and tag.parts then
    open_or_close(source, tag)
  elseif tag then
    assign(source, command, tag)
  end
end

local function map_keys(panel, source)
  local actions = {
    ['<CR>'] = function()
      local tag = tag_here(source)
      if tag and tag.parts then
        open_or_close(source, tag)
      elseif tag and type(tag.value) == 'boolean' then
        require('ladder').toggle(tag.name, source)
      else
        ask(source, 'set')
      end
    end,
    c = function()
      ask(source, 'set')
    end,
    f = function()
      ask(source, 'force')
    end,
    u = function()
      local tag = tag_here(source)
      if tag and not tag.parts then
        simulation.command(source, 'unforce', { tag = tag.name })
      end
    end,
    w = function()
      local tag = tag_here(source)
      if tag and not tag.parts then
        require('ladder.why').ask(source, tag.name)
      end
    end,
    ['*'] = function()
      local tag = tag_here(source)
      if tag then
        local names = watched.of(source) or {}
        local others = vim.tbl_filter(function(name)
          return name ~= tag.name
        end, names)
        watched.set(source, #others < #names and others or vim.list_extend(others, { tag.name }))
        list_with_watched(source, panels[source], panels[source].listed)
      end
    end,
    F = function()
      local panel = panels[source]
      vim.ui.input({ prompt = 'Part of a name or type: ', default = panel.wanted }, function(wanted)
        if wanted and panels[source] == panel then
          panel.wanted = vim.trim(wanted)
          list(panel, panel.listed)
          simulation.look(source)
          refresh(source)
        end
      end)
    end,
    q = function()
      M.close(source)
    end,
  }
  side_buffer.map(panel, side_buffer.with_run(source, actions))
end

local function create(source)
  local panel = side_buffer.create('tags', source)
  map_keys(panel, source)
  -- What scrolls into sight is to be asked for, and drawn.
  vim.api.nvim_create_autocmd('WinScrolled', {
    buffer = panel,
    callback = function()
      refresh(source)
    end,
  })
  return panel
end

--- @param source integer
function M.open(source)
  local panel = { bufnr = create(source), program = 0, wanted = '', tags = {}, listed = {}, watched = {}, opened = {}, depths = {}, drawn = {}, names = 4, types = 4 }
  panels[source] = panel
  shown.tags(source, function()
    local first, last = lines_shown(panel)
    local names = {}
    for index = first, last do
      table.insert(names, panel.tags[index].name)
    end
    return names
  end)
  -- The keys are those of the panel: a split that had no focus would leave them to the program.
  vim.api.nvim_open_win(panel.bufnr, true, { split = 'below', height = 4, style = 'minimal' })
  for _, window in ipairs(vim.fn.win_findbuf(panel.bufnr)) do
    vim.wo[window][0].cursorline = true
    vim.wo[window][0].winfixheight = true
    vim.wo[window][0].wrap = false
  end
  refresh(source)
end

--- @param source integer
function M.close(source)
  local panel = panels[source]
  panels[source] = nil
  shown.tags(source, nil)
  for _, window in ipairs(panel and vim.fn.win_findbuf(panel.bufnr) or {}) do
    vim.api.nvim_win_close(window, true)
  end
end

--- @param source integer
function M.toggle(source)
  local panel = panels[source]
  if panel and vim.api.nvim_buf_is_valid(panel.bufnr) then
    M.close(source)
  else
    M.open(source)
  end
end

return M
