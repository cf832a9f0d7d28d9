-- `.ld` is left alone on purpose: it belongs to linker scripts.
vim.filetype.add({ extension = { clad = 'clad', ['ladder-test'] = 'laddertest' } })

-- Programs of other systems whose endings no other files have.
local foreign = {}
for _, extension in ipairs({ 'l5k', 'L5K', 'l5x', 'L5X', 's7dcl', 'S7DCL', 'scl', 'SCL', 'tcpou', 'TcPOU', 'TCPOU' }) do
  foreign[extension] = 'ladderforeign'
end
vim.filetype.add({ extension = foreign })

-- Structured Text by what it begins with: other languages have files called so, too.
local UNITS = { PROGRAM = true, FUNCTION = true, FUNCTION_BLOCK = true, TYPE = true, VAR_GLOBAL = true, CONFIGURATION = true }
vim.filetype.add({
  extension = {
    st = function(_, bufnr)
      local text = table.concat(vim.api.nvim_buf_get_lines(bufnr, 0, 60, false), '\n')
      text = text:gsub('%(%*.-%*%)', ' '):gsub('//[^\n]*', ' ')
      local word = text:match('^%s*([%a_]+)')
      return word and UNITS[word:upper()] and 'ladderst' or nil
    end,
  },
})
