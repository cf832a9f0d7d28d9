-- What a simulation costs in Neovim: how long a user waits, and how busy the editor is. Writes a table.
local ladder = require('ladder')
local sessions = require('ladder.session')

local times = 9
local seconds = tonumber(vim.env.LADDER_SECONDS) or 10

local function now()
  return vim.uv.hrtime() / 1e6
end

--- How long this process has worked, in milliseconds.
local function worked()
  local usage = vim.uv.getrusage()
  local function ms(time)
    return time.sec * 1000 + time.usec / 1000
  end
  return ms(usage.utime) + ms(usage.stime)
end

--- How long it takes until something holds and is drawn, in milliseconds.
local function time_until(act, holds)
  local began = now()
  act()
  assert(vim.wait(60000, holds, 1), 'waited 60 s in vain')
  vim.cmd('redraw')
  return now() - began
end

local function repeated(act, holds)
  local taken = {}
  for time = 1, times do
    taken[time] = time_until(function()
      act(time)
    end, function()
      return holds(time)
    end)
    vim.wait(100)
  end
  return taken
end

local function shown(values)
  table.sort(values)
  return ('%.0f (%.0f)'):format(values[math.ceil(#values / 2)], values[#values])
end

--- Counts the states that are shown.
local states = 0
local counted = {}
local function count(client)
  if counted[client.id] then
    return
  end
  counted[client.id] = true
  local notify = client.notify
  client.notify = function(self, method, ...)
    if method == 'ladder/simulationShown' then
      states = states + 1
    end
    return notify(self, method, ...)
  end
end

--- Lets the program run for a while: the share of the time that the editor works, and how many states it shows in a second.
local function look_at_run()
  vim.wait(1000)
  local began, before, first = now(), worked(), states
  vim.wait(seconds * 1000)
  local taken = now() - began
  return ('%.1f %%'):format((worked() - before) / taken * 100), ('%.1f'):format((states - first) / taken * 1000)
end

local function measure_one(name)
  local row = { { '', name } }
  local function tell(what, value)
    table.insert(row, { what, value or '' })
  end
  vim.cmd.edit(vim.env.LADDER_SCRATCH .. '/' .. name .. '.clad')
  local bufnr = vim.api.nvim_get_current_buf()
  assert(vim.wait(60000, function()
    return vim.lsp.get_clients({ bufnr = bufnr, name = 'ladder' })[1] ~= nil
  end, 5))
  local client = vim.lsp.get_clients({ bufnr = bufnr, name = 'ladder' })[1]
  count(client)
  -- What is asked when a file is opened comes first.
  vim.wait(3000)
  local usual = vim.startswith(name, 'usual')
  local function state()
    return ladder.state(bufnr) or {}
  end
  --- All that was done is in the picture that is shown.
  local function is_shown()
    local session = sessions.of(bufnr)
    return not session.busy and #session.waiting == 0 and session.seen >= session.asked
  end
  local function command(text)
    return function()
      vim.cmd('Ladder ' .. text)
    end
  end
  local function is(status)
    return function()
      return state().status == status and is_shown()
    end
  end
  tell('start, ms', ('%.0f'):format(time_until(command('start'), is('paused'))))
  if usual then
    vim.cmd('Ladder set start 1')
  end
  tell('step, ms', shown(repeated(command('step'), function(time)
    return state().scan == time and is_shown()
  end)))
  tell('back, ms', shown(repeated(command('back'), function(time)
    return state().scan == times - time and is_shown()
  end)))
  vim.cmd('Ladder speed max')
  local function pauses()
    local taken = {}
    for time = 1, times do
      taken[time] = time_until(command('pause'), is('paused'))
      vim.cmd('Ladder run')
      vim.wait(500)
    end
    return shown(taken)
  end
  time_until(command('run'), is('running'))
  local busy, rate = look_at_run()
  tell('pause, ms', pauses())
  vim.cmd('Ladder diagram')
  local busy_with_diagram, rate_with_diagram = look_at_run()
  tell('pause, with the diagram, ms', pauses())
  time_until(command('pause'), is('paused'))
  vim.cmd('Ladder diagram')
  local why = {}
  for time = 1, usual and times or 0 do
    local began = now()
    local tag = 'run' .. tonumber(name:match('%d+')) - 2
    local params = { command = 'ladder.simulate.why', arguments = { { session = sessions.of(bufnr).id, tag = tag } } }
    assert(client:request_sync('workspace/executeCommand', params, 60000, bufnr).result)
    why[time] = now() - began
  end
  tell('why (the answer is here), ms', why[1] and shown(why))
  tell('process busy', busy)
  tell('... with the diagram', busy_with_diagram)
  tell('states shown in a second', rate)
  tell('... with the diagram', rate_with_diagram)
  vim.cmd('Ladder stop')
  vim.cmd('bwipeout!')
  return row
end

function measure(names)
  local done, message = xpcall(function()
    local rows = {}
    for name in names:gmatch('%S+') do
      for index, cells in ipairs(measure_one(name)) do
        rows[index] = rows[index] or { cells[1] }
        table.insert(rows[index], cells[2])
      end
    end
    local lines = {}
    for index, row in ipairs(rows) do
      for column, cell in ipairs(row) do
        row[column] = ('%-' .. (column == 1 and 30 or 14) .. 's'):format(cell)
      end
      table.insert(lines, '| ' .. table.concat(row, ' | ') .. ' |')
      if index == 1 then
        table.insert(lines, (lines[1]:gsub('[^|]', '-')))
      end
    end
    local load = { vim.uv.loadavg() }
    table.insert(lines, '')
    local note = 'Medians of %d, in brackets the longest; load %.1f %.1f %.1f.'
    table.insert(lines, note:format(times, load[1], load[2], load[3]))
    vim.fn.writefile(lines, vim.env.LADDER_SCRATCH .. '/table')
  end, debug.traceback)
  if not done then
    vim.fn.writefile({ message }, vim.env.LADDER_SCRATCH .. '/table')
  end
  vim.cmd('qall!')
end
