--- Buffers next to a program that show something of its simulation: its tags, its diagram, its trace.
local M = {}

--- A buffer that shows something of a program. Nobody edits it, and it goes when it is closed.
--- @param kind string what it shows, in one word
--- @param source integer the buffer of the program
--- @return integer
function M.create(kind, source)
  local bufnr = vim.api.nvim_create_buf(false, true)
  vim.bo[bufnr].bufhidden = 'wipe'
  vim.bo[bufnr].filetype = 'ladder_' .. kind
  vim.bo[bufnr].modifiable = false
  vim.api.nvim_buf_set_name(bufnr, ('ladder://%s/%d'):format(kind, source))
  vim.b[bufnr].ladder_source = source
  return bufnr
end

--- A buffer with these lines, in the place of the last one of its kind for this program.
--- @param kind string what it shows, in one word
--- @param source integer the buffer of the program
--- @param lines string[]
--- @return integer
function M.with_lines(kind, source, lines)
  local old = vim.fn.bufnr(('^ladder://%s/%d$'):format(kind, source))
  if old > 0 then
    vim.api.nvim_buf_delete(old, { force = true })
  end
  local bufnr = M.create(kind, source)
  vim.bo[bufnr].modifiable = true
  vim.api.nvim_buf_set_lines(bufnr, 0, -1, false, lines)
  vim.bo[bufnr].modifiable = false
  return bufnr
end

--- @param bufnr integer
--- @param actions table<string, function> by their keys
function M.map(bufnr, actions)
  for key, action in pairs(actions) do
    vim.keymap.set('n', key, action, { buffer = bufnr, nowait = true })
  end
end

--- Adds what a double click does, and two of them in a row. Neovim itself would select a word, a line, a block.
--- @param actions table<string, function> by their keys
--- @param act function
function M.on_double_click(actions, act)
  local function nothing() end
  for clicks = 2, 4 do
    actions[('<%d-LeftMouse>'):format(clicks)] = nothing
    actions[('<%d-LeftRelease>'):format(clicks)] = clicks == 3 and nothing or act
  end
end

--- The keys of a buffer with those that all buffers have which show a run: step, back, run and pause.
--- @param source integer the buffer of the program
--- @param actions table<string, function> by their keys
--- @return table<string, function>
function M.with_run(source, actions)
  local simulation = require('ladder.simulation')
  local function scans(name)
    return function()
      simulation.command(source, name, { scans = vim.v.count1 })
    end
  end
  local running = {
    s = scans('step'),
    b = scans('back'),
    r = function()
      simulation.run(source)
    end,
    p = function()
      simulation.pause(source)
    end,
  }
  return vim.tbl_extend('error', running, actions)
end

--- The windows that show it.
--- @param bufnr integer
--- @return integer[]
function M.windows(bufnr)
  return vim.api.nvim_buf_is_valid(bufnr) and vim.fn.win_findbuf(bufnr) or {}
end

return M
