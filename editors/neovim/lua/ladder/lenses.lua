--- What the lenses above networks do that Neovim does not do by itself.
local M = {}

--- Lists the places that a lens has counted in the quickfix list.
--- @param command lsp.Command its arguments are an address, a position and the places
--- @param context { bufnr: integer, client_id: integer }
function M.show(command, context)
  local client = vim.lsp.get_client_by_id(context.client_id)
  local encoding = client and client.offset_encoding or 'utf-16'
  local items = vim.lsp.util.locations_to_items(command.arguments[3], encoding)
  if #items == 0 then
    return vim.notify('ladder: ' .. command.title)
  end
  vim.fn.setqflist({}, ' ', { title = 'Ladder: ' .. command.title, items = items })
  vim.cmd('botright copen')
end

return M
