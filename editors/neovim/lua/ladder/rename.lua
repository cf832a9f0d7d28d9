--- Asks for another name in the place of one that a code action has made up.
--- @param uri string of the program
--- @param name string
return function(uri, name)
  local bufnr = vim.uri_to_bufnr(uri)
  for row, line in ipairs(vim.api.nvim_buf_get_lines(bufnr, 0, -1, false)) do
    local at = line:find(name, 1, true)
    if at and vim.api.nvim_get_current_buf() == bufnr then
      vim.cmd("normal! m'")
      vim.api.nvim_win_set_cursor(0, { row, at - 1 })
      return vim.lsp.buf.rename()
    end
  end
end
