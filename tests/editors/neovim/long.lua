-- What keys cost in a long program, counted: what is sent and received, marked, and read by the highlighter.
return function(t)
  local typing = require('typing')

  --- A program in which each rung's coil is the next one's contact.
  local function program(rungs)
    local lines = {}
    for number = 1, rungs do
      lines[number] = ('+--[ ]( tag_%05d )--------------[TON]( timer_%05d, T#5s )--( )( tag_%05d )--+'):format(
        number,
        number,
        number % rungs + 1
      )
    end
    return lines
  end

  --- In the Neovim that is typed into: counts from now on.
  local COUNTING = [[
    _G.counted = { sent = {}, received = {}, lines = 0 }
    local client = vim.lsp.get_clients({ name = 'ladder' })[1]
    local function add(into, method, value)
      into[method] = (into[method] or 0) + #vim.json.encode(value)
    end
    local rpc = client.rpc
    local request, notify = rpc.request, rpc.notify
    rpc.request = function(method, params, callback, ...)
      add(counted.sent, method, params)
      return request(method, params, function(err, result, ...)
        add(counted.received, method, result or vim.NIL)
        return callback(err, result, ...)
      end, ...)
    end
    rpc.notify = function(method, params)
      add(counted.sent, method, params)
      return notify(method, params)
    end
    vim.api.nvim_buf_attach(0, false, { on_lines = function(_, _, _, first, old, new)
      counted.lines = counted.lines + math.max(old, new) - first
    end })
    vim.cmd('syntime on | syntime clear')
  ]]

  local COUNTS = [[
    vim.cmd.redraw()
    local tried = 0
    for line in vim.gsplit(vim.fn.execute('syntime report'), '\n') do
      tried = tried + (tonumber(line:match('^%s*[%d.]+%s+(%d+)')) or 0)
    end
    counted.tried = tried
    counted.marks = #vim.api.nvim_buf_get_extmarks(0, -1, 0, -1, {})
    return counted
  ]]

  --- Types in the middle of a program, and counts.
  local function typed_in(rungs)
    local lines = program(rungs)
    local keys = typing.open(t, lines, { 'set redrawtime=100' })
    keys:press('2000G')
    local function coloured()
      return keys:lua("return #vim.api.nvim_buf_get_extmarks(0, vim.api.nvim_create_namespace('ladder_colours'), 0, -1, {})") > 0
    end
    t.eventually('the colours of what is shown', coloured)
    keys:lua(COUNTING)
    keys:press('0f_', 'i')
    for key in ('spare'):gmatch('.') do
      keys:press(key)
      vim.wait(30)
    end
    keys:press('<Esc>')
    t.eventually('the network to be drawn', function()
      return #keys:lua('return vim.fn.getline(2000)') == #lines[2000] and keys:lua('return vim.fn.getline(2000)') ~= lines[2000]
    end)
    -- Until nothing more comes. What is given up has no answer.
    local before
    t.eventually('an end of what is sent', function()
      local now = keys:lua('return vim.json.encode(counted)')
      local is_over = now == before
      before = now
      vim.wait(400)
      return is_over
    end)
    local counted = keys:lua(COUNTS)
    keys:close()
    return counted
  end

  local function sum(bytes)
    return vim.iter(vim.tbl_values(bytes)):fold(0, function(all, more)
      return all + more
    end)
  end

  t.step('in 10,000 rungs six keys cost no more than what they change and what is shown', function()
    local counted = typed_in(10000)
    -- Far less than the program, which has 800,000 bytes; and twice to four times what was counted when this was written.
    for what, pair in vim.spairs({
      ['bytes sent'] = { sum(counted.sent), 5000 },
      ['bytes received'] = { sum(counted.received), 50000 },
      ['lines changed'] = { counted.lines, 10 },
      ['marks'] = { counted.marks, 4000 },
      ['patterns tried by the highlighter'] = { counted.tried, 50000 },
    }) do
      assert(pair[1] <= pair[2], ('%s: %d\n%s'):format(what, pair[1], vim.inspect(counted)))
      assert(pair[1] > 0, what .. ' are not counted')
    end
  end)
end
