-- Scenarios are timing diagrams: what would shift their columns is switched off.
if vim.b.did_ftplugin then
  return
end
vim.b.did_ftplugin = true

local set = vim.opt_local
set.commentstring = '# %s'
set.comments = ':#'
set.wrap = false
set.expandtab = true
set.virtualedit = 'block'
set.textwidth = 0

require('ladder.margin').keep()
require('ladder.completion').attach(vim.api.nvim_get_current_buf())
require('ladder.dap').register_if_there()

vim.b.undo_ftplugin = 'setlocal commentstring< comments< wrap< expandtab< virtualedit< textwidth< signcolumn<'
