--- Keys of the diagram that draw: each is one edit of the program, and one step of its undo. They work on what the cursor is on.
local cursor = require('ladder.diagram.cursor')
local server = require('ladder.server')

local M = {}

--- Asks the server about the program, in the version that it has.
--- @param source integer
--- @param command string
--- @param argument table
--- @param answer fun(result: any, client: vim.lsp.Client)
local function ask(source, command, argument, answer)
  local client = server.of(source)
  if not client then
    return vim.notify('ladder: no language server is attached', vim.log.levels.WARN)
  end
  argument.uri = vim.uri_from_bufnr(source)
  argument.version = vim.lsp.util.buf_versions[source]
  server.command(client, source, command, argument, function(err, result)
    if err then
      return vim.notify('ladder: ' .. err.message, vim.log.levels.WARN)
    end
    answer(result, client)
  end)
end

--- Makes a change of the drawing.
--- @param source integer
--- @param change table
--- @param done fun() called when the program has become another one
local function edit(source, change, done)
  local tick = vim.api.nvim_buf_get_changedtick(source)
  ask(source, 'ladder.diagramEdit', { edit = change }, function(edited, client)
    if vim.api.nvim_buf_get_changedtick(source) ~= tick then
      return
    end
    vim.lsp.util.apply_text_edits(edited.edits, source, client.offset_encoding)
    vim.api.nvim_echo({ { edited.said } }, false, {})
    done()
  end)
end

--- Asks for a text; for a free name where nothing is written.
--- @param prompt string
--- @param offer table
--- @param answer fun(text: string)
local function name(prompt, offer, answer)
  vim.ui.input({ prompt = prompt .. ': ' }, function(text)
    local written = text == '' and offer.names or text
    if written and written ~= '' then
      answer(written)
    end
  end)
end

--- The keys after |<LocalLeader>|, and what each draws: `put` is the block whose tag is asked for.
M.keys = {
  { 'c', put = '[ ]', says = 'Put in a contact' },
  { 'C', put = '[/]', says = 'Put in a closed contact' },
  { 'q', put = '( )', says = 'Put in a coil' },
  { 'b', put = '[ ]', side = 'below', says = 'Draw a contact in parallel' },
  { 'B', put = '[ ]', side = 'above', says = 'Draw a contact in parallel above' },
  { 'e', does = 'invert', says = 'Make it its opposite' },
  { 'd', does = 'delete', says = 'Delete it with its wire' },
  { 'n', does = 'network', says = 'Write a network below' },
}

local opposite = { ['[ ]'] = '[/]', ['[/]'] = '[ ]', ['( )'] = '(/)', ['(/)'] = '( )' }

--- @param source integer
--- @param diagram ladder.Diagram
--- @param key table one of `M.keys`
--- @param done fun()
function M.run(source, diagram, key, done)
  if key.does == 'network' then
    local line = cursor.line_here(diagram)
    return vim.ui.input({ prompt = 'XIC start XIO stop OTE run: ' }, function(entry)
      if entry and entry ~= '' then
        edit(source, { op = 'network', network = line, place = 'below', entry = entry }, done)
      end
    end)
  end
  local block = cursor.block_here(diagram)
  if not block then
    return vim.notify('ladder: there is no contact, coil or block under the cursor.', vim.log.levels.WARN)
  end
  local range = block.range
  if key.does == 'delete' then
    return edit(source, { op = 'delete', what = { range } }, done)
  end
  ask(source, 'ladder.diagramOffer', { what = { range } }, function(offer)
    if key.does == 'invert' then
      local text = opposite[(offer.text or ''):sub(1, 3)]
      if not text then
        return vim.notify('ladder: this has no opposite.', vim.log.levels.WARN)
      end
      local head = { start = range.start, ['end'] = { line = range.start.line, character = range.start.character + 3 } }
      return edit(source, { op = 'head', what = head, text = text }, done)
    end
    name(key.says, offer, function(tag)
      local text = ('%s( %s )'):format(key.put, tag)
      local acting = key.put == '( )' and offer.acting
      if key.side or acting then
        local from, to = acting and acting.from or range.start, acting and acting.to or range['end']
        return edit(source, { op = 'parallel', from = from, to = to, text = text, side = key.side or 'below' }, done)
      end
      local at = offer.points and offer.points.behind or range['end']
      edit(source, { op = 'insert', at = at, text = text }, done)
    end)
  end)
end

--- Maps the keys in the buffer of a diagram.
--- @param source integer
--- @param diagram ladder.Diagram
--- @param done fun() called when the program has become another one
function M.map(source, diagram, done)
  for _, key in ipairs(M.keys) do
    vim.keymap.set('n', '<LocalLeader>' .. key[1], function()
      M.run(source, diagram, key, done)
    end, { buffer = diagram.bufnr, desc = key.says })
  end
end

return M
