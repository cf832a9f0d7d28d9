--- What was done in a simulation, as a test next to the program.
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

--- Asks of which tags something is expected, one after the other, until the first entry is taken.
--- @param offered { name: string, type: string, output: boolean }[]
--- @param chosen table<string, true>
--- @param done fun(names: string[])
local function choose(offered, chosen, done)
  local items = { false }
  vim.list_extend(items, offered)
  local function text(item)
    if not item then
      return ('Write the test (%d tags)'):format(vim.tbl_count(chosen))
    end
    local role = item.output and ', output' or ''
    return ('[%s] %s : %s%s'):format(chosen[item.name] and 'x' or ' ', item.name, item.type, role)
  end
  vim.ui.select(items, { prompt = 'The test expects values of', format_item = text }, function(item, index)
    if not index then
      return
    end
    if item then
      chosen[item.name] = not chosen[item.name] or nil
      return choose(offered, chosen, done)
    end
    local names = {}
    for _, tag in ipairs(offered) do
      if chosen[tag.name] then
        table.insert(names, tag.name)
      end
    end
    done(names)
  end)
end

--- Saves what was done so far as a file of scenarios next to the program, opens it and runs it once.
--- @param bufnr integer the program
--- @param name string what the scenario is called; "" for "recorded"
function M.record(bufnr, name)
  local asked = { name = name ~= '' and name or nil }
  local function write(recorded)
    local folder = vim.fs.dirname(vim.api.nvim_buf_get_name(bufnr))
    local file = fresh(vim.fs.joinpath(folder, recorded.file))
    vim.cmd.split({ args = { vim.fn.fnameescape(file) } })
    vim.api.nvim_buf_set_lines(0, 0, -1, false, vim.split(vim.trim(recorded.text), '\n'))
    vim.cmd('silent write')
    for _, note in ipairs(recorded.notes or {}) do
      vim.notify('ladder: ' .. note .. '.')
    end
    require('ladder.test').run(vim.api.nvim_get_current_buf())
  end
  simulation.ask(bufnr, 'record', asked, function(recorded)
    local chosen = {}
    for _, output in ipairs(recorded.outputs) do
      chosen[output] = true
    end
    -- What is chosen already is what is most likely wanted.
    local offered, others = {}, {}
    for _, tag in ipairs(recorded.offered) do
      table.insert(chosen[tag.name] and offered or others, tag)
    end
    vim.list_extend(offered, others)
    choose(offered, chosen, function(names)
      asked.outputs = names
      simulation.ask(bufnr, 'record', asked, write)
    end)
  end)
end

return M
