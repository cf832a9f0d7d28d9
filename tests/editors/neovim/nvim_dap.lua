-- nvim-dap itself drives the adapter, as the plugin sets it up. It runs in a Neovim of its own, since the steps of
-- debugging.lua put something else in its place.
package.path = vim.env.LADDER_ROOT .. '/tests/editors/neovim/?.lua;' .. package.path
local t = require('harness')

local messages = {}
vim.notify = function(message)
  table.insert(messages, message)
end

--- What a person picks from a list: the item of this name.
local pick
vim.ui.select = function(items, options, choose)
  for _, item in ipairs(items) do
    if (options.format_item or tostring)(item) == pick then
      return choose(item)
    end
  end
  error(('there is no %s to be picked'):format(pick), 0)
end

--- What a person answers to a question.
local answer
vim.fn.input = function()
  return answer
end

local stops, looks = {}, 0

--- Does something, and waits until the program is halted and nvim-dap has all that it shows.
--- @return table stopped, string[] stack the names and lines of the frames
local function stops_after(act)
  local dap = require('dap')
  local before = looks
  t.clear(stops)
  act()
  local stopped = t.eventually('the program to stop', function()
    return looks > before and stops[1]
  end)
  local session = dap.session()
  t.eventually('the variables of the scopes', function()
    local scopes = session.current_frame.scopes
    return scopes and vim.iter(scopes):all(function(scope)
      return scope.expensive or scope.variables
    end)
  end)
  local stack = vim.tbl_map(function(frame)
    return ('%s %d'):format(frame.name:match('^[^,]+'), frame.line)
  end, session.threads[session.stopped_thread_id].frames)
  t.equal('the line of the cursor', session.current_frame.line, vim.fn.line('.'))
  return stopped, stack
end

--- The value of an expression where the program is halted.
local function value(expression)
  local found
  require('dap').session():evaluate(expression, function(err, result)
    found = err and tostring(err) or result.result
  end)
  return t.eventually('the value of ' .. expression, function()
    return found
  end)
end

--- The line of the program that has this text.
local function line(part)
  for number, text in ipairs(vim.api.nvim_buf_get_lines(0, 0, -1, false)) do
    if text:find(part, 1, true) then
      return number
    end
  end
  error(part .. ' is not in the program', 0)
end

local function go_to(part)
  vim.api.nvim_win_set_cursor(0, { line(part), 0 })
end

--- Waits until there is something in the console.
local function writes(text)
  t.eventually(('%q in the console'):format(text), function()
    local lines = vim.api.nvim_buf_get_lines(vim.fn.bufnr('dap-repl'), 0, -1, false)
    return table.concat(lines, '\n'):find(text, 1, true)
  end)
end

--- Does something in the console's window.
local function in_console(act)
  local before = vim.api.nvim_get_current_win()
  require('dap.repl').open()
  vim.api.nvim_set_current_win(vim.fn.bufwinid(vim.fn.bufnr('dap-repl')))
  act()
  vim.api.nvim_set_current_win(before)
end

--- Ends the session, and takes the breakpoints away.
local function finish(act)
  local dap = require('dap')
  act()
  t.eventually('the session to end', function()
    return not dap.session()
  end)
  dap.clear_breakpoints()
end

--- Opens a program that has a user-defined block and a function, and its scenarios.
local function open_counter()
  -- One that a step has left behind.
  if require('dap').session() then
    finish(vim.cmd.DapTerminate)
  end
  local file = vim.fs.dirname(vim.api.nvim_buf_get_name(t.open('motor.clad'))) .. '/counter'
  for _, ending in ipairs({ '.clad', '.ladder-test' }) do
    local programs = vim.env.LADDER_ROOT .. '/tests/debug-adapter/programs/counter'
    vim.fn.writefile(vim.fn.readfile(programs .. ending), file .. ending)
  end
  vim.cmd.edit(file .. '.clad')
end

--- Begins a session as `:DapContinue` does, in which the button is pressed from the first scan on.
local function begin(more)
  local dap = require('dap')
  local inputs = vim.tbl_extend('force', { button = true }, more or {})
  return stops_after(function()
    dap.run(vim.tbl_extend('force', dap.configurations.clad[1], { inputs = inputs, speed = 'max' }))
  end)
end

t.step('it is set up where the first ladder file is opened', function()
  t.open('motor.clad')
  local dap = require('dap')
  assert(dap.adapters.ladder, 'there is no adapter')
  dap.listeners.after.event_stopped.test = function(_, body)
    table.insert(stops, body)
  end
  dap.listeners.after.scopes.test = function()
    looks = looks + 1
  end
end)

