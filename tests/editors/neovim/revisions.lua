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
