-- A ladder file is a drawing: what would shift its columns is switched off.
if vim.b.did_ftplugin then
  return
end
vim.b.did_ftplugin = true

local set = vim.opt_local
set.commentstring = '# %s #'
set.comments = ''
set.wrap = false
set.expandtab = true
set.tabstop = 4
set.shiftwidth = 4
set.virtualedit = 'block'
-- No breaking of long lines and no joining of comments while typing: both would cut a rung in two.
set.textwidth = 0
set.formatoptions:remove({ 't', 'c', 'r', 'o' })
set.conceallevel = 0
set.spell = false
-- `$` begins the name of a user-defined block.
set.iskeyword:append('$')
set.matchpairs = '(:),[:]'

vim.b.undo_ftplugin = table.concat({
  'setlocal commentstring< comments< wrap< expandtab< tabstop< shiftwidth< virtualedit<',
  'setlocal textwidth< formatoptions< conceallevel< spell< iskeyword< matchpairs<',
}, ' | ')
