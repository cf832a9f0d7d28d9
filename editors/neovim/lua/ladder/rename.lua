--- Asks for another name in the place of one that a code action has made up.
--- @param uri string of the program
--- @param name string
return function(uri, name)
  local bufnr = vim.uri_to_bufnr(uri)
  -- Not in `function_10`, nor in `$function_1`.
  local whole = '%f[%w_$]' .. vim.pesc(name) .. '%f[^%w_]'
  for row, line in ipairs(vim.api.nvim_buf_get_lines(bufnr, 0, -1, false)) do
    local at = line:find(whole)
    if at and vim.api.nvim_get_current_buf() == bufnr then
      vim.cmd("normal! m'")
      vim.api.nvim_win_set_cursor(0, { row, at - 1 })
      return vim.lsp.buf.rename()
    end
  end
end
