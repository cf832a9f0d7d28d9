--- What happens where the language server is missing: it is said once, and the server starts as soon as it is there.
local M = {}

local program = require('ladder.program')

--- How often it is looked for, in milliseconds: some files are asked whether they exist.
local LOOK_AGAIN = 2000

--- @type uv.uv_timer_t|nil
local timer
local said = false

--- Starts the server for all ladder buffers, if there is one now.
local function look()
  local found = program.find('ladder')
  if not found or not timer then
    return
  end
  timer:close()
  timer = nil
  vim.lsp.config('ladder', { cmd = { found, 'lsp' } })
  -- Enabling it again attaches it to the buffers that are open.
  vim.lsp.enable('ladder')
  vim.notify('ladder: the language server is there now: ' .. found)
end

--- Where the server cannot be started for want of its program, says so, once, and waits for it.
function M.watch()
  local command = (vim.lsp.config.ladder or {}).cmd
  if said or type(command) ~= 'table' or vim.fn.executable(command[1]) == 1 then
    return
  end
  said = true
  if not program.is_nowhere(command[1]) then
    local text = 'ladder: the language server "%s", which your configuration names, is not a program. :checkhealth ladder says more.'
    return vim.notify(text:format(command[1]), vim.log.levels.WARN)
  end
  timer = assert(vim.uv.new_timer())
  timer:start(LOOK_AGAIN, LOOK_AGAIN, vim.schedule_wrap(look))
  vim.notify(
    'ladder: the language server was not found: there is no program "ladder" on the PATH or in the folder of Cargo. '
      .. 'Install it ("cargo install --path cli" in the project); it is started as soon as it is there. '
      .. ':checkhealth ladder says more.',
    vim.log.levels.WARN
  )
end

return M
