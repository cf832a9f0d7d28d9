--- Completion as Neovim's own client does it, made fit for a drawing.
---
--- - A list inserts nothing before something is chosen: what Neovim puts in by itself would be a block more.
--- - An edit of the client reaches to the cursor only. What it should replace after the cursor, as the `]` of `[TO]`,
---   the server names with the command `ladder.completion.cut`.
--- - An answer that comes after something was chosen opens no new list, which would leave the bare word in the text.
--- - |i_CTRL-X_CTRL-O| inserts whole proposals also where `vim.lsp.completion` was not enabled.
local M = {}

--- The items of 'completeopt' that leave the text alone until something is chosen.
--- @param value string
--- @return string
local function calm(value)
  local items = vim.split(value, ',', { trimempty = true })
  items = vim.tbl_filter(function(item)
    -- The longest common beginning of blocks is half a block.
    return item ~= 'longest' and item ~= 'menu'
  end, items)
  if not vim.list_contains(items, 'menuone') then
    table.insert(items, 'menuone')
  end
  if not vim.list_contains(items, 'noinsert') and not vim.list_contains(items, 'noselect') then
    table.insert(items, 'noselect')
  end
  return table.concat(items, ',')
end

--- Whether Neovim's own client completes what was chosen in this buffer.
local function is_enabled(bufnr)
  local group = ('nvim.lsp.completion_%d'):format(bufnr)
  local known, found = pcall(vim.api.nvim_get_autocmds, { group = group, event = 'CompleteDone' })
  return known and #found > 0
end

--- Cuts a text that is after what was inserted. `before` is the rest of its line.
--- @param argument { cut: string, before: string }
--- @param bufnr integer
function M.cut(argument, bufnr)
  local tail = argument.cut .. argument.before
  local row = vim.api.nvim_win_get_cursor(0)[1] - 1
  -- A proposal of several lines ends below the cursor.
  for index, line in ipairs(vim.api.nvim_buf_get_lines(bufnr, row, row + 20, false)) do
    if vim.endswith(line, tail) then
      local at, to = #line - #tail, #line - #argument.before
      vim.api.nvim_buf_set_text(bufnr, row + index - 1, at, row + index - 1, to, {})
      return
    end
  end
end

--- Puts in the whole of a proposal whose word was chosen.
local function insert_whole(bufnr)
  local chosen = vim.tbl_get(vim.v.completed_item, 'user_data', 'nvim', 'lsp')
  local item = chosen and chosen.completion_item
  local client = chosen and vim.lsp.get_client_by_id(chosen.client_id)
  if not client or client.name ~= 'ladder' or not item.textEdit then
    return
  end
  if item.insertTextFormat == vim.lsp.protocol.InsertTextFormat.Snippet then
    local start = item.textEdit.range.start
    local row, column = unpack(vim.api.nvim_win_get_cursor(0))
    local line = vim.api.nvim_get_current_line()
    local from = vim.str_byteindex(line, client.offset_encoding, start.character, false)
    vim.api.nvim_buf_set_text(bufnr, row - 1, from, row - 1, column, {})
    vim.snippet.expand(item.textEdit.newText)
  end
  if item.command then
    client:exec_cmd(item.command, { bufnr = bufnr })
  end
end

--- Whether the person has chosen one of the list that is open.
local function is_chosen()
  if vim.fn.pumvisible() == 0 then
    return false
  end
  -- Where Neovim itself begins with the first one, that is not a choice yet.
  local first = vim.list_contains(vim.split(vim.bo.completeopt, ','), 'noselect') and 0 or 1
  return vim.fn.complete_info({ 'selected' }).selected >= first
end

--- The clients whose requests are followed, by their numbers.
local followed = {}

--- Keeps a list in which something was chosen from answers to earlier keys.
--- @param client vim.lsp.Client
function M.follow(client)
  if followed[client.id] then
    return
  end
  followed[client.id] = true
  local request = client.request
  client.request = function(self, method, params, handler, bufnr)
    if method ~= 'textDocument/completion' or not handler then
      return request(self, method, params, handler, bufnr)
    end
    return request(self, method, params, function(...)
      if not is_chosen() then
        return handler(...)
      end
    end, bufnr)
  end
end

--- @param bufnr integer
function M.attach(bufnr)
  local group = vim.api.nvim_create_augroup('ladder.completion.' .. bufnr, { clear = true })
  local function settle()
    local value = calm(vim.go.completeopt)
    if vim.bo[bufnr].completeopt ~= value then
      vim.bo[bufnr].completeopt = value
    end
  end
  settle()
  vim.api.nvim_create_autocmd('OptionSet', { group = group, pattern = 'completeopt', callback = settle })
  vim.api.nvim_create_autocmd('CompleteDone', {
    group = group,
    buffer = bufnr,
    callback = function()
      if vim.v.event.reason == 'accept' and not is_enabled(bufnr) then
        insert_whole(bufnr)
      end
    end,
  })
  vim.api.nvim_create_autocmd('BufWipeout', {
    group = group,
    buffer = bufnr,
    once = true,
    callback = function()
      pcall(vim.api.nvim_del_augroup_by_id, group)
    end,
  })
end

return M
