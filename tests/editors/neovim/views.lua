-- The tags, the diagram and the trace next to the program.

--- The buffer of the diagram that is shown, and its window.
local function diagram()
  local window = vim.iter(vim.api.nvim_list_wins()):find(function(window)
    return vim.bo[vim.api.nvim_win_get_buf(window)].filetype == 'ladder_diagram'
  end)
  return vim.api.nvim_win_get_buf(window), window
end

--- The row of a buffer that has a pattern in it, as soon as there is one.
local function row_with(t, bufnr, pattern, what)
  return t.eventually(what or pattern, function()
    return vim.iter(ipairs(vim.api.nvim_buf_get_lines(bufnr, 0, -1, false))):find(function(_, line)
      return line:find(pattern)
    end)
  end)
end

return function(t)
  local ladder = require('ladder')

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
    local input = vim.ui.input
    local function filter(wanted)
      vim.ui.input = function(_, done)
        done(wanted)
      end
      vim.api.nvim_feedkeys('F', 'x', false)
      vim.ui.input = input
      return vim.tbl_map(function(line)
        return line:match('^%S+')
      end, vim.api.nvim_buf_get_lines(0, 0, -1, false))
    end
    t.equal('the tags that hold it', { 'run' }, filter('RU'))
    assert(#filter('') > 3, 'all tags are shown again')
    vim.api.nvim_win_set_cursor(0, { 1, 0 })
    vim.api.nvim_feedkeys('q', 'x', false)
    t.equal('the buffer in the window', bufnr, vim.api.nvim_get_current_buf())
  end)

  t.step('what is watched comes first in the tag panel, and is still watched after the next start', function()
    local bufnr = t.open('motor.clad')
    local function rows()
      return vim.tbl_map(function(line)
        return line:match('^%*? ?%S+')
      end, vim.api.nvim_buf_get_lines(0, 0, -1, false))
    end
    for _, first in ipairs({ 'start', '* run' }) do
      vim.cmd('Ladder start')
      assert(ladder.wait(bufnr), 'no answer')
      vim.cmd('Ladder tags')
      t.eventually(first .. ' in the first line', function()
        return rows()[1] == first
      end)
      vim.fn.search('^run')
      vim.api.nvim_feedkeys('*', 'x', false)
      t.eventually('run to be watched, or not any more', function()
        return rows()[1] == (first == 'start' and '* run' or 'start')
      end)
      vim.api.nvim_feedkeys('q', 'x', false)
      vim.cmd('Ladder stop')
    end
  end)

  t.step('the values of tags are after their declarations', function()
    local bufnr = t.open('pumps.clad')
    vim.cmd('Ladder start')
    assert(ladder.wait(bufnr), 'no answer')
    vim.cmd('Ladder set run 1')
    assert(ladder.wait(bufnr), 'no answer')
    local declared = t.eventually('the value of run', function()
      for _, line in ipairs(t.seen(bufnr)) do
        if line:find('run', 1, true) and line:find(';', 1, true) then
          return line
        end
      end
    end)
    t.equal('what is after the declaration', '1', declared:match('(%S+)$'))
    vim.cmd('Ladder stop')
  end)

  t.step('the tag panel takes the focus while the program runs, and its keys do not change the program', function()
    local bufnr = t.open('motor.clad')
    local text = vim.api.nvim_buf_get_lines(bufnr, 0, -1, false)
    vim.cmd('Ladder start')
    vim.cmd('Ladder speed 10')
    vim.cmd('Ladder run')
    assert(ladder.wait(bufnr), 'no answer')
    vim.cmd('Ladder tags')
    t.equal('the file type where the cursor is', 'ladder_tags', vim.bo.filetype)
    local function row(pattern)
      return t.eventually(pattern, function()
        local found
        for line, shown in ipairs(vim.api.nvim_buf_get_lines(0, 0, -1, false)) do
          found = found or shown:find(pattern) and line
        end
        return found
      end)
    end
    vim.api.nvim_win_set_cursor(0, { row('^start +BOOL +input +0$'), 0 })
    vim.api.nvim_feedkeys(vim.keycode('<CR>'), 'x', false)
    row('^start +BOOL +input +1$')
    row('^lamp +BOOL +output +1$')
    -- Keys that the panel has no use for, and that would change a text.
    vim.cmd('silent! normal xddiA')
    t.equal('the program', text, vim.api.nvim_buf_get_lines(bufnr, 0, -1, false))
    t.equal('the status', 'running', ladder.state(bufnr).status)
    vim.api.nvim_feedkeys('q', 'x', false)
    t.equal('the buffer in the window', bufnr, vim.api.nvim_get_current_buf())
    vim.cmd('Ladder stop')
  end)

  t.step('the diagram next to the text is live, and its keys work on what the cursor is on', function()
    local bufnr = t.open('motor.clad')
    local text = vim.api.nvim_get_current_win()
    vim.cmd('Ladder diagram')
    local drawing, window = diagram()
    local function eventually(what, pattern)
      return row_with(t, drawing, pattern, what)
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
    local row = vim.api.nvim_win_get_cursor(window)[1]
    assert(vim.api.nvim_buf_get_lines(drawing, row - 1, row, false)[1]:find('IN'), 'the cursor is in line ' .. row)
    vim.api.nvim_set_current_win(window)
    local function cursor_to(pattern)
      local at = eventually(pattern, pattern)
      local line = vim.api.nvim_buf_get_lines(drawing, at - 1, at, false)[1]
      vim.api.nvim_win_set_cursor(window, { at, line:find(pattern) - 1 })
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
    for _, lines in ipairs({ { 1 }, {} }) do
      vim.api.nvim_feedkeys(vim.keycode('<F9>'), 'x', false)
      t.equal('the lines with a breakpoint', lines, require('ladder.breakpoints').lines(bufnr))
    end
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

  t.step('the cursor of the diagram stays on its contact when the power changes', function()
    local bufnr = t.open('motor.clad')
    vim.cmd('Ladder start')
    vim.cmd('Ladder diagram')
    local drawing, window = diagram()
    local function rung(pattern)
      return row_with(t, drawing, pattern)
    end
    local function under_cursor()
      local row, at = unpack(vim.api.nvim_win_get_cursor(window))
      return vim.api.nvim_buf_get_lines(drawing, row - 1, row, false)[1]:sub(at + 1, at + 1)
    end
    local row = rung('^├.*/')
    local line = vim.api.nvim_buf_get_lines(drawing, row - 1, row, false)[1]
    local at = line:find('/', 1, true)
    vim.api.nvim_set_current_win(window)
    vim.api.nvim_win_set_cursor(window, { row, at - 1 })
    t.equal('what the cursor is on', '/', under_cursor())
    vim.cmd('Ladder set start 1')
    vim.cmd('Ladder step')
    -- A heavy line is written with more bytes than a blank.
    rung('^┝.*━/━┝')
    t.equal('what the cursor is on', '/', under_cursor())
    vim.api.nvim_feedkeys('q', 'x', false)
    t.equal('the buffer in the window', bufnr, vim.api.nvim_get_current_buf())
    vim.cmd('Ladder stop | bwipeout!')
  end)

  t.step('a number is set in the diagram, and is above its operand', function()
    local bufnr = t.open('motor.clad')
    vim.api.nvim_buf_set_lines(bufnr, 0, -1, false, {
      'VAR_INPUT  level : INT;  END_VAR',
      '+--[GT]( level, 50 )--( )( high )--+',
    })
    vim.cmd('Ladder start')
    assert(ladder.wait(bufnr), 'no answer')
    vim.cmd('Ladder diagram')
    local drawing, window = diagram()
    local function row_of(text)
      return row_with(t, drawing, vim.pesc(text))
    end
    local row = row_of('level')
    vim.api.nvim_set_current_win(window)
    local line = vim.api.nvim_buf_get_lines(drawing, row - 1, row, false)[1]
    local at = line:find('level', 1, true)
    vim.api.nvim_win_set_cursor(window, { row, at })
    local ask = vim.ui.input
    vim.ui.input = function(_, answer)
      answer('60')
    end
    vim.api.nvim_feedkeys('c', 'x', false)
    t.equal('the line of the value', row_of('level') - 1, row_of('60'))
    vim.ui.input = ask
    vim.api.nvim_feedkeys(vim.keycode('<F10>'), 'x', false)
    t.eventually('the power after it', function()
      return t.values(bufnr, { 'high' }) == 'high=1'
    end)
    vim.api.nvim_feedkeys('q', 'x', false)
    vim.cmd('Ladder stop | bwipeout!')
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
    local drawing = diagram()
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
    -- Half of it, and all of it again.
    local function last_time()
      local axis = vim.api.nvim_buf_get_lines(0, 0, 1, false)[1]
      local first = axis:match('│(%d+) ms')
      return first and tonumber(first)
    end
    local whole = last_time()
    vim.api.nvim_feedkeys('+', 'x', false)
    t.eventually('the newer half', function()
      return last_time() and last_time() > whole
    end)
    vim.api.nvim_feedkeys('-', 'x', false)
    t.eventually('the whole', function()
      return last_time() == whole
    end)
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
    local look = "lua io.write(table.concat(require('ladder.remembered')('ladder-trace').of(0) or {}, ' '))"
    local file = vim.api.nvim_buf_get_name(bufnr)
    local again = vim.system({ vim.v.progpath, '--headless', '--clean', '-u', init, file, '-c', look, '-c', 'qa!' }):wait(10000)
    assert(again.stdout:find('warmup.ET', 1, true), again.stdout .. again.stderr)
  end)

  t.step(':Ladder references lists what reads, writes, sets and resets each tag, and leads there', function()
    local bufnr = t.open('motor.clad')
    vim.cmd('Ladder references')
    local list = t.eventually('the list', function()
      return vim.bo.filetype == 'ladder_references' and vim.api.nvim_get_current_buf()
    end)
    local lines = vim.api.nvim_buf_get_lines(list, 0, -1, false)
    local at
    for index, line in ipairs(lines) do
      if line:find('^run : BOOL') then
        at = index
      end
    end
    assert(at, table.concat(lines, '\n'))
    local place = lines[at + 1]
    local line = tonumber(place:match('^    write%s+line (%d+), network %d+$'))
    assert(line, place)
    vim.api.nvim_win_set_cursor(0, { at + 1, 0 })
    vim.api.nvim_feedkeys(vim.keycode('<CR>'), 'x', false)
    t.equal('the buffer', bufnr, vim.api.nvim_get_current_buf())
    t.equal('the line', line, vim.api.nvim_win_get_cursor(0)[1])
    t.equal('the word there', 'run', vim.fn.expand('<cword>'))
    vim.cmd('bwipeout! ' .. list)
  end)
end
