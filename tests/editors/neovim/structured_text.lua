-- Structured Text, which a simulation runs as it is.
return function(t)
  local ladder = require('ladder')

  t.step('a simulation of Structured Text shows values beside its names', function()
    local file = vim.env.LADDER_SCRATCH .. '/counter.st'
    vim.fn.writefile({
      '(* counts *)',
      'PROGRAM Counter',
      'VAR go : BOOL; n, m : INT; END_VAR',
      '    IF go THEN n := n + 1; END_IF;',
      '    m := n * 2;',
      'END_PROGRAM',
    }, file)
    vim.cmd.edit(file)
    local bufnr = vim.api.nvim_get_current_buf()
    t.equal('the file type', 'ladderst', vim.bo.filetype)
    vim.g.ladder_start_paused = true
    vim.cmd('Ladder start')
    assert(ladder.wait(), 'no answer to the start')
    vim.cmd('Ladder set go TRUE')
    vim.cmd('Ladder step 3')
    assert(ladder.wait(), 'no answer to the step')
    local client = vim.lsp.get_clients({ bufnr = bufnr, name = 'ladder' })[1]
    local params = { textDocument = { uri = vim.uri_from_bufnr(bufnr) }, position = { line = 4, character = 4 } }
    local hover = client:request_sync('textDocument/hover', params, 5000, bufnr)
    assert(hover.result.contents.value:find('`m` is **6**', 1, true), hover.result.contents.value)
    vim.cmd('Ladder stop')
    vim.g.ladder_start_paused = nil
  end)

  t.step('another file that is called so is nobody else\'s', function()
    local file = vim.env.LADDER_SCRATCH .. '/hello.st'
    vim.fn.writefile({ '"Smalltalk"', "Transcript showCr: 'Hello'." }, file)
    vim.cmd.edit(file)
    assert(vim.bo.filetype ~= 'ladderst', vim.bo.filetype)
  end)
end
