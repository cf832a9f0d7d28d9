--- Values beside their operands, drawn over blanks and wires: text put between the elements of a line would push the
--- drawing apart.
require('ladder.highlight')

local labels = require('ladder.labels')
local sessions = require('ladder.session')
local value = require('ladder.value')

local M = {}

local namespace = vim.api.nvim_create_namespace('ladder_values')

--- @class ladder.PlacedLabel
--- @field label ladder.Label
--- @field tag ladder.Tag
--- @field place 'above'|'below'|'between'
--- @field column integer
--- @field name string the operand's tag
--- @field drawn boolean|nil

--- What is where, by buffer; computed when other lines are shown, or when a value outgrows its room.
--- @type table<integer, { labels: ladder.PlacedLabel[], marks: table<integer, string> }>
local placed = {}

--- @param tag ladder.Tag
--- @return string
local function text_of(tag)
  return value.show(tag) .. (tag.forced and '!' or '')
end

--- @param session ladder.Session
--- @return ladder.PlacedLabel[]
local function find_labels(session)
  local found = {}
  local encoding = session.client.offset_encoding
  for line, operands in pairs(session.operands) do
    local text = vim.api.nvim_buf_get_lines(session.bufnr, line, line + 1, false)[1] or ''
    for _, operand in ipairs(operands) do
      local tag = sessions.tag(session, operand.tags[1])
      -- The drawing itself tells a contact's value, unless somebody holds it, and the text that of a constant.
      local is_constant = tag and tag.readOnly and not vim.startswith(tag.name, 'SYS.')
      if tag and not is_constant and (not operand.drawn or tag.forced) then
        local byte = vim.str_byteindex(text, encoding, operand.range.start.character, false)
        table.insert(found, {
          name = operand.tags[1],
          drawn = operand.drawn,
          label = {
            row = line,
            column = vim.fn.strdisplaywidth(text:sub(1, byte)),
            text = text_of(tag),
            room = labels.room(tag.type),
          },
        })
      end
    end
  end
  table.sort(found, function(a, b)
    return a.label.row < b.label.row or (a.label.row == b.label.row and a.label.column < b.label.column)
  end)
  local places = labels.place(
    vim.tbl_map(function(it)
      return it.label
    end, found),
    function(row)
      return row >= 0 and vim.api.nvim_buf_get_lines(session.bufnr, row, row + 1, false)[1] or nil
    end
  )
  for index, place in ipairs(places) do
    found[index].place, found[index].column = place[1], place[2]
  end
  return found
end

--- @param tag ladder.Tag
local function group_of(tag)
  return tag.forced and 'LadderForced' or tag.value == true and 'LadderValueOn' or 'LadderValue'
end

--- What is over each line, and in a line of its own above it: pieces of text at their columns.
--- @param session ladder.Session
--- @param found ladder.PlacedLabel[]
local function rows_of(session, found)
  local rows = vim.defaulttable()
  for _, it in ipairs(found) do
    local tag = sessions.tag(session, it.name)
    if tag then
      local piece = { column = it.column, text = text_of(tag), group = group_of(tag) }
      if it.place == 'between' then
        table.insert(rows[it.label.row].between, piece)
      elseif it.place == 'above' then
        table.insert(rows[it.label.row - 1].over, piece)
      else
        -- Else it could be one of the line below.
        piece.text = '^' .. piece.text
        table.insert(rows[it.label.row + 1].over, piece)
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
  local function put(column, chunks)
    local options = { virt_text = chunks, virt_text_pos = 'overlay', undo_restore = false, strict = false }
    vim.api.nvim_buf_set_extmark(bufnr, namespace, row, column, options)
  end
  -- Past the end of the line one piece of text holds them all: a second one would cover the first.
  local behind = {}
  for _, it in ipairs(pieces) do
    if it.column < width then
      put(vim.fn.byteidx(line, it.column), { { it.text, it.group } })
    else
      table.insert(behind, it)
    end
  end
  if #behind > 0 then
    put(#line, joined(behind, width))
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
--- @param moved boolean other lines are shown, or a tag was forced or let go
function M.show(session, moved)
  local bufnr = session.bufnr
  local known = placed[bufnr]
  for _, it in ipairs(known and known.labels or {}) do
    local tag = sessions.tag(session, it.name)
    local room = math.max(it.label.room, vim.fn.strdisplaywidth(it.label.text))
    moved = moved or (tag ~= nil and vim.fn.strdisplaywidth(text_of(tag)) > room)
  end
  if moved or not known then
    known = { labels = find_labels(session), marks = {} }
    placed[bufnr] = known
    vim.api.nvim_buf_clear_namespace(bufnr, namespace, 0, -1)
  end
  local rows = rows_of(session, known.labels)
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
  placed[bufnr] = nil
  vim.api.nvim_buf_clear_namespace(bufnr, namespace, 0, -1)
end

return M
