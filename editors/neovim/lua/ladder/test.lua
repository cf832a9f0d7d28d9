--- `:Ladder test`: runs scenarios and lists what is wrong in the quickfix list.
local M = {}

--- What `ladder test --format json` tells, as entries of the quickfix list.
--- @param report table
--- @param folder string that the files are named from
--- @return table[]
function M.entries(report, folder)
  local entries = {}
  local function add(file, place, text)
    local path = vim.startswith(file, '/') and file or vim.fs.joinpath(folder, file)
    table.insert(entries, { filename = path, lnum = place.line, col = place.column, type = 'E', text = text })
  end
  for _, file in ipairs(report.files) do
    for _, found in ipairs(file.errors) do
      add(found.file, found, found.message)
    end
    for _, scenario in ipairs(file.scenarios) do
      for _, difference in ipairs(scenario.differences) do
        add(file.file, difference, ('%s: %s'):format(scenario.name, difference.message))
      end
      for _, violation in ipairs(scenario.violations or {}) do
        add(file.file, violation, ('%s: %s'):format(scenario.name, violation.message))
      end
      if scenario.stopped_in_step then
        local text = ('%s: the simulation stopped in step %d'):format(scenario.name, scenario.stopped_in_step)
        add(file.file, scenario, text)
      end
    end
  end
  return entries
end

--- The scenario files of a buffer: itself, or those next to the program that it is.
--- @param bufnr integer
--- @return string[]
local function files(bufnr)
  local file = vim.api.nvim_buf_get_name(bufnr)
  if vim.bo[bufnr].filetype == 'laddertest' then
    return { file }
  end
  local scenarios = vim.fn.fnamemodify(file, ':r') .. '.ladder-test'
  if vim.bo[bufnr].filetype == 'clad' and vim.uv.fs_stat(scenarios) then
    return { scenarios }
  end
  error('there are no scenarios: open a file that ends in .ladder-test', 0)
end

local namespace = vim.api.nvim_create_namespace('ladder_test')

--- Marks what is wrong at its rows, until the text is changed or the scenarios run again.
--- @param entries table[]
local function mark(entries)
  vim.diagnostic.reset(namespace)
  local by_buffer = {}
  for _, entry in ipairs(entries) do
    local bufnr = vim.fn.bufnr(vim.fn.fnameescape(entry.filename))
    if bufnr > 0 then
      by_buffer[bufnr] = by_buffer[bufnr] or {}
      table.insert(by_buffer[bufnr], {
        lnum = entry.lnum - 1,
        col = entry.col - 1,
        message = entry.text,
        severity = vim.diagnostic.severity.ERROR,
        source = 'ladder test',
      })
    end
  end
  for bufnr, found in pairs(by_buffer) do
    vim.diagnostic.set(namespace, bufnr, found)
    vim.api.nvim_buf_attach(bufnr, false, {
      on_lines = function()
        vim.schedule(function()
          vim.diagnostic.reset(namespace, bufnr)
        end)
        return true
      end,
    })
  end
end

--- Leaves of a report only one scenario.
--- @param report table
--- @param name string
local function only(report, name)
  report.summary.passed, report.summary.failed = 0, 0
  for _, file in ipairs(report.files) do
    file.scenarios = vim.tbl_filter(function(scenario)
      return scenario.name == name
    end, file.scenarios)
    for _, scenario in ipairs(file.scenarios) do
      local kind = scenario.passed and 'passed' or 'failed'
      report.summary[kind] = report.summary[kind] + 1
    end
  end
end

--- Runs the scenarios of a buffer, as they are on disk.
--- @param bufnr integer
--- @param scenario string|nil the name of the only one that counts
function M.run(bufnr, scenario)
  local paths = files(bufnr)
  if vim.bo[bufnr].modified then
    vim.api.nvim_buf_call(bufnr, function()
      vim.cmd('silent update')
    end)
  end
  local program = require('ladder.program').ladder()
  local folder = vim.fn.getcwd()
  local command = vim.list_extend({ program, 'test', '--format', 'json', '--' }, paths)
  vim.system(command, { text = true, cwd = folder }, vim.schedule_wrap(function(done)
    local read, report = pcall(vim.json.decode, done.stdout)
    if not read then
      return vim.notify('ladder: ' .. vim.trim(done.stderr), vim.log.levels.ERROR)
    end
    if scenario then
      only(report, scenario)
    end
    local entries = M.entries(report, folder)
    mark(entries)
    vim.fn.setqflist({}, ' ', { title = 'Ladder test', items = entries })
    local sum = report.summary
    local text = ('ladder: %d scenarios passed, %d failed'):format(sum.passed, sum.failed)
    if sum.not_run > 0 then
      text = ('%s, %d files not run for errors'):format(text, sum.not_run)
    end
    vim.notify(text, #entries > 0 and vim.log.levels.WARN or vim.log.levels.INFO)
    if #entries > 0 then
      vim.cmd('botright copen | wincmd p')
    else
      vim.cmd('cclose')
    end
  end))
end

return M
