-- Scenarios: run, and made from what was done.
return function(t, messages)
  t.step(':Ladder test lists the scenarios that fail in the quickfix list', function()
    vim.cmd.edit(vim.env.LADDER_FIXTURES .. '/motor.ladder-test')
    t.equal('the file type', 'laddertest', vim.bo.filetype)
    t.equal("'commentstring'", '# %s', vim.bo.commentstring)
    vim.fn.setqflist({}, 'r')
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

  t.step('what was done is saved as a test next to the program, and runs once', function()
    local file = vim.env.LADDER_SCRATCH .. '/done.clad'
    vim.fn.writefile(vim.fn.readfile(vim.env.LADDER_FIXTURES .. '/motor.clad'), file)
    vim.cmd.edit(file)
    t.eventually('the server', function()
      return #vim.lsp.get_clients({ bufnr = 0, name = 'ladder' }) > 0
    end)
    vim.cmd('Ladder start')
    t.eventually('the simulation', function()
      return require('ladder.session').of(vim.api.nvim_get_current_buf())
    end)
    vim.cmd('Ladder set start 1')
    vim.cmd('Ladder step 2')
    -- The list is answered as a user would: one tag less, then the first entry.
    local select, shown = vim.ui.select, {}
    vim.ui.select = function(items, options, chosen)
      table.insert(shown, vim.tbl_map(options.format_item, items))
      local index = #shown == 1 and #items or 1
      chosen(items[index], index)
    end
    t.clear(messages)
    vim.cmd('Ladder record it starts')
    t.eventually('the scenario', function()
      return vim.api.nvim_buf_get_name(0):find('done%-recorded%.ladder%-test$')
    end)
    vim.ui.select = select
    assert(shown[1][1]:find('Write the test', 1, true), shown[1][1])
    local last = shown[2][#shown[2]]
    assert(last:find('^%[x%]'), last)
    local lines = table.concat(vim.fn.readfile(vim.api.nvim_buf_get_name(0)), '\n')
    assert(lines:find('program done.clad', 1, true) and lines:find('scenario "it starts"', 1, true), lines)
    assert(lines:find('start +%-') and lines:find('run +=> %-'), lines)
    t.eventually('its result', function()
      return messages[#messages] == 'ladder: 1 scenarios passed, 0 failed'
    end)
    vim.cmd('bwipeout!')
    vim.cmd('Ladder stop')
    vim.cmd('bwipeout!')
  end)
end