t.step(':DapContinue runs a program, from before its first scan', function()
  open_counter()
  pick = 'Run this program, from before its first scan'
  local stopped, stack = stops_after(vim.cmd.DapContinue)
  t.equal('why it is', 'entry', stopped.reason)
  t.equal('the stack', { 'main ' .. line('[$Tally]( 1') }, stack)
  finish(vim.cmd.DapTerminate)
end)

t.step('breakpoints have conditions, count their hits, and write', function()
  open_counter()
  local dap = require('dap')
  go_to('[GE]')
  dap.set_breakpoint(nil, '% 3')
  go_to('[TON]( hold')
  dap.set_breakpoint(nil, nil, 'presses are {presses}, twice that {presses * 2}')
  go_to('[DIV]')
  dap.set_breakpoint('SYS.SCAN >= 7 AND button')
  begin()
  t.equal('why it is', 'breakpoint', stops_after(dap.continue).reason)
  t.equal('the scan', '2', value('SYS.SCAN'))
  stops_after(dap.continue)
  t.equal('the scan', '5', value('SYS.SCAN'))
  writes('presses are 1, twice that 2')
  local _, stack = stops_after(dap.continue)
  t.equal('the scan', '7', value('SYS.SCAN'))
  t.equal('the stack', { 'divide ' .. line('[DIV]'), 'main ' .. line('[TON]( hold') }, stack)
  -- One that is set while the program is halted.
  dap.clear_breakpoints()
  go_to('[ADD]( sum')
  dap.set_breakpoint()
  _, stack = stops_after(dap.continue)
  t.equal('the stack', { '$Tally#1 ' .. line('[ADD]( sum'), 'main ' .. line('[$Tally]( 1') }, stack)
  dap.up()
  t.eventually('the cursor to be where the block is called', function()
    return vim.fn.line('.') == line('[$Tally]( 1')
  end)
  finish(vim.cmd.DapTerminate)
end)

t.step('a breakpoint that cannot be is shown so, with words', function()
  open_counter()
  local dap = require('dap')
  go_to('[GE]')
  dap.set_breakpoint('presses >')
  begin()
  local signs = vim.fn.sign_getplaced(vim.api.nvim_get_current_buf(), { group = 'dap_breakpoints' })[1].signs
  t.equal('the sign', 'DapBreakpointRejected', signs[1].name)
  dap.list_breakpoints(false)
  local text = vim.fn.getqflist()[1].text
  assert(text:find('Rejected: a value is missing', 1, true), text)
  finish(vim.cmd.DapTerminate)
end)

