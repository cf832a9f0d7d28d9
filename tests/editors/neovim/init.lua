-- A user's configuration in three lines: the plugin on the runtimepath and the server where the build put it.
vim.opt.runtimepath:prepend(vim.env.LADDER_ROOT .. '/editors/neovim')
vim.lsp.config('ladder', { cmd = { vim.env.LADDER_BIN, 'lsp' } })
vim.opt.swapfile = false
-- What is counted in scans begins with the first.
vim.g.ladder_start_paused = true
