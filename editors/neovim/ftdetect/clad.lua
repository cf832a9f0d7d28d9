-- `.ld` is left alone on purpose: it belongs to linker scripts.
vim.filetype.add({ extension = { clad = 'clad', ['ladder-test'] = 'laddertest' } })
