--- Room for signs next to the text: a column that comes and goes with the first finding would shift the drawing while a
--- person types in it.
local M = {}

--- What keeps the column where it is; nil if it stays anyway.
--- @param value string of 'signcolumn'
--- @return string|nil
function M.steady(value)
  local most = value == 'auto' and '1' or value:match('^auto:(%d)$')
  if most then
    return most == '1' and 'yes' or 'auto:1-' .. most
  end
end

--- Keeps the column in the windows that show this buffer.
function M.keep()
  local value = M.steady(vim.wo.signcolumn)
  if value then
    vim.opt_local.signcolumn = value
  end
end

return M
