--- `:Ladder prove`: proves properties, and shows what came of each with the run that was found. Those that do not hold are
--- findings of the server.
local M = {}

--- The kind of the buffer that shows the answers.
local KIND = 'proofs'

--- The properties of a file with their lines, from 1. One without a name is called by its text.
--- @param lines string[]
--- @return { name: string, line: integer }[]
function M.properties(lines)
  local forms = { always = true, never = true, when = true, after = true, within = true, possible = true }
  local found, named = {}, nil
  for number, line in ipairs(lines) do
    local name, after = line:match('^%s*property%s+"([^"]*)"(.*)$')
    if name then
      named = { name = vim.trim(name), line = number }
    end
    -- A # right after a letter or digit belongs to a literal.
    local form = vim.trim(((' ' .. (after or line)):gsub('([^%w])#.*$', '%1')))
    local first, rest = form:match('^(%a+)%s+(.*)$')
    local is_row = rest and (vim.startswith(rest, '=>') or rest:match('^[-_.%s]*$'))
    if first and not is_row and (forms[first] or form:match('^no%s+faults$')) then
      table.insert(found, named or { name = form, line = number })
      named = nil
    end
  end
  return found
end

--- The property that the cursor is in or below.
--- @return string|nil
function M.here()
  local above = M.properties(vim.api.nvim_buf_get_lines(0, 0, -1, false))
  local line, here = vim.fn.line('.'), nil
  for _, property in ipairs(above) do
    if property.line <= line then
      here = property.name
    end
  end
  return here
end

--- What is shown of an answer.
--- @param property table
--- @return string[]
local function lines_of(property)
  local lines = { ('%s: %s'):format(property.name, property.message) }
  if property.neverTriggered then
    table.insert(lines, '    what is on its left side never happens')
  end
  local what = property.verdict == 'unknown' and 'not decided' or 'left open'
  for _, open in ipairs(property.open) do
    table.insert(lines, ('    %s: %s'):format(what, open.message))
  end
  if property.diagram then
    for _, row in ipairs(vim.split(property.diagram, '\n')) do
      table.insert(lines, '    ' .. row)
    end
  end
  return lines
end

--- The buffer of the scenarios of a program, or the buffer itself.
local function scenarios_of(bufnr)
  if vim.bo[bufnr].filetype == 'laddertest' then
    return bufnr
  end
  local file = vim.fn.fnamemodify(vim.api.nvim_buf_get_name(bufnr), ':r') .. '.ladder-test'
  if vim.bo[bufnr].filetype == 'clad' and vim.uv.fs_stat(file) then
    return vim.fn.bufadd(file)
  end
  error('there are no properties: open a file that ends in .ladder-test', 0)
end

--- Shows the answers below the window of the properties.
local function show(bufnr, properties)
  local lines = {}
  for _, property in ipairs(properties) do
    vim.list_extend(lines, lines_of(property))
  end
  local shown = require('ladder.side_buffer').with_lines(KIND, bufnr, lines)
  local height = math.min(#lines, math.max(3, math.floor(vim.o.lines / 3)))
  vim.cmd(('botright %dsplit'):format(height))
  vim.api.nvim_win_set_buf(0, shown)
  vim.wo.wrap = false
  vim.keymap.set('n', 'q', '<Cmd>close<CR>', { buffer = shown })
  vim.cmd('wincmd p')
end

--- Proves the properties of a buffer, or one of them.
--- @param bufnr integer
--- @param name string|nil
function M.run(bufnr, name)
  local server = require('ladder.server')
  local client = server.await(bufnr)
  if not client then
    return vim.notify('ladder: no language server is attached to this buffer.', vim.log.levels.ERROR)
  end
  local scenarios = scenarios_of(bufnr)
  local asked = { uri = vim.uri_from_bufnr(scenarios), name = name }
  vim.notify('ladder: proving...')
  server.command(client, bufnr, 'ladder.proveProperties', asked, function(err, answer)
    if err then
      return vim.notify('ladder: ' .. err.message, vim.log.levels.ERROR)
    end
    local count, wrong = {}, false
    for _, property in ipairs(answer.properties) do
      count[property.verdict] = (count[property.verdict] or 0) + 1
      wrong = wrong or not (property.verdict == 'proved' or property.verdict == 'possible')
    end
    local parts = {}
    for _, verdict in ipairs({ 'proved', 'possible', 'violated', 'impossible', 'unknown', 'vacuous' }) do
      if count[verdict] then
        table.insert(parts, ('%d %s'):format(count[verdict], verdict))
      end
    end
    show(scenarios, answer.properties)
    vim.notify('ladder: ' .. table.concat(parts, ', '), wrong and vim.log.levels.WARN or vim.log.levels.INFO)
  end)
end

return M
