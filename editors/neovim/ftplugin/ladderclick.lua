-- A Click program is a Python file, and edited as one.
vim.treesitter.language.register('python', 'ladderclick')
vim.cmd.runtime('ftplugin/python.vim')
