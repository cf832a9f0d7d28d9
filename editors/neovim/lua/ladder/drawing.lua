--- The drawing while a person types: Enter begins the next rung or branch, a `/` closes a branch, and a network is drawn
--- again when insert mode is left.
local M = {}

--- Milliseconds that a key may wait for the server.
local PATIENCE = 300

--- The keys that the server is asked about.
local ENTER, CLOSE = '\n', '/'

--- The keys that may repeat or reject what Enter has begun.
local OVER = { ['+'] = true, ['|'] = true, ['#'] = true, E = true, F = true, V = true }

local function is_wanted()
  return vim.g.ladder_draw ~= false
end

--- Whether a line is no more than Enter has begun.
local function is_begun(line)
  return line == '+--' or line:match('^|[ |]*/%-%- *$') ~= nil
end

--- Has the server go on after a key that was just typed. The next key waits, so that it finds what was begun.
--- @param typed string the key
--- @param by_key boolean whether it was typed: `o` begins a line too, and splits none
local function go_on(client, bufnr, state, typed, by_key)
  if vim.api.nvim_get_current_buf() ~= bufnr or not vim.startswith(vim.fn.mode(), 'i') then
    return
  end
  local params = vim.lsp.util.make_position_params(0, client.offset_encoding)
  params.ch = typed
  params.options = { tabSize = vim.bo[bufnr].tabstop, insertSpaces = true }
  local answer = client:request_sync('textDocument/onTypeFormatting', params, PATIENCE, bufnr)
  local edits = answer and answer.result
  if not edits or #edits == 0 then
    return
  end
  -- A line end within a block is taken back.
  local from, to = edits[1].range.start, edits[1].range['end']
  local joins = typed == ENTER and #edits == 1 and to.line == from.line + 1
  if joins and not by_key then
    return
  end
  vim.lsp.util.apply_text_edits(edits, bufnr, client.offset_encoding)
  if joins then
    local line = vim.api.nvim_buf_get_lines(bufnr, from.line, from.line + 1, false)[1]
    vim.api.nvim_win_set_cursor(0, { from.line + 1, vim.str_byteindex(line, client.offset_encoding, from.character, false) })
  elseif typed == ENTER then
    local row = vim.api.nvim_win_get_cursor(0)[1]
    local line = vim.api.nvim_get_current_line()
    vim.api.nvim_win_set_cursor(0, { row, #line })
    state.begun = line:match('^%+%-*$') and row or nil
  end
end

--- Takes back a rung that was begun and left empty: it was not wanted.
--- @return boolean whether there was one
local function give_up(bufnr, state)
  local begun = state.begun
  state.begun = nil
  if not begun or not (vim.api.nvim_buf_get_lines(bufnr, begun - 1, begun, false)[1] or ''):match('^%+%-*$') then
    return false
  end
  -- One step of undo with the Enter that began it.
  pcall(vim.cmd.undojoin)
  vim.api.nvim_buf_set_lines(bufnr, begun - 1, begun, false, { '' })
  return true
end

--- Draws the networks that were typed in, unless something else is done meanwhile.
local function draw(client, bufnr, state)
  -- On its way to the next place of a snippet Neovim leaves insert mode too; the places would not move along with the drawing.
  if vim.api.nvim_get_current_buf() ~= bufnr or vim.fn.mode() ~= 'n' or give_up(bufnr, state) or not state.changed then
    return
  end
  state.changed = false
  if vim.snippet and vim.snippet.active() then
    vim.snippet.stop()
  end
  local first, last = vim.fn.line("'["), vim.fn.line("']")
  local tick = vim.api.nvim_buf_get_changedtick(bufnr)
  client:request('textDocument/rangeFormatting', {
    textDocument = vim.lsp.util.make_text_document_params(bufnr),
    range = { start = { line = first - 1, character = 0 }, ['end'] = { line = math.max(first, last) - 1, character = 0 } },
    options = { tabSize = vim.bo[bufnr].tabstop, insertSpaces = true },
  }, function(_, edits)
    local current = vim.api.nvim_buf_is_valid(bufnr) and vim.api.nvim_buf_get_changedtick(bufnr) == tick
    -- An answer may come when something is typed again.
    current = current and not (vim.snippet and vim.snippet.active())
    if not edits or #edits == 0 or not current then
      return
    end
    vim.api.nvim_buf_call(bufnr, function()
      -- One step of undo with what was typed.
      pcall(vim.cmd.undojoin)
      vim.lsp.util.apply_text_edits(edits, bufnr, client.offset_encoding)
    end)
  end, bufnr)
end

--- @param client vim.lsp.Client
--- @param bufnr integer
function M.attach(client, bufnr)
  local state = { changed = false, begun = nil }
  local group = vim.api.nvim_create_augroup('ladder.drawing.' .. bufnr, { clear = true })
  local function on(events, callback)
    vim.api.nvim_create_autocmd(events, { group = group, buffer = bufnr, callback = callback })
  end
  local attached = true
  vim.api.nvim_buf_attach(bufnr, false, {
    on_lines = function(_, _, _, first, old, new)
      if not attached then
        return true
      end
      state.changed = true
      -- The line that was begun is at another place, or Enter was pressed in it.
      if new ~= old then
        state.begun = nil
      end
      if new - old ~= 1 or not is_wanted() then
        return
      end
      local by_key = vim.startswith(vim.fn.mode(), 'i')
      vim.schedule(function()
        -- The cursor is on the line that is new: after Enter, or `o` in normal mode.
        if vim.api.nvim_get_current_buf() == bufnr and vim.api.nvim_win_get_cursor(0)[1] == new then
          go_on(client, bufnr, state, ENTER, by_key)
        end
      end)
    end,
  })
  on('InsertEnter', function()
    if not (vim.snippet and vim.snippet.active()) then
      state.changed = false
    end
  end)
  on('InsertCharPre', function()
    local typed = vim.v.char
    if is_wanted() and (typed == CLOSE or OVER[typed] and is_begun(vim.api.nvim_get_current_line())) then
      vim.schedule(function()
        local column = vim.api.nvim_win_get_cursor(0)[2]
        if vim.api.nvim_get_current_line():sub(column, column) == typed then
          go_on(client, bufnr, state, typed, true)
        end
      end)
    end
  end)
  on('CursorMovedI', function()
    if state.begun and vim.api.nvim_win_get_cursor(0)[1] ~= state.begun then
      give_up(bufnr, state)
    end
  end)
  -- From insert mode, or from a place of a snippet that is selected.
  on('ModeChanged', function()
    local event = vim.v.event
    if event.new_mode == 'n' and (vim.startswith(event.old_mode, 'i') or event.old_mode == 's') and is_wanted() then
      -- When the keys that Neovim has put in for itself are read.
      vim.schedule(function()
        draw(client, bufnr, state)
      end)
    end
  end)
  on('LspDetach', function(event)
    if event.data.client_id == client.id then
      attached = false
      vim.api.nvim_del_augroup_by_id(group)
    end
  end)
end

return M
