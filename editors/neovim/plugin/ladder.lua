-- Nothing of the plugin's own code is loaded here: the server waits for the first ladder file, the rest for `:Ladder`.
if vim.g.loaded_ladder then
  return
end
vim.g.loaded_ladder = true

if vim.fn.has('nvim-0.11') == 0 then
  vim.api.nvim_echo({ { 'ladder: this plugin needs Neovim 0.11 or later', 'WarningMsg' } }, true, {})
  return
end

if vim.g.ladder_enable ~= false then
  vim.lsp.enable('ladder')
end

local group = vim.api.nvim_create_augroup('ladder', { clear = true })

-- Neovim passes by a server without a program, and says nothing.
vim.api.nvim_create_autocmd('FileType', {
  group = group,
  pattern = { 'clad', 'ladderclick', 'laddertest' },
  callback = function()
    if vim.lsp.is_enabled('ladder') then
      require('ladder.missing').watch()
    end
  end,
})

vim.api.nvim_create_autocmd('FileType', {
  group = group,
  pattern = { 'clad', 'ladderclick', 'laddertest' },
  once = true,
  callback = function()
    require('ladder.diagnostics').show_in_text()
  end,
})

vim.api.nvim_create_autocmd('LspAttach', {
  group = group,
  callback = function(event)
    local client = vim.lsp.get_client_by_id(event.data.client_id)
    if client and client.name == 'ladder' then
      require('ladder.version').check(client)
      require('ladder.completion').follow(client)
    end
    if client and client.name == 'ladder' and vim.list_contains({ 'clad', 'laddertest' }, vim.bo[event.buf].filetype) then
      require('ladder.align').attach(client, event.buf)
    end
    if client and client.name == 'ladder' and vim.bo[event.buf].filetype == 'clad' then
      require('ladder.colours').attach(client, event.buf)
      require('ladder.drawing').attach(client, event.buf)
      require('ladder.cursor').attach(client, event.buf)
    end
  end,
})

vim.api.nvim_create_autocmd('BufReadCmd', {
  group = group,
  pattern = 'ladder-library:/*',
  callback = function(event)
    require('ladder.library')(event.buf, event.match)
  end,
})

vim.api.nvim_create_user_command('LadderClick', function()
  require('ladder.click').open(vim.api.nvim_get_current_buf())
end, { desc = 'Open this Python file as a Click program' })

vim.api.nvim_create_user_command('Ladder', function(arguments)
  require('ladder.command').run(arguments.fargs)
end, {
  nargs = '*',
  desc = 'Simulate the ladder program in this buffer',
  complete = function(lead, line, position)
    return require('ladder.command').complete(lead, line:sub(1, position))
  end,
})
