-- What `vim.lsp.enable('ladder')` starts. Change parts of it with `vim.lsp.config('ladder', { ... })`.
return {
  cmd = { require('ladder.program').command('ladder'), 'lsp' },
  filetypes = { 'clad', 'ladderclick', 'ladderforeign', 'ladderst', 'laddertest', 'toml', 'xml' },
  -- Only what a person has called a Click program is one for the server: files in Python are not sent.
  get_language_id = function(_, filetype)
    return filetype == 'ladderclick' and 'ladder-click' or filetype
  end,
  -- Of all files in TOML only ladder.toml is the server's, of those in XML only programs. A program without a project gets a
  -- server too.
  root_dir = function(bufnr, attach)
    local name = vim.fs.basename(vim.api.nvim_buf_get_name(bufnr))
    local filetype = vim.bo[bufnr].filetype
    local is_other = (filetype == 'toml' and name ~= 'ladder.toml')
      or (filetype == 'xml' and not require('ladder.click').is_foreign(bufnr))
    if not is_other then
      attach(vim.fs.root(bufnr, { 'ladder.toml', '.git' }))
    end
  end,
  -- Neovim 0.11 asks for diagnostics, but not again when another file changes them, unless it is asked to.
  capabilities = {
    workspace = {
      diagnostics = { refreshSupport = true },
      -- It applies them, and does not say so: an edit that makes a file comes in no other form.
      workspaceEdit = { documentChanges = true },
    },
    -- What lenses and code actions may do here: see `commands`.
    experimental = {
      commands = {
        'ladder.simulation.start',
        'ladder.test',
        'ladder.prove',
        'ladder.showReferences',
        'ladder.completion.cut',
        'ladder.rename',
      },
      -- Findings link the pages of their rules, which `:Ladder explain` shows.
      rulePages = true,
      -- Definitions lead into the library, whose sources the plugin opens.
      libraryBlocks = true,
    },
  },
  commands = {
    ['ladder.simulation.start'] = function(command)
      require('ladder.simulation').begin(vim.uri_to_bufnr(command.arguments[1]))
    end,
    ['ladder.test'] = function(_, context)
      require('ladder.test').run(context.bufnr)
    end,
    ['ladder.prove'] = function(command, context)
      require('ladder.prove').run(context.bufnr, command.arguments[2])
    end,
    ['ladder.showReferences'] = function(command, context)
      require('ladder.lenses').show(command, context)
    end,
    ['ladder.rename'] = function(command)
      require('ladder.rename')(command.arguments[1], command.arguments[2])
    end,
    ['ladder.completion.cut'] = function(command, context)
      require('ladder.completion').cut(command.arguments[1], context.bufnr)
    end,
  },
  handlers = {
    ['workspace/diagnostic/refresh'] = function(_, _, context)
      require('ladder.diagnostics').refresh(context.client_id)
      return vim.NIL
    end,
    ['ladder/preview'] = function(_, previewed)
      require('ladder.click').receive(previewed)
    end,
    ['ladder/fromDebugger'] = function(_, said, context)
      require('ladder.bridge').receive(said, context.client_id)
    end,
    ['ladder/simulationState'] = function(_, state, context)
      require('ladder.simulation').receive(state, context.client_id)
    end,
  },
}
