-- What the picture is taken with: the plugin, its server, and findings shown in words.
vim.opt.runtimepath:prepend(vim.env.LADDER_ROOT .. '/editors/neovim')
vim.lsp.config('ladder', { cmd = { vim.env.LADDER_BIN, 'lsp' } })
vim.diagnostic.config({
  virtual_lines = {
    format = function(diagnostic)
      return vim.split(diagnostic.message, '\n')[1]
    end,
  },
})
vim.opt.termguicolors = true
vim.opt.background = vim.g.ground or 'dark'
vim.opt.swapfile = false
vim.opt.ruler = false
vim.opt.hlsearch = false
vim.opt.laststatus = 2
vim.opt.scrolloff = 0
vim.opt.showmode = false
vim.opt.shortmess:append('FI')
vim.opt.fillchars = { eob = ' ' }
