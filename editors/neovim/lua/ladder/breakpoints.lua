--- Breakpoints of a buffer: signs next to rungs, which move with the text, and tags. They outlive a simulation.
require('ladder.highlight')

local M = {}

local namespace = vim.api.nvim_create_namespace('ladder_breakpoints')

--- @type table<integer, string[]>
local tags = {}

local function marks(bufnr, row)
  local from = row and { row, 0 } or 0
  local to = row and { row, -1 } or -1
  return vim.api.nvim_buf_get_extmarks(bufnr, namespace, from, to, {})
end

--- The lines with a breakpoint, counted from 0.
--- @param bufnr integer
--- @return integer[]
function M.lines(bufnr)
  return vim.tbl_map(function(mark)
    return mark[2]
  end, marks(bufnr))
end

--- @param bufnr integer
--- @param row integer counted from 0
function M.toggle_line(bufnr, row)
  local there = marks(bufnr, row)
  for _, mark in ipairs(there) do
    vim.api.nvim_buf_del_extmark(bufnr, namespace, mark[1])
  end
  if #there == 0 then
    vim.api.nvim_buf_set_extmark(bufnr, namespace, row, 0, {
      sign_text = '●',
      sign_hl_group = 'LadderBreakpoint',
      invalidate = true,
    })
  end
end

--- @param bufnr integer
--- @param name string
function M.toggle_tag(bufnr, name)
  local known = tags[bufnr] or {}
  tags[bufnr] = vim.tbl_filter(function(tag)
    return tag ~= name
  end, known)
  if #tags[bufnr] == #known then
    table.insert(tags[bufnr], name)
  end
end

--- What `ladder.simulate.breakpoints` takes besides the session.
--- @param bufnr integer
--- @return { lines: integer[], tags: string[] }
function M.argument(bufnr)
  return { lines = M.lines(bufnr), tags = tags[bufnr] or {} }
end

--- @param bufnr integer
--- @return boolean
function M.any(bufnr)
  return #M.lines(bufnr) > 0 or #(tags[bufnr] or {}) > 0
end

return M
