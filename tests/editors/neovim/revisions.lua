-- What changed since a revision of git.
return function(t, messages)
  local folder = vim.fs.joinpath(vim.env.LADDER_SCRATCH, 'revisions')
  local file = vim.fs.joinpath(folder, 'motor.clad')
  local function git(...)
    local done = vim.system({ 'git', '-c', 'user.name=t', '-c', 'user.email=t@example.com', ... }, { cwd = folder }):wait()
    if done.code ~= 0 then
      error(done.stderr, 0)
    end
  end

  t.step(':Ladder diff shows what changed since the last commit', function()
    vim.fn.mkdir(folder)
    vim.fn.writefile({ '+--[ ]( a )--( )( x )--+', '', '+--[ ]( b )--( )( y )--+' }, file)
    git('init', '-q')
    git('add', '-A')
    git('commit', '-qm', 'x')
    vim.cmd.edit(file)
    vim.api.nvim_buf_set_lines(0, 0, 1, false, { '+--[/]( a )--( )( x )--+' })
    vim.cmd('Ladder diff')
    t.eventually('the difference', function()
      return vim.bo.filetype == 'ladder_diff'
    end)
    local lines = vim.api.nvim_buf_get_lines(0, 0, -1, false)
    t.equal('the heading', true, vim.tbl_contains(lines, 'edited, does another thing: network, line 1, writes x'))
    t.equal('a mark', true, vim.tbl_contains(lines, '     ^^^^^^^^'))
    t.equal('whether it can be edited', false, vim.bo.modifiable)
    vim.api.nvim_feedkeys('q', 'xt', false)
    t.equal('the window', file, vim.api.nvim_buf_get_name(0))
  end)

  t.step(':Ladder review has a sign for each rung that is not as the last commit has it', function()
    local function signs()
      local namespace = vim.api.nvim_get_namespaces().ladder_review
      return vim.tbl_map(function(mark)
        return ('%d%s'):format(mark[2] + 1, vim.trim(mark[4].sign_text))
      end, vim.api.nvim_buf_get_extmarks(0, namespace, 0, -1, { details = true }))
    end
    local function eventually(wanted)
      local ok = pcall(t.eventually, 'the signs', function()
        return vim.deep_equal(signs(), wanted)
      end)
      if not ok then
        t.equal('the signs', wanted, signs())
      end
    end
    vim.cmd('Ladder review')
    eventually({ '1≠' })
    vim.api.nvim_win_set_cursor(0, { 1, 0 })
    vim.cmd('Ladder review reason')
    local said = 'ladder: edited, does another thing: network, line 1, writes x: with a off, x goes off in the old and on in the new program'
    t.equal('the reason', said, messages[#messages])
    -- They follow the text, whose version the answer is of.
    vim.api.nvim_buf_set_lines(0, 2, 3, false, { '+--[ ]( b )--[ ]( b )--( )( y )--+', '', '+--[ ]( c )--( )( z )--+' })
    vim.cmd('doautocmd TextChanged')
    eventually({ '1≠', '3=', '5+' })
    vim.cmd('Ladder review')
    t.equal('the signs', {}, signs())
    vim.cmd('silent write')
  end)

  t.step(':Ladder diff says that nothing changed, and what is wrong', function()
    git('commit', '-qam', 'y')
    vim.cmd('Ladder diff')
    t.eventually('a message', function()
      return messages[#messages] == 'ladder: nothing has changed since HEAD'
    end)
    vim.cmd('Ladder diff none')
    t.eventually('a message', function()
      return messages[#messages]:find('no such revision', 1, true)
    end)
    vim.cmd('bwipeout!')
  end)
end
