--- `:Ladder diff`: what changed in a program since a revision of git, network by network.
local side_buffer = require('ladder.side_buffer')

local M = {}

--- @param source integer the buffer of the program
--- @param lines string[]
local function show(source, lines)
  local bufnr = side_buffer.with_lines('diff', source, lines)
  -- Its signs are those of any difference.
  vim.bo[bufnr].syntax = 'diff'
  side_buffer.map(bufnr, {
    q = function()
      vim.api.nvim_win_close(0, true)
    end,
  })
  vim.api.nvim_open_win(bufnr, true, { split = 'below', height = math.min(math.max(#lines, 3), 24), style = 'minimal' })
  vim.wo[0][0].wrap = false
end

--- Saves the buffer, and opens the difference in a window.
--- @param source integer
--- @param revision string|nil without it HEAD
function M.open(source, revision)
  local file = vim.api.nvim_buf_get_name(source)
  if file == '' then
    error('the buffer has no file yet.', 0)
  end
  vim.api.nvim_buf_call(source, function()
    vim.cmd('silent update')
  end)
  revision = revision or 'HEAD'
  local name = vim.fs.basename(file)
  local command = { require('ladder.program').ladder(), 'diff', '--', ('%s:./%s'):format(revision, name), './' .. name }
  local options = { cwd = vim.fs.dirname(file), text = true, env = { NO_COLOR = '1' } }
  local started, failed = pcall(vim.system, command, options, function(done)
    vim.schedule(function()
      if done.code == 0 then
        vim.notify(('ladder: nothing has changed since %s'):format(revision), vim.log.levels.INFO)
      elseif done.code == 1 then
        show(source, vim.split(vim.trim(done.stdout), '\n', { plain = true }))
      else
        local said = vim.trim(done.stderr):gsub('^error: ', '')
        vim.notify('ladder: ' .. said, vim.log.levels.ERROR)
      end
    end)
  end)
  if not started then
    error(tostring(failed), 0)
  end
end

return M
