--- A person at the keys: another Neovim, driven through its socket.
local M = {}

local keyboard = {}
keyboard.__index = keyboard

--- Starts Neovim on a program in a folder of its own.
--- @param t table the harness
--- @param lines string[] the program
--- @param setup string[]|nil commands of Ex before the file is opened
--- @param others table<string, string[]>|nil other files of the folder, by name
function M.open(t, lines, setup, others)
  local folder = vim.fn.tempname()
  vim.fn.mkdir(folder, 'p')
  vim.fn.writefile({}, folder .. '/ladder.toml')
  local file = folder .. '/typed.clad'
  vim.fn.writefile(lines, file)
  for name, text in pairs(others or {}) do
    vim.fn.writefile(text, folder .. '/' .. name)
  end
  local command = { vim.v.progpath, '--clean', '--embed', '-u', vim.env.LADDER_ROOT .. '/tests/editors/neovim/init.lua' }
  for _, line in ipairs(setup or {}) do
    vim.list_extend(command, { '--cmd', line })
  end
  table.insert(command, file)
  local channel = vim.fn.jobstart(command, { rpc = true })
  assert(channel > 0, 'Neovim does not start')
  vim.rpcrequest(channel, 'nvim_ui_attach', 120, 40, vim.empty_dict())
  local self = setmetatable({ t = t, channel = channel, file = file }, keyboard)
  t.eventually('the language server to attach', function()
    return self:lua([[local bufnr = vim.api.nvim_get_current_buf()
      local client = vim.lsp.get_clients({ name = 'ladder' })[1]
      return client ~= nil and client.attached_buffers[bufnr] == true]])
  end)
  return self
end

function keyboard:lua(code, ...)
  return vim.rpcrequest(self.channel, 'nvim_exec_lua', code, { ... })
end

--- Presses keys.
--- @param ... string in the notation of |key-notation|
function keyboard:press(...)
  for _, keys in ipairs({ ... }) do
    vim.rpcrequest(self.channel, 'nvim_input', keys)
    -- Until they have been read.
    self.t.eventually('the keys to be read', function()
      return self:lua('return vim.fn.getchar(1)') == 0
    end)
  end
end

--- Puts a text into the buffer and the cursor into it.
function keyboard:write(lines, row, column)
  self:press('<Esc>')
  -- A snippet ends before its text does: Neovim may abort where its places are taken away after that (neovim#27196).
  self:lua('vim.snippet.stop()')
  self:lua('vim.api.nvim_buf_set_lines(0, 0, -1, false, ...)', lines)
  self:lua('vim.api.nvim_win_set_cursor(0, { ... })', row, column)
end

--- @return string[]
function keyboard:lines()
  return self:lua('return vim.api.nvim_buf_get_lines(0, 0, -1, false)')
end

--- @return integer[] the cursor's row from 1 and its column from 0
function keyboard:cursor()
  return self:lua('return vim.api.nvim_win_get_cursor(0)')
end

--- Waits until the list of proposals is open.
function keyboard:list()
  self.t.eventually('the list of proposals', function()
    return self:lua('return vim.fn.pumvisible()') == 1
  end)
end

--- Accepts the proposal of this label.
function keyboard:choose(label)
  self:list()
  local steps = self:lua(
    [[local label = ...
    local found = vim.fn.complete_info({ 'items', 'selected' })
    for index, item in ipairs(found.items) do
      if item.abbr == label then
        return index - found.selected - 1
      end
    end]],
    label
  )
  assert(steps ~= vim.NIL, label .. ' is not proposed')
  for _ = 1, steps do
    self:press('<C-n>')
  end
  self:press('<C-y>')
end

--- Waits until the text is this.
function keyboard:expect(what, wanted)
  local found
  local arrived = vim.wait(3000, function()
    found = self:lines()
    return vim.deep_equal(wanted, found)
  end, 5)
  if not arrived then
    self.t.equal(what, wanted, found)
  end
end

function keyboard:close()
  vim.fn.jobstop(self.channel)
end

return M
