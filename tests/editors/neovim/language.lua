-- What the language server says: the text, its errors, what is proposed, renamed and aligned.
return function(t)
  local ladder = require('ladder')

  t.step('the file type of .clad files is clad and lines are not wrapped', function()
    t.open('motor.clad')
    t.equal('the file type', 'clad', vim.bo.filetype)
    t.equal("'wrap'", false, vim.wo.wrap)
    t.equal("'commentstring'", '# %s #', vim.bo.commentstring)
  end)

  t.step('the server attaches and finds nothing wrong with a good program', function()
    local bufnr = t.open('motor.clad')
    t.equal(
      'the list of diagnostics',
      {},
      vim.tbl_map(function(found)
        return found.message
      end, vim.diagnostic.get(bufnr))
    )
  end)

  t.step('gcc and gc with a motion toggle comments', function()
    local bufnr = t.open('motor.clad')
    local before = vim.api.nvim_buf_get_lines(bufnr, 0, -1, false)
    vim.api.nvim_feedkeys('Ggcc', 'tx', false)
    t.equal('the last line', '# ' .. before[6]:gsub('T#', '') .. ' #', vim.api.nvim_get_current_line())
    vim.api.nvim_feedkeys('2GgcG', 'tx', false)
    t.equal('the second line', '# ' .. before[2] .. ' #', vim.api.nvim_buf_get_lines(bufnr, 1, 2, false)[1])
    vim.cmd('silent undo | silent undo')
    t.equal('the text', before, vim.api.nvim_buf_get_lines(bufnr, 0, -1, false))
  end)

  t.step('a connector without a partner gets a diagnostic at its place', function()
    local bufnr = t.open('unpaired.clad')
    local found = t.eventually('the diagnostic', function()
      return vim.diagnostic.get(bufnr)[1]
    end)
    t.equal('its code', 'unpaired-connector', found.code)
    t.equal('its line', 1, found.lnum)
    t.equal('its column', 36, found.col)
    t.equal('its severity', vim.diagnostic.severity.ERROR, found.severity)
  end)

  --- What Neovim shows at the end of a line for its diagnostics.
  local function virtual_text(bufnr, row)
    local text = ''
    for _, namespace in pairs(vim.diagnostic.get_namespaces()) do
      local marks = namespace.user_data.virt_text_ns
        and vim.api.nvim_buf_get_extmarks(
          bufnr,
          namespace.user_data.virt_text_ns,
          { row, 0 },
          { row, -1 },
          { details = true }
        )
      for _, mark in ipairs(marks or {}) do
        for _, chunk in ipairs(mark[4].virt_text or {}) do
          text = text .. chunk[1]
        end
      end
    end
    return text
  end

  t.step('of a warning and an error in one line the error is told, without any setting', function()
    local bufnr = t.open('motor.clad')
    local count = vim.api.nvim_buf_line_count(bufnr)
    vim.api.nvim_buf_set_lines(bufnr, count, -1, false, { '', '+--[TOM]( a )--[ ]( b )( )( y )--+' })
    t.eventually('both diagnostics', function()
      local found = vim.diagnostic.get(bufnr, { lnum = count + 1 })
      return #found > 1 and found
    end)
    local text = t.eventually('their text', function()
      local text = virtual_text(bufnr, count + 1)
      return text ~= '' and text
    end)
    assert(text:find('TOM', 1, true), 'the line tells: ' .. text)
  end)

  t.step(':Ladder explain shows the page of the rule, that of the error first', function()
    local bufnr = t.open('motor.clad')
    local count = vim.api.nvim_buf_line_count(bufnr)
    vim.api.nvim_buf_set_lines(bufnr, count, -1, false, { '', '+--[TOM]( a )--[ ]( b )( )( y )--+' })
    t.eventually('both diagnostics', function()
      return #vim.diagnostic.get(bufnr, { lnum = count + 1 }) > 1
    end)
    local function page(column, ...)
      vim.api.nvim_win_set_cursor(0, { count + 2, column })
      vim.cmd.Ladder({ args = { 'explain', ... } })
      local float = t.eventually('the window', function()
        return vim.b[bufnr].lsp_floating_preview
      end)
      local text = table.concat(vim.api.nvim_buf_get_lines(vim.api.nvim_win_get_buf(float), 0, -1, false), '\n')
      vim.api.nvim_win_close(float, true)
      return text:match('([%l]+%-[%l-]+)')
    end
    t.equal('the rule', 'unknown-instruction', page(0))
    t.equal('the rule at the cursor', 'missing-wire', page(23))
    t.equal('the rule that is named', 'double-coil', page(0, 'double-coil'))
  end)

  t.step('a correction takes the diagnostic away', function()
    local bufnr = t.open('unpaired.clad')
    t.eventually('the diagnostic', function()
      return vim.diagnostic.get(bufnr)[1]
    end)
    vim.api.nvim_buf_set_text(bufnr, 1, 21, 1, 37, {})
    t.eventually('no diagnostics', function()
      return #vim.diagnostic.get(bufnr) == 0
    end)
  end)

  t.step('what one file shows to another is followed in both', function()
    local main = t.open('calls.clad')
    t.eventually('the diagnostic', function()
      return (vim.diagnostic.get(main)[1] or {}).code == 'unknown-function'
    end)
    local library = vim.fs.dirname(vim.api.nvim_buf_get_name(main)) .. '/library.clad'
    vim.cmd.split(library)
    vim.api.nvim_buf_set_lines(0, 0, -1, false, { '+--<FUN>( count )--[ ]( go )--( )( counted )--+' })
    t.eventually('no diagnostics', function()
      return #vim.diagnostic.get(main) == 0
    end)
    vim.cmd('bwipeout!')
  end)

  t.step('an error in ladder.toml is shown at its place, and other files in TOML are left alone', function()
    local folder = vim.env.LADDER_SCRATCH .. '/settings'
    vim.fn.mkdir(folder)
    vim.fn.writefile({ '[format]', 'with = 120' }, folder .. '/ladder.toml')
    vim.fn.writefile({ '[format]' }, folder .. '/other.toml')
    vim.cmd.edit(folder .. '/other.toml')
    local other = vim.api.nvim_get_current_buf()
    vim.cmd.edit(folder .. '/ladder.toml')
    local bufnr = vim.api.nvim_get_current_buf()
    local found = t.eventually('the diagnostic', function()
      return vim.diagnostic.get(bufnr)[1]
    end)
    t.equal('its place', { 1, 0, 4 }, { found.lnum, found.col, found.end_col })
    t.equal('its message', '`with` is not a setting in [format]: did you mean `width`?', found.message)
    vim.api.nvim_buf_set_text(bufnr, 1, 1, 1, 2, { 'id' })
    t.eventually('no diagnostics', function()
      return #vim.diagnostic.get(bufnr) == 0
    end)
    t.equal('the servers of another file', 0, #vim.lsp.get_clients({ bufnr = other, name = 'ladder' }))
    vim.cmd('bwipeout!')
  end)

  t.step('hovering over a timer explains it', function()
    local bufnr = t.open('motor.clad')
    local row = 5
    local col = vim.api.nvim_buf_get_lines(bufnr, row, row + 1, false)[1]:find('TON') - 1
    vim.api.nvim_win_set_cursor(0, { row + 1, col })
    vim.lsp.buf.hover()
    local float = t.eventually('the hover window', function()
      return vim.b[bufnr].lsp_floating_preview
    end)
    local text = table.concat(vim.api.nvim_buf_get_lines(vim.api.nvim_win_get_buf(float), 0, -1, false), '\n')
    assert(
      text:find('TON', 1, true) and text:lower():find('timer', 1, true),
      'the window does not name the timer:\n' .. text
    )
    vim.api.nvim_win_close(float, true)
  end)

  t.step('formatting aligns a crooked drawing', function()
    local bufnr = t.open('crooked.clad')
    vim.lsp.buf.format({ name = 'ladder', timeout_ms = 5000 })
    local wanted = vim.fn.readfile(vim.env.LADDER_FIXTURES .. '/motor.clad')
    t.equal('the text', wanted, vim.api.nvim_buf_get_lines(bufnr, 0, -1, false))
  end)

  t.step('completion proposes tags of the right type', function()
    local bufnr = t.open('motor.clad')
    local count = vim.api.nvim_buf_line_count(bufnr)
    vim.api.nvim_buf_set_lines(bufnr, count, -1, false, { '+--[TO' })
    vim.api.nvim_win_set_cursor(0, { count + 1, 6 })
    local client = require('ladder.server').of(bufnr)
    local params = vim.lsp.util.make_position_params(0, client.offset_encoding)
    local answer = client:request_sync('textDocument/completion', params, 2000, bufnr)
    local items = vim.lsp.completion._lsp_to_complete_items(answer.result, '[TO', client.id)
    local timer = vim.iter(items):find(function(item)
      return item.abbr == '[TON]'
    end)
    assert(timer, vim.inspect(vim.tbl_map(function(item)
      return item.abbr
    end, items)))
    t.equal('the word that stands for it while it is chosen', '[TON]', timer.word)
  end)

  t.step('lenses start simulations and count jumps', function()
    local bufnr = t.open('motor.clad')
    vim.api.nvim_buf_set_lines(bufnr, -1, -1, false, { '+--<JMP>( out )--+', '+--<LBL>( out )--+' })
    local client = require('ladder.server').of(bufnr)
    local lenses = client:request_sync('textDocument/codeLens', {
      textDocument = vim.lsp.util.make_text_document_params(bufnr),
    }, 2000, bufnr).result
    local titles = {}
    for _, lens in ipairs(lenses) do
      if not lens.command then
        lens = client:request_sync('codeLens/resolve', lens, 2000, bufnr).result
        client:exec_cmd(lens.command, { bufnr = bufnr })
      end
      table.insert(titles, lens.command.title)
    end
    t.equal('the lenses', { 'Start simulation', '1 jump' }, titles)
    t.equal('the places in the quickfix list', 1, #vim.fn.getqflist())
    vim.cmd('cclose')
    client:exec_cmd(lenses[1].command, { bufnr = bufnr })
    assert(ladder.wait(bufnr), 'no answer')
    t.equal('the status', 'paused', ladder.state(bufnr).status)
    vim.cmd('Ladder stop')
  end)

  t.step('rename changes every place and draws the networks again', function()
    local bufnr = t.open('motor.clad')
    vim.fn.cursor(6, 9)
    vim.lsp.buf.rename('motor_is_running')
    local lines = t.eventually('the new name', function()
      local lines = vim.api.nvim_buf_get_lines(bufnr, 0, -1, false)
      return lines[2]:find('motor_is_running', 1, true) and lines
    end)
    t.equal('the drawing', {
      '+--\\--[ ]( start )-------------\\--[/]( stop )---------( )( motor_is_running )--+',
    }, { lines[2] })
  end)

  t.step('a name that an extraction makes up can be typed at once', function()
    local bufnr = t.open('motor.clad')
    -- Another name that begins alike is above.
    vim.api.nvim_buf_set_lines(bufnr, 0, 0, false, { '+--<CALL>( function_10 )--+' })
    vim.api.nvim_buf_set_lines(bufnr, -1, -1, false, { '', '+--<FUN>( function_10 )--( )( other )--+' })
    vim.api.nvim_win_set_cursor(0, { 7, 4 })
    local input, asked = vim.ui.input, nil
    vim.ui.input = function(options, done)
      asked = options.default
      done('WarmUp')
    end
    vim.lsp.buf.code_action({ apply = true, context = { only = { 'refactor.extract' } }, filter = function(action)
      return vim.startswith(action.title, 'Extract the network into the function')
    end })
    local function has(text)
      return table.concat(vim.api.nvim_buf_get_lines(bufnr, 0, -1, false), '\n'):find(text, 1, true)
    end
    t.eventually('the new name', function()
      return has('<CALL>( WarmUp )') and has('<FUN>( WarmUp )')
    end)
    vim.ui.input = input
    t.equal('the name that was made up', 'function_1', asked)
    vim.cmd('bwipeout!')
  end)

  t.step('the outline names networks by the comments above them', function()
    t.open('motor.clad')
    vim.lsp.buf.document_symbol({
      on_list = function(list)
        vim.b.outline = vim.tbl_map(function(item)
          return item.text
        end, list.items)
      end,
    })
    local outline = t.eventually('the outline', function()
      return vim.b.outline
    end)
    t.equal('the outline', {
      '[Object] Größe: a motor with a seal-in contact, and a lamp when it has warmed up',
      '[Object] Network 2',
    }, outline)
  end)

  t.step('the definition of a block of the library is its source', function()
    local bufnr = t.open('motor.clad')
    vim.api.nvim_buf_set_lines(bufnr, 0, -1, false, { '+--[$Debounce]( button )--( )( y )--+' })
    vim.api.nvim_win_set_cursor(0, { 1, 6 })
    vim.lsp.buf.definition()
    t.eventually('the source', function()
      return vim.api.nvim_buf_get_name(0) == 'ladder-library:/Debounce.clad'
    end)
    t.equal('its first line', true, vim.api.nvim_buf_get_lines(0, 0, 1, false)[1]:find('^# A signal') ~= nil)
    t.equal('what it is', { 'clad', 'nofile', false }, { vim.bo.filetype, vim.bo.buftype, vim.bo.modifiable })
    vim.cmd('bwipeout!')
    vim.cmd('edit! motor.clad')
  end)

  t.step(':checkhealth ladder finds the server', function()
    t.open('motor.clad')
    vim.cmd('silent checkhealth ladder')
    local report = table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, false), '\n')
    assert(report:find('Language server: ladder', 1, true), report)
    assert(not report:find('ERROR', 1, true), report)
    vim.cmd('bwipeout')
  end)
end
