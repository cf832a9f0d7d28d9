--- `:Ladder` and its subcommands: what each takes, what it does, what completes it.
local M = {}

--- The buffer a command is about: the one whose tags the panel shows, if it was given in the panel.
local function buffer()
  local bufnr = vim.api.nvim_get_current_buf()
  return vim.b[bufnr].ladder_source or bufnr
end

--- The buffer that a command of the simulator is about: of a Click program its diagram.
local function drawing()
  return require('ladder.click').drawing(buffer()) or buffer()
end

local function simulation()
  return require('ladder.simulation')
end

local function session()
  return require('ladder.session').of(drawing())
end

--- The tag under the cursor.
--- Thrown as a string without a place: `run` shows it to the user as it is.
local function refuse(message)
  error(message, 0)
end

local function tag_here(wants_bool)
  local running = session() or refuse('no simulation runs for this buffer; ":Ladder start" starts one.')
  return require('ladder.operands').tag_here(running, wants_bool)
end

local function count(text, default)
  if not text then
    return default
  end
  local number = tonumber(text)
  if not number or number < 1 or number % 1 ~= 0 then
    refuse(('"%s" is not a number of scans: write a whole number from 1.'):format(text))
  end
  return number
end

--- A tag's name and a value, which may hold blanks if it is a string.
local function assignment(arguments, subcommand)
  local name = arguments[1]
  local text = table.concat(arguments, ' ', 2)
  if not name or text == '' then
    refuse((':Ladder %s needs a tag and a value, as in ":Ladder %s start 1".'):format(subcommand, subcommand))
  end
  return name, text
end

--- Sends what was typed for a tag.
local function assign(arguments, subcommand)
  local name, text = assignment(arguments, subcommand)
  simulation().command(drawing(), subcommand, { tag = name, text = text })
end

--- @param wanted fun(tag: ladder.Tag): boolean
--- @param lead string what their names hold
local function tag_names(wanted, lead)
  local names = {}
  for _, tag in ipairs(simulation().search(drawing(), lead)) do
    if wanted(tag) then
      table.insert(names, tag.name)
    end
  end
  return names
end

--- Completes a tag, then TRUE or FALSE if it is a BOOL.
local function complete_assignment(wanted)
  return function(arguments, lead)
    if #arguments == 0 then
      return tag_names(wanted, lead)
    end
    local is_meant = function(tag)
      return vim.fn.tolower(tag.name) == vim.fn.tolower(arguments[1]) and tag.type == 'BOOL'
    end
    return #arguments == 1 and #tag_names(is_meant, arguments[1]) > 0 and { 'TRUE', 'FALSE' } or {}
  end
end

local function is_bool(tag)
  return tag.type == 'BOOL' and not tag.readOnly
end

local function is_forced(tag)
  return tag.forced
end

local function is_writable(tag)
  return not tag.readOnly
end

local function any()
  return true
end

--- `0.1`, `10`, `10x`, `max`
local function speed(text)
  if text == 'max' then
    return 'max'
  end
  local number = tonumber(((text or ''):gsub('x$', '')))
  if not number or number <= 0 then
    refuse(':Ladder speed needs a number, as 0.1 for slow motion or 10 for ten times real time, or "max".')
  end
  return number
end

--- @class ladder.Subcommand
--- @field run fun(arguments: string[])
--- @field complete? fun(before: string[], lead: string): string[] `before` are the arguments in front of `lead`

