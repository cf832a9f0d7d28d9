--- Steps with a name, each reported as it passes or fails, and what steps need to look at Neovim with.
local M = {}

local steps = {}

--- @param name string what holds if the step passes
--- @param check fun() raises an error if it does not
function M.step(name, check)
  table.insert(steps, { name = name, check = check })
end

--- Runs all steps in order, then ends Neovim: with 0 if all passed, else with 1.
function M.run()
  local failed = 0
  for _, step in ipairs(steps) do
    local started = vim.uv.hrtime()
    local passed, message = xpcall(step.check, function(err)
      return type(err) == 'string' and err or vim.inspect(err)
    end)
    local ms = (vim.uv.hrtime() - started) / 1e6
    io.stdout:write(('%s  neovim: %s (%.0f ms)\n'):format(passed and 'ok  ' or 'FAIL', step.name, ms))
    if not passed then
      failed = failed + 1
      io.stdout:write('      ' .. message:gsub('\n', '\n      ') .. '\n')
    end
  end
  io.stdout:flush()
  vim.cmd(failed == 0 and 'qall!' or 'cquit! 1')
end

--- @param what string
--- @param wanted any
--- @param found any
function M.equal(what, wanted, found)
  if not vim.deep_equal(wanted, found) then
    local function show(value)
      return type(value) == 'table' and table.concat(vim.tbl_map(tostring, value), '\n') or tostring(value)
    end
    error(('%s is not as expected.\nexpected:\n%s\nfound:\n%s'):format(what, show(wanted), show(found)), 0)
  end
end

--- Waits for something that the server brings about.
--- @param what string
--- @param holds fun(): any
--- @return any the value that `holds` gave in the end
function M.eventually(what, holds)
  local value
  if not vim.wait(5000, function()
    value = holds()
    return value
  end, 5) then
    error('waited 5 s in vain for ' .. what, 0)
  end
  return value
end

--- Empties a list that others hold, too.
--- @param list any[]
function M.clear(list)
  while #list > 0 do
    table.remove(list)
  end
end

local opened = 0

--- Opens a fresh copy of a fixture in a folder of its own, and waits until the server is attached.
--- @param name string
--- @return integer bufnr
function M.open(name)
  opened = opened + 1
  local folder = ('%s/%d'):format(vim.env.LADDER_SCRATCH, opened)
  vim.fn.mkdir(folder)
  local copy = folder .. '/' .. name
  vim.fn.writefile(vim.fn.readfile(vim.env.LADDER_FIXTURES .. '/' .. name), copy)
  vim.cmd.edit(copy)
  local bufnr = vim.api.nvim_get_current_buf()
  M.eventually('the language server to attach', function()
    return vim.lsp.get_clients({ bufnr = bufnr, name = 'ladder' })[1]
  end)
  return bufnr
end

--- The drawing with every character that is not highlighted by one of these groups replaced by a blank.
--- @param bufnr integer
--- @param ... string
--- @return string[] lines without blanks at their ends
function M.highlighted(bufnr, ...)
  local groups = { ... }
  local cells = {}
  for row, line in ipairs(vim.api.nvim_buf_get_lines(bufnr, 0, -1, false)) do
    cells[row] = (' '):rep(#line)
  end
  local namespace = vim.api.nvim_get_namespaces().ladder_power
  for _, mark in ipairs(vim.api.nvim_buf_get_extmarks(bufnr, namespace, 0, -1, { details = true })) do
    local row, col, details = mark[2], mark[3], mark[4]
    if vim.list_contains(groups, details.hl_group) then
      local text = vim.api.nvim_buf_get_text(bufnr, row, col, details.end_row, details.end_col, {})[1]
      cells[row + 1] = cells[row + 1]:sub(1, col) .. text .. cells[row + 1]:sub(col + #text + 1)
    end
  end
  return vim.tbl_map(function(line)
    return (line:gsub('%s+$', ''))
  end, cells)
end

--- What has power in the drawing.
--- @param bufnr integer
--- @return string[]
function M.powered(bufnr)
  return M.highlighted(bufnr, 'LadderPowerOn', 'LadderClosedOn')
end

--- @param bufnr integer
--- @param names string[]
--- @return string `a=1  b=0!`
function M.values(bufnr, names)
  return table.concat(
    vim.tbl_map(function(name)
      local tag = require('ladder').tag(name, bufnr)
      return ('%s=%s%s'):format(name, tag and tag.text or '?', tag and tag.forced and '!' or '')
    end, names),
    '  '
  )
end

--- The drawing as a person sees it: with what the plugin draws over it, and between its lines.
--- @param bufnr integer
--- @return string[] lines without blanks at their ends
function M.seen(bufnr)
  local lines = vim.api.nvim_buf_get_lines(bufnr, 0, -1, false)
  local namespace = vim.api.nvim_get_namespaces().ladder_values
  for _, mark in ipairs(vim.api.nvim_buf_get_extmarks(bufnr, namespace, 0, -1, { details = true })) do
    local row, col, details = mark[2] + 1, mark[3], mark[4]
    local text = ''
    for _, chunk in ipairs(details.virt_text or details.virt_lines[1]) do
      text = text .. chunk[1]
    end
    if details.virt_lines then
      lines[row] = text .. '\n' .. lines[row]
    else
      local is_at_end = col == #lines[row]
      M.equal('the place of a value', is_at_end and 'eol' or 'overlay', details.virt_text_pos)
      text = is_at_end and ' ' .. text or text
      lines[row] = lines[row]:sub(1, col) .. text .. lines[row]:sub(col + #text + 1)
    end
  end
  return vim.tbl_map(function(line)
    return (line:gsub('%s+$', ''))
  end, lines)
end

return M
