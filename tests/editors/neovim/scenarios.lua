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
end
