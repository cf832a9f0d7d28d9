-- How what has power and what has none is told apart, and what a key does with the tag under the cursor.
return function(t, messages)
  local ladder = require('ladder')

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
    vim.cmd('Ladder stop')
    vim.api.nvim_buf_set_lines(bufnr, 0, -1, false, {
      'VAR CONSTANT  LIMIT : INT := 80;  END_VAR',
      '+--[GT]( level, LIMIT )--( )( high )--+',
    })
    vim.cmd('Ladder start')
    assert(ladder.wait(), 'no answer')
    t.clear(messages)
    vim.cmd('Ladder force LIMIT 3')
    assert(ladder.wait(), 'no answer')
    assert(messages[1] and messages[1]:find('LIMIT', 1, true), 'nothing was said of the constant')
    t.equal('the status', 'paused, scan 0, 0ms', vim.b[bufnr].ladder_status)
    vim.cmd('Ladder stop | bwipeout!')
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
      local back = luminance(vim.api.nvim_get_hl(0, { name = 'Normal' }).bg)
      for _, group in ipairs({ 'LadderPowerOff', 'LadderBlocks', 'LadderValue', 'LadderPowerOn' }) do
        local front = luminance(vim.api.nvim_get_hl(0, { name = group, link = false }).fg)
        local contrast = (math.max(front, back) + 0.05) / (math.min(front, back) + 0.05)
        assert(contrast >= 4.5, ('%s has a contrast of %.1f on %s'):format(group, contrast, background))
      end
    end
  end)

  t.step('of a long program only what the window shows is sent and drawn', function()
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
end
