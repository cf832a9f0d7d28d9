-- A simulation: what has power, values, steps, breakpoints, and changes while it runs.
return function(t, messages)
  local ladder = require('ladder')

  t.step(':Ladder completes subcommands, and tags once a simulation runs', function()
    t.open('motor.clad')
    t.equal('completion', { 'start', 'status', 'step', 'stop' }, vim.fn.getcompletion('Ladder st', 'cmdline'))
    vim.cmd('Ladder start')
    assert(ladder.wait(), 'no answer to the start')
    t.equal('completion of tags', { 'start', 'stop' }, vim.fn.getcompletion('Ladder set st', 'cmdline'))
    t.equal('completion of values', { 'TRUE' }, vim.fn.getcompletion('Ladder set start T', 'cmdline'))
    vim.cmd('Ladder stop')
  end)

  t.step('a start runs and shows the first rung, unless it is to begin paused', function()
    local bufnr = t.open('motor.clad')
    -- Tags that fill the window.
    local declared = { 'VAR' }
    for number = 1, 2 * vim.o.lines do
      table.insert(declared, ('  unused%d : BOOL;'):format(number))
    end
    table.insert(declared, 'END_VAR')
    vim.api.nvim_buf_set_lines(bufnr, 0, 0, false, declared)
    vim.api.nvim_win_set_cursor(0, { 1, 0 })
    vim.cmd.redraw()
    vim.g.ladder_start_paused = nil
    vim.cmd('Ladder start')
    t.eventually('the program to run', function()
      local state = ladder.state()
      return state and state.status == 'running' and state.scan > 0
    end)
    vim.cmd.redraw()
    assert(vim.fn.line('w$') > #declared, 'the first rung is not in sight')
    vim.g.ladder_start_paused = true
    vim.cmd('Ladder start')
    assert(ladder.wait(), 'no answer to the start')
    t.equal('the status', 'paused', ladder.state().status)
    vim.cmd('Ladder stop')
  end)

  t.step('before the first scan nothing but the rail has power', function()
    local bufnr = t.open('motor.clad')
    vim.cmd('Ladder start')
    assert(ladder.wait(), 'no answer to the start')
    local state = assert(ladder.state(), 'no state: ' .. (messages[#messages] or ''))
    t.equal('the status', 'paused', state.status)
    t.equal('the number of scans', 0, state.scan)
    for _, line in ipairs(t.powered(bufnr)) do
      assert(not line:find('(', 1, true), 'a block has power before the first scan: ' .. line)
    end
  end)

  local RAILS = '|' .. (' '):rep(78) .. '|'
  local BRANCHES = '|  |' .. (' '):rep(16) .. '|' .. (' '):rep(58) .. '|'

  t.step('three scans with start high give power to exactly these cells', function()
    local bufnr = t.open('motor.clad')
    vim.cmd('Ladder start')
    vim.cmd('Ladder set start TRUE')
    vim.cmd('Ladder step')
    assert(ladder.wait(), 'no answer to the first step')
    t.equal('the live cells after one scan', {
      '',
      '+--\\--[ ]( start )--\\--[/]( stop )---------------------------------( )( run )--+',
      '',
      '   /--              /',
      '',
      '+--[ ]( run )----------------------------',
    }, t.powered(bufnr))
    vim.cmd('Ladder step 2')
    assert(ladder.wait(), 'no answer to the further steps')
    t.equal('the live cells after three scans', {
      '',
      '+--\\--[ ]( start )--\\--[/]( stop )---------------------------------( )( run )--+',
      '',
      '   /--[ ]( run )----/',
      '',
      '+--[ ]( run )----------------------------[TON]( warmup, T#20ms )--( )( lamp )--+',
    }, t.powered(bufnr))
    t.equal('the dead cells', { '', '', BRANCHES, RAILS, '', '' }, t.highlighted(bufnr, 'LadderPowerOff'))
    t.equal('the number of scans', 3, ladder.state().scan)
  end)

  t.step('hovering over an operand shows its value while the program runs', function()
    local bufnr = t.open('motor.clad')
    vim.cmd('Ladder start')
    vim.cmd('Ladder set start TRUE')
    assert(ladder.wait(), 'no answer')
    vim.cmd('Ladder run')
    t.eventually('a run', function()
      local state = ladder.state()
      return state and state.status == 'running' and state.scan > 5
    end)
    local row, col = 1, 0
    for number, text in ipairs(vim.api.nvim_buf_get_lines(bufnr, 0, -1, false)) do
      local found = text:find('( warmup', 1, true)
      if found then
        row, col = number, found + 2
      end
    end
    vim.api.nvim_win_set_cursor(0, { row, col })
    vim.api.nvim_feedkeys('K', 'x', false)
    local float = t.eventually('the hover window', function()
      return vim.b[bufnr].lsp_floating_preview
    end)
    local text = table.concat(vim.api.nvim_buf_get_lines(vim.api.nvim_win_get_buf(float), 0, -1, false), '\n')
    assert(text:find('warmup%.ET.- is ', 1), 'the window does not tell the value:\n' .. text)
    t.equal('the status', 'running', ladder.state().status)
    vim.api.nvim_win_close(float, true)
    vim.cmd('Ladder stop')
    assert(ladder.wait(), 'no answer')
  end)

  t.step('values are next to their operands, where they can be seen', function()
    local bufnr = t.open('motor.clad')
    vim.cmd('Ladder start')
    vim.cmd('Ladder set start 1')
    vim.cmd('Ladder step 3')
    assert(ladder.wait(), 'no answer')
    t.equal('the drawing', {
      '# Größe: a motor with a seal-in contact, and a lamp when it has warmed up #',
      '+--\\--[ ]( start )--\\--[/]( stop )---------------------------------( )( run )--+',
      '|  |                |                                                          |',
      '|  /--[ ]( run )----/                                                          |',
      '                                                20ms',
      '+--[ ]( run )----------------------------[TON]( warmup, T#20ms )--( )( lamp )--+',
    }, t.seen(bufnr))
    t.equal('the status line', 'paused, scan 3, 30ms', vim.b[bufnr].ladder_status)
    assert(vim.wo.winbar:find('paused, scan 3, 30ms', 1, true), vim.wo.winbar)
  end)

  t.step('the seal-in holds, a forced stop breaks it, a release brings back the input', function()
    local bufnr = t.open('motor.clad')
    for _, command in ipairs({ 'start', 'set start 1', 'step', 'set start 0', 'step' }) do
      vim.cmd('Ladder ' .. command)
    end
    assert(ladder.wait(), 'no answer')
    t.equal('the live cells with the seal-in', {
      '+--\\--              \\--[/]( stop )---------------------------------( )( run )--+',
      '   /--[ ]( run )----/',
    }, { t.powered(bufnr)[2], t.powered(bufnr)[4] })
    vim.cmd('Ladder force stop 1')
    vim.cmd('Ladder step')
    assert(ladder.wait(), 'no answer to force')
    t.equal('the values', 'start=0  stop=1!  run=0', t.values(bufnr, { 'start', 'stop', 'run' }))
    vim.cmd('Ladder unforce stop')
    vim.cmd('Ladder step')
    assert(ladder.wait(), 'no answer to unforce')
    t.equal('the values', 'start=0  stop=0  run=0', t.values(bufnr, { 'start', 'stop', 'run' }))
  end)

  t.step('going back and forward again shows the scans as they were', function()
    local bufnr = t.open('motor.clad')
    for _, command in ipairs({ 'start', 'step', 'set start 1', 'step', 'back' }) do
      vim.cmd('Ladder ' .. command)
    end
    assert(ladder.wait(), 'no answer')
    t.equal('the values', 'start=0  stop=0  run=0', t.values(bufnr, { 'start', 'stop', 'run' }))
    t.equal('the scans', { 1, 1, 1 }, { ladder.state().scan, ladder.state().behind, ladder.state().ahead })
    vim.cmd('Ladder step')
    assert(ladder.wait(), 'no answer')
    t.equal('the values', 'start=1  stop=0  run=1', t.values(bufnr, { 'start', 'stop', 'run' }))
  end)

  t.step('a step by block marks the block that runs next', function()
    local bufnr = t.open('motor.clad')
    local function marked()
      local namespace = vim.api.nvim_get_namespaces().ladder_next
      local mark = vim.api.nvim_buf_get_extmarks(bufnr, namespace, 0, -1, { details = true })[1]
      return mark and vim.api.nvim_buf_get_text(bufnr, mark[2], mark[3], mark[4].end_row, mark[4].end_col, {})[1]
    end
    vim.cmd('Ladder start')
    vim.cmd('Ladder block')
    assert(ladder.wait(), 'no answer')
    t.equal('the marked block', '[ ]( start )', marked())
    vim.cmd('Ladder rung')
    assert(ladder.wait(), 'no answer')
    t.equal('the marked block', '[ ]( run )', marked())
    vim.cmd('Ladder step')
    assert(ladder.wait(), 'no answer')
    t.equal('the marked block', nil, marked())
    t.equal('the number of scans', 1, ladder.state().scan)
  end)

  t.step('a breakpoint has a sign, stops a run and goes again', function()
    local bufnr = t.open('motor.clad')
    local function signs()
      local found = {}
      local namespace = vim.api.nvim_get_namespaces().ladder_breakpoints
      for _, mark in ipairs(vim.api.nvim_buf_get_extmarks(bufnr, namespace, 0, -1, { details = true })) do
        table.insert(found, ('%d %s'):format(mark[2], vim.trim(mark[4].sign_text)))
      end
      return found
    end
    vim.api.nvim_win_set_cursor(0, { 6, 0 })
    vim.cmd('Ladder break')
    t.equal('the signs', { '5 ●' }, signs())
    t.clear(messages)
    vim.cmd('Ladder start')
    vim.cmd('Ladder run')
    t.eventually('the stop', function()
      return messages[1]
    end)
    assert(messages[1]:find('stopped in front of the rung in line 6', 1, true), messages[1])
    t.equal('the status', 'paused', ladder.state().status)
    vim.cmd('Ladder break')
    vim.cmd('Ladder break run')
    vim.cmd('Ladder step')
    vim.cmd('Ladder set start 1')
    t.equal('the signs', {}, signs())
    t.clear(messages)
    vim.cmd('Ladder run')
    t.eventually('the stop', function()
      return messages[1]
    end)
    assert(messages[1]:find('run changed from FALSE to TRUE', 1, true), messages[1])
    -- A notification that comes late repeats a hit that is over.
    local session = require('ladder.session').of(bufnr)
    assert(ladder.wait(), 'no answer')
    local old = vim.deepcopy(session.state)
    t.equal('the number of the hit', 2, old.hit.number)
    old.hit.number, old.hit.message = 1, 'an old hit'
    t.clear(messages)
    require('ladder.simulation').receive(old, session.client.id)
    t.equal('the messages', {}, messages)
  end)

  t.step('why is a list to walk through, and marks what stops the power, also while the program runs', function()
    local bufnr = t.open('motor.clad')
    vim.cmd('Ladder start')
    vim.cmd('Ladder step')
    assert(ladder.wait(), 'no answer')
    local line = vim.api.nvim_buf_get_lines(bufnr, 1, 2, false)[1]
    vim.api.nvim_win_set_cursor(0, { 2, (line:find('( )', 1, true)) })
    vim.cmd('Ladder why')
    assert(ladder.wait(), 'no answer')
    local found = vim.tbl_map(function(item)
      return ('%d:%d %s'):format(item.lnum, item.col, item.text)
    end, vim.fn.getqflist())
    t.equal('the list', {
      '2:68 run is 0 since the start',
      '2:68   ( )( run ) wrote it in line 2',
      '0:0   blocked by',
      '2:7   x [ ]( start ) (line 2, column 7): start is 0',
      '0:0     start is 0 since the start: nothing else was given',
      '0:0   or else by',
      '4:7   x [ ]( run ) (line 4, column 7): run is 0',
    }, found)
    t.equal('the buffer that has the focus', bufnr, vim.api.nvim_get_current_buf())
    local function stops()
      local namespace = vim.api.nvim_get_namespaces().ladder_why
      return vim.tbl_map(function(mark)
        return vim.api.nvim_buf_get_text(bufnr, mark[2], mark[3], mark[4].end_row, mark[4].end_col, {})[1]
      end, vim.api.nvim_buf_get_extmarks(bufnr, namespace, 0, -1, { details = true }))
    end
    t.equal('the marks', { '[ ]( start )', '[ ]( run )' }, stops())
    vim.cmd('cfirst | cnext | cnext')
    t.equal('the cursor', { 2, 6 }, vim.api.nvim_win_get_cursor(0))
    vim.cmd('Ladder step')
    assert(ladder.wait(), 'no answer')
    t.equal('the marks after another scan', {}, stops())
    vim.cmd('cclose | Ladder run')
    vim.fn.setqflist({})
    vim.cmd('Ladder why lamp')
    t.eventually('the list', function()
      return #vim.fn.getqflist() > 0
    end)
    vim.cmd('cclose | Ladder stop')
  end)

  t.step('a warm restart begins again', function()
    t.open('motor.clad')
    vim.cmd('Ladder start')
    vim.cmd('Ladder step 3')
    vim.cmd('Ladder warm')
    assert(ladder.wait(), 'no answer')
    t.equal('the scans', { 0, 0 }, { ladder.state().scan, ladder.state().behind })
  end)

  t.step('a run goes on by itself until it is paused', function()
    t.open('motor.clad')
    vim.cmd('Ladder start')
    vim.cmd('Ladder run')
    assert(ladder.wait(), 'no answer')
    t.eventually('some scans', function()
      return ladder.state().scan > 3
    end)
    vim.cmd('Ladder pause')
    t.eventually('the pause', function()
      return ladder.state().status == 'paused'
    end)
  end)

  t.step('a run is shown while it goes, as fast as was said', function()
    local bufnr = t.open('motor.clad')
    for _, command in ipairs({ 'start', 'set start 1', 'speed 0.02', 'run' }) do
      vim.cmd('Ladder ' .. command)
    end
    local seen = {}
    t.eventually('the timer to run', function()
      seen[t.values(bufnr, { 'warmup.ET' })] = true
      return seen['warmup.ET=10ms'] and seen['warmup.ET=20ms']
    end)
    assert(vim.b[bufnr].ladder_status:find('0.02x speed', 1, true), vim.b[bufnr].ladder_status)
    vim.cmd('Ladder speed max')
    t.eventually('many scans', function()
      return ladder.state().scan > 2000
    end)
    vim.cmd('Ladder stop')
  end)

  t.step('an edit goes on with what runs', function()
    local bufnr = t.open('motor.clad')
    vim.cmd('Ladder start')
    vim.cmd('Ladder set start 1')
    vim.cmd('Ladder step')
    assert(ladder.wait(), 'no answer')
    local before = t.powered(bufnr)
    t.clear(messages)
    vim.api.nvim_buf_set_lines(bufnr, 0, 0, false, { '# new #' })
    local version = vim.api.nvim_buf_get_changedtick(bufnr)
    t.eventually('the new text', function()
      return ladder.state().version >= version and not require('ladder.session').of(bufnr).stale
    end)
    t.eventually('the live cells, a line below', function()
      return vim.deep_equal(before, vim.list_slice(t.powered(bufnr), 2))
    end)
    t.equal('no message', {}, messages)
    vim.cmd('Ladder step')
    assert(ladder.wait(), 'no answer')
    t.equal('the number of scans', 2, ladder.state().scan)
    before = vim.list_slice(t.powered(bufnr), 2)
    -- With errors the last good program runs on.
    vim.api.nvim_buf_set_lines(bufnr, 0, 1, false, { '+--[ ( x )--+' })
    t.eventually('the errors', function()
      return ladder.state().stale
    end)
    assert(ladder.status():find('before the errors', 1, true), 'the status does not tell: ' .. ladder.status())
    t.eventually('the live cells', function()
      return vim.deep_equal(before, vim.list_slice(t.powered(bufnr), 2))
    end)
    vim.cmd('Ladder step')
    assert(ladder.wait(), 'no answer')
    t.equal('the number of scans', 3, ladder.state().scan)
    vim.cmd('Ladder stop')
  end)

  t.step('a change while the program runs takes effect, an error does not, and undo brings all back', function()
    local bufnr = t.open('motor.clad')
    for _, command in ipairs({ 'start', 'set start 1', 'run' }) do
      vim.cmd('Ladder ' .. command)
    end
    local function run_is(value)
      return function()
        local state = ladder.state(bufnr)
        return t.values(bufnr, { 'run' }) == 'run=' .. value and state.status == 'running' and state
      end
    end
    local scan = t.eventually('the motor', run_is(1)).scan
    local text = vim.api.nvim_buf_get_lines(bufnr, 0, -1, false)
    -- The closed contact becomes an open one.
    local at = text[2]:find('[/]( stop', 1, true)
    vim.api.nvim_buf_set_text(bufnr, 1, at, 1, at + 1, { ' ' })
    local changed = t.eventually('no power after the contact', run_is(0))
    assert(changed.scan > scan and not changed.stale, 'it began again')
    vim.cmd('silent undo')
    t.equal('the text', text, vim.api.nvim_buf_get_lines(bufnr, 0, -1, false))
    t.eventually('the motor again', run_is(1))
    vim.api.nvim_buf_set_text(bufnr, 1, at, 1, at + 2, { '' })
    scan = t.eventually('the error', function()
      return ladder.state(bufnr).stale and ladder.state(bufnr)
    end).scan
    t.eventually('more scans of the last good program', function()
      return ladder.state(bufnr).stale and ladder.state(bufnr).scan > scan + 5
    end)
    vim.cmd('silent undo')
    t.eventually('the motor without an error', function()
      local state = run_is(1)()
      return state and not state.stale
    end)
    vim.cmd('Ladder stop | bwipeout!')
  end)

  t.step('a fault is reported at its place and in the bar, also while the program runs', function()
    local bufnr = t.open('motor.clad')
    vim.api.nvim_buf_set_lines(bufnr, 0, -1, false, {
      'VAR_INPUT  go : BOOL;  zero : INT;  END_VAR',
      'VAR  shelf : ARRAY[0..3] OF INT;  place : INT := 9;  quotient, found : INT;  END_VAR',
      '+--[ ]( go )--[DIV]( quotient, 10, zero )--+',
      '+--[ ]( go )--[MOVE]( found, shelf[place] )--+',
    })
    local function faults()
      local found = vim.diagnostic.get(bufnr, { severity = vim.diagnostic.severity.ERROR })
      return vim.tbl_map(function(it)
        return ('%d:%d %s'):format(it.lnum, it.col, it.message:match('^[^:]+'))
      end, found)
    end
    vim.cmd('Ladder start')
    vim.cmd('Ladder step')
    assert(ladder.wait(bufnr), 'no answer')
    t.equal('the faults', {}, faults())
    vim.cmd('Ladder run')
    vim.cmd('Ladder set go 1')
    t.eventually('both faults', function()
      return #faults() == 2
    end)
    t.equal('the faults', { '2:14 division by zero', '3:14 index 9 is outside the array [0..3]' }, faults())
    t.equal('the status', 'running', ladder.state(bufnr).status)
    assert(vim.wo.winbar:find('LadderForced#running, .*, 2 faults'), vim.wo.winbar)
    vim.cmd('Ladder stop')
    t.equal('the faults of a simulation that is over', {}, faults())
    vim.cmd('bwipeout!')
  end)

  t.step('a program with errors is not simulated, and the reason is shown', function()
    t.open('unpaired.clad')
    t.clear(messages)
    vim.cmd('Ladder start')
    t.eventually('a message', function()
      return messages[1]
    end)
    t.equal('the state', nil, ladder.state())
  end)

  t.step('an unknown tag is named', function()
    t.open('motor.clad')
    vim.cmd('Ladder start')
    t.clear(messages)
    vim.cmd('Ladder set strat 1')
    assert(ladder.wait(), 'no answer')
    assert(messages[1] and messages[1]:find('strat', 1, true), 'no message names the tag')
  end)
end
