--- What draws in the diagram: each stroke is one change of the program, at what the cursor is on.
local change = require('ladder.change')
local cursor = require('ladder.diagram.cursor')
local here = require('ladder.diagram.here')
local operands = require('ladder.diagram.operands')

--- @class ladder.Pen
--- @field source integer the buffer of the program
--- @field diagram ladder.Diagram
--- @field redraw fun()
--- @field version integer of the text that the key was meant for
--- @field held { what: lsp.Range[], tick: integer }|nil what was picked up
--- @field begun { at: lsp.Position, what: lsp.Position, tick: integer }|nil where a branch begins
local Pen = {}
Pen.__index = Pen

local M = {}

local NOTHING = 'there is nothing under the cursor to draw at: go to a wire or a block'
local NO_BLOCK = 'there is no contact, coil or block under the cursor'
local NO_NETWORK = 'there is no network under the cursor'

--- @param source integer
--- @param diagram ladder.Diagram
--- @param redraw fun() called when the program has become another one
--- @return ladder.Pen
function M.new(source, diagram, redraw)
  return setmetatable({ source = source, diagram = diagram, redraw = redraw }, Pen)
end

--- A key was pressed: what it does is about the text as it is now.
function Pen:begin()
  self.version = vim.lsp.util.buf_versions[self.source]
end

--- @param what string
function M.tell(what)
  vim.api.nvim_echo({ { what } }, false, {})
end

--- How the server counts the characters of a line.
--- @return 'utf-8'|'utf-16'|'utf-32'
function Pen:encoding()
  local client = require('ladder.server').of(self.source)
  return client and client.offset_encoding or 'utf-16'
end

function Pen:tick()
  return vim.api.nvim_buf_get_changedtick(self.source)
end

--- Draws again, with the cursor on a place of the program.
--- @param place lsp.Position|nil
--- @param is_right_end boolean|nil as for `cursor.want`
function Pen:show(place, is_right_end)
  if place then
    cursor.want(self.source, self.diagram, place, is_right_end)
  end
  self.redraw()
end

--- @param edit table
--- @param done fun(edited: table)|nil what is shown then, unless it is what the server says
function Pen:edit(edit, done)
  change.make(self.source, 'ladder.diagramEdit', { version = self.version, edit = edit }, function(edited)
    M.tell(edited.said)
    if done then
      return done(edited)
    end
    local first = edited.select[1]
    self:show(edited.focus or first and first.start)
  end)
end

--- Asks what can be done.
--- @param asked table `at`, `what` or `network`, and a `text`
--- @param answer fun(offer: table)
function Pen:offer(asked, answer)
  asked.version = self.version
  change.ask(self.source, 'ladder.diagramOffer', asked, answer)
end

--- Says why something cannot be done, if it cannot.
--- @param offer table
--- @param op string
--- @return boolean
function M.is_refused(offer, op)
  for _, offered in ipairs(offer.offers) do
    if offered.op == op and offered.why then
      change.refuse(offered.why)
      return true
    end
  end
  return false
end

--- Asks where something goes: into the wire under the cursor, or after what is selected; into a network of its own where there
--- is none yet.
--- @param answer fun(target: table, offer: table) `target` is the change without its text
function Pen:place(answer)
  local blocks, wire = here.selected(self.diagram), here.wire(self.diagram)
  if #blocks > 0 or wire then
    return self:offer(#blocks > 0 and { what = here.ranges(blocks) } or { at = wire.at }, function(offer)
      if not M.is_refused(offer, 'insert') then
        answer({ op = 'insert', at = #blocks > 0 and offer.points.behind or wire.at }, offer)
      end
    end)
  end
  if #self.diagram.wires > 0 then
    return change.refuse(NOTHING)
  end
  answer({ op = 'network', network = here.line(self.diagram), place = 'below' }, {})
end

--- Asks for what the selected blocks are; says so where there are none.
--- @param answer fun(offer: table, what: lsp.Range[])
function Pen:blocks(answer)
  local what = here.ranges(here.selected(self.diagram))
  if #what == 0 then
    return change.refuse(NO_BLOCK)
  end
  self:offer({ what = what }, function(offer)
    answer(offer, what)
  end)
end

--- Asks for the operands of a block that is new, and draws it.
--- @param row { block: string, title: string, operands: string|nil } as a row of the palette
--- @param target table the change without its text
--- @param offer table
function Pen:write(row, target, offer)
  if not row.operands then
    return self:edit(vim.tbl_extend('error', target, { text = row.block }))
  end
  local free = row.operands ~= '' and row.operands or offer.name or 'tag_1'
  local question = { prompt = ('%s (%s)'):format(row.title, free), text = '', is_bool = #row.block == 3 }
  operands.ask(self.source, question, function(text, declare)
    local written = ('%s( %s )'):format(row.block, text ~= '' and text or free)
    local place = target.at or target.from
    self:declared(declare, place and { at = place, text = written }, function()
      self:edit(vim.tbl_extend('error', target, { text = written, declare = declare }))
    end)
  end)
end

--- Where somebody wrote only the type of a new name, the section in which it would be declared is taken.
--- @param declare { section: string|nil, type: string }|nil
--- @param asked table|nil as for `offer`
--- @param done fun()
function Pen:declared(declare, asked, done)
  if not declare or declare.section then
    return done()
  end
  declare.section = 'VAR'
  if not asked then
    return done()
  end
  self:offer(asked, function(offer)
    local first = (offer.declares or {})[1]
    declare.section = first and first.section or declare.section
    done()
  end)
end

--- Draws a block into the wire, or after the block under the cursor.
--- @param pen ladder.Pen
--- @param row table as of the palette
function M.put(pen, row)
  pen:place(function(target, offer)
    pen:write(row, target, offer)
  end)
end

--- The block under the cursor; says so where there is none.
--- @return ladder.DrawnBlock|nil
function Pen:block()
  local block = here.block(self.diagram)
  if not block then
    change.refuse(NO_BLOCK)
  end
  return block
end

--- @param answer fun(line: integer, offer: table)
function Pen:of_network(answer)
  local line = here.line(self.diagram)
  if not line then
    return change.refuse(NO_NETWORK)
  end
  self:offer({ network = line }, function(offer)
    answer(line, offer)
  end)
end

return M
