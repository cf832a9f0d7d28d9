--- Tab in insert mode on a rung: past the last place of a snippet, and wherever none is open, it leads to the end of the wire.
--- Blanks there would cut it.
local M = {}

--- Whether a line of text is drawn: rails, connectors, wires or blocks.
local function is_drawn(line)
  return line:match('^%s*[+|\\/]') or line:match('[%])>]%-') or line:match('%-[%[(<\\/+]')
end

--- Where the wire of a drawn line can go on: in front of its right rail.
local function end_of_wire(line)
  local drawn = line:gsub('%s+$', ''):gsub('%s+|$', ''):gsub('%-*%+$', '')
  return #drawn
end

--- What Tab does at the cursor, as keys.
local function keys()
  if vim.snippet and vim.snippet.active({ direction = 1 }) then
    return '<Cmd>lua vim.snippet.jump(1)<CR>'
  end
  local line = vim.api.nvim_get_current_line()
  if vim.fn.pumvisible() == 1 or not is_drawn(line) then
    return '<Tab>'
  end
  local column = vim.api.nvim_win_get_cursor(0)[2]
  local wire = end_of_wire(line)
  return ('<Cmd>call cursor(0, %d)<CR>'):format((column < wire and wire or #line) + 1)
end

--- Whether a person has mapped Tab; Neovim's own mapping leads through a snippet only.
local function is_mapped()
  local known = vim.fn.maparg('<Tab>', 'i', false, true)
  return not vim.tbl_isempty(known) and not vim.startswith(known.desc or '', 'vim.snippet.jump')
end

--- Maps Tab in the current buffer.
function M.map()
  if not is_mapped() then
    vim.keymap.set('i', '<Tab>', keys, { buffer = true, expr = true, desc = 'Next place on the rung' })
  end
end

return M
