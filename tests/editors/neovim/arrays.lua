-- Arrays: tags that open, and which element an operand is.

return function(t)
  local ladder = require('ladder')

  local function lines()
    return vim.tbl_map(function(line)
      return (line:gsub(' +', ' '):gsub(' $', ''))
    end, vim.api.nvim_buf_get_lines(0, 0, -1, false))
  end

  local function press(bufnr, row, keys)
    vim.api.nvim_win_set_cursor(0, { row, 0 })
    vim.api.nvim_feedkeys(vim.keycode(keys), 'x', false)
    assert(ladder.wait(bufnr), 'no answer')
  end

  t.step('the tag panel shows an array as a tag that opens into its elements', function()
    local bufnr = t.open('pumps.clad')
    vim.cmd('Ladder start')
    assert(ladder.wait(), 'no answer')
    vim.cmd('Ladder tags')
    assert(ladder.wait(bufnr), 'no answer')
    local closed = {
      '▸ trip ARRAY[1..2] OF BOOL input',
      'run BOOL input 0',
      '▸ pump ARRAY[1..2] OF BOOL output',
      'i INT internal 0',
      '▸ starts ARRAY[1..2] OF INT internal',
    }
    t.equal('the tags', closed, lines())
    press(bufnr, 1, '<CR>')
    t.equal('the tags with an array that is open', { '▾ trip ARRAY[1..2] OF BOOL input', ' trip[1] BOOL input 0', ' trip[2] BOOL input 0', 'run BOOL input 0' }, vim.list_slice(lines(), 1, 4))
    press(bufnr, 3, '<CR>')
    t.equal('an element that was inverted', ' trip[2] BOOL input 1', lines()[3])
    press(bufnr, 1, '<CR>')
    t.equal('the tags with the array closed', closed, lines())
    vim.api.nvim_feedkeys('q', 'x', false)
    vim.cmd('Ladder stop')
  end)

  t.step('what a tag opens into may open again', function()
    local bufnr = t.open('lines.clad')
    vim.cmd('Ladder start')
    assert(ladder.wait(), 'no answer')
    vim.cmd('Ladder tags')
    assert(ladder.wait(bufnr), 'no answer')
    press(bufnr, 2, '<CR>')
    press(bufnr, 4, '<CR>')
    t.equal('the tags', {
      'step Phase internal FILLING',
      '▾ lines ARRAY[1..2] OF Motor internal',
      ' ▸ lines[1] Motor internal speed=50.0',
      ' ▾ lines[2] Motor internal speed=50.0',
      ' lines[2].speed REAL internal 50.0',
      ' ▸ lines[2].delay TON internal Q=FALSE ET=T#0s',
    }, lines())
    press(bufnr, 6, '<CR>')
    t.equal('a timer that is open', { ' lines[2].delay.Q BOOL internal 0', ' lines[2].delay.ET TIME internal 0ms' }, vim.list_slice(lines(), 7))
    press(bufnr, 2, '<CR>')
    t.equal('the tags with the array closed', { 'step Phase internal FILLING', '▸ lines ARRAY[1..2] OF Motor internal' }, lines())
    vim.api.nvim_feedkeys('q', 'x', false)
    vim.cmd('Ladder stop')
  end)

  t.step('an operand in a loop shows which element it is', function()
    local bufnr = t.open('pumps.clad')
    vim.cmd('Ladder start')
    assert(ladder.wait(), 'no answer')
    vim.cmd('Ladder step')
    assert(ladder.wait(bufnr), 'no answer')
    local namespace = vim.api.nvim_get_namespaces().ladder_values
    t.eventually('[2]=0', function()
      local shown = vim.inspect(vim.api.nvim_buf_get_extmarks(bufnr, namespace, 0, -1, { details = true }))
      return shown:find('[2]=0', 1, true) ~= nil
    end)
    vim.cmd('Ladder stop')
  end)
end
