--- The tag panel: a split below the drawing that lists every tag with its value, and takes keys to change them.
require('ladder.highlight')

local sessions = require('ladder.session')
local simulation = require('ladder.simulation')
local status = require('ladder.status')
local value = require('ladder.value')

local M = {}

local namespace = vim.api.nvim_create_namespace('ladder_panel')
local max_height = 14

--- Panels by the buffer whose tags they show.
--- @type table<integer, integer>
local panels = {}

local keys = '<CR> toggle  c change  f force  u release  s step  r run  p pause  q close'

--- @param state ladder.State
--- @return string[] lines, table[] marks { row, first column, end column, group }
local function render(state)
  local names, types = 4, 4
  for _, tag in ipairs(state.tags) do
    names = math.max(names, vim.fn.strdisplaywidth(tag.name))
    types = math.max(types, #tag.type)
  end
  local lines, marks = {}, {}
  for index, tag in ipairs(state.tags) do
    local pad = (' '):rep(names - vim.fn.strdisplaywidth(tag.name))
    local name = tag.name .. pad .. '  '
    local kind = ('%-' .. types .. 's  %-8s  '):format(tag.type, tag.role)
    local shown = value.show(tag)
    lines[index] = name .. kind .. shown .. (tag.forced and '  forced' or '')
    local at = #name + #kind
    table.insert(marks, { index - 1, 0, #tag.name, 'LadderTagName' })
    table.insert(marks, { index - 1, #name, at, 'LadderTagType' })
    if tag.value == true then
      table.insert(marks, { index - 1, at, at + #shown, 'LadderValueOn' })
    end
    if tag.forced then
      table.insert(marks, { index - 1, at + #shown, #lines[index], 'LadderForced' })
    end
  end
  return lines, marks
end

--- @param panel integer
--- @param source integer
local function title(panel, source)
  local name = vim.fn.fnamemodify(vim.api.nvim_buf_get_name(source), ':t')
  local session = sessions.of(source)
  local text = ('%s: %s'):format(name, session and status.text(session) or 'not simulated')
  for _, window in ipairs(vim.fn.win_findbuf(panel)) do
    vim.wo[window][0].winbar = (text .. '  %=' .. keys):gsub('%%([^=])', '%%%%%1')
  end
end

--- @param source integer
local function refresh(source)
  local panel = panels[source]
  if not panel or not vim.api.nvim_buf_is_valid(panel) then
    panels[source] = nil
    return
  end
  local session = sessions.of(source)
  local lines, marks = {}, {}
  if session and session.state then
    lines, marks = render(session.state)
  end
  vim.bo[panel].modifiable = true
  vim.api.nvim_buf_set_lines(panel, 0, -1, false, lines)
  vim.bo[panel].modifiable = false
  vim.api.nvim_buf_clear_namespace(panel, namespace, 0, -1)
  for _, mark in ipairs(marks) do
    vim.api.nvim_buf_set_extmark(panel, namespace, mark[1], mark[2], { end_col = mark[3], hl_group = mark[4] })
  end
  title(panel, source)
end

simulation.on_change(refresh)

--- The tag in the cursor's line.
local function tag_here(source)
  local session = sessions.of(source)
  return session and session.state and session.state.tags[vim.api.nvim_win_get_cursor(0)[1]]
end

--- Asks for a value, then sends it with `set` or `force`.
local function ask(source, command)
  local tag = tag_here(source)
  if not tag then
    return
  end
  local prompt = ('%s %s (%s): '):format(command, tag.name, tag.type)
  vim.ui.input({ prompt = prompt, default = value.show(tag) }, function(text)
    if text and text ~= '' then
      simulation.command(source, command, { tag = tag.name, value = value.parse(tag.type, text) })
    end
  end)
end

local function map_keys(panel, source)
  local actions = {
    ['<CR>'] = function()
      local tag = tag_here(source)
      if tag and type(tag.value) == 'boolean' then
        simulation.command(source, 'set', { tag = tag.name, value = not tag.value })
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
      if tag then
        simulation.command(source, 'unforce', { tag = tag.name })
      end
    end,
    s = function()
      simulation.command(source, 'step', { scans = vim.v.count1 })
    end,
    b = function()
      simulation.command(source, 'back', { scans = vim.v.count1 })
    end,
    w = function()
      local tag = tag_here(source)
      if tag then
        simulation.ask(source, 'why', { tag = tag.name }, require('ladder.why').show)
      end
    end,
    r = function()
      simulation.command(source, 'run')
    end,
    p = function()
      simulation.pause(source)
    end,
    q = function()
      M.close(source)
    end,
  }
  for key, action in pairs(actions) do
    vim.keymap.set('n', key, action, { buffer = panel, nowait = true })
  end
end

local function create(source)
  local panel = vim.api.nvim_create_buf(false, true)
  vim.bo[panel].bufhidden = 'wipe'
  vim.bo[panel].filetype = 'ladder_tags'
  vim.api.nvim_buf_set_name(panel, ('ladder://tags/%d'):format(source))
  vim.b[panel].ladder_source = source
  map_keys(panel, source)
  return panel
end

--- @param source integer
function M.open(source)
  local panel = create(source)
  panels[source] = panel
  local session = sessions.of(source)
  local tags = session and session.state and #session.state.tags or 0
  vim.api.nvim_open_win(panel, false, {
    split = 'below',
    -- One line more for the title.
    height = math.min(math.max(tags, 3) + 1, max_height),
    style = 'minimal',
  })
  for _, window in ipairs(vim.fn.win_findbuf(panel)) do
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
  for _, window in ipairs(panel and vim.fn.win_findbuf(panel) or {}) do
    vim.api.nvim_win_close(window, true)
  end
end

--- @param source integer
function M.toggle(source)
  local panel = panels[source]
  if panel and vim.api.nvim_buf_is_valid(panel) then
    M.close(source)
  else
    M.open(source)
  end
end

return M
