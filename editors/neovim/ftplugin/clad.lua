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

require('ladder.margin').keep()
require('ladder.dap').register_if_there()
require('ladder.completion').attach(vim.api.nvim_get_current_buf())

-- The editor's own `gc` would put a `#` around a `#`.
if not vim.g.no_plugin_maps and not vim.g.no_clad_maps then
  local function map(modes, keys, action, description)
    vim.keymap.set(modes, keys, action, { buffer = true, expr = true, desc = description })
  end
  map({ 'n', 'x' }, 'gc', function()
    return require('ladder.comment').start()
  end, 'Toggle comment')
  require('ladder.edit').map(vim.api.nvim_get_current_buf())
  require('ladder.tab').map()
  map('n', 'gcc', function()
    return require('ladder.comment').start() .. '_'
  end, 'Toggle comment line')
end

vim.b.undo_ftplugin = table.concat({
  'setlocal commentstring< comments< wrap< expandtab< tabstop< shiftwidth< virtualedit<',
  'setlocal textwidth< formatoptions< conceallevel< spell< iskeyword< matchpairs< completeopt< signcolumn<',
  "lua pcall(vim.api.nvim_del_augroup_by_name, 'ladder.completion.' .. vim.api.nvim_get_current_buf())",
  'silent! nunmap <buffer> gc',
  'silent! xunmap <buffer> gc',
  'silent! nunmap <buffer> gcc',
  'silent! iunmap <buffer> <Tab>',
}, ' | ')
