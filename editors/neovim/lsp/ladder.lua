-- What `vim.lsp.enable('ladder')` starts. Change parts of it with `vim.lsp.config('ladder', { ... })`.
return {
  cmd = { 'ladder', 'lsp' },
  filetypes = { 'clad' },
  root_markers = { 'ladder.toml', '.git' },
  handlers = {
    ['ladder/simulationState'] = function(_, state, context)
      require('ladder.simulation').receive(state, context.client_id)
    end,
  },
}
