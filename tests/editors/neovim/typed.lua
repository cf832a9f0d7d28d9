-- Typing a program by hand: what is completed, begun and drawn meanwhile.
return function(t)
  local typing = require('typing')

  local function enabling(options)
    return (
      "autocmd LspAttach * lua vim.lsp.completion.enable(true, vim.lsp.get_clients({ name = 'ladder' })[1].id, "
      .. 'vim.api.nvim_get_current_buf(), %s)'
    ):format(options)
  end

  local as_typed = 'let g:ladder_draw = v:false'
  local ways = {
    ['not enabled'] = { as_typed },
    ['enabled'] = { as_typed, enabling('{}') },
    ['autotrigger'] = { as_typed, enabling('{ autotrigger = true }') },
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
      return keys:lua([[local first = vim.fn.complete_info({ 'items' }).items[1]
        return first and vim.startswith(first.user_data.nvim.lsp.completion_item.filterText, '[count')]])
    end)
    -- Neovim asks once for each key; the last answer is the list that stays.
    vim.wait(200)
    keys:choose('[CTD]')
    keys:expect('the block', { '+--[CTD]( c, 10 )--' })
    keys:close()
  end)

  t.step('a list that is open stays open on the way to what it is for', function()
    local keys = typing.open(t, { '' }, ways.autotrigger)
    keys:press('i+--[')
    keys:list()
    for letter in ('timer'):gmatch('.') do
      keys:press(letter)
      -- Neovim asks for each key, and closes a list that has become empty for good.
      vim.wait(150)
      t.equal('the list after ' .. letter, 1, keys:lua('return vim.fn.pumvisible()'))
    end
    keys:choose('[TON]')
    keys:expect('the block', { '+--[TON]( t, T#1s )--' })
    keys:close()
  end)

  --- A text without what the drawing adds: all wires have one length.
  local function undrawn(lines)
    return vim.tbl_map(function(line)
      return (line:gsub('%-%-+', '--'):gsub('%s*|?%s*$', ''))
    end, lines)
  end

  local places = {
    { 'first', { '+--%s--( )( y )--+' }, 1 },
    { 'in the middle', { '+--[ ]( a )--%s--( )( y )--+' }, 1 },
    { 'last', { '+--[ ]( a )--%s' }, 1 },
    { 'in a branch', { '+--\\--[ ]( a )--\\--( )( y )--+', '|  /--%s--/' }, 2 },
  }
  local blocks = { '[ ', '( ', '[TON', '[SEARCH', '<JMP' }

  --- The text after a block was completed at a place and its first operand typed.
  local function completed(keys, place, block)
    local _, lines, row = unpack(place)
    local before = vim.tbl_map(function(line)
      return (line:gsub('%%s', function()
        return block
      end))
    end, lines)
    local column = lines[row]:find('%s', 1, true) - 1 + #block
    keys:write(before, row, column - 1)
    keys:press('a', '<C-x><C-o>')
    keys:list()
    keys:press('<C-n>', '<C-y>')
    t.eventually('a place to be selected', function()
      return keys:lua("return vim.snippet.active() and vim.fn.mode() == 's'")
    end)
    -- Longer than the server needs for a drawing.
    vim.wait(60)
    keys:press('zz9')
    local typed_out = keys:lines()
    keys:press('<Esc>')
    return before, typed_out
  end

  t.step('Tab leads through the operands, past the last one, and puts nothing in', function()
    local keys = typing.open(t, { '' })
    keys:write({ '+--[ ]( a )--[TON' }, 1, 16)
    keys:press('a', '<C-x><C-o>')
    keys:list()
    keys:press('<C-n>', '<C-y>')
    t.eventually('a place to be selected', function()
      return keys:lua("return vim.snippet.active() and vim.fn.mode() == 's'")
    end)
    keys:press('t1', '<Tab>', '9s', '<Tab>')
    local rung = '+--[ ]( a )--[TON]( t1, 9s )--'
    keys:expect('the block', { rung })
    t.equal('the cursor after the wire', { 1, #rung }, keys:cursor())
    keys:press('<Tab>')
    keys:expect('the block', { rung })
    keys:press('( )( y )--+', '<Left><Left><Left><Left><Left>', '<Tab>')
    t.equal('the cursor in front of the rail', { 1, #rung + #'( )( y )' }, keys:cursor())
    keys:press('<Tab>')
    t.equal('the cursor after the rail', { 1, #rung + #'( )( y )--+' }, keys:cursor())
    keys:press('<Esc>')
    -- Where nothing is drawn it is the key that it always is.
    keys:write({ 'VAR' }, 1, 2)
    keys:press('a', '<Tab>')
    keys:expect('blanks', { 'VAR ' })
    keys:close()
  end)

  t.step('what is completed is drawn when its operands are typed, wherever it is on a rung', function()
    local keys = typing.open(t, { '' })
    for _, place in ipairs(places) do
      for _, block in ipairs(blocks) do
        local what = block .. ' ' .. place[1]
        keys:lua('vim.g.ladder_draw = false')
        local _, plain = completed(keys, place, block)
        assert(table.concat(plain):find('zz9', 1, true), vim.inspect(plain))
        keys:lua('vim.g.ladder_draw = nil')
        local before, typed_out = completed(keys, place, block)
        t.equal(what, plain, typed_out)
        -- A block with an error or an open rung may stay as it is written.
        vim.wait(60)
        local drawn = keys:lines()
        t.equal(what .. ', drawn', undrawn(plain), undrawn(drawn))
        keys:press('u')
        t.eventually(what .. ' to be undone', function()
          return not table.concat(keys:lines()):find('zz9', 1, true)
        end)
        keys:press('u', 'u', 'u', '10<C-r>')
        keys:expect(what .. ', redone', drawn)
        t.equal(what .. ' began as', #before, #drawn)
      end
    end
    keys:close()
  end)

  t.step('an answer that comes late does not take back what was chosen', function()
    local keys = typing.open(t, { '' }, ways.autotrigger)
    keys:press('i+--[')
    keys:list()
    keys:press('coun')
    t.eventually('the counters', function()
      return keys:lua([[local first = vim.fn.complete_info({ 'items' }).items[1]
        return first and vim.startswith(first.user_data.nvim.lsp.completion_item.filterText, '[coun')]])
    end)
    vim.wait(200)
    keys:press('<C-n>')
    -- As for a key that was typed before the choice.
    keys:lua('vim.lsp.completion.get()')
    vim.wait(200)
    keys:press('<C-y>')
    t.eventually('the whole block', function()
      return keys:lines()[1]:match('^%+%-%-%[CT%w+%]%( ')
    end)
    keys:close()
  end)

  t.step('a long program keeps its colours at its end, and Neovim reads no tokens of all of it', function()
    local rungs = {}
    for number = 1, 4000 do
      rungs[number] = ('+--[ ]( a%d )--[/]( b%d )--[TON]( t%d, T#5s )--( )( c%d )--+'):format(number, number, number, number)
    end
    local keys = typing.open(t, rungs, { 'set redrawtime=100' })
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

  --- Presses keys one by one, and waits for the text after each.
  local function typed(keys, steps)
    for _, step in ipairs(steps) do
      keys:press(step[1])
      keys:expect('the text after ' .. step[1], step[2])
    end
  end

  t.step('Enter begins the next rung, once more a line further down, and then none', function()
    local rung = '+--[ ]( a )----------------------------------------------------------( )( y )--+'
    local keys = typing.open(t, { '+--[ ]( a )--( )( y )--+' })
    typed(keys, {
      { 'A<CR>', { rung, '+--' } },
      { '[/]( b )--( )( z )--+', { rung, '+--[/]( b )--( )( z )--+' } },
      { '<CR>', { rung, '+--[/]( b )----------------------------------------------------------( )( z )--+', '+--' } },
      { '<CR>', { rung, '+--[/]( b )----------------------------------------------------------( )( z )--+', '', '+--' } },
      { '<CR>', { rung, '+--[/]( b )----------------------------------------------------------( )( z )--+', '', '', '' } },
    })
    t.equal('the cursor', { 5, 0 }, keys:cursor())
    keys:write({ rung }, 1, 0)
    typed(keys, { { 'o', { rung, '+--' } }, { '<Esc>', { rung, '' } } })
    keys:close()
  end)

  t.step('Enter within a block does nothing, and o below an open one begins a line', function()
    local keys = typing.open(t, { '' })
    typed(keys, {
      { 'i+--[ ]( run )--[TON<CR>', { '+--[ ]( run )--[TON' } },
      { ']( t, 5s )<Left><CR>', { '+--[ ]( run )--[TON]( t, 5s )' } },
      { '9', { '+--[ ]( run )--[TON]( t, 5s 9)' } },
      
    })
    keys:write({ '+--[ ]( run )--[TON' }, 1, 0)
    typed(keys, { { 'o', { '+--[ ]( run )--[TON', '' } } })
    keys:close()
  end)

  t.step('after the declarations a rung begins at the left', function()
    local keys = typing.open(t, { '' })
    local declared = { 'VAR', '    a : BOOL;', 'END_VAR' }
    typed(keys, {
      { 'iVAR<CR>', { 'VAR', '    ' } },
      { 'a : BOOL;<CR>', { 'VAR', '    a : BOOL;', '    ' } },
      { 'END_VAR<CR>', vim.list_extend(vim.deepcopy(declared), { '' }) },
      { '<CR>', vim.list_extend(vim.deepcopy(declared), { '', '' }) },
      { '+--', vim.list_extend(vim.deepcopy(declared), { '', '+--' }) },
    })
    keys:close()
  end)

  t.step('\\, Enter, a contact and / draw a branch', function()
    local before = { '+--[ ]( a )--( )( y )--+' }
    local keys = typing.open(t, before)
    keys:lua('vim.api.nvim_win_set_cursor(0, { 1, 3 })')
    typed(keys, {
      { 'i\\', { '+--\\[ ]( a )--( )( y )--+' } },
      { '--<Left><Left><CR>', { '+--\\--[ ]( a )--( )( y )--+', '|  /--' } },
      { '[ ]( b )', { '+--\\--[ ]( a )--( )( y )--+', '|  /--[ ]( b )' } },
      { '/', { '+--\\--[ ]( a )--\\----------------------------------------------------( )( y )--+', '|  /--[ ]( b )--/                                                              |' } },
    })
    keys:close()
  end)

  t.step('a branch below what is written so far', function()
    local keys = typing.open(t, { '' })
    typed(keys, {
      { 'i+--\\--[ ]( a )<CR>', { '+--\\--[ ]( a )', '|  /--' } },
      { '[ ]( b )/', { '+--\\--[ ]( a )--\\--', '|  /--[ ]( b )--/' } },
      { '<Up><End>( )( y )--+', { '+--\\--[ ]( a )--\\--( )( y )--+', '|  /--[ ]( b )--/' } },
      { '<Esc>', { '+--\\--[ ]( a )--\\----------------------------------------------------( )( y )--+', '|  /--[ ]( b )--/                                                              |' } },
    })
    keys:close()
  end)

  t.step('leaving insert mode draws the network, and undo takes it back with what was typed', function()
    local before = { '+--[ ]( a )----------------------------------------------------------( )( y )--+', '', '+-[ ]( x )-( )( z )-+' }
    local keys = typing.open(t, before)
    keys:lua('vim.api.nvim_win_set_cursor(0, { 1, 8 })')
    typed(keys, {
      { 'along_name<Esc>', { '+--[ ]( along_name )-------------------------------------------------( )( y )--+', '', '+-[ ]( x )-( )( z )-+' } },
      { 'u', before },
    })
    keys:lua('vim.g.ladder_draw = false')
    typed(keys, { { '1G09lix<Esc>', { '+--[ ]( ax )----------------------------------------------------------( )( y )--+', '', '+-[ ]( x )-( )( z )-+' } } })
    keys:close()
  end)

  t.step('with one line in the configuration a file is formatted when it is written', function()
    local keys = typing.open(t, { '+-[ ]( x )-( )( z )-+' }, { 'let g:ladder_format_on_save = v:true' })
    keys:press(':w<CR>')
    t.eventually('the file to be formatted', function()
      return vim.deep_equal({ '+--[ ]( x )----------------------------------------------------------( )( z )--+' }, vim.fn.readfile(keys.file))
    end)
    keys:close()
    local plain = typing.open(t, { '+-[ ]( x )-( )( z )-+' })
    plain:lua('vim.cmd.write()')
    t.equal('the file', { '+-[ ]( x )-( )( z )-+' }, vim.fn.readfile(plain.file))
    plain:close()
  end)

  t.step('a half-typed rung is not red until insert mode is left', function()
    local keys = typing.open(t, { '+--[ ]( a )----------------------------------------------------------( )( y )--+', '' })
    local function found()
      return #keys:lua('return vim.diagnostic.get(0)')
    end
    keys:press('Go+--\\--[ ]( b')
    -- Longer than Neovim and the server need.
    vim.wait(800)
    t.equal('the diagnostics while it is typed', 0, found())
    keys:press('<Esc>')
    t.eventually('the diagnostics', function()
      return found() > 0
    end)
    keys:press('a )--( )( z )--+<CR>')
    t.eventually('no diagnostics', function()
      return found() == 0
    end)
    keys:close()
  end)

  t.step('the first finding does not shift the text, and other files keep their margin', function()
    local keys = typing.open(t, { '+--[ ]( a )----------------------------------------------------------( )( y )--+', '' }, { 'set signcolumn=auto' })
    local function margin()
      return keys:lua('vim.cmd.redraw() return vim.fn.getwininfo(vim.fn.win_getid())[1].textoff')
    end
    local before = margin()
    keys:press('Go+--\\--[ ]( b<Esc>')
    t.eventually('the sign of a finding', function()
      return keys:lua([[return #vim.fn.sign_getplaced('%', { group = '*' })[1].signs > 0 or
        #vim.api.nvim_buf_get_extmarks(0, -1, 0, -1, { type = 'sign' }) > 0]])
    end)
    t.equal('the width of the margin', before, margin())
    keys:press(':edit! ' .. vim.fs.dirname(keys.file) .. '/notes.txt<CR>')
    t.equal("'signcolumn' of another file", 'auto', keys:lua('return vim.wo.signcolumn'))
    keys:close()
  end)

  t.step('a margin that a person has chosen stays, and one for several signs keeps room for one', function()
    for chosen, kept in pairs({ auto = 'yes', ['auto:1'] = 'yes', ['auto:3'] = 'auto:1-3', ['auto:1-2'] = 'auto:1-2', no = 'no', number = 'number' }) do
      local keys = typing.open(t, { '' }, { 'set signcolumn=' .. chosen })
      t.equal("'signcolumn' of " .. chosen, kept, keys:lua('return vim.wo.signcolumn'))
      keys:close()
    end
  end)

  t.step('Enter between two rungs that touch begins one, and leaving it there takes it back', function()
    local first, last = '+--[ ]( a )----------------------------------------------------------( )( y )--+', '+--[ ]( x )----------------------------------------------------------( )( z )--+'
    local keys = typing.open(t, { first, last })
    typed(keys, {
      { 'A<CR>', { first, '+--', last } },
      { '<Esc>', { first, '', last } },
      { 'u', { first, last } },
      { 'ggo', { first, '+--', last } },
      { '[/]( b )--( )( v )--+<Esc>', { first, '+--[/]( b )----------------------------------------------------------( )( v )--+', last } },
    })
    keys:close()
  end)

  t.step('a rung that was begun goes when the cursor leaves it, with the undo of Enter', function()
    local first, last = '+--[ ]( a )----------------------------------------------------------( )( y )--+', '+--[ ]( x )----------------------------------------------------------( )( z )--+'
    local keys = typing.open(t, { first, last })
    typed(keys, {
      { 'A<CR>', { first, '+--', last } },
      { '<Down>', { first, '', last } },
      { '<Esc>u', { first, last } },
      { 'ggA<CR>', { first, '+--', last } },
      { '<Up>', { first, '', last } },
      { '<Esc>u', { first, last } },
      -- Once more a line further down: what is left there goes, too.
      { 'ggA<CR>', { first, '+--', last } },
      { '<CR>', { first, '', '+--', last } },
      { '<Up>', { first, '', '', last } },
      { '<Esc>', { first, '', '', last } },
    })
    keys:write({ first, last }, 1, 0)
    -- What was typed into stays.
    typed(keys, {
      { 'A<CR>', { first, '+--', last } },
      { '[ ]( b )', { first, '+--[ ]( b )', last } },
      { '<Up>', { first, '+--[ ]( b )', last } },
    })
    keys:close()
  end)

  t.step('keys draw: each is one step of undo', function()
    local before = { '+--[ ]( a )----------------------------------------------------------( )( y )--+' }
    local keys = typing.open(t, before)
    for _, case in ipairs({
      { '0f-2h', 'c', { '+--[ ]( contact_1 )--[ ]( a )----------------------------------------( )( y )--+' } },
      { '013l', 'C', { '+--[ ]( a )--[/]( contact_1 )----------------------------------------( )( y )--+' } },
      { '$', 'q', { '+--[ ]( a )-------------------------------------------( )( y )--( )( coil_1 )--+' } },
      { '013l', 'f', { '+--[ ]( a )----------------------------------[TON]( timer_1, T#1s )--( )( y )--+' } },
      { '04l', 'b', { '+--\\--[ ]( a )--------------\\----------------------------------------( )( y )--+', '|  /--[ ]( new_contact_1 )--/                                                  |' } },
      { '04l', 'e', { '+--[/]( a )----------------------------------------------------------( )( y )--+' } },
      { '04l', 'd', { '+--------------------------------------------------------------------( )( y )--+' } },
      { '$8h', 'h', { '+------------( )( y )--[ ]( a )--+' } },
    }) do
      keys:press(case[1] .. '\\' .. case[2])
      if case[2] ~= 'h' then
        keys:expect(case[2], case[3])
      else
        t.eventually('the coil in front of the contact', function()
          return (keys:lines()[1] or ''):find('y )--[ ]( a )', 1, true)
        end)
      end
      keys:press('u')
      keys:expect('undone ' .. case[2], before)
    end
    keys:close()
  end)

  t.step('keys move a block along its rung and to another: each is one step of undo', function()
    local above, below = '+--[ ]( a )--[/]( b )------------------------------------------------( )( y )--+', '+--[ ]( c )----------------------------------------------------------( )( z )--+'
    local keys = typing.open(t, { above, '', below })
    local function first(line)
      return (line or ''):gsub('%-+', '-')
    end
    for _, case in ipairs({
      { 'gg04l', 'l', { '+-[/]( b )-[ ]( a )-( )( y )-+', '', '+-[ ]( c )-( )( z )-+' } },
      { 'gg04l', 'j', { '+-[/]( b )-( )( y )-+', '', '+-[ ]( a )-[ ]( c )-( )( z )-+' } },
      { 'G04l', 'k', { '+-[ ]( c )-[ ]( a )-[/]( b )-( )( y )-+', '', '+-( )( z )-+' } },
    }) do
      keys:press(case[1] .. '\\' .. case[2])
      local found
      if not vim.wait(3000, function()
        found = vim.tbl_map(first, keys:lines())
        return vim.deep_equal(case[3], found)
      end, 5) then
        t.equal(case[2], case[3], found)
      end
      keys:press('u')
      keys:expect('undone ' .. case[2], { above, '', below })
    end
    keys:close()
  end)
end
