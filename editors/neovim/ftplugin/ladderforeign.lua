-- A program of another system: most of them are XML, and coloured as such.
local name = vim.api.nvim_buf_get_name(0):lower()
if name:match('%.l5x$') or name:match('%.tcpou$') then
  vim.bo.syntax = 'xml'
end
