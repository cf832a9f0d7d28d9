--- The plugin's interface for mappings and scripts. Every function takes a buffer number; 0 or nil is the current one.
--- There is nothing to set up.
local M = {}

local function resolve(bufnr)
  return (bufnr and bufnr ~= 0) and bufnr or vim.api.nvim_get_current_buf()
end

--- The last state the simulator sent, as described in the protocol's `ladder/simulationState`.
--- @param bufnr integer|nil
--- @return ladder.State|nil
function M.state(bufnr)
  local session = require('ladder.session').of(resolve(bufnr))
  return session and session.state
end

--- What a tag holds, if the program's windows or the panel show it.
--- @param name string
--- @param bufnr integer|nil
--- @return ladder.Tag|nil
function M.tag(name, bufnr)
  return require('ladder.session').tag(require('ladder.session').of(resolve(bufnr)), name)
end

--- One line for a status line: `running, scan 120, 1.2s`; empty without a simulation. `b:ladder_status` holds the same.
--- @param bufnr integer|nil
--- @return string
function M.status(bufnr)
  return require('ladder.status').text(require('ladder.session').of(resolve(bufnr)))
end

--- Inverts a BOOL tag.
--- @param name string
--- @param bufnr integer|nil
function M.toggle(name, bufnr)
  bufnr = resolve(bufnr)
  require('ladder.simulation').with_tag(bufnr, name, function(tag)
    if not tag or type(tag.value) ~= 'boolean' then
      return vim.notify(('ladder: %s is not a BOOL tag of this simulation.'):format(name), vim.log.levels.WARN)
    end
    -- What is held stays held, at the other value.
    require('ladder.simulation').command(bufnr, tag.forced and 'force' or 'set', {
      tag = tag.name,
      value = not tag.value,
    }, true)
  end)
end

--- Waits until the simulator has answered every command given so far.
--- @param bufnr integer|nil
--- @param timeout_ms integer|nil 2000 if not given
--- @return boolean answered
function M.wait(bufnr, timeout_ms)
  return require('ladder.simulation').wait(resolve(bufnr), timeout_ms)
end

--- Tells nvim-dap how ladder programs are debugged. Where that is installed when the first ladder file is opened this
--- happens by itself.
--- @return boolean registered false if there is no nvim-dap
function M.dap()
  return require('ladder.dap').register()
end

return M
