--- The server's colours for a long program: those of the lines that windows show.
---
--- Neovim 0.11 asks for the tokens of a whole file after every change, and takes longer to read them than a key may.
local M = {}

--- Programs of more lines than this are coloured by what is shown.
local LONG = 3000
--- Milliseconds in which changes are gathered.
local GATHER = 80

local namespace = vim.api.nvim_create_namespace('ladder_colours')

--- Marks a token as Neovim's own highlighter does.
local function mark(bufnr, filetype, row, from, to, kind, modifiers)
  local function add(group, above)
    vim.api.nvim_buf_set_extmark(bufnr, namespace, row, from, {
      hl_group = ('@lsp.%s.%s'):format(group, filetype),
      end_col = to,
      priority = vim.hl.priorities.semantic_tokens + above,
      strict = false,
    })
  end
  add('type.' .. kind, 0)
  for _, modifier in ipairs(modifiers) do
    add('mod.' .. modifier, 1)
    add(('typemod.%s.%s'):format(kind, modifier), 2)
  end
end

--- @param client vim.lsp.Client
--- @param bufnr integer
--- @param data integer[] tokens as the protocol sends them
local function draw(client, bufnr, data)
  local legend = client.server_capabilities.semanticTokensProvider.legend
  local filetype = vim.bo[bufnr].filetype
  vim.api.nvim_buf_clear_namespace(bufnr, namespace, 0, -1)
  local row, start = 0, 0
  for index = 1, #data, 5 do
    local down, right, length, kind, bits = unpack(data, index, index + 4)
    row, start = row + down, down == 0 and start + right or right
    local line = vim.api.nvim_buf_get_lines(bufnr, row, row + 1, false)[1] or ''
    local function byte(character)
      return vim.str_byteindex(line, client.offset_encoding, character, false)
    end
    local modifiers = {}
    for number, name in ipairs(legend.tokenModifiers) do
      if bit.band(bits, bit.lshift(1, number - 1)) ~= 0 then
        table.insert(modifiers, name)
      end
    end
    mark(bufnr, filetype, row, byte(start), byte(start + length), legend.tokenTypes[kind + 1], modifiers)
  end
end

--- The lines that windows show of a buffer, and as many above and below them.
local function shown(bufnr)
  local first, last
  for _, window in ipairs(vim.fn.win_findbuf(bufnr)) do
    local top, bottom = vim.fn.line('w0', window), vim.fn.line('w$', window)
    local margin = bottom - top
    first = math.min(first or math.huge, top - margin)
    last = math.max(last or 0, bottom + margin)
  end
  if first then
    return math.max(first - 1, 0), math.min(last, vim.api.nvim_buf_line_count(bufnr))
  end
end

local function ask(client, bufnr)
  local first, last = shown(bufnr)
  if not first then
    return
  end
  local tick = vim.api.nvim_buf_get_changedtick(bufnr)
  client:request('textDocument/semanticTokens/range', {
    textDocument = vim.lsp.util.make_text_document_params(bufnr),
    range = { start = { line = first, character = 0 }, ['end'] = { line = last, character = 0 } },
  }, function(_, tokens)
    local is_current = vim.api.nvim_buf_is_valid(bufnr) and vim.api.nvim_buf_get_changedtick(bufnr) == tick
    if tokens and is_current then
      draw(client, bufnr, tokens.data)
    end
  end, bufnr)
end

--- Takes the colours of a long program over from Neovim's own highlighter.
--- @param client vim.lsp.Client
--- @param bufnr integer
function M.attach(client, bufnr)
  local provider = client.server_capabilities.semanticTokensProvider
  local is_long = vim.api.nvim_buf_line_count(bufnr) > LONG
  if vim.fn.has('nvim-0.12') == 1 or not is_long or not (provider and provider.range) then
    return
  end
  -- It is started after this, when all configuration has had its say about it.
  vim.defer_fn(function()
    vim.lsp.semantic_tokens.stop(bufnr, client.id)
  end, 0)
  local timer = assert(vim.uv.new_timer())
  local function soon()
    timer:start(GATHER, 0, vim.schedule_wrap(function()
      if vim.api.nvim_buf_is_valid(bufnr) and not client:is_stopped() then
        ask(client, bufnr)
      end
    end))
  end
  local group = vim.api.nvim_create_augroup('ladder.colours.' .. bufnr, { clear = true })
  vim.api.nvim_create_autocmd({ 'TextChanged', 'TextChangedI', 'TextChangedP', 'WinScrolled', 'BufWinEnter' }, {
    group = group,
    buffer = bufnr,
    callback = soon,
  })
  vim.api.nvim_create_autocmd({ 'LspDetach', 'BufWipeout' }, {
    group = group,
    buffer = bufnr,
    callback = function(event)
      if event.event == 'LspDetach' and event.data.client_id ~= client.id then
        return
      end
      timer:stop()
      if vim.api.nvim_buf_is_valid(bufnr) then
        vim.api.nvim_buf_clear_namespace(bufnr, namespace, 0, -1)
      end
      vim.api.nvim_del_augroup_by_id(group)
    end,
  })
  soon()
end

return M