t.step('tags are in scopes, and are changed there and in the console', function()
  open_counter()
  local repl = require('dap.repl')
  begin()
  local names = vim.tbl_map(function(scope)
    return scope.name
  end, require('dap').session().current_frame.scopes)
  local wanted = { 'Inputs', 'Outputs', 'Internal', 'Timers and counters', 'Constants', 'Blocks', 'System' }
  t.equal('the scopes', wanted, names)
  in_console(function()
    repl.execute('.scopes')
    writes('presses: 0')
    pick, answer = 'Set expression', '2 * LIMIT'
    go_to('presses: 0')
    require('dap.ui').trigger_actions()
  end)
  t.eventually('the tag to be given a value', function()
    return value('presses') == '6'
  end)
  repl.execute('divisor := 5')
  repl.execute('force button := FALSE')
  writes('FALSE (forced)')
  repl.execute('SUM(marks[1..4]) + presses * divisor')
  writes('\n30')
  repl.execute('presses +')
  writes('a value is missing next to this operator')
  -- The names that go on with what is written.
  local column, items
  vim.fn.complete = function(at, found)
    column, items = at, found
  end
  in_console(function()
    local bufnr = vim.api.nvim_get_current_buf()
    vim.api.nvim_buf_set_lines(bufnr, -2, -1, false, { 'dap> presses > ho' })
    vim.api.nvim_win_set_cursor(0, { vim.api.nvim_buf_line_count(bufnr), #'dap> presses > ho' })
    repl.omnifunc(1, '')
    t.eventually('the names', function()
      return items
    end)
  end)
  local words = vim.tbl_map(function(item)
    return item.word
  end, items)
  t.equal('the names', { 'hold', 'hold.ET', 'hold.IN', 'hold.PT', 'hold.Q' }, words)
  t.equal('where they begin', #'dap> presses > ' + 1, column)
  repl.close()
  finish(vim.cmd.DapTerminate)
end)

t.step('it steps over, into, out and back, and runs to the cursor and back', function()
  open_counter()
  local dap = require('dap')
  begin()
  local call, enough, last = line('[$Tally]( 1'), line('[GE]'), line('[TON]( hold')
  local function steps(act, wanted)
    local _, stack = stops_after(act)
    t.equal('the stack', wanted, stack)
  end
  steps(dap.step_over, { 'main ' .. enough })
  steps(dap.step_over, { 'main ' .. last })
  steps(dap.step_back, { 'main ' .. enough })
  steps(dap.step_back, { 'main ' .. call })
  -- The contact, then the block.
  steps(dap.step_into, { 'main ' .. call })
  steps(dap.step_into, { '$Tally#1 ' .. line('[ADD]( sum'), 'main ' .. call })
  steps(dap.step_out, { 'main ' .. call })
  go_to('( full )--+')
  steps(dap.run_to_cursor, { 'main ' .. enough })
  local stopped = stops_after(dap.reverse_continue)
  t.equal('why it is', 'entry', stopped.reason)
  t.equal('the presses', '0', value('presses'))
  finish(vim.cmd.DapTerminate)
end)

t.step('it is paused while it runs', function()
  open_counter()
  local dap = require('dap')
  begin()
  dap.continue()
  t.eventually('the program to run', function()
    return not dap.session().stopped_thread_id
  end)
  t.equal('why it is', 'pause', stops_after(vim.cmd.DapPause).reason)
  finish(vim.cmd.DapTerminate)
end)

t.step('a fault is shown where it is', function()
  open_counter()
  local dap = require('dap')
  begin({ divisor = 0 })
  local stopped, stack = stops_after(dap.continue)
  t.equal('why it is', 'exception', stopped.reason)
  t.equal('where it is', 'divide ' .. line('[DIV]'), stack[1])
  local shown = t.eventually('the diagnostic', function()
    return vim.diagnostic.get(0, { namespace = dap.session().ns })[1]
  end)
  assert(shown.message:find('division by zero', 1, true), shown.message)
  t.equal('its line', line('[DIV]') - 1, shown.lnum)
  finish(vim.cmd.DapTerminate)
end)

t.step('a restart begins again, with a configuration that has changed', function()
  open_counter()
  local dap = require('dap')
  begin({ divisor = 2 })
  stops_after(dap.step_out)
  t.equal('the presses', '1', value('presses'))
  stops_after(dap.restart)
  t.equal('the presses', '0', value('presses'))
  t.equal('the divisor', '2', value('divisor'))
  -- What is run under the name of the session restarts it.
  begin({ divisor = 3 })
  t.equal('the divisor', '3', value('divisor'))
  finish(vim.cmd.DapTerminate)
end)

t.step('the scenario at the cursor is run', function()
  open_counter()
  local dap = require('dap')
  vim.cmd.edit(vim.fn.expand('%:r') .. '.ladder-test')
  vim.cmd('/two are')
  local stopped, stack = stops_after(vim.cmd.DapContinue)
  t.equal('why it is', 'exception', stopped.reason)
  assert(stopped.text:find('full is FALSE, expected TRUE', 1, true), stopped.text)
  assert(stack[2]:find('scenario "two are not enough" ', 1, true), stack[2])
  -- Another one is run in place of it, and passes.
  vim.cmd.edit(vim.fn.expand('%:r') .. '.ladder-test')
  vim.cmd('/three presses')
  dap.run_last()
  t.eventually('the session to end', function()
    return not dap.session()
  end)
  writes('three presses')
end)

t.step('configurations of a launch.json are offered', function()
  open_counter()
  local folder = vim.fn.expand('%:p:h')
  vim.fn.mkdir(folder .. '/.vscode')
  vim.fn.writefile({
    '{ "configurations": [{',
    '    "type": "ladder", "request": "launch", "name": "Held", "stopOnEntry": true,',
    '    "program": "${workspaceFolder}/counter.clad", "forces": { "button": true }',
    '}] }',
  }, folder .. '/.vscode/launch.json')
  local before = vim.fn.getcwd()
  vim.cmd.cd(folder)
  pick = 'Held'
  stops_after(vim.cmd.DapContinue)
  vim.cmd.cd(before)
  t.equal('the button', 'TRUE (forced)', value('button'))
  finish(vim.cmd.DapTerminate)
end)

t.step('with the session the adapter ends', function()
  open_counter()
  local before = vim.api.nvim_get_proc_children(vim.fn.getpid())
  for _, act in ipairs({ vim.cmd.DapTerminate, vim.cmd.DapDisconnect }) do
    begin()
    local adapter = vim.iter(vim.api.nvim_get_proc_children(vim.fn.getpid())):find(function(process)
      return not vim.list_contains(before, process)
    end)
    assert(adapter, 'there is no adapter')
    finish(act)
    t.eventually('the adapter to end', function()
      return not vim.list_contains(vim.api.nvim_get_proc_children(vim.fn.getpid()), adapter)
    end)
  end
  for _, message in ipairs(messages) do
    assert(not message:find('exited with', 1, true), message)
  end
end)

t.run()
