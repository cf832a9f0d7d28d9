--- Another head or other operands for a block; it moves, or goes.
local change = require('ladder.change')
local branches = require('ladder.diagram.branches')
local comments = require('ladder.diagram.comments')
local here = require('ladder.diagram.here')
local pens = require('ladder.diagram.pen')
local operands = require('ladder.diagram.operands')

local M = {}

--- Gives a contact or coil another head.
--- @param choose fun(head: string): string|nil
function M.head(pen, choose)
  pen:blocks(function(offer, what)
    local at = what[1].start
    local text = choose((offer.text or ''):sub(1, 3))
    if #what > 1 or not text then
      return change.refuse('select one contact or coil that there is such a kind of')
    end
    if not pens.is_refused(offer, 'head') then
      local head = { start = at, ['end'] = { line = at.line, character = at.character + 3 } }
      pen:edit({ op = 'head', what = head, text = text })
    end
  end)
end

--- What is in the parentheses of a block, and where.
--- @param range lsp.Range
--- @return string|nil text, lsp.Range|nil
local function inside(pen, range)
  local encoding = pen:encoding()
  local row = range.start.line
  local line = vim.api.nvim_buf_get_lines(pen.source, row, row + 1, false)[1] or ''
  local from = vim.str_byteindex(line, encoding, range.start.character, false)
  local to = vim.str_byteindex(line, encoding, range['end'].character, false)
  local block = line:sub(from + 1, to)
  local first, text, after = block:match('^[%[(<][^%])>]*[%])>]%s*%(%s*()(.-)()%s*%)$')
  if range['end'].line ~= row or not first then
    return nil
  end
  local function place(at)
    return { line = row, character = vim.str_utfindex(line, encoding, from + at - 1, false) }
  end
  return text, { start = place(first), ['end'] = place(after) }
end

--- Writes other operands, or the text of a comment.
function M.operands(pen)
  local block = pen:block()
  if not block then
    return
  end
  pen:offer({ what = { block.range } }, function(offer)
    local comment = (offer.text or ''):match('^#%s*(.-)%s*#$')
    if comment then
      return comments.write(pen, block.range, comment)
    end
    local text, what = inside(pen, block.range)
    if not text then
      return change.refuse('there are no parentheses')
    end
    local question = { prompt = 'Operands', text = text, is_bool = offer.text:match('^.[^%]]?[%])]') ~= nil }
    operands.ask(pen.source, question, function(new, declare)
      if new ~= text then
        local asked = { what = { block.range }, text = ('[ ]( %s )'):format(new) }
        pen:declared(declare, asked, function()
          pen:edit({ op = 'operand', what = what, text = new, declare = declare })
        end)
      end
    end)
  end)
end

--- Writes another name for the tag of a block, everywhere.
function M.rename(pen)
  local block = here.block(pen.diagram)
  local text, what = nil, nil
  if block then
    text, what = inside(pen, block.range)
  end
  local name = text and text:match('^[%a_][%w_]*')
  if not name then
    return change.refuse('there is no tag under the cursor')
  end
  vim.ui.input({ prompt = 'New name of ' .. name .. ': ', default = name }, function(new)
    if new and new ~= '' and new ~= name then
      pen:edit({ op = 'rename', what = { start = what.start, ['end'] = what.start }, text = new })
    end
  end)
end

function M.delete(pen)
  local what = here.ranges(here.selected(pen.diagram))
  if #what > 0 or pen:block() then
    pen:edit({ op = 'delete', what = what })
  end
end

--- Selects the next larger group.
function M.larger(pen)
  pen:blocks(function(offer)
    if not offer.larger then
      return change.refuse('there is no larger group')
    end
    here.select(pen.diagram, offer.largerThings)
  end)
end

--- Moves the block under the cursor along its rung or to the next one; of a branch its end.
--- @param way 'left'|'right'|'up'|'down'
function M.move(pen, way)
  local join = not here.block(pen.diagram) and here.join(pen.diagram)
  if join and (way == 'left' or way == 'right') then
    return branches.move_end(pen, join, way == 'right')
  end
  local block = pen:block()
  if not block then
    return
  end
  local argument = { range = block.range, edit = way }
  change.make(pen.source, 'ladder.edit', argument, function(edited)
    pen:show(edited.cursor)
  end)
end

return M
