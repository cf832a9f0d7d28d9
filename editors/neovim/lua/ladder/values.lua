--- Values next to their operands, drawn over blanks and wires: text put between the elements of a line would push the
--- drawing apart.
require('ladder.highlight')

local sessions = require('ladder.session')

local M = {}

local namespace = vim.api.nvim_create_namespace('ladder_values')

--- What is drawn, by buffer: the labels, and what each line has of them.
--- @type table<integer, { labels: ladder.Label[], marks: table<integer, string> }>
local drawn = {}

--- @param tag ladder.Tag
local function group_of(tag)
  return tag.forced and 'LadderForced' or tag.value == true and 'LadderValueOn' or 'LadderValue'
end

--- What is over each line, and in a line of its own above it: pieces of text at their columns.
--- @param session ladder.Session
local function rows_of(session)
  local rows = vim.defaulttable()
  for _, label in ipairs(session.labels) do
    local tag = sessions.tag(session, label.tag)
    if tag then
      local text = (label.index or '') .. tag.text .. (tag.forced and '!' or '')
      local piece = { column = label.column, text = text, group = group_of(tag) }
      local row = label.at.line
      if label.side == 'between' then
        table.insert(rows[row].between, piece)
      elseif label.side == 'after' then
        table.insert(rows[row].over, piece)
      elseif label.side == 'above' then
        table.insert(rows[row - 1].over, piece)
      else
        -- Else it could be one of the line below.
        piece.text = '^' .. text
        table.insert(rows[row + 1].over, piece)
      end
    end
  end
  return rows
end

--- Equal if and only if the content is.
local function key_of(content)
  local key = {}
  for _, pieces in ipairs({ rawget(content, 'over') or {}, rawget(content, 'between') or {} }) do
    for _, it in ipairs(pieces) do
      table.insert(key, ('%d %s %s'):format(it.column, it.group, it.text))
    end
  end
  return table.concat(key, '\0')
end

--- @alias ladder.Piece { column: integer, text: string, group: string }

--- Pieces as one text that begins at a column.
--- @param pieces ladder.Piece[]
--- @param column integer
--- @return [string, string?][] chunks
local function joined(pieces, column)
  local chunks = {}
  for _, it in ipairs(pieces) do
    table.insert(chunks, { (' '):rep(it.column - column) })
    table.insert(chunks, { it.text, it.group })
    column = it.column + vim.fn.strdisplaywidth(it.text)
  end
  return chunks
end

--- @param bufnr integer
--- @param row integer
--- @param pieces ladder.Piece[]
local function put_over(bufnr, row, pieces)
  local line = vim.api.nvim_buf_get_lines(bufnr, row, row + 1, false)[1] or ''
  local width = vim.fn.strdisplaywidth(line)
  table.sort(pieces, function(a, b)
    return a.column < b.column
  end)
  local function put(column, chunks, position)
    local options = { virt_text = chunks, virt_text_pos = position, undo_restore = false, strict = false }
    vim.api.nvim_buf_set_extmark(bufnr, namespace, row, column, options)
  end
  -- Past the end of the line one piece of text holds them all: a second one would cover the first.
  local trailing = {}
  for _, it in ipairs(pieces) do
    if it.column < width then
      put(vim.fn.byteidx(line, it.column), { { it.text, it.group } }, 'overlay')
    else
      table.insert(trailing, it)
    end
  end
  if #trailing > 0 then
    -- At the end of a line texts make room for each other: the messages of diagnostics come after. Neovim puts a blank in front.
    put(#line, joined(trailing, width + 1), 'eol')
  end
end

--- @param bufnr integer
--- @param row integer
--- @param pieces ladder.Piece[]
local function put_between(bufnr, row, pieces)
  -- Above the first line of a text nothing can be seen.
  local first = row == 0
  vim.api.nvim_buf_set_extmark(bufnr, namespace, row, 0, {
    virt_lines = { joined(pieces, 0) },
    virt_lines_above = not first,
    undo_restore = false,
    strict = false,
  })
end

--- @param session ladder.Session
function M.show(session)
  local bufnr = session.bufnr
  local known = drawn[bufnr]
  if not known or known.labels ~= session.labels then
    known = { labels = session.labels, marks = {} }
    drawn[bufnr] = known
    vim.api.nvim_buf_clear_namespace(bufnr, namespace, 0, -1)
  end
  local rows = rows_of(session)
  for row, content in pairs(rows) do
    local key = key_of(content)
    if known.marks[row] ~= key then
      known.marks[row] = key
      vim.api.nvim_buf_clear_namespace(bufnr, namespace, row, row + 1)
      if rawget(content, 'over') then
        put_over(bufnr, row, content.over)
      end
      if rawget(content, 'between') then
        put_between(bufnr, row, content.between)
      end
    end
  end
end

--- @param bufnr integer
function M.clear(bufnr)
  drawn[bufnr] = nil
  vim.api.nvim_buf_clear_namespace(bufnr, namespace, 0, -1)
end

return M
