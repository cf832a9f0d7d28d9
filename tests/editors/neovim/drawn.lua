-- Drawings as people know them from elsewhere, typed and pasted: what is found, and what the fix draws.
return function(t)
  local typing = require('typing')

  --- Waits for the findings, chooses the fix of this title with the cursor at the beginning of the first line, and looks at
  --- what it draws; then at its undo.
  local function fixed(keys, title, wanted)
    local before = keys:lines()
    t.eventually('an error', function()
      return keys:lua('return #vim.diagnostic.get(0, { severity = 1 })') > 0
    end)
    keys:press('gg0')
    keys:lua(
      [[local title = ...
      vim.lsp.buf.code_action({ apply = true, filter = function(action)
        return vim.startswith(action.title, title)
      end })]],
      title
    )
    keys:expect(title, wanted)
    t.eventually('no error', function()
      return keys:lua('return #vim.diagnostic.get(0, { severity = 1 })') == 0
    end)
    keys:press('u')
    keys:expect('undone', before)
    keys:close()
  end

  t.step('three parallel branches drawn the natural way, typed by hand, are drawn again by the fix', function()
    local drawn = {
      '+--\\--[ ]( a )--\\--( )( y )--+',
      '|  |--[ ]( b )--|            |',
      '|  /--[ ]( c )--/            |',
    }
    local keys = typing.open(t, { '' })
    keys:press('i')
    for number, line in ipairs(drawn) do
      -- What Enter has begun is typed once more.
      for key in line:gmatch('.') do
        keys:press(key)
      end
      if number < #drawn then
        keys:press('<CR>')
      end
    end
    keys:expect('what was typed', drawn)
    keys:press('<Esc>')
    fixed(keys, 'Draw it with `/--\\`', {
      '+--\\--[ ]( a )--------\\----------------------------------------------( )( y )--+',
      '|  /--\\--[ ]( b )--\\--/                                                        |',
      '|     /--[ ]( c )--/                                                           |',
    })
  end)

  t.step('a drawing with box-drawing characters, pasted, is drawn again by the fix', function()
    local pasted = {
      '├──┬──[ ]( a )──┬──( )( y )──┤',
      '│  └──[ ]( b )──┘            │',
    }
    for _, mode in ipairs({ '', 'i' }) do
      local keys = typing.open(t, { '' })
      keys:press(mode)
      -- As a terminal that brackets what is pasted.
      keys:lua('vim.api.nvim_paste(..., true, -1)', table.concat(pasted, '\n'))
      keys:expect('what was pasted', pasted)
      keys:press('<Esc>')
      fixed(keys, 'Draw it with - +', {
        '+--\\--[ ]( a )--\\----------------------------------------------------( )( y )--+',
        '|  /--[ ]( b )--/                                                              |',
      })
    end
  end)
end
