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
    for _, mistake in ipairs(file.mistakes) do
      add(mistake.file, mistake, mistake.message)
    end
    for _, scenario in ipairs(file.scenarios) do
      for _, difference in ipairs(scenario.differences) do
        add(file.file, difference, ('%s: %s'):format(scenario.name, difference.message))
      end
      if scenario.stopped_in_step then
        local text = ('%s: the simulation stopped in step %d'):format(scenario.name, scenario.stopped_in_step)
        add(file.file, scenario, text)
      end
    end
  end
  return entries
end

--- The scenario files of a buffer: itself, or those beside the program that it is.
--- @param bufnr integer
--- @return string[]
local function files(bufnr)
  local file = vim.api.nvim_buf_get_name(bufnr)
  if vim.bo[bufnr].filetype == 'laddertest' then
    return { file }
  end
  local beside = vim.fn.fnamemodify(file, ':r') .. '.ladder-test'
  if vim.bo[bufnr].filetype == 'clad' and vim.uv.fs_stat(beside) then
    return { beside }
  end
  error('there are no scenarios: open a file that ends in .ladder-test', 0)
end

--- Runs the scenarios of a buffer, as they are on disk.
--- @param bufnr integer
function M.run(bufnr)
  local paths = files(bufnr)
  if vim.bo[bufnr].modified then
    vim.api.nvim_buf_call(bufnr, function()
      vim.cmd('silent update')
    end)
  end
  local program = (vim.lsp.config.ladder or {}).cmd
  program = type(program) == 'table' and program[1] or require('ladder.program').command('ladder')
  local folder = vim.fn.getcwd()
  local command = vim.list_extend({ program, 'test', '--format', 'json', '--' }, paths)
  vim.system(command, { text = true, cwd = folder }, vim.schedule_wrap(function(done)
    local read, report = pcall(vim.json.decode, done.stdout)
    if not read then
      return vim.notify('ladder: ' .. vim.trim(done.stderr), vim.log.levels.ERROR)
    end
    local entries = M.entries(report, folder)
    vim.fn.setqflist({}, ' ', { title = 'Ladder test', items = entries })
    local sum = report.summary
    local text = ('ladder: %d scenarios passed, %d failed'):format(sum.passed, sum.failed)
    if sum.not_run > 0 then
      text = ('%s, %d files not run for mistakes'):format(text, sum.not_run)
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
