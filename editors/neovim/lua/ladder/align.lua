--- Aligns programs and scenarios when they are written, where a person wants that (`g:ladder_format_on_save`).
local M = {}

--- @param client vim.lsp.Client
--- @param bufnr integer
function M.attach(client, bufnr)
  local group = vim.api.nvim_create_augroup('ladder.align.' .. bufnr, { clear = true })
  vim.api.nvim_create_autocmd('BufWritePre', {
    group = group,
    buffer = bufnr,
    callback = function()
      if vim.g.ladder_format_on_save then
        vim.lsp.buf.format({ bufnr = bufnr, id = client.id })
      end
    end,
  })
  vim.api.nvim_create_autocmd('LspDetach', {
    group = group,
    buffer = bufnr,
    callback = function(event)
      if event.data.client_id == client.id then
        vim.api.nvim_del_augroup_by_id(group)
      end
    end,
  })
end

return M
