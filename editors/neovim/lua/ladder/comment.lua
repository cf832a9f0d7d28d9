--- Turns lines into comments and back. A comment cannot hold a `#`, so the editor's own `gc` would break a rung with a
--- duration in it: `T#5s` becomes `5s`, which means the same; where another `#` is, the command refuses.
local M = {}

local function is_comment(line)
  return line:match('^%s*#[^#]*#%s*$') ~= nil
end

local function is_blank(line)
  return line:match('^%s*$') ~= nil
end

local function uncommented(line)
  local indent, text = line:match('^(%s*)#%s?([^#]-)%s?#%s*$')
  return indent and indent .. text or line
end

--- @param text string without a `#` in its strings
local function without_prefixes(text)
  return (
    text:gsub('%f[%w_]([%a]+)#(%-?%d)', function(kind, digit)
      local folded = kind:upper()
      return (folded == 'T' or folded == 'TIME') and digit or nil
    end)
  )
end

--- @return string|nil nil if a `#` is in the way
local function commented(line)
  local indent, text = line:match('^(%s*)(.-)%s*$')
  -- A `$'` does not end a string.
  for string in text:gsub('%$.', ''):gmatch("'[^']*'") do
    if string:find('#', 1, true) then
      return nil
    end
  end
  local bare = without_prefixes(text)
  return not bare:find('#', 1, true) and ('%s# %s #'):format(indent, bare) or nil
end

--- All lines are comments: they are no longer. Else those that are not become one each.
--- @param lines string[]
--- @return string[]|nil lines
--- @return integer|nil refused the first line that holds another `#`, from 1
function M.toggle(lines)
  local all = vim.iter(lines):all(function(line)
    return is_blank(line) or is_comment(line)
  end)
  if all then
    return vim.tbl_map(uncommented, lines)
  end
  local result = {}
  for index, line in ipairs(lines) do
    result[index] = (is_blank(line) or is_comment(line)) and line or commented(line)
    if not result[index] then
      return nil, index
    end
  end
  return result
end

--- The operator's function: `gc` sets it as 'operatorfunc'.
function M.operate()
  local first, last = vim.api.nvim_buf_get_mark(0, '[')[1], vim.api.nvim_buf_get_mark(0, ']')[1]
  local lines, refused = M.toggle(vim.api.nvim_buf_get_lines(0, first - 1, last, false))
  if lines then
    vim.api.nvim_buf_set_lines(0, first - 1, last, false, lines)
  else
    local message = 'ladder: line %d holds a "#", which would end the comment. Write it without.'
    vim.notify(message:format(first + refused - 1), vim.log.levels.WARN)
  end
end

--- For a mapping with `expr`: begins the operator.
--- @return string
function M.start()
  vim.o.operatorfunc = "v:lua.require'ladder.comment'.operate"
  return 'g@'
end

return M
