--- Says to the server in which line a person types, so that the findings of a half-typed rung wait.
local M = {}

--- @param client vim.lsp.Client
--- @param bufnr integer
function M.attach(client, bufnr)
  if not vim.list_contains(vim.tbl_get(client.server_capabilities, 'executeCommandProvider', 'commands') or {}, 'ladder.cursor') then
    return
  end
  local said
  local group = vim.api.nvim_create_augroup('ladder.cursor.' .. bufnr, { clear = true })
  --- @param line integer|nil from 0
  local function say(line)
    if line == said or client:is_stopped() then
      return
    end
    said = line
    -- A request, not a notification: before it Neovim sends the changes that it has gathered.
    local argument = { uri = vim.uri_from_bufnr(bufnr), line = line or vim.NIL }
    require('ladder.server').command(client, bufnr, 'ladder.cursor', argument, function() end)
  end
  local function on(events, callback)
    vim.api.nvim_create_autocmd(events, { group = group, buffer = bufnr, callback = callback })
  end
  on({ 'InsertEnter', 'CursorMovedI' }, function()
    say(vim.api.nvim_win_get_cursor(0)[1] - 1)
  end)
  on('InsertLeave', function()
    say(nil)
  end)
  on('LspDetach', function(event)
    if event.data.client_id == client.id then
      vim.api.nvim_del_augroup_by_id(group)
    end
  end)
end

return M
