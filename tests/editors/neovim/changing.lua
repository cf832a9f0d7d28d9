-- A program that is changed while it is simulated: what could not be kept, the way back across the change, another name.
return function(t, messages)
  local ladder = require('ladder')

  --- What of line 6, with the timer, has power.
  local function timer_line(bufnr)
    return t.powered(bufnr)[6]
  end

  --- Puts another text in the place of one in line 6.
  local function replace(bufnr, old, new)
    local at = vim.api.nvim_buf_get_lines(bufnr, 5, 6, false)[1]:find(old, 1, true) - 1
    vim.api.nvim_buf_set_text(bufnr, 5, at, 5, at + #old, { new })
  end

  t.step('what a change could not keep is reported, and stepping back goes across the change', function()
    local bufnr = t.open('motor.clad')
    for _, command in ipairs({ 'start', 'set start 1', 'step 3' }) do
      vim.cmd('Ladder ' .. command)
    end
    assert(ladder.wait(), 'no answer')
    t.equal('the lamp', 'lamp=1', t.values(bufnr, { 'lamp' }))
    t.clear(messages)
    replace(bufnr, 'T#20ms', 'T#1h')
    replace(bufnr, '[TON]', '[TOF]')
    replace(bufnr, '( lamp )', '(/)( lamp )')
    replace(bufnr, '( )(/)', '(/)')
    t.eventually('what was lost', function()
      return vim.list_contains(messages, 'ladder: warmup was a TON and is a TOF now: it begins with its initial value.')
    end)
    vim.cmd('Ladder step 2')
    assert(ladder.wait(), 'no answer')
    t.equal('the new program', '5 lamp=0', ladder.state().scan .. ' ' .. t.values(bufnr, { 'lamp' }))
    vim.cmd('Ladder back 4')
    assert(ladder.wait(), 'no answer')
    t.equal('the old program', '1 run=1', ladder.state().scan .. ' ' .. t.values(bufnr, { 'run' }))
    t.equal('power in a line that is another one now', '', timer_line(bufnr))
    t.equal('power in a line that is the same', true, vim.endswith(t.powered(bufnr)[2], '( )( run )--+'))
    vim.cmd('Ladder step 4')
    assert(ladder.wait(), 'no answer')
    t.equal('the new program', '5 lamp=0', ladder.state().scan .. ' ' .. t.values(bufnr, { 'lamp' }))
    assert(timer_line(bufnr):find('[TOF]', 1, true), timer_line(bufnr))
    vim.cmd('Ladder stop | bwipeout!')
  end)

  t.step('a tag that is renamed while the program runs goes on', function()
    local bufnr = t.open('motor.clad')
    for _, command in ipairs({ 'start', 'set start 1', 'step', 'set start 0', 'run' }) do
      vim.cmd('Ladder ' .. command)
    end
    t.eventually('a run', function()
      local state = ladder.state(bufnr)
      return state and state.status == 'running' and state.scan > 3
    end)
    t.equal('the motor holds itself', 'start=0  run=1', t.values(bufnr, { 'start', 'run' }))
    local at = vim.api.nvim_buf_get_lines(bufnr, 3, 4, false)[1]:find('run', 1, true)
    vim.api.nvim_win_set_cursor(0, { 4, at })
    local text = vim.api.nvim_get_current_win()
    vim.cmd('Ladder tags')
    local panel = vim.api.nvim_get_current_buf()
    local function listed(name)
      return vim.iter(vim.api.nvim_buf_get_lines(panel, 0, -1, false)):any(function(line)
        return vim.startswith(line, name .. ' ')
      end)
    end
    t.eventually('the tag in the panel', function()
      return listed('run')
    end)
    vim.api.nvim_set_current_win(text)
    vim.cmd('Ladder trace run')
    local trace = vim.api.nvim_get_current_buf()
    local function traced(name)
      return vim.iter(vim.api.nvim_buf_get_lines(trace, 0, -1, false)):find(function(line)
        return vim.startswith(line, name .. ' ')
      end)
    end
    t.eventually('the tag in the trace', function()
      return traced('run')
    end)
    vim.api.nvim_set_current_win(text)
    vim.lsp.buf.rename('turns')
    t.eventually('the other name', function()
      return ladder.tag('turns', bufnr)
    end)
    t.eventually('the other name in the panel, and that alone', function()
      return listed('turns') and not listed('run')
    end)
    t.eventually('the other name in the trace, and that alone', function()
      return traced('turns') and not traced('run')
    end)
    local scan = ladder.state(bufnr).scan
    t.eventually('more scans', function()
      return ladder.state(bufnr).scan > scan + 5
    end)
    t.equal('the motor', 'start=0  turns=1', t.values(bufnr, { 'start', 'turns' }))
    t.equal('the status', 'running', ladder.state(bufnr).status)
    vim.cmd('Ladder tags')
    vim.cmd('Ladder trace')
    vim.cmd('Ladder stop | bwipeout!')
  end)

  t.step('the panel says why while the program runs', function()
    local bufnr = t.open('motor.clad')
    vim.cmd('Ladder start')
    vim.cmd('Ladder run')
    assert(ladder.wait(bufnr), 'no answer')
    vim.cmd('Ladder tags')
    t.eventually('the tags', function()
      return vim.api.nvim_buf_line_count(0) > 3
    end)
    vim.fn.search('^lamp ')
    vim.fn.setqflist({}, 'r')
    vim.api.nvim_feedkeys('w', 'x', false)
    t.eventually('the list', function()
      local first = vim.fn.getqflist()[1]
      return first and vim.startswith(first.text, 'lamp is 0')
    end)
    t.equal('the status', 'running', ladder.state(bufnr).status)
    vim.cmd('cclose | Ladder stop')
    vim.cmd('only | bwipeout!')
  end)
end
