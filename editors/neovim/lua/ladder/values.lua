--- Values at the ends of lines. Never inside a line: text put between its elements would push the drawing apart.
require('ladder.highlight')

local operands = require('ladder.operands')
local value = require('ladder.value')

local M = {}

local namespace = vim.api.nvim_create_namespace('ladder_values')

--- @class ladder.Line
--- @field row integer
--- @field places integer[] of the tags it names, in the state's list
--- @field id integer|nil the extmark
--- @field shown string|nil what stands there now

--- The lines that show values. They depend on the text and the list of tags alone, so they are found once a session.
--- @type table<integer, ladder.Line[]>
local lines_of = {}

--- @param bufnr integer
--- @param state ladder.State
--- @param encoding string
--- @return ladder.Line[]
local function find_lines(bufnr, state, encoding)
  local blocks = {}
  for _, item in ipairs(state.power) do
    local from, to = item.range.start, item.range['end']
    if from.line == to.line then
      local text = vim.api.nvim_buf_get_lines(bufnr, from.line, from.line + 1, false)[1] or ''
      local first = vim.str_byteindex(text, encoding, from.character, false)
      local last = vim.str_byteindex(text, encoding, to.character, false)
      blocks[from.line] = blocks[from.line] or {}
      table.insert(blocks[from.line], text:sub(first + 1, last))
    end
  end
  local index = operands.index(state.tags)
  local lines = {}
  for row, texts in pairs(blocks) do
    local places = operands.places(texts, index)
    if #places > 0 then
      table.insert(lines, { row = row, places = places })
    end
  end
  return lines
end

--- @param tags ladder.Tag[]
--- @param places integer[]
--- @return [string, string][] chunks pieces of text, each with its highlight group
--- @return string key equal if and only if the chunks are
local function render(tags, places)
  local chunks, key = {}, {}
  for _, place in ipairs(places) do
    local tag = tags[place]
    local text = value.show(tag) .. (tag.forced and '!' or '')
    local group = tag.forced and 'LadderForced' or tag.value == true and 'LadderValueOn' or 'LadderValue'
    table.insert(chunks, { (#chunks == 0 and ' ' or '  ') .. tag.name .. '=', 'LadderValue' })
    table.insert(chunks, { text, group })
    table.insert(key, text)
  end
  return chunks, table.concat(key, '\0')
end

--- @param bufnr integer
--- @param state ladder.State
--- @param encoding string the position encoding of the server
function M.show(bufnr, state, encoding)
  lines_of[bufnr] = lines_of[bufnr] or find_lines(bufnr, state, encoding)
  for _, line in ipairs(lines_of[bufnr]) do
    local text, shown = render(state.tags, line.places)
    if shown ~= line.shown then
      line.shown = shown
      line.id = vim.api.nvim_buf_set_extmark(bufnr, namespace, line.row, 0, {
        id = line.id,
        virt_text = text,
        virt_text_pos = 'eol',
        hl_mode = 'combine',
        invalidate = true,
        undo_restore = false,
        strict = false,
      })
    end
  end
end

--- @param bufnr integer
function M.clear(bufnr)
  lines_of[bufnr] = nil
  vim.api.nvim_buf_clear_namespace(bufnr, namespace, 0, -1)
end

return M
