--- Scenario files in Neovim: completion, hover, the way to the program, rename, and columns that are aligned on a write.
local PROGRAM = {
  'VAR_INPUT',
  '    start : BOOL;',
  'END_VAR',
  'VAR_OUTPUT',
  '    run : BOOL;',
  'END_VAR',
  '',
  '+--[ ]( start )--------------( )( run )--+',
}
local SCENARIOS = { 'program it.clad', 'step 100ms', '', 'scenario "it starts"', 'start _-_', 'run => _--' }

return function(t)
  --- Opens the scenarios, and waits for the server.
  local function open()
    local folder = vim.fn.tempname()
    vim.fn.mkdir(folder, 'p')
    vim.fn.writefile({}, folder .. '/ladder.toml')
    vim.fn.writefile(PROGRAM, folder .. '/it.clad')
    vim.fn.writefile(SCENARIOS, folder .. '/it.ladder-test')
    vim.cmd.edit(folder .. '/it.ladder-test')
    t.eventually('the server', function()
      return vim.lsp.get_clients({ bufnr = 0, name = 'ladder' })[1]
    end)
    return folder
  end

  local function ask(method, line, column, more)
    local params = vim.tbl_extend('force', {
      textDocument = vim.lsp.util.make_text_document_params(0),
      position = { line = line, character = column },
    }, more or {})
    local answers = vim.lsp.buf_request_sync(0, 'textDocument/' .. method, params, 5000) or {}
    local _, answer = next(answers)
    return assert(answer, method).result
  end

  t.step('in a scenario file tags are proposed and shown, and lead to the program', function()
    open()
    local list = ask('completion', 4, 0)
    local labels = vim.tbl_map(function(item)
      return item.label
    end, list.items)
    assert(vim.list_contains(labels, 'start') and vim.list_contains(labels, 'scenario'), vim.inspect(labels))
    local said = ask('hover', 5, 1).contents.value
    assert(said:find('run : BOOL', 1, true), said)
    vim.api.nvim_win_set_cursor(0, { 6, 0 })
    vim.lsp.buf.definition()
    t.eventually('the declaration', function()
      return vim.fs.basename(vim.api.nvim_buf_get_name(0)) == 'it.clad' and vim.api.nvim_win_get_cursor(0)[1] == 5
    end)
    vim.cmd('bwipeout!')
  end)

  t.step('in a row the tags of a file that the program uses are proposed after its name', function()
    local keys = require('typing').open(t, { '+--<CALL>( count )--( )( run )--+' }, {}, {
      ['lib.clad'] = {
        'VAR',
        '    total : DINT;  warm : TON;  spare : INT;',
        'END_VAR',
        '+--<FUN>( count )--[INC]( total )--[TON]( warm, 5s )--<RET>--+',
      },
      ['typed.ladder-test'] = { 'program typed.clad', 'scenario "it counts"', '' },
    })
    keys:press(':edit ' .. vim.fs.dirname(keys.file) .. '/typed.ladder-test<CR>')
    t.eventually('the server', function()
      return keys:lua([[return #vim.lsp.get_clients({ bufnr = 0, name = 'ladder' }) == 1 and vim.bo.filetype == 'laddertest']])
    end)
    keys:press('Golib.w<C-x><C-o>')
    keys:choose('lib.warm.ET')
    keys:expect('the row', { 'program typed.clad', 'scenario "it counts"', '', 'lib.warm.ET => ' })
    keys:press('<C-x><C-o>')
    keys:choose('100ms')
    keys:expect('the row', { 'program typed.clad', 'scenario "it counts"', '', 'lib.warm.ET => 100ms' })
    keys:close()
  end)

  t.step('a name follows from a scenario into the program', function()
    local folder = open()
    vim.api.nvim_win_set_cursor(0, { 6, 0 })
    vim.lsp.buf.rename('motor_runs')
    t.eventually('the row', function()
      return vim.api.nvim_buf_get_lines(0, 5, 6, false)[1]:find('^motor_runs +=> _%-%-$')
    end)
    local program = vim.fn.bufnr(folder .. '/it.clad')
    local text = table.concat(vim.api.nvim_buf_get_lines(program, 0, -1, false), '\n')
    assert(text:find('motor_runs : BOOL', 1, true), text)
    vim.cmd('bwipeout!')
  end)

  t.step('a scenario file is aligned when it is written, where that is wanted', function()
    open()
    vim.g.ladder_format_on_save = true
    vim.cmd('silent write')
    vim.g.ladder_format_on_save = nil
    t.equal('the rows', { 'start    _-_', 'run   => _--' }, vim.api.nvim_buf_get_lines(0, 4, 6, false))
    vim.cmd('bwipeout!')
  end)

  t.step('inputs, outputs, contacts, coils and blocks have highlights of their own', function()
    t.open('motor.clad')
    local wanted = {
      ['@lsp.typemod.variable.input.clad'] = 'LadderInput',
      ['@lsp.typemod.variable.output.clad'] = 'LadderOutput',
      cladContact = 'LadderContact',
      cladCoil = 'LadderCoil',
      cladBlock = 'LadderBlock',
      cladTag = 'LadderTag',
    }
    for name, link in pairs(wanted) do
      t.equal(name, link, vim.api.nvim_get_hl(0, { name = name }).link)
    end
    local seen = {}
    for _, name in ipairs({ 'Input', 'Output', 'Tag', 'Contact', 'Coil', 'Block' }) do
      local look = vim.inspect(vim.api.nvim_get_hl(0, { name = 'Ladder' .. name, link = false }))
      assert(not seen[look], ('Ladder%s looks like %s'):format(name, seen[look]))
      seen[look] = 'Ladder' .. name
    end
  end)
end
