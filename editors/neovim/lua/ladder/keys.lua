--- The keys of a simulation, in the buffer of the program while it is simulated. A key that has a mapping there already
--- keeps it.
local M = {}

--- @type { [1]: string, [2]: string, [3]: string }[] key, subcommand of `:Ladder`, what it does
M.all = {
  { '<F4>', 'toggle', 'toggle the tag under the cursor' },
  { '<S-F4>', 'why', 'why has the tag under the cursor its value' },
  { '<F5>', 'run', 'run' },
  { '<F6>', 'pause', 'pause' },
  { '<F8>', 'back', 'one scan back' },
  { '<F9>', 'break', 'breakpoint on this rung' },
  { '<F10>', 'step', 'one scan' },
  { '<F11>', 'block', 'one block' },
}

--- What was mapped here, by buffer.
--- @type table<integer, string[]>
local mapped = {}

--- @param bufnr integer
function M.map(bufnr)
  if vim.g.no_plugin_maps or vim.g.no_clad_maps or mapped[bufnr] then
    return
  end
  mapped[bufnr] = {}
  for _, key in ipairs(M.all) do
    local taken = vim.api.nvim_buf_call(bufnr, function()
      return vim.fn.mapcheck(key[1], 'n') ~= ''
    end)
    if not taken then
      vim.keymap.set('n', key[1], '<Cmd>Ladder ' .. key[2] .. '<CR>', { buffer = bufnr, desc = 'Ladder: ' .. key[3] })
      table.insert(mapped[bufnr], key[1])
    end
  end
end

--- @param bufnr integer
function M.unmap(bufnr)
  for _, key in ipairs(mapped[bufnr] or {}) do
    pcall(vim.keymap.del, 'n', key, { buffer = bufnr })
  end
  mapped[bufnr] = nil
end

return M
