--- What was done in a simulation, as a scenario in a new buffer.
local M = {}

local simulation = require('ladder.simulation')

--- A file that is not there yet.
local function fresh(file)
  local stem = file:gsub('%.ladder%-test$', '')
  local number = 1
  while vim.uv.fs_stat(file) or vim.fn.bufexists(file) == 1 do
    number = number + 1
    file = ('%s-%d.ladder-test'):format(stem, number)
  end
  return file
end

--- Opens what was done so far as a file of scenarios next to the program. Nothing is written until it is saved.
--- @param bufnr integer the program
--- @param name string what the scenario is called; "" for "recorded"
function M.record(bufnr, name)
  simulation.ask(bufnr, 'record', { name = name ~= '' and name or nil }, function(recorded)
    local folder = vim.fs.dirname(vim.api.nvim_buf_get_name(bufnr))
    vim.cmd.split({ args = { vim.fn.fnameescape(fresh(vim.fs.joinpath(folder, recorded.file))) } })
    vim.api.nvim_buf_set_lines(0, 0, -1, false, vim.split(vim.trim(recorded.text), '\n'))
    for _, note in ipairs(recorded.notes or {}) do
      vim.notify('ladder: ' .. note .. '.')
    end
  end)
end

return M
