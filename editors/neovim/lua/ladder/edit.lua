--- Keys that draw: a contact, a coil, a block, a branch; a block moved or deleted. Each is one step of undo.
local change = require('ladder.change')

local M = {}

--- The keys after |<LocalLeader>|, what each does, and how it is called.
M.keys = {
  { 'c', 'contact', 'Put in a contact' },
  { 'C', 'closedContact', 'Put in a closed contact' },
  { 'q', 'coil', 'Put in a coil' },
  { 'f', 'block', 'Put in a block' },
  { 'b', 'branch', 'Draw a branch around it' },
  { 'e', 'invert', 'Make it its opposite' },
  { 'd', 'delete', 'Delete it with its wire' },
  { 'h', 'left', 'Move it left' },
  { 'l', 'right', 'Move it right' },
  { 'k', 'up', 'Move it to the rung above' },
  { 'j', 'down', 'Move it to the rung below' },
}

--- The cursor, or what is selected.
local function range_here(client, bufnr)
  local window = vim.api.nvim_get_current_win()
  if not vim.fn.mode():match('^[vV\22]') then
    local place = vim.lsp.util.make_position_params(window, client.offset_encoding).position
    return { start = place, ['end'] = place }
  end
  local first, last = vim.fn.getpos('v'), vim.fn.getpos('.')
  if first[2] > last[2] or (first[2] == last[2] and first[3] > last[3]) then
    first, last = last, first
  end
  vim.api.nvim_feedkeys(vim.keycode('<Esc>'), 'nx', false)
  local params = vim.lsp.util.make_given_range_params(
    { first[2], first[3] - 1 },
    { last[2], last[3] - 1 },
    bufnr,
    client.offset_encoding
  )
  return params.range
end

--- @param edit string one of those in `M.keys`
function M.run(edit)
  local bufnr = vim.api.nvim_get_current_buf()
  local client = require('ladder.server').of(bufnr)
  local argument = { range = client and range_here(client, bufnr), edit = edit }
  change.make(bufnr, 'ladder.edit', argument, function(made, client)
    local cursor = made.cursor
    if cursor and vim.api.nvim_get_current_buf() == bufnr then
      local line = vim.api.nvim_buf_get_lines(bufnr, cursor.line, cursor.line + 1, false)[1] or ''
      local column = vim.str_byteindex(line, client.offset_encoding, cursor.character, false)
      vim.api.nvim_win_set_cursor(0, { cursor.line + 1, column })
    end
  end)
end

--- Maps the keys in a buffer.
--- @param bufnr integer
function M.map(bufnr)
  for _, key in ipairs(M.keys) do
    vim.keymap.set({ 'n', 'x' }, '<LocalLeader>' .. key[1], function()
      M.run(key[2])
    end, { buffer = bufnr, desc = key[3] })
  end
end

return M
