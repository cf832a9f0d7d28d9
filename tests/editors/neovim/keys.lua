-- Where the keys are listed: in the help, by a command, and above the windows.
return function(t, messages)
  local keys = require('ladder.keys')

  t.step('the help lists the keys of a simulation, and those of each window', function()
    -- Its tags are made in a folder of their own.
    local folder = vim.env.LADDER_SCRATCH .. '/help'
    vim.fn.mkdir(folder .. '/doc', 'p')
    vim.uv.fs_copyfile(vim.env.LADDER_ROOT .. '/editors/neovim/doc/ladder.txt', folder .. '/doc/ladder.txt')
    vim.cmd.helptags(folder .. '/doc')
    --- The keys that a section of the help lists.
    local function listed(section)
      vim.opt.runtimepath:prepend(folder)
      vim.cmd.help(section)
      vim.opt.runtimepath:remove(folder)
      local first = vim.api.nvim_win_get_cursor(0)[1]
      local last = vim.fn.search('\\*ladder-\\|^===', 'nW')
      local found = {}
      for _, line in ipairs(vim.api.nvim_buf_get_lines(0, first, last - 1, false)) do
        -- Keys have eight columns, or a line of their own.
        for name in (line:match('^    (%S+)$') or line:match('^    (%S.......)') or ''):gmatch('%S+') do
          found[name] = true
        end
      end
      vim.cmd.helpclose()
      return found
    end
    local of_program = listed('ladder-keys')
    for _, key in ipairs(keys.all) do
      assert(of_program[key[1]], key[1] .. ' is not in the help')
    end
    local bufnr = t.open('motor.clad')
    vim.cmd('Ladder start')
    assert(require('ladder').wait(bufnr), 'no answer')
    for command, section in pairs({ tags = 'ladder-panel', diagram = 'ladder-diagram', trace = 'ladder-trace' }) do
      vim.cmd('Ladder ' .. command)
      local side = vim.iter(vim.api.nvim_list_bufs()):find(function(buffer)
        return vim.bo[buffer].filetype == 'ladder_' .. command
      end)
      local found = listed(section)
      for _, map in ipairs(vim.api.nvim_buf_get_keymap(side, 'n')) do
        local is_mouse = map.lhs:find('Mouse') or map.lhs:find('Release')
        local is_arrow = map.lhs == '<Left>' or map.lhs == '<Right>'
        local is_of_program = vim.iter(keys.all):any(function(key)
          return key[1] == map.lhs
        end)
        assert(is_mouse or is_arrow or is_of_program or found[map.lhs], ('%s of %s is not in the help'):format(map.lhs, section))
      end
      vim.cmd('Ladder ' .. command)
    end
    vim.cmd('Ladder stop')
    vim.cmd('bwipeout!')
  end)

  t.step(':Ladder keys lists them', function()
    t.open('motor.clad')
    t.clear(messages)
    vim.cmd('Ladder keys')
    local listed = messages[1]
    for _, key in ipairs(keys.all) do
      assert(listed:find(key[1], 1, true), key[1] .. ' is not listed:\n' .. listed)
    end
    vim.cmd('bwipeout!')
  end)
end
