-- Properties: proved, with what violates one as a finding and as rows, by command and by lens.
local PROGRAM = {
  'VAR_INPUT',
  '    go_up, go_down : BOOL;',
  'END_VAR',
  'VAR_OUTPUT',
  '    up, down : BOOL;',
  'END_VAR',
  '',
  '+--[ ]( go_up )----[/]( down )--( )( up )----+',
  '',
  '+--[ ]( go_down )--[/]( up )----( )( down )--+',
}
local PROPERTIES = {
  'program door.clad',
  '',
  'property "not both"',
  'never up and down',
  '',
  'property "it goes"',
  'always up or not go_up',
}

return function(t, messages)
  t.step(':Ladder prove shows what came of each property, and marks the one that is violated', function()
    local folder = vim.fn.tempname()
    vim.fn.mkdir(folder, 'p')
    vim.fn.writefile({}, folder .. '/ladder.toml')
    vim.fn.writefile(PROGRAM, folder .. '/door.clad')
    vim.fn.writefile(PROPERTIES, folder .. '/door.ladder-test')
    vim.cmd.edit(folder .. '/door.ladder-test')
    t.eventually('the server', function()
      return vim.lsp.get_clients({ bufnr = 0, name = 'ladder' })[1]
    end)
    vim.cmd('Ladder prove')
    t.eventually('the answer', function()
      return messages[#messages] == 'ladder: 1 proved, 1 violated'
    end)
    local shown = vim.fn.bufnr('^ladder://proofs/')
    local lines = vim.api.nvim_buf_get_lines(shown, 0, -1, false)
    t.equal('the first line', 'not both: proved for any times', lines[1])
    assert(lines[2]:find('^it goes: violated in scan %d'), vim.inspect(lines))
    local rows = table.concat(vim.list_slice(lines, 3), '\n')
    assert(rows:find('    go_up ', 1, true) and rows:find('up +=> '), rows)
    local function finding()
      return vim.tbl_filter(function(found)
        return found.code == 'property-violated'
      end, vim.diagnostic.get(0))[1]
    end
    local found = t.eventually('the finding', finding)
    t.equal('its line', 6, found.lnum + 1)
    vim.api.nvim_set_option_value('modified', false, { buf = shown })
    vim.cmd('bwipeout! ' .. shown)
  end)

  t.step('a finding of a proof goes when the text changes, and its run becomes a scenario', function()
    vim.api.nvim_win_set_cursor(0, { 6, 0 })
    vim.lsp.buf.code_action({
      apply = true,
      filter = function(action)
        return action.title == 'Write the counterexample as a scenario'
      end,
    })
    t.eventually('the scenario', function()
      return vim.fn.search('^scenario "it goes is violated"$', 'nw') > 0
    end)
    t.eventually('no finding', function()
      return #vim.diagnostic.get(0) == 0
    end)
  end)

  t.step('outputs that lock each other propose a property, in a file that is made for it', function()
    local properties = vim.api.nvim_get_current_buf()
    local folder = vim.fn.tempname()
    vim.fn.mkdir(folder, 'p')
    vim.fn.writefile({}, folder .. '/ladder.toml')
    vim.fn.writefile(PROGRAM, folder .. '/gate.clad')
    vim.cmd.edit(folder .. '/gate.clad')
    t.eventually('the server', function()
      return vim.lsp.get_clients({ bufnr = 0, name = 'ladder' })[1]
    end)
    vim.fn.cursor(8, 39)
    vim.lsp.buf.code_action({
      apply = true,
      filter = function(action)
        return action.title == 'Add the property: never up and down'
      end,
    })
    local made = t.eventually('the file', function()
      local bufnr = vim.fn.bufnr(folder .. '/gate.ladder-test')
      return bufnr > 0 and vim.api.nvim_buf_is_loaded(bufnr) and bufnr
    end)
    t.equal('the property', {
      'program gate.clad',
      '',
      'property "not both up and down"',
      'never up and down',
    }, vim.api.nvim_buf_get_lines(made, 0, 4, false))
    vim.cmd('bwipeout! ' .. made)
    vim.cmd('bwipeout!')
    vim.api.nvim_set_current_buf(properties)
  end)

  t.step('the lens of a property proves that one', function()
    t.clear(messages)
    vim.api.nvim_win_set_cursor(0, { 3, 0 })
    t.equal('the property at the cursor', 'not both', require('ladder.prove').here())
    vim.lsp.codelens.refresh({ bufnr = 0 })
    local lens = t.eventually('the lens', function()
      return vim.tbl_filter(function(lens)
        return lens.command and lens.command.title == 'Prove' and lens.range.start.line == 2
      end, vim.lsp.codelens.get(0))[1]
    end)
    local client = vim.lsp.get_clients({ bufnr = 0, name = 'ladder' })[1]
    client:exec_cmd(lens.command, { bufnr = vim.api.nvim_get_current_buf() })
    t.eventually('the answer', function()
      return messages[#messages] == 'ladder: 1 proved'
    end)
    vim.cmd('bwipeout! ' .. vim.fn.bufnr('^ladder://proofs/'))
    vim.cmd('bwipeout!')
  end)
end