--- @type table<string, ladder.Subcommand>
local subcommands = {
  start = {
    run = function()
      require('ladder.click').start(buffer())
    end,
  },
  serve = {
    run = function()
      local state = require('ladder').state()
      simulation().command(drawing(), 'serve', { on = not (state and state.served) })
    end,
  },
  online = {
    run = function()
      simulation().go_online(drawing())
    end,
  },
  offline = {
    run = function()
      simulation().stop(drawing())
    end,
  },
  step = {
    run = function(arguments)
      simulation().command(drawing(), 'step', { scans = count(arguments[1], 1) })
    end,
  },
  back = {
    run = function(arguments)
      simulation().command(drawing(), 'back', { scans = count(arguments[1], 1) })
    end,
  },
  block = {
    run = function()
      simulation().command(drawing(), 'stepBlock')
    end,
  },
  rung = {
    run = function()
      simulation().command(drawing(), 'stepRung')
    end,
  },
  ['break'] = {
    run = function(arguments)
      local breakpoints = require('ladder.breakpoints')
      if arguments[1] then
        breakpoints.toggle_tag(drawing(), arguments[1])
      elseif drawing() ~= buffer() then
        refuse('put the cursor on a rung of the diagram; the Python file has none.')
      else
        breakpoints.toggle_line(drawing(), vim.api.nvim_win_get_cursor(0)[1] - 1)
      end
      simulation().send_breakpoints(drawing())
    end,
    complete = function(before, lead)
      return #before == 0 and tag_names(any, lead) or {}
    end,
  },
  why = {
    run = function(arguments)
      local tag = arguments[1] or tag_here() or refuse('there is no tag under the cursor.')
      require('ladder.why').ask(drawing(), tag)
    end,
    complete = function(before, lead)
      return #before == 0 and tag_names(any, lead) or {}
    end,
  },
  record = {
    run = function(arguments)
      require('ladder.record').record(drawing(), table.concat(arguments, ' '))
    end,
  },
  warm = {
    run = function()
      simulation().command(drawing(), 'warmRestart')
    end,
  },
  run = {
    run = function(arguments)
      simulation().run(drawing(), count(arguments[1], nil))
    end,
  },
  speed = {
    run = function(arguments)
      simulation().speed(drawing(), speed(arguments[1]))
    end,
    complete = function(before)
      return #before == 0 and { '0.01', '0.1', '0.5', '1', '2', '10', '100', 'max' } or {}
    end,
  },
  keys = {
    run = function()
      local lines = vim.tbl_map(function(key)
        return ('%-7s %s'):format(key[1], key[3])
      end, require('ladder.keys').all)
      vim.notify('ladder: while a program is simulated\n' .. table.concat(lines, '\n'))
    end,
  },
  pause = {
    run = function()
      simulation().pause(drawing())
    end,
  },
  set = {
    run = function(arguments)
      assign(arguments, 'set')
    end,
    complete = complete_assignment(is_writable),
  },
  toggle = {
    run = function(arguments)
      local tag = arguments[1] or tag_here(true) or refuse('there is no tag under the cursor.')
      require('ladder').toggle(tag, drawing())
    end,
    complete = function(before, lead)
      return #before == 0 and tag_names(is_bool, lead) or {}
    end,
  },
  force = {
    run = function(arguments)
      assign(arguments, 'force')
    end,
    complete = complete_assignment(is_writable),
  },
  unforce = {
    run = function(arguments)
      simulation().command(drawing(), 'unforce', { tag = arguments[1] })
    end,
    complete = function(before, lead)
      return #before == 0 and tag_names(is_forced, lead) or {}
    end,
  },
  reset = {
    run = function()
      simulation().command(drawing(), 'reset')
    end,
  },
  stop = {
    run = function()
      simulation().stop(drawing())
    end,
  },
  tags = {
    run = function()
      require('ladder.panel').toggle(drawing())
    end,
  },
  references = {
    run = function()
      require('ladder.references').open(drawing())
    end,
  },
  diff = {
    run = function(arguments)
      require('ladder.diff').open(buffer(), arguments[1])
    end,
  },
  review = {
    run = function(arguments)
      if not arguments[1] then
        require('ladder.review').toggle(buffer())
      elseif arguments[1] == 'reason' then
        require('ladder.review').reason(buffer())
      else
        refuse(('":Ladder review" takes nothing, or "reason" for the rung at the cursor; not "%s".'):format(arguments[1]))
      end
    end,
    complete = function(arguments)
      return #arguments == 0 and { 'reason' } or {}
    end,
  },
  diagram = {
    run = function()
      require('ladder.diagram').toggle(drawing())
    end,
  },
  trace = {
    run = function(arguments)
      require('ladder.trace').toggle(drawing(), arguments)
    end,
    complete = function(_, lead)
      return tag_names(any, lead)
    end,
  },
  check = {
    run = function()
      vim.diagnostic.setloclist({ title = 'Ladder check' })
    end,
  },
  explain = {
    run = function(arguments)
      local explain = require('ladder.explain')
      local rule = arguments[1] or explain.rule_here() or refuse('there is no finding in this line; ":Ladder explain RULE" shows the page of a rule.')
      explain.show(buffer(), rule)
    end,
    complete = function(arguments)
      return #arguments == 0 and require('ladder.explain').rules() or {}
    end,
  },
  test = {
    run = function(arguments)
      local nearest
      if arguments[1] == 'nearest' then
        nearest = require('ladder.dap').scenario_here() or refuse('the cursor is in no scenario.')
      elseif arguments[1] then
        refuse(('":Ladder test" takes nothing, or "nearest" for the scenario at the cursor; not "%s".'):format(arguments[1]))
      end
      require('ladder.test').run(buffer(), nearest)
    end,
    complete = function(arguments)
      return #arguments == 0 and { 'nearest' } or {}
    end,
  },
  prove = {
    run = function(arguments)
      local prove, here = require('ladder.prove'), nil
      if arguments[1] == 'nearest' then
        here = prove.here() or refuse('there is no property above the cursor.')
      elseif arguments[1] then
        refuse(('":Ladder prove" takes nothing, or "nearest" for the property at the cursor; not "%s".'):format(arguments[1]))
      end
      prove.run(buffer(), here)
    end,
    complete = function(arguments)
      return #arguments == 0 and { 'nearest' } or {}
    end,
  },
  convert = {
    run = function(arguments)
      require('ladder.convert').run(buffer(), arguments[1])
    end,
    complete = function(before)
      return #before == 0 and require('ladder.convert').notations(buffer()) or {}
    end,
  },
  preview = {
    run = function()
      require('ladder.click').preview(buffer())
    end,
  },
  status = {
    run = function()
      local client = require('ladder.server').of(buffer())
      local info = client and client.server_info or {}
      local server = client and ('%s %s'):format(info.name or client.name, info.version or '')
        or 'no language server attached'
      local session = require('ladder').status(drawing())
      vim.notify(('ladder: %s; simulation: %s'):format(vim.trim(server), session == '' and 'none' or session))
    end,
  },
}

