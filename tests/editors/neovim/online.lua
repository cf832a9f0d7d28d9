-- A controller that is watched: values and power of a program that runs elsewhere, and nothing that writes.
return function(t, messages)
  local ladder = require('ladder')

  t.step('without a word of where it is, the way to say it is told', function()
    t.open('watched.clad')
    vim.cmd('Ladder online')
    t.eventually('the refusal', function()
      return vim.iter(messages):any(function(message)
        return message:find('[online]', 1, true) ~= nil
      end)
    end)
  end)

  t.step('the power of a running controller is shown in the text', function()
    local bufnr = t.open('watched.clad')
    local settings = vim.fn.expand('%:p:h') .. '/ladder.toml'
    vim.fn.writefile({ '[online]', ('modbus = "%s"'):format(vim.env.LADDER_CONTROLLER) }, settings)
    local client = vim.lsp.get_clients({ bufnr = bufnr, name = 'ladder' })[1]
    -- Not every system reports files that are new.
    client:notify('workspace/didChangeWatchedFiles', { changes = { { uri = vim.uri_from_fname(settings), type = 1 } } })
    vim.cmd('Ladder online')
    t.eventually('the values', function()
      local state = ladder.state()
      return state and state.controller and state.text:find('READ ONLY; values', 1, true)
    end)
    t.eventually('the power', function()
      return vim.iter(t.powered(bufnr)):any(function(line)
        return line:find('( )( run )', 1, true) ~= nil
      end)
    end)
    t.eventually('what follows an edge is not known', function()
      return vim.iter(t.highlighted(bufnr, 'LadderPowerUnknown')):any(function(line)
        return line:find('( )( begun )', 1, true) ~= nil
      end)
    end)
    t.clear(messages)
    vim.cmd('Ladder set start FALSE')
    t.eventually('the refusal', function()
      return vim.iter(messages):any(function(message)
        return message:find('only watched', 1, true) ~= nil
      end)
    end)
    vim.cmd('Ladder offline')
    t.equal('the session', nil, ladder.state())
  end)
end
