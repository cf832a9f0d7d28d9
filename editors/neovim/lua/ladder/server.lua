--- Finds the language server of a buffer and asks it.
local M = {}

--- @param bufnr integer
--- @return vim.lsp.Client|nil
function M.of(bufnr)
  return vim.lsp.get_clients({ bufnr = bufnr, name = 'ladder' })[1]
end

--- The same, but a server that is just starting is waited for, so that `:Ladder start` may follow `:edit` at once.
--- @param bufnr integer
--- @return vim.lsp.Client|nil
function M.await(bufnr)
  local filetype = vim.bo[bufnr].filetype
  local served = filetype == 'clad' or filetype == 'ladderst' or require('ladder.click').is_foreign(bufnr)
  if served and vim.lsp.is_enabled('ladder') then
    vim.wait(2000, function()
      return M.of(bufnr) ~= nil
    end, 10)
  end
  return M.of(bufnr)
end

--- Asks for one of the simulator's commands; each takes exactly one object.
---
--- Neovim's own `exec_cmd` is passed by: it forgets to call back when a command is not in the server's list.
--- @param client vim.lsp.Client
--- @param bufnr integer
--- @param command string `ladder.simulate.step`, ...
--- @param argument table
--- @param answer fun(err: lsp.ResponseError|nil, result: any)
--- @return boolean sent false if the server has ended
function M.command(client, bufnr, command, argument, answer)
  local params = { command = command, arguments = { argument } }
  return client:request('workspace/executeCommand', params, function(err, result)
    answer(err, result)
  end, bufnr)
end

return M
