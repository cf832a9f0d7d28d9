-- Programs of other systems, shown as ladder text and the other way round.
return function(t, messages)
  t.step(':Ladder convert shows a program of another system as ladder text', function()
    vim.cmd.edit(vim.env.LADDER_FIXTURES .. '/motor.rung')
    local bufnr = vim.api.nvim_get_current_buf()
    vim.cmd('Ladder convert')
    t.eventually('another buffer', function()
      return vim.api.nvim_get_current_buf() ~= bufnr and vim.bo.filetype == 'clad'
    end)
    local lines = vim.api.nvim_buf_get_lines(0, 0, -1, false)
    t.equal('the last line', '|  /--[ ]( Q0 )--[ ]( M1 )--/                                                  |', lines[#lines])
    -- There is a motor.clad already.
    t.equal('its name', 'motor-2.clad', vim.fs.basename(vim.api.nvim_buf_get_name(0)))
    t.equal('the message', 'ladder: 4 translated, 0 approximated, 0 refused', messages[#messages])
    local remark = vim.fn.getqflist()[1]
    t.equal('where the remark is', bufnr, remark.bufnr)
    t.equal('the place of the remark', { 1, 8 }, { remark.lnum, remark.col })
    vim.cmd('cclose | bwipeout!')
  end)

  t.step(':Ladder convert takes what the buffer shows, and says what is wrong', function()
    vim.cmd.edit(vim.env.LADDER_FIXTURES .. '/motor.rung')
    local bufnr = vim.api.nvim_get_current_buf()
    vim.api.nvim_buf_set_lines(bufnr, 0, 1, false, { 'start open I0.1 end' })
    vim.cmd('Ladder convert')
    t.eventually('a message', function()
      return messages[#messages]:find('motor.rung:1:7', 1, true)
    end)
    vim.cmd('bwipeout!')
  end)

  t.step(':Ladder convert shows ladder text in another notation', function()
    t.open('motor.clad')
    local bufnr = vim.api.nvim_get_current_buf()
    t.equal('the notations', true, vim.tbl_contains(require('ladder.convert').notations(bufnr), 'textbook'))
    vim.cmd('Ladder convert cplc-draft')
    t.eventually('another buffer', function()
      return vim.api.nvim_get_current_buf() ~= bufnr
    end)
    t.equal('its beginning', 'IN = {', vim.api.nvim_buf_get_lines(0, 0, 1, false)[1]:sub(1, 6))
    vim.cmd('cclose | bwipeout!')
  end)
end
