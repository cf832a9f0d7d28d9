-- `.ld` is left alone on purpose: it belongs to linker scripts.
vim.filetype.add({ extension = { clad = 'clad', ['ladder-test'] = 'laddertest' } })

-- Programs of other systems whose endings no other files have.
local foreign = {}
for _, extension in ipairs({ 'l5k', 'L5K', 'l5x', 'L5X', 's7dcl', 'S7DCL', 'scl', 'SCL', 'tcpou', 'TcPOU', 'TCPOU' }) do
  foreign[extension] = 'ladderforeign'
end
vim.filetype.add({ extension = foreign })
