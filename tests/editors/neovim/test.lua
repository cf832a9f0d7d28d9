-- A person's first hour in Neovim, step by step: open, see a mistake, ask, align, simulate.
package.path = vim.env.LADDER_ROOT .. '/tests/editors/neovim/?.lua;' .. package.path
local t = require('harness')
local ladder = require('ladder')

require('units')(t)
require('typed')(t)
require('debugging')(t)
require('missing')(t)

local messages = {}
vim.notify = function(message)
  table.insert(messages, message)
end

t.step('the file type of .clad files is clad and lines are not wrapped', function()
  t.open('motor.clad')
  t.equal('the file type', 'clad', vim.bo.filetype)
  t.equal("'wrap'", false, vim.wo.wrap)
  t.equal("'commentstring'", '# %s #', vim.bo.commentstring)
end)

t.step('the server attaches and finds nothing wrong with a good program', function()
  local bufnr = t.open('motor.clad')
  t.equal(
    'the list of diagnostics',
    {},
    vim.tbl_map(function(found)
      return found.message
    end, vim.diagnostic.get(bufnr))
  )
end)

t.step(':Ladder test lists the scenarios that fail in the quickfix list', function()
  vim.cmd.edit(vim.env.LADDER_FIXTURES .. '/motor.ladder-test')
  t.equal('the file type', 'laddertest', vim.bo.filetype)
  t.equal("'commentstring'", '# %s', vim.bo.commentstring)
  vim.cmd('Ladder test')
  local found = t.eventually('an entry', function()
    return vim.fn.getqflist()[1]
  end)
  t.equal('its line', 10, found.lnum)
  t.equal('its column', 12, found.col)
  t.equal(
    'its text',
    'stop does nothing: run is FALSE in step 3 (at 30ms), TRUE was expected; 3 of 6 steps differ',
    found.text
  )
  t.equal('the message', 'ladder: 1 scenarios passed, 1 failed', messages[#messages])
  local function marks()
    return vim.tbl_map(function(found)
      return ('%d:%d %s'):format(found.lnum + 1, found.col + 1, found.source)
    end, vim.diagnostic.get(0, { namespace = vim.api.nvim_get_namespaces().ladder_test }))
  end
  t.equal('the marks', { '10:12 ladder test' }, marks())
  vim.cmd('cclose')
  vim.cmd('/start runs it')
  vim.cmd('Ladder test nearest')
  t.eventually('the result of that scenario alone', function()
    return messages[#messages] == 'ladder: 1 scenarios passed, 0 failed'
  end)
  t.equal('the marks', {}, marks())
end)

t.step(':Ladder convert shows a program of another system as ladder text', function()
  vim.cmd.edit(vim.env.LADDER_FIXTURES .. '/motor.rung')
  local bufnr = vim.api.nvim_get_current_buf()
  vim.cmd('Ladder convert')
  t.eventually('another buffer', function()
    return vim.api.nvim_get_current_buf() ~= bufnr and vim.bo.filetype == 'clad'
  end)
  local lines = vim.api.nvim_buf_get_lines(0, 0, -1, false)
  t.equal('the last line', '|  /--[ ]( Q0 )--[ ]( M1 )--/                              |', lines[#lines])
  t.equal('its file', '', vim.api.nvim_buf_get_name(0))
  t.equal('the message', 'ladder: 4 translated, 0 approximated, 0 refused', messages[#messages])
  local remark = vim.fn.getqflist()[1]
  t.equal('where the remark is', bufnr, remark.bufnr)
  t.equal('the place of the remark', { 1, 8 }, { remark.lnum, remark.col })
  vim.cmd('cclose | bwipeout!')
end)

t.step(':Ladder convert takes what the buffer shows, and says what is wrong', function()
  vim.cmd.edit(vim.env.LADDER_FIXTURES .. '/motor.rung')
  local bufnr = vim.api.nvim_get_current_buf()
  vim.api.nvim_buf_set_lines(bufnr, 0, 1, false, { 'start open I0.1 end' })
  vim.cmd('Ladder convert')
  t.eventually('a message', function()
    return messages[#messages]:find('motor.rung:1:7', 1, true)
  end)
  vim.cmd('bwipeout!')
end)

t.step(':Ladder convert shows ladder text in another notation', function()
  t.open('motor.clad')
  local bufnr = vim.api.nvim_get_current_buf()
  t.equal('the notations', true, vim.tbl_contains(require('ladder.convert').notations(bufnr), 'textbook'))
  vim.cmd('Ladder convert cplc-draft')
  t.eventually('another buffer', function()
    return vim.api.nvim_get_current_buf() ~= bufnr
  end)
  t.equal('its beginning', 'IN = {', vim.api.nvim_buf_get_lines(0, 0, 1, false)[1]:sub(1, 6))
  vim.cmd('cclose | bwipeout!')
end)

t.step('gcc and gc with a motion toggle comments', function()
  local bufnr = t.open('motor.clad')
  local before = vim.api.nvim_buf_get_lines(bufnr, 0, -1, false)
  vim.api.nvim_feedkeys('Ggcc', 'tx', false)
  t.equal('the last line', '# ' .. before[6]:gsub('T#', '') .. ' #', vim.api.nvim_get_current_line())
  vim.api.nvim_feedkeys('2GgcG', 'tx', false)
  t.equal('the second line', '# ' .. before[2] .. ' #', vim.api.nvim_buf_get_lines(bufnr, 1, 2, false)[1])
  vim.cmd('silent undo | silent undo')
  t.equal('the text', before, vim.api.nvim_buf_get_lines(bufnr, 0, -1, false))
end)

t.step('a connector without a partner gets a diagnostic at its place', function()
  local bufnr = t.open('unpaired.clad')
  local found = t.eventually('the diagnostic', function()
    return vim.diagnostic.get(bufnr)[1]
  end)
  t.equal('its code', 'unpaired-connector', found.code)
  t.equal('its line', 1, found.lnum)
  t.equal('its column', 36, found.col)
  t.equal('its severity', vim.diagnostic.severity.ERROR, found.severity)
end)

t.step('a correction takes the diagnostic away', function()
  local bufnr = t.open('unpaired.clad')
  t.eventually('the diagnostic', function()
    return vim.diagnostic.get(bufnr)[1]
  end)
  vim.api.nvim_buf_set_text(bufnr, 1, 21, 1, 37, {})
  t.eventually('no diagnostics', function()
    return #vim.diagnostic.get(bufnr) == 0
  end)
end)

t.step('what one file shows to another is followed in both', function()
  local main = t.open('calls.clad')
  t.eventually('the diagnostic', function()
    return (vim.diagnostic.get(main)[1] or {}).code == 'unknown-function'
  end)
  local library = vim.fs.dirname(vim.api.nvim_buf_get_name(main)) .. '/library.clad'
  vim.cmd.split(library)
  vim.api.nvim_buf_set_lines(0, 0, -1, false, { '+--<FUN>( count )--[ ]( go )--( )( counted )--+' })
  t.eventually('no diagnostics', function()
    return #vim.diagnostic.get(main) == 0
  end)
  vim.cmd('bwipeout!')
end)

t.step('a mistake in ladder.toml is shown at its place, and other files in TOML are left alone', function()
  local folder = vim.env.LADDER_SCRATCH .. '/settings'
  vim.fn.mkdir(folder)
  vim.fn.writefile({ '[format]', 'with = 120' }, folder .. '/ladder.toml')
  vim.fn.writefile({ '[format]' }, folder .. '/other.toml')
  vim.cmd.edit(folder .. '/other.toml')
  local other = vim.api.nvim_get_current_buf()
  vim.cmd.edit(folder .. '/ladder.toml')
  local bufnr = vim.api.nvim_get_current_buf()
  local found = t.eventually('the diagnostic', function()
    return vim.diagnostic.get(bufnr)[1]
  end)
  t.equal('its place', { 1, 0, 4 }, { found.lnum, found.col, found.end_col })
  t.equal('its message', '`with` is no setting in [format]: did you mean `width`?', found.message)
  vim.api.nvim_buf_set_text(bufnr, 1, 1, 1, 2, { 'id' })
  t.eventually('no diagnostics', function()
    return #vim.diagnostic.get(bufnr) == 0
  end)
  t.equal('the servers of another file', 0, #vim.lsp.get_clients({ bufnr = other, name = 'ladder' }))
  vim.cmd('bwipeout!')
end)

t.step('hovering over a timer explains it', function()
  local bufnr = t.open('motor.clad')
  local row = 5
  local col = vim.api.nvim_buf_get_lines(bufnr, row, row + 1, false)[1]:find('TON') - 1
  vim.api.nvim_win_set_cursor(0, { row + 1, col })
  vim.lsp.buf.hover()
  local float = t.eventually('the hover window', function()
    return vim.b[bufnr].lsp_floating_preview
  end)
  local text = table.concat(vim.api.nvim_buf_get_lines(vim.api.nvim_win_get_buf(float), 0, -1, false), '\n')
  assert(
    text:find('TON', 1, true) and text:lower():find('timer', 1, true),
    'the window does not name the timer:\n' .. text
  )
  vim.api.nvim_win_close(float, true)
end)

t.step('formatting aligns a crooked drawing', function()
  local bufnr = t.open('crooked.clad')
  vim.lsp.buf.format({ name = 'ladder', timeout_ms = 5000 })
  local wanted = vim.fn.readfile(vim.env.LADDER_FIXTURES .. '/motor.clad')
  t.equal('the text', wanted, vim.api.nvim_buf_get_lines(bufnr, 0, -1, false))
end)

t.step(':Ladder completes subcommands, and tags once a simulation runs', function()
  t.open('motor.clad')
  t.equal('completion', { 'start', 'status', 'step', 'stop' }, vim.fn.getcompletion('Ladder st', 'cmdline'))
  vim.cmd('Ladder start')
  assert(ladder.wait(), 'no answer to the start')
  t.equal('completion of tags', { 'start', 'stop' }, vim.fn.getcompletion('Ladder set st', 'cmdline'))
  t.equal('completion of values', { 'TRUE' }, vim.fn.getcompletion('Ladder set start T', 'cmdline'))
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

local RAILS = '|' .. (' '):rep(58) .. '|'
local BRANCHES = '|  |' .. (' '):rep(16) .. '|' .. (' '):rep(38) .. '|'

t.step('three scans with start high give power to exactly these cells', function()
  local bufnr = t.open('motor.clad')
  vim.cmd('Ladder start')
  vim.cmd('Ladder set start TRUE')
  vim.cmd('Ladder step')
  assert(ladder.wait(), 'no answer to the first step')
  t.equal('the live cells after one scan', {
    '',
    '+--\\--[ ]( start )--\\--[/]( stop )-------------( )( run )--+',
    '',
    '   /--              /',
    '',
    '+--[ ]( run )--------',
  }, t.powered(bufnr))
  vim.cmd('Ladder step 2')
  assert(ladder.wait(), 'no answer to the further steps')
  t.equal('the live cells after three scans', {
    '',
    '+--\\--[ ]( start )--\\--[/]( stop )-------------( )( run )--+',
    '',
    '   /--[ ]( run )----/',
    '',
    '+--[ ]( run )--------[TON]( warmup, T#20ms )--( )( lamp )--+',
  }, t.powered(bufnr))
  t.equal('the dead cells', { '', '', BRANCHES, RAILS, '', '' }, t.highlighted(bufnr, 'LadderPowerOff'))
  t.equal('the number of scans', 3, ladder.state().scan)
end)

t.step('values stand beside their operands, where they can be seen', function()
  local bufnr = t.open('motor.clad')
  vim.cmd('Ladder start')
  vim.cmd('Ladder set start 1')
  vim.cmd('Ladder step 3')
  assert(ladder.wait(), 'no answer')
  t.equal('the drawing', {
    '# Größe: a motor with a seal-in contact, and a lamp when it has warmed up #',
    '+--\\--[ ]( start )--\\--[/]( stop )-------------( )( run )--+',
    '|  |                |                                      |',
    '|  /--[ ]( run )----/                                      |',
    '                            20ms',
    '+--[ ]( run )--------[TON]( warmup, T#20ms )--( )( lamp )--+',
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
    '+--\\--              \\--[/]( stop )-------------( )( run )--+',
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
  messages = {}
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
  messages = {}
  vim.cmd('Ladder run')
  t.eventually('the stop', function()
    return messages[1]
  end)
  assert(messages[1]:find('run changed from FALSE to TRUE', 1, true), messages[1])
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
    '2:48 run is 0 since the start',
    '2:48   ( )( run ) wrote it in line 2',
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

t.step('a warm restart begins anew', function()
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

t.step('the tag panel lists the tags and toggles an input', function()
  local bufnr = t.open('motor.clad')
  vim.cmd('Ladder start')
  assert(ladder.wait(), 'no answer')
  vim.cmd('Ladder tags')
  assert(ladder.wait(bufnr), 'no answer')
  t.equal('the file type of the panel', 'ladder_tags', vim.bo.filetype)
  t.equal('the first line', { 'start', 'BOOL', 'input', '0' }, vim.split(vim.api.nvim_get_current_line(), '%s+'))
  vim.api.nvim_win_set_cursor(0, { 1, 0 })
  vim.api.nvim_feedkeys(vim.keycode('<CR>3s'), 'x', false)
  assert(ladder.wait(bufnr), 'no answer')
  t.equal('the first line', { 'start', 'BOOL', 'input', '1' }, vim.split(vim.api.nvim_get_current_line(), '%s+'))
  t.equal('the number of scans', 3, ladder.state(bufnr).scan)
  vim.api.nvim_feedkeys('q', 'x', false)
  t.equal('the buffer in the window', bufnr, vim.api.nvim_get_current_buf())
end)

t.step('the diagram beside the text is live, and its keys work on what the cursor is on', function()
  local bufnr = t.open('motor.clad')
  local text = vim.api.nvim_get_current_win()
  vim.cmd('Ladder diagram')
  local diagram = vim.iter(vim.api.nvim_list_wins()):find(function(window)
    return vim.bo[vim.api.nvim_win_get_buf(window)].filetype == 'ladder_diagram'
  end)
  local drawing = vim.api.nvim_win_get_buf(diagram)
  local function eventually(what, pattern)
    return t.eventually(what, function()
      return vim.iter(ipairs(vim.api.nvim_buf_get_lines(drawing, 0, -1, false))):find(function(_, line)
        return line:find(pattern)
      end)
    end)
  end
  eventually('the drawing at rest', '^├──┬──┤   ├──┬──┤ / ├──')
  vim.cmd('Ladder start')
  vim.cmd('Ladder set start 1')
  vim.cmd('Ladder step 2')
  assert(ladder.wait(), 'no answer')
  eventually('power as weight', '^┝━━┳━━┥━━━┝━━┳━━┥━/━┝━.*━%(━━━%)━━┥$')
  eventually('a value above its operand', '^│ +10ms +│')
  local wire = eventually('a branch', '^│  ┗━━┥━━━┝━━┛')
  local marks = vim.api.nvim_buf_get_extmarks(drawing, -1, { wire - 1, 0 }, { wire - 1, -1 }, { details = true })
  t.equal('the highlight of what has power', true, vim.iter(marks):any(function(mark)
    return mark[4].hl_group == 'LadderPowerOn'
  end))
  -- The cursor of the program is followed, to the block.
  local timer = vim.api.nvim_buf_get_lines(bufnr, 5, 6, false)[1]:find('[TON]', 1, true)
  vim.api.nvim_win_set_cursor(text, { 6, timer })
  vim.api.nvim_exec_autocmds('CursorMoved', { buffer = bufnr })
  local row = vim.api.nvim_win_get_cursor(diagram)[1]
  assert(vim.api.nvim_buf_get_lines(drawing, row - 1, row, false)[1]:find('IN'), 'the cursor is in line ' .. row)
  vim.api.nvim_set_current_win(diagram)
  local function cursor_to(pattern)
    local at = eventually(pattern, pattern)
    local line = vim.api.nvim_buf_get_lines(drawing, at - 1, at, false)[1]
    vim.api.nvim_win_set_cursor(diagram, { at, line:find(pattern) - 1 })
  end
  cursor_to('stop')
  vim.api.nvim_feedkeys(vim.keycode('t<F10>'), 'x', false)
  eventually('a contact that blocks power', '━━┥ / ├──')
  assert(ladder.wait(bufnr), 'no answer')
  t.equal('the input', 'stop=1', t.values(bufnr, { 'stop' }))
  vim.api.nvim_feedkeys('t', 'x', false)
  assert(ladder.wait(bufnr), 'no answer')
  local ask = vim.ui.input
  vim.ui.input = function(_, answer)
    answer('0')
  end
  vim.api.nvim_feedkeys('f', 'x', false)
  eventually('a forced tag', 'stop!')
  vim.ui.input = ask
  vim.api.nvim_feedkeys('u', 'x', false)
  eventually('a tag that is not forced', 'stop ')
  cursor_to('start')
  vim.api.nvim_feedkeys(vim.keycode('t<F10>p<F10>'), 'x', false)
  t.eventually('the end of the pulse', function()
    return ladder.state(bufnr).scan == 5 and ladder.tag('start', bufnr).value == false
  end)
  vim.api.nvim_feedkeys(vim.keycode('<CR>'), 'x', false)
  t.equal('the window', text, vim.api.nvim_get_current_win())
  local at = vim.api.nvim_buf_get_lines(bufnr, 1, 2, false)[1]:find('[ ]( start', 1, true)
  t.equal('the place in the text', { 2, at - 1 }, vim.api.nvim_win_get_cursor(text))
  vim.cmd('Ladder diagram')
  t.equal('the number of windows', 1, #vim.api.nvim_list_wins())
  vim.cmd('Ladder stop')
end)

t.step('of a long program only the networks in sight are drawn', function()
  local bufnr = t.open('motor.clad')
  local rungs = {}
  for number = 1, 10000 do
    rungs[number] = ('+--[ ]( in%d )--( )( out%d )--+'):format(number, number)
  end
  vim.api.nvim_buf_set_lines(bufnr, 0, -1, false, rungs)
  vim.cmd('Ladder start')
  assert(ladder.wait(bufnr, 10000), 'no answer')
  vim.cmd('Ladder diagram')
  vim.api.nvim_win_set_cursor(0, { 7000, 0 })
  vim.cmd('redraw')
  vim.api.nvim_exec_autocmds('WinScrolled', {})
  local drawing = vim.iter(vim.api.nvim_list_bufs()):find(function(buffer)
    return vim.bo[buffer].filetype == 'ladder_diagram'
  end)
  local lines = t.eventually('the networks around line 7000', function()
    local lines = vim.api.nvim_buf_get_lines(drawing, 0, -1, false)
    return table.concat(lines, '\n'):find('in7000 ', 1, true) and lines
  end)
  assert(#lines < 200, #lines .. ' lines are drawn')
  vim.cmd('Ladder diagram')
  vim.cmd('Ladder stop')
  vim.cmd('bwipeout!')
end)

t.step('the trace draws tags over time, and leads to a scan of the past', function()
  local bufnr = t.open('motor.clad')
  vim.cmd('Ladder start')
  vim.cmd('Ladder step 4')
  vim.cmd('Ladder set start 1')
  vim.cmd('Ladder step 16')
  assert(ladder.wait(), 'no answer')
  vim.cmd('Ladder trace')
  local function line(name)
    return vim.iter(vim.api.nvim_buf_get_lines(0, 0, -1, false)):find(function(text)
      return vim.startswith(text, name)
    end)
  end
  local function eventually(what, pattern)
    return t.eventually(what, function()
      return vim.iter(vim.api.nvim_buf_get_lines(0, 0, -1, false)):find(function(text)
        return text:find(pattern)
      end)
    end)
  end
  t.equal('the file type', 'ladder_trace', vim.bo.filetype)
  eventually('inputs and outputs', '^lamp ')
  vim.api.nvim_feedkeys('=', 'x', false)
  eventually('the edge', '^start .*▁▁╱▔▔▔▔.* 1$')
  vim.cmd('Ladder trace warmup.ET')
  eventually('the timer', '^warmup.ET .*▁.*20ms$')
  -- Two cursors: five columns apart.
  vim.api.nvim_feedkeys('0vlllll', 'x', false)
  eventually('the readings', '^start .* 1 +0 +1$')
  eventually('the difference', '^warmup.ET .* %+%d+ms$')
  assert(vim.wo.winbar:find('A 10ms  B %d+ms  B%-A %+%d+ms'), vim.wo.winbar)
  -- The cursor that is not active stays.
  vim.api.nvim_feedkeys('o$', 'x', false)
  t.eventually('the cursor at the end', function()
    return vim.wo.winbar:find('A 200ms', 1, true)
  end)
  vim.api.nvim_feedkeys(vim.keycode('<Esc>'), 'x', false)
  vim.api.nvim_feedkeys('0lll', 'x', false)
  vim.api.nvim_feedkeys(vim.keycode('<CR>'), 'x', false)
  t.eventually('a scan of the past', function()
    return ladder.state(bufnr).scan == 4 and ladder.state(bufnr).ahead == 16
  end)
  t.eventually('the program as it was then', function()
    return ladder.tag('start', bufnr).value == false
  end)
  eventually('what the input held then', '^start .* 0 +0$')
  vim.api.nvim_win_set_cursor(0, { 2, 0 })
  vim.api.nvim_feedkeys('n', 'x', false)
  t.eventually('the next change of the tag in the line', function()
    return vim.wo.winbar:find('A 50ms', 1, true)
  end)
  vim.api.nvim_feedkeys('d', 'x', false)
  t.eventually('the tag to be gone', function()
    return not line('start')
  end)
  vim.api.nvim_feedkeys('q', 'x', false)
  t.equal('the buffer in the window', bufnr, vim.api.nvim_get_current_buf())
  vim.cmd('Ladder stop')
end)

t.step('the tags of the trace are there again when the editor is', function()
  local bufnr = t.open('motor.clad')
  vim.cmd('Ladder start')
  vim.cmd('Ladder trace warmup.ET')
  t.eventually('the timer', function()
    return vim.iter(vim.api.nvim_buf_get_lines(0, 0, -1, false)):find(function(text)
      return vim.startswith(text, 'warmup.ET')
    end)
  end)
  vim.api.nvim_feedkeys('q', 'x', false)
  vim.cmd('Ladder stop')
  local init = vim.fs.joinpath(vim.env.LADDER_ROOT, 'tests/editors/neovim/init.lua')
  local look = "lua io.write(table.concat(require('ladder.trace.chosen').of(0) or {}, ' '))"
  local file = vim.api.nvim_buf_get_name(bufnr)
  local again = vim.system({ vim.v.progpath, '--headless', '--clean', '-u', init, file, '-c', look, '-c', 'qa!' }):wait(10000)
  assert(again.stdout:find('warmup.ET', 1, true), again.stdout .. again.stderr)
end)

t.step('a key toggles the contact under the cursor, wherever on it the cursor is', function()
  local bufnr = t.open('motor.clad')
  vim.cmd('Ladder start')
  assert(ladder.wait(), 'no answer')
  local line = vim.api.nvim_buf_get_lines(bufnr, 1, 2, false)[1]
  for _, place in ipairs({ '[ ]( start', ']( start', 'rt )', ' )--\\--[/]' }) do
    local before = t.values(bufnr, { 'start' })
    vim.api.nvim_win_set_cursor(0, { 2, line:find(place, 1, true) - 1 })
    vim.api.nvim_feedkeys(vim.keycode('<F4>'), 'x', false)
    assert(ladder.wait(), 'no answer')
    t.equal('the value at ' .. place, before == 'start=0' and 'start=1' or 'start=0', t.values(bufnr, { 'start' }))
  end
  local timer = vim.api.nvim_buf_get_lines(bufnr, 5, 6, false)[1]:find('[TON]', 1, true)
  vim.api.nvim_win_set_cursor(0, { 6, timer })
  t.equal('the tag on a bracket', 'warmup.ET', require('ladder.operands').tag_here(require('ladder.session').of(bufnr)))
  vim.api.nvim_feedkeys(vim.keycode('<F10><F10><F8>'), 'x', false)
  assert(ladder.wait(), 'no answer')
  t.equal('the scans', 1, ladder.state().scan)
  vim.cmd('Ladder stop')
  t.equal('the mapping', '', vim.fn.mapcheck('<F10>', 'n'))
  t.equal('the bar', '', vim.wo.winbar)
end)

t.step('what is forced is marked at its contact, and a constant cannot be forced', function()
  local bufnr = t.open('motor.clad')
  for _, command in ipairs({ 'start', 'force stop on', 'step' }) do
    vim.cmd('Ladder ' .. command)
  end
  assert(ladder.wait(), 'no answer')
  t.equal('the line below', '|  |                |       ^1!', t.seen(bufnr)[3]:sub(1, 31))
  t.equal('the status', 'paused, scan 1, 10ms, 1 forced', vim.b[bufnr].ladder_status)
end)

t.step('contacts that let power through, and contacts that do not, are two things', function()
  local bufnr = t.open('motor.clad')
  vim.cmd('Ladder start')
  vim.cmd('Ladder step')
  assert(ladder.wait(), 'no answer')
  local function block(group)
    return vim.trim(t.highlighted(bufnr, group)[2])
  end
  t.equal('closed, without power', '[/]( stop )', block('LadderClosed'))
  t.equal('blocks', '[ ]( start )', block('LadderBlocks'))
  for group, attribute in pairs({ LadderClosed = 'underline', LadderClosedOn = 'underline', LadderPowerOn = 'bold' }) do
    assert(vim.api.nvim_get_hl(0, { name = group, link = false })[attribute], group .. ' is not ' .. attribute)
  end
  assert(vim.api.nvim_get_hl(0, { name = 'LadderNext', link = false }).reverse, 'what runs next can be overlooked')
end)

t.step('what has no power can be read on the default scheme, dark and light', function()
  local function luminance(colour)
    local sum = 0
    for shift, weight in pairs({ [16] = 0.2126, [8] = 0.7152, [0] = 0.0722 }) do
      local part = bit.band(bit.rshift(colour, shift), 255) / 255
      sum = sum + weight * (part <= 0.03928 and part / 12.92 or ((part + 0.055) / 1.055) ^ 2.4)
    end
    return sum
  end
  for _, background in ipairs({ 'light', 'dark' }) do
    vim.o.background = background
    -- While Neovim starts, as it does here, it does not say so itself.
    vim.api.nvim_exec_autocmds('OptionSet', { pattern = 'background' })
    local behind = luminance(vim.api.nvim_get_hl(0, { name = 'Normal' }).bg)
    for _, group in ipairs({ 'LadderPowerOff', 'LadderBlocks', 'LadderValue', 'LadderPowerOn' }) do
      local front = luminance(vim.api.nvim_get_hl(0, { name = group, link = false }).fg)
      local contrast = (math.max(front, behind) + 0.05) / (math.min(front, behind) + 0.05)
      assert(contrast >= 4.5, ('%s has a contrast of %.1f on %s'):format(group, contrast, background))
    end
  end
end)

t.step('of a long program only what the window shows is told and drawn', function()
  local lines = {}
  for rung = 1, 10000 do
    lines[rung] = ('+--[ ]( a%d )--[/]( b%d )--( )( c%d )--+'):format(rung, rung, rung)
  end
  vim.cmd.edit(vim.env.LADDER_SCRATCH .. '/long.clad')
  local bufnr = vim.api.nvim_get_current_buf()
  vim.api.nvim_buf_set_lines(bufnr, 0, -1, false, lines)
  t.eventually('the server', function()
    return vim.lsp.get_clients({ bufnr = bufnr, name = 'ladder' })[1]
  end)
  vim.cmd('Ladder start')
  assert(ladder.wait(bufnr, 20000), 'no answer')
  local function rows()
    local namespace = vim.api.nvim_get_namespaces().ladder_power
    local marks = vim.api.nvim_buf_get_extmarks(bufnr, namespace, 0, -1, {})
    return marks[1] and marks[1][2] + 1 or 0, marks[1] and marks[#marks][2] + 1, #marks
  end
  local first, last, marks = rows()
  t.equal('the first line', 1, first)
  assert(last < 100 and marks < 1000, ('%d marks up to line %d'):format(marks, last))
  vim.api.nvim_win_set_cursor(0, { 5000, 0 })
  vim.cmd('normal! zt')
  vim.cmd('doautocmd WinScrolled')
  t.eventually('the lines around the cursor', function()
    first = rows()
    return first > 4900
  end)
  assert(ladder.wait(bufnr, 20000), 'no answer')
  vim.cmd('Ladder toggle a5000')
  vim.cmd('Ladder step')
  assert(ladder.wait(bufnr, 20000), 'no answer')
  t.equal('the values', 'a5000=1  c5000=1', t.values(bufnr, { 'a5000', 'c5000' }))
  vim.cmd('Ladder stop | bwipeout!')
end)

t.step('a run is shown while it goes, as fast as was said', function()
  local bufnr = t.open('motor.clad')
  for _, command in ipairs({ 'start', 'set start 1', 'speed 0.1', 'run' }) do
    vim.cmd('Ladder ' .. command)
  end
  local seen = {}
  t.eventually('the timer to run', function()
    seen[t.values(bufnr, { 'warmup.ET' })] = true
    return seen['warmup.ET=10ms'] and seen['warmup.ET=20ms']
  end)
  assert(vim.b[bufnr].ladder_status:find('0.1x speed', 1, true), vim.b[bufnr].ladder_status)
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
  messages = {}
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

t.step('what was done becomes a scenario in a new buffer', function()
  t.open('motor.clad')
  vim.cmd('Ladder start')
  vim.cmd('Ladder set start 1')
  vim.cmd('Ladder step 2')
  vim.cmd('Ladder record it starts')
  t.eventually('the scenario', function()
    return vim.api.nvim_buf_get_name(0):find('motor%-recorded%.ladder%-test$')
  end)
  local lines = table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, false), '\n')
  assert(lines:find('program motor.clad', 1, true) and lines:find('scenario "it starts"', 1, true), lines)
  assert(lines:find('start +%-') and lines:find('run +=> %-'), lines)
  vim.cmd('bwipeout!')
  vim.cmd('Ladder stop')
end)

t.step('a program with errors is not simulated, and the reason is told', function()
  t.open('unpaired.clad')
  messages = {}
  vim.cmd('Ladder start')
  t.eventually('a message', function()
    return messages[1]
  end)
  t.equal('the state', nil, ladder.state())
end)

t.step('an unknown tag is named', function()
  t.open('motor.clad')
  vim.cmd('Ladder start')
  messages = {}
  vim.cmd('Ladder set strat 1')
  assert(ladder.wait(), 'no answer')
  assert(messages[1] and messages[1]:find('strat', 1, true), 'no message names the tag')
end)

t.step('completion proposes tags of the right type', function()
  local bufnr = t.open('motor.clad')
  local count = vim.api.nvim_buf_line_count(bufnr)
  vim.api.nvim_buf_set_lines(bufnr, count, -1, false, { '+--[TO' })
  vim.api.nvim_win_set_cursor(0, { count + 1, 6 })
  local client = require('ladder.server').of(bufnr)
  local params = vim.lsp.util.make_position_params(0, client.offset_encoding)
  local answer = client:request_sync('textDocument/completion', params, 2000, bufnr)
  local items = vim.lsp.completion._lsp_to_complete_items(answer.result, '[TO', client.id)
  local timer = vim.iter(items):find(function(item)
    return item.abbr == '[TON]'
  end)
  assert(timer, vim.inspect(vim.tbl_map(function(item)
    return item.abbr
  end, items)))
  t.equal('the word that stands for it while it is chosen', '[TON]', timer.word)
end)

t.step('lenses start simulations and count jumps', function()
  local bufnr = t.open('motor.clad')
  vim.api.nvim_buf_set_lines(bufnr, -1, -1, false, { '+--<JMP>( out )--+', '+--<LBL>( out )--+' })
  local client = require('ladder.server').of(bufnr)
  local lenses = client:request_sync('textDocument/codeLens', {
    textDocument = vim.lsp.util.make_text_document_params(bufnr),
  }, 2000, bufnr).result
  local titles = {}
  for _, lens in ipairs(lenses) do
    if not lens.command then
      lens = client:request_sync('codeLens/resolve', lens, 2000, bufnr).result
      client:exec_cmd(lens.command, { bufnr = bufnr })
    end
    table.insert(titles, lens.command.title)
  end
  t.equal('the lenses', { 'Start simulation', '1 jump' }, titles)
  t.equal('the places in the quickfix list', 1, #vim.fn.getqflist())
  vim.cmd('cclose')
  client:exec_cmd(lenses[1].command, { bufnr = bufnr })
  assert(ladder.wait(bufnr), 'no answer')
  t.equal('the status', 'paused', ladder.state(bufnr).status)
  vim.cmd('Ladder stop')
end)

t.step('rename changes every place and draws the networks again', function()
  local bufnr = t.open('motor.clad')
  vim.fn.cursor(6, 9)
  vim.lsp.buf.rename('motor_is_running')
  local lines = t.eventually('the new name', function()
    local lines = vim.api.nvim_buf_get_lines(bufnr, 0, -1, false)
    return lines[2]:find('motor_is_running', 1, true) and lines
  end)
  t.equal('the drawing', {
    '+--\\--[ ]( start )-------------\\--[/]( stop )---------( )( motor_is_running )--+',
  }, { lines[2] })
end)

t.step('a Python file is nobody else\'s until :LadderClick says that it is a Click program', function()
  local copy = vim.env.LADDER_SCRATCH .. '/tank.py'
  vim.fn.writefile(vim.fn.readfile(vim.env.LADDER_FIXTURES .. '/tank.py'), copy)
  vim.cmd.edit(copy)
  local bufnr = vim.api.nvim_get_current_buf()
  t.equal('the file type', 'python', vim.bo.filetype)
  t.equal('the servers', 0, #vim.lsp.get_clients({ bufnr = bufnr }))
  vim.cmd('LadderClick')
  local client = t.eventually('the language server to attach', function()
    return vim.lsp.get_clients({ bufnr = bufnr, name = 'ladder' })[1]
  end)
  t.equal("'commentstring'", '# %s', vim.bo.commentstring)
  vim.api.nvim_buf_set_lines(bufnr, 3, 4, false, { '        out(y.Valve or y.Lamp)' })
  local function broken()
    return vim.tbl_filter(function(found)
      return found.code == 'bad-program'
    end, vim.diagnostic.get(bufnr))[1]
  end
  local found = t.eventually('the diagnostic', broken)
  t.equal('its place', { 3, 12 }, { found.lnum, found.col })
  vim.cmd('Ladder preview')
  t.eventually('the reason why there is no diagram', function()
    return messages[#messages]:find('tank.py:4:13', 1, true)
  end)
  vim.api.nvim_buf_set_lines(bufnr, 3, 4, false, { '        out(y.Valve)' })
  t.eventually('no such diagnostic', function()
    return not broken()
  end)
  local params = { textDocument = { uri = vim.uri_from_bufnr(bufnr) }, position = { line = 3, character = 9 } }
  local hover = client:request_sync('textDocument/hover', params, 5000, bufnr)
  assert(hover.result.contents.value:find('[LT]( Level, Limit )', 1, true), hover.result.contents.value)
end)

t.step('the diagram of a Click program stands beside it, and follows what is typed', function()
  local program = vim.fn.bufnr(vim.env.LADDER_SCRATCH .. '/tank.py')
  vim.cmd.buffer(program)
  local click = require('ladder.click')
  vim.cmd('Ladder preview')
  local drawing = t.eventually('the diagram', function()
    return click.drawing(program)
  end)
  t.equal('the current buffer', program, vim.api.nvim_get_current_buf())
  t.equal('its windows', 1, #vim.fn.win_findbuf(drawing))
  t.equal('its file type', 'clad', vim.bo[drawing].filetype)
  t.equal('whether it is edited', false, vim.bo[drawing].modifiable)
  local function rung(name)
    return vim.tbl_filter(function(line)
      return vim.startswith(line, '+--') and line:find(name, 1, true)
    end, vim.api.nvim_buf_get_lines(drawing, 0, -1, false))[1]
  end
  t.equal('a rung', '+--[/]( Start )-------------------------------( )( Lamp )--+', rung('Lamp'))
  vim.api.nvim_buf_set_lines(program, 6, 7, false, { '        out(y.Idle)' })
  t.eventually('the other coil', function()
    return rung('Idle')
  end)
  vim.cmd('Ladder preview')
  t.equal('the same diagram', drawing, click.drawing(program))
end)

t.step('the simulation of a Click program shows the power in its diagram', function()
  local program = vim.fn.bufnr(vim.env.LADDER_SCRATCH .. '/tank.py')
  local drawing = require('ladder.click').drawing(program)
  vim.cmd('Ladder start')
  t.eventually('a simulation', function()
    return ladder.state(drawing)
  end)
  vim.cmd('Ladder set Limit 5')
  vim.cmd('Ladder set Start 1')
  vim.cmd('Ladder step')
  assert(ladder.wait(drawing), 'no answer')
  local powered = table.concat(t.powered(drawing), '\n')
  assert(powered:find('( )( Valve )', 1, true), powered)
  assert(not powered:find('( )( Idle )', 1, true), powered)
  t.equal('the status', true, vim.startswith(ladder.status(drawing), 'paused'))
  -- What is typed changes the diagram, and the simulation goes on with it.
  vim.api.nvim_buf_set_lines(program, 6, 7, false, { '        out(y.Lamp)' })
  t.eventually('the new coil', function()
    local state = ladder.state(drawing)
    return state.change and require('ladder.session').tag(require('ladder.session').of(drawing), 'Lamp')
  end)
  vim.cmd('Ladder stop')
  vim.cmd('only | bwipeout!')
end)

t.step('the outline names networks by the comments above them', function()
  t.open('motor.clad')
  vim.lsp.buf.document_symbol({
    on_list = function(list)
      vim.b.outline = vim.tbl_map(function(item)
        return item.text
      end, list.items)
    end,
  })
  local outline = t.eventually('the outline', function()
    return vim.b.outline
  end)
  t.equal('the outline', {
    '[Object] Größe: a motor with a seal-in contact, and a lamp when it has warmed up',
    '[Object] Network 2',
  }, outline)
end)

t.step(':checkhealth ladder finds the server', function()
  t.open('motor.clad')
  vim.cmd('silent checkhealth ladder')
  local report = table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, false), '\n')
  assert(report:find('Language server: ladder', 1, true), report)
  assert(not report:find('ERROR', 1, true), report)
  vim.cmd('bwipeout')
end)

t.run()
