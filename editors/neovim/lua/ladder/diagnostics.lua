--- Diagnostics of the server: asked for again when a change in one file may concern another, and shown in the text.
local M = {}

--- The namespaces whose messages are shown already.
--- @type table<integer, true>
local shown = {}

--- Whether the user has decided how messages are shown. What Neovim itself has by default is off, as if they had said so.
local function is_decided()
  local config = vim.diagnostic.config() or {}
  return vim.g.ladder_virtual_text == false or config.virtual_text or config.virtual_lines
end

--- Has the messages of the server at the ends of their lines, the most severe of a line in words. With Neovim's defaults only
--- a sign is shown, and that of a warning hides the error of the same line.
function M.show_in_text()
  vim.api.nvim_create_autocmd('DiagnosticChanged', {
    group = vim.api.nvim_create_augroup('ladder.diagnostics', { clear = true }),
    callback = function(event)
      for _, diagnostic in ipairs(event.data.diagnostics) do
        local namespace = diagnostic.namespace
        if diagnostic.source == 'ladder' and not shown[namespace] then
          shown[namespace] = true
          vim.diagnostic.config({ severity_sort = true }, namespace)
          if not is_decided() then
            vim.diagnostic.config({ virtual_text = true }, namespace)
          end
        end
      end
    end,
  })
end

--- @param client_id integer
function M.refresh(client_id)
  local client = vim.lsp.get_client_by_id(client_id)
  if not client then
    return
  end
  for bufnr in pairs(client.attached_buffers) do
    local params = { textDocument = vim.lsp.util.make_text_document_params(bufnr) }
    client:request('textDocument/diagnostic', params, nil, bufnr)
  end
end

return M
