-- nvim-dap cannot be installed by these tests. This stands in for it: it takes the same tables, starts the adapter that
-- they name in the same way, and sends the requests that it would send.
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

--- Starts the adapter of a configuration.
function stand_in.start(configuration)
  local session = { seq = 0, received = {}, buffer = '' }
  stand_in.adapters[configuration.type](function(adapter)
    assert(adapter.type == 'executable')
    session.process = vim.system(vim.list_extend({ adapter.command }, adapter.args), {
      cwd = adapter.options.cwd,
      stdin = true,
      stdout = function(_, data)
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
      end,
    })
  end)
  function session.request(command, arguments)
    session.seq = session.seq + 1
    local message = { seq = session.seq, type = 'request', command = command, arguments = arguments }
    local body = vim.json.encode(message)
    session.process:write(('Content-Length: %d\r\n\r\n%s'):format(#body, body))
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

  --- As nvim-dap begins a session.
  local function begin(configuration, breakpoints)
    local session = stand_in.start(configuration)
    answer(session, 'initialize', {
      clientID = 'neovim',
      adapterID = 'nvim-dap',
      pathFormat = 'path',
      columnsStartAt1 = true,
      linesStartAt1 = true,
    })
    answer(session, 'launch', expanded(configuration))
    event(session, 'initialized')
    if breakpoints then
      answer(session, 'setBreakpoints', {
        source = { path = vim.api.nvim_buf_get_name(0) },
        breakpoints = breakpoints,
      })
    end
    answer(session, 'setExceptionBreakpoints', { filters = { 'faults', 'expectations' } })
    answer(session, 'configurationDone')
    return session
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
    answer(session, 'disconnect')
    t.eventually('the adapter to end', function()
      return session.process:is_closing()
    end)
  end)

  t.step('the scenario at the cursor is debugged', function()
    vim.cmd.edit(vim.env.LADDER_FIXTURES .. '/motor.ladder-test')
    vim.cmd('/stop does nothing')
    local session = begin(stand_in.configurations.laddertest[1])
    local stopped = event(session, 'stopped')
    t.equal('why it is', 'exception', stopped.reason)
    assert(stopped.description:find('run is FALSE, expected TRUE in step 3', 1, true), stopped.description)
    answer(session, 'disconnect')
  end)
end
