--- The sources of the library's blocks, to which a definition leads: no files, the server has their text.

--- Fills a buffer whose name is such an address: `ladder-library:/Debounce.clad`.
--- @param bufnr integer
--- @param address string
return function(bufnr, address)
  local client = vim.lsp.get_clients({ name = 'ladder' })[1]
  local block = '$' .. vim.fs.basename(address):gsub('%.clad$', '')
  local params = { command = 'ladder.libraryBlock', arguments = { { block = block } } }
  local answer = client and client:request_sync('workspace/executeCommand', params, 2000)
  if not (answer and answer.result) then
    return vim.notify('ladder: no language server has the source of ' .. block .. '.', vim.log.levels.ERROR)
  end
  vim.api.nvim_buf_set_lines(bufnr, 0, -1, false, vim.split(vim.trim(answer.result.text), '\n'))
  -- To look at: no server is asked about it, and nothing is written.
  vim.bo[bufnr].buftype = 'nofile'
  vim.bo[bufnr].modifiable = false
  vim.bo[bufnr].filetype = 'clad'
end
