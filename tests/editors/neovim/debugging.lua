-- nvim-dap cannot be installed everywhere; where it is, nvim_dap.lua uses it. This stands in for it: it takes the same
-- tables, starts the adapter that they name in the same way, and sends the requests that it would send.
local stand_in = { adapters = {}, configurations = {} }

--- What nvim-dap replaces in a configuration before it is sent.
local function expanded(configuration)
  local sent = {}
  for name, value in pairs(configuration) do
    if type(value) == 'function' then
      value = value()
    end
    sent[name] = type(value) == 'string' and value:gsub('%${file}', vim.api.nvim_buf_get_name(0)) or value
  end
  return sent
end

--- Connects to the adapter of a configuration.
function stand_in.start(configuration)
  local session = { seq = 0, received = {}, buffer = '' }
  stand_in.adapters[configuration.type](function(adapter)
    assert(adapter.type == 'pipe')
    local socket = assert(vim.uv.new_pipe(false))
    socket:connect(adapter.pipe, function(err)
      assert(not err, err)
      socket:read_start(function(_, data)
        session.buffer = session.buffer .. (data or '')
        while true do
          local header, body = session.buffer:match('^Content%-Length: (%d+)\r\n\r\n()')
          if not header or #session.buffer < body - 1 + tonumber(header) then
            return
          end
          local stop = body - 1 + tonumber(header)
          table.insert(session.received, vim.json.decode(session.buffer:sub(body, stop)))
          session.buffer = session.buffer:sub(stop + 1)
        end
      end)
      session.socket = socket
    end)
  end, expanded(configuration))
  vim.wait(5000, function()
    return session.socket
  end, 5)
  function session.request(command, arguments)
    session.seq = session.seq + 1
    local message = { seq = session.seq, type = 'request', command = command, arguments = arguments }
    local body = vim.json.encode(message)
    session.socket:write(('Content-Length: %d\r\n\r\n%s'):format(#body, body))
    return session.seq
  end
  function session.find(wanted)
    for index, message in ipairs(session.received) do
      if wanted(message) then
        return table.remove(session.received, index)
      end
    end
  end
  return session
end

return function(t)
  local function answer(session, command, arguments)
    local seq = session.request(command, arguments)
    local found = t.eventually('the answer to ' .. command, function()
      return session.find(function(message)
        return message.type == 'response' and message.request_seq == seq
      end)
    end)
    assert(found.success, found.message)
    return found.body
  end
  local function event(session, name)
    return t.eventually('the event ' .. name, function()
      return session.find(function(message)
        return message.event == name
      end)
    end).body
  end

  --- As nvim-dap ends a session.
  local function finish(session)
    answer(session, 'disconnect')
    session.socket:close()
    t.eventually('the simulation to end', function()
      return vim.iter(require('ladder.session').all()):all(function(it)
        return not it.debugged
      end)
    end)
  end

  --- Its signs in the buffer: each a line, with what `set_breakpoint(condition, hit_condition, log_message)` was given.
  local function place(session, breakpoints)
    local placed = answer(session, 'setBreakpoints', {
      source = { path = vim.api.nvim_buf_get_name(0) },
      breakpoints = breakpoints,
    }).breakpoints
    for _, breakpoint in ipairs(placed) do
      assert(breakpoint.verified, breakpoint.message)
    end
    return placed
  end

  --- As nvim-dap begins a session.
  local function begin(configuration, breakpoints)
    local session = stand_in.start(configuration)
    local capabilities = answer(session, 'initialize', {
      clientID = 'neovim',
      adapterID = 'nvim-dap',
      pathFormat = 'path',
      columnsStartAt1 = true,
      linesStartAt1 = true,
    })
    answer(session, 'launch', expanded(configuration))
    event(session, 'initialized')
    if breakpoints then
      place(session, breakpoints)
    end
    -- Those that the adapter proposes.
    local filters = {}
    for _, filter in ipairs(capabilities.exceptionBreakpointFilters) do
      if filter.default then
        table.insert(filters, filter.filter)
      end
    end
    answer(session, 'setExceptionBreakpoints', { filters = filters })
    answer(session, 'configurationDone')
    return session
  end

  --- Sends what goes on, and waits until the program appears again.
  --- @return table stopped, table[] frames
  local function stops_after(session, command)
    answer(session, command, { threadId = 1 })
    local stopped = event(session, 'stopped')
    return stopped, answer(session, 'stackTrace', { threadId = 1 }).stackFrames
  end

  --- Opens a program of others' tests, which has a user-defined block and a function.
  local function open_counter()
    local bufnr = t.open('motor.clad')
    local file = vim.fs.dirname(vim.api.nvim_buf_get_name(bufnr)) .. '/counter.clad'
    vim.fn.writefile(vim.fn.readfile(vim.env.LADDER_ROOT .. '/tests/debug-adapter/programs/counter.clad'), file)
    vim.cmd.edit(file)
    return function(part)
      for number, text in ipairs(vim.api.nvim_buf_get_lines(0, 0, -1, false)) do
        if text:find(part, 1, true) then
          return number
        end
      end
      error(part .. ' is not in the program', 0)
    end
  end

  --- A session in which the button is pressed from the first scan on.
  local function pressed(breakpoints, more)
    local configuration = vim.tbl_extend('force', stand_in.configurations.clad[1], {
      inputs = vim.tbl_extend('force', { button = true }, more or {}),
      speed = 'max',
    })
    local session = begin(configuration, breakpoints)
    t.equal('why it is', 'entry', event(session, 'stopped').reason)
    return session
  end

  local function value(session, expression)
    return answer(session, 'evaluate', { expression = expression, context = 'repl' }).result
  end

  t.step('without nvim-dap nothing is registered', function()
    t.open('motor.clad')
    t.equal('whether it was registered', false, require('ladder').dap())
  end)

  t.step('nvim-dap gets the adapter and a configuration for programs', function()
    package.preload.dap = function()
      return stand_in
    end
    t.open('motor.clad')
    assert(stand_in.adapters.ladder, 'there is no adapter')
    t.equal('the number of configurations', 2, #stand_in.configurations.clad)
    t.equal('whether it was registered', true, require('ladder').dap())
    t.equal('the number of configurations after another call', 2, #stand_in.configurations.clad)
  end)

  t.step('a program is debugged', function()
    t.open('motor.clad')
    local session = begin(stand_in.configurations.clad[1], { { line = 6 } })
    t.equal('why it is', 'entry', event(session, 'stopped').reason)
    answer(session, 'evaluate', { expression = 'start := TRUE', context = 'repl' })
    answer(session, 'continue', { threadId = 1 })
    t.equal('why it is', 'breakpoint', event(session, 'stopped').reason)
    local frame = answer(session, 'stackTrace', { threadId = 1 }).stackFrames[1]
    t.equal('the line', 6, frame.line)
    t.equal('its file', vim.api.nvim_buf_get_name(0), frame.source.path)
    t.equal('run', 'TRUE', answer(session, 'evaluate', { expression = 'run AND start' }).result)
    finish(session)
  end)

  t.step('stopped at a breakpoint the buffer shows power and values, why answers, and a force holds', function()
    local bufnr = t.open('motor.clad')
    local session = begin(stand_in.configurations.clad[1], { { line = 6 } })
    event(session, 'stopped')
    answer(session, 'evaluate', { expression = 'force start := TRUE', context = 'repl' })
    answer(session, 'continue', { threadId = 1 })
    t.equal('why it is', 'breakpoint', event(session, 'stopped').reason)
    local sessions = require('ladder.session')
    t.eventually('the values of what has run', function()
      local run = sessions.tag(sessions.of(bufnr), 'run')
      return run and run.value == true and sessions.tag(sessions.of(bufnr), 'start').forced
    end)
    t.eventually('power in the drawing', function()
      local power = vim.api.nvim_get_namespaces().ladder_power
      local marks = vim.api.nvim_buf_get_extmarks(bufnr, power, 0, -1, { details = true })
      return vim.iter(marks):any(function(mark)
        return mark[4].hl_group == 'LadderPowerOn'
      end)
    end)
    local why
    require('ladder.simulation').ask(bufnr, 'why', { tag = 'run' }, function(found)
      why = found
    end)
    t.eventually('why', function()
      return why and why.text:find('start', 1, true)
    end)
    -- A command of the buffer is an event for the debugger.
    vim.cmd.Ladder('step')
    t.equal('why it is', 'step', event(session, 'stopped').reason)
    finish(session)
    t.equal('a simulation', nil, sessions.of(bufnr))
  end)

  t.step('a simulation that runs is given a breakpoint, and goes on without the debugger', function()
    local bufnr = t.open('motor.clad')
    local simulation, sessions = require('ladder.simulation'), require('ladder.session')
    simulation.start(bufnr)
    simulation.run(bufnr)
    assert(simulation.wait(bufnr))
    local id = sessions.of(bufnr).id
    local session = begin(stand_in.configurations.clad[1], { { line = 6 } })
    t.equal('why it is', 'breakpoint', event(session, 'stopped').reason)
    t.equal('the session', id, sessions.of(bufnr).id)
    finish(session)
    simulation.run(bufnr)
    assert(simulation.wait(bufnr))
    t.eventually('the simulation to run', function()
      return sessions.of(bufnr).state.status == 'running' and #(sessions.of(bufnr).state.breakpoints or {}) == 0
    end)
    simulation.stop(bufnr)
  end)

  t.step('the scenario at the cursor is debugged', function()
    vim.cmd.edit(vim.env.LADDER_FIXTURES .. '/motor.ladder-test')
    vim.cmd('/stop does nothing')
    local session = begin(stand_in.configurations.laddertest[1])
    local stopped = event(session, 'stopped')
    t.equal('why it is', 'exception', stopped.reason)
    assert(stopped.description:find('run is FALSE, expected TRUE in step 3', 1, true), stopped.description)
    finish(session)
  end)

  t.step('a breakpoint counts its hits, and has a condition', function()
    local line = open_counter()
    local session = pressed({ { line = line('[GE]'), hitCondition = '% 3' } })
    t.equal('why it is', 'breakpoint', stops_after(session, 'continue').reason)
    t.equal('the scan', '2', value(session, 'SYS.SCAN'))
    stops_after(session, 'continue')
    t.equal('the scan', '5', value(session, 'SYS.SCAN'))
    place(session, { { line = line('[GE]'), condition = 'SYS.SCAN >= 20 AND button' } })
    stops_after(session, 'continue')
    t.equal('the scan', '20', value(session, 'SYS.SCAN'))
    finish(session)
  end)

  t.step('a log point writes and does not stop', function()
    local line = open_counter()
    local session = pressed({
      { line = line('[GE]'), logMessage = 'presses are {presses}, twice that {presses * 2}' },
      { line = line('[TON]( hold'), condition = 'SYS.SCAN = 1' },
    })
    stops_after(session, 'continue')
    t.equal('the scan', '1', value(session, 'SYS.SCAN'))
    for _ = 1, 2 do
      local output = event(session, 'output')
      t.equal('what is written', { 'console', 'presses are 1, twice that 2\n' }, { output.category, output.output })
    end
    finish(session)
  end)

  t.step('the stack goes through a user-defined block to its place', function()
    local line = open_counter()
    local session = pressed({ { line = line('[ADD]( sum') } })
    local _, frames = stops_after(session, 'continue')
    local seen = vim.tbl_map(function(frame)
      return ('%s %d'):format(frame.name:match('^[^,]+'), frame.line)
    end, frames)
    t.equal('the stack', { '$Tally#1 ' .. line('[ADD]( sum'), 'main ' .. line('[$Tally]( 1') }, seen)
    t.equal('its file', vim.api.nvim_buf_get_name(0), frames[2].source.path)
    finish(session)
  end)

  t.step('a fault is an exception, with words', function()
    local line = open_counter()
    local session = pressed(nil, { divisor = 0 })
    local stopped, frames = stops_after(session, 'continue')
    t.equal('why it is', 'exception', stopped.reason)
    t.equal('the line', line('[DIV]'), frames[1].line)
    -- nvim-dap shows the first of these, and asks for the other.
    assert(stopped.text:find('division by zero', 1, true), stopped.text)
    local information = answer(session, 'exceptionInfo', { threadId = 1 })
    assert(information.description:find('division by zero', 1, true), vim.inspect(information))
    finish(session)
  end)

  t.step('the program runs to the cursor, and steps back', function()
    local line = open_counter()
    local session = pressed({ { line = line('[ADD]( sum') } })
    -- nvim-dap takes its breakpoints away, sets one where the cursor is, and restores them at the stop.
    place(session, { { line = line('( full )--+') } })
    local _, frames = stops_after(session, 'continue')
    t.equal('the line', line('( full )--+'), frames[1].line)
    t.equal('the presses', '1', value(session, 'presses'))
    _, frames = stops_after(session, 'stepBack')
    t.equal('the line a rung back', line('[$Tally]( 1'), frames[1].line)
    t.equal('the presses', '0', value(session, 'presses'))
    place(session, { { line = line('[ADD]( sum') } })
    _, frames = stops_after(session, 'continue')
    t.equal('the line', line('[ADD]( sum'), frames[1].line)
    local stopped
    stopped, frames = stops_after(session, 'reverseContinue')
    t.equal('why it is', 'entry', stopped.reason)
    finish(session)
  end)
end
