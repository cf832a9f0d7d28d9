--- The keys of the diagram: they work on what its cursor is on.
local assign = require('ladder.assign')
local breakpoints = require('ladder.breakpoints')
local cursor = require('ladder.diagram.cursor')
local here = require('ladder.diagram.here')
local sessions = require('ladder.session')
local side_buffer = require('ladder.side_buffer')
local simulation = require('ladder.simulation')

local M = {}

--- The tag under the cursor.
--- @param source integer
--- @param diagram ladder.Diagram
--- @param wants_bool boolean|nil
--- @return string|nil
local function tag_here(source, diagram, wants_bool)
  local block = here.block(diagram)
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

--- Gives the buffer of a diagram its keys.
--- @param source integer
--- @param diagram ladder.Diagram
--- @param close function
function M.map(source, diagram, close)
  local function of_tag(run, wants_bool)
    return function()
      local name = tag_here(source, diagram, wants_bool)
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
  local function ask(command)
    return of_tag(function(name)
      simulation.with_tag(source, name, function(tag)
        if tag then
          assign(source, command, tag)
        end
      end)
    end)
  end
  local function send(command)
    return function()
      simulation.command(source, command, { scans = vim.v.count1 })
    end
  end
  local actions = {
    ['<CR>'] = function()
      cursor.open_text(source, diagram)
    end,
    t = toggle,
    ['<F4>'] = toggle,
    p = of_tag(function(name)
      simulation.command(source, 'pulse', { tag = name })
    end, true),
    c = ask('set'),
    f = ask('force'),
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
    ['<F9>'] = function()
      local line = here.line(diagram)
      if line then
        breakpoints.toggle_line(source, line)
        simulation.send_breakpoints(source)
      end
    end,
    ['<F10>'] = send('step'),
    ['<F8>'] = send('back'),
    q = close,
  }
  side_buffer.on_double_click(actions, toggle)
  side_buffer.map(diagram.bufnr, actions)
end

return M
