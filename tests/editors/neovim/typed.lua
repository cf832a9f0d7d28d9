-- Typing a program by hand: what is completed, begun and drawn meanwhile.
return function(t)
  local typing = require('typing')

  local function enabling(options)
    return (
      "autocmd LspAttach * lua vim.lsp.completion.enable(true, vim.lsp.get_clients({ name = 'ladder' })[1].id, "
      .. 'vim.api.nvim_get_current_buf(), %s)'
    ):format(options)
  end

  local ways = {
    ['not enabled'] = {},
    ['enabled'] = { enabling('{}') },
    ['autotrigger'] = { enabling('{ autotrigger = true }') },
  }
  local options = { '', 'menu,preview', 'menuone,noselect', 'menu,noinsert', 'menuone,longest', 'menuone,fuzzy' }
  local cases = {
    { '+--[', '[ ]', '+--[ ]( tag )--' },
    { '+--[TO', '[TON]', '+--[TON]( t, T#1s )--' },
    { '+--[timer', '[TON]', '+--[TON]( t, T#1s )--' },
    { '+--[ ]( a )--(', '( )', '+--[ ]( a )--( )( tag )--+' },
    { '+--[TO]--( )( y )--+', '[TON]', '+--[TON]( t, T#1s )--( )( y )--+', 6 },
    { '+--[TOF]( u, 5s )--( )( y )--+', '[TON]', '+--[TON]( u, 5s )--( )( y )--+', 6 },
    { '+--[ ]( first )--( )( fi', 'first', '+--[ ]( first )--( )( first )--+' },
  }

  for way, setup in vim.spairs(ways) do
    t.step('completion leaves what is typed alone: ' .. way, function()
      local keys = typing.open(t, { '' }, setup)
      for _, option in ipairs(options) do
        keys:lua('vim.cmd.set("completeopt=" .. ...)', option)
        keys:press('ggcc+--[')
        if way == 'autotrigger' then
          keys:list()
        end
        keys:press(' ]( a )--(')
        if way == 'autotrigger' then
          keys:list()
        end
        keys:press('S)( b )--+<Esc>')
        keys:expect(option, { '+--[ ]( a )--(S)( b )--+' })
      end
      keys:close()
    end)

    t.step('what is completed comes out whole: ' .. way, function()
      local keys = typing.open(t, { '' }, setup)
      for _, option in ipairs(options) do
        keys:lua('vim.cmd.set("completeopt=" .. ...)', option)
        for _, case in ipairs(cases) do
          local written, label, whole, column = unpack(case)
          keys:write({ written }, 1, column or #written)
          keys:press(column and 'i' or 'a', '<C-x><C-o>')
          keys:choose(label)
          keys:expect(("'%s' with %s"):format(option, written), { whole })
          keys:press('<Esc>')
        end
      end
      keys:close()
    end)
  end

  t.step('a list that is open finds an instruction by what it is for', function()
    local keys = typing.open(t, { '' }, ways.autotrigger)
    keys:press('i+--[')
    keys:list()
    keys:press('count')
    t.eventually('the counters', function()
      return keys:lua([[local first = vim.fn.complete_info({ 'items' }).items[1] return first and first.abbr]]) == '[CTU]'
    end)
    keys:choose('[CTD]')
    keys:expect('the block', { '+--[CTD]( c, 10 )--' })
    keys:close()
  end)

  t.step('a program of 10,000 rungs keeps its colours at its end, and Neovim reads no tokens of all of it', function()
    local rungs = {}
    for number = 1, 10000 do
      rungs[number] = ('+--[ ]( a%d )--[/]( b%d )--[TON]( t%d, T#5s )--( )( c%d )--+'):format(number, number, number, number)
    end
    local keys = typing.open(t, rungs, { 'set redrawtime=300' })
    keys:press('G')
    t.equal('the colour of a block', 'cladContact', keys:lua([[vim.cmd.redraw()
      return vim.fn.synIDattr(vim.fn.synID(vim.fn.line('$'), 4, 1), 'name')]]))
    local function colours()
      return keys:lua([[local last = vim.fn.line('$') - 1
        local marks = vim.api.nvim_buf_get_extmarks(0, vim.api.nvim_create_namespace('ladder_colours'), { last, 0 },
          { last, -1 }, { details = true })
        return #marks > 0 and marks[1][4].hl_group]])
    end
    local first = t.eventually('the tokens of what is shown', colours)
    assert(vim.startswith(first, '@lsp.type.'), first)
    t.equal("Neovim's own tokens", false, keys:lua([[return vim.lsp.semantic_tokens.__STHighlighter.active[vim.api.nvim_get_current_buf()] ~= nil]]))
    keys:press('gg', 'G')
    keys:close()
  end)
end