--- Runs `:Ladder` with the words after it.
--- @param words string[]
function M.run(words)
  local name = words[1] or 'status'
  local subcommand = subcommands[name]
  if not subcommand then
    return vim.notify(
      ('ladder: there is no ":Ladder %s"; there are: %s.'):format(name, table.concat(M.names(), ', ')),
      vim.log.levels.ERROR
    )
  end
  local done, message = pcall(subcommand.run, vim.list_slice(words, 2))
  if not done then
    vim.notify('ladder: ' .. message, vim.log.levels.ERROR)
  end
end

--- @return string[] sorted
function M.names()
  local names = vim.tbl_keys(subcommands)
  table.sort(names)
  return names
end

--- @param lead string what is typed of the word to complete
--- @param line string the command line up to the cursor
--- @return string[]
function M.complete(lead, line)
  local words = vim.split(vim.trim(line:sub(1, #line - #lead)), '%s+')
  -- words[1] is the command itself, perhaps after a range or `silent`.
  while words[1] and not words[1]:match('Ladder$') do
    table.remove(words, 1)
  end
  local candidates
  if #words <= 1 then
    candidates = M.names()
  else
    local subcommand = subcommands[words[2]]
    candidates = subcommand and subcommand.complete and subcommand.complete(vim.list_slice(words, 3), lead) or {}
  end
  local folded = vim.fn.tolower(lead)
  return vim.tbl_filter(function(candidate)
    return vim.startswith(vim.fn.tolower(candidate), folded)
  end, candidates)
end

return M
