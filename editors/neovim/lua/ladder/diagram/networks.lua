--- Networks come, move, part and join.
local here = require('ladder.diagram.here')
local pens = require('ladder.diagram.pen')

local M = {}

--- Asks for a whole network.
--- @param side 'below'|'above'
function M.write(pen, side)
  local line = here.line(pen.diagram)
  vim.ui.input({ prompt = 'XIC start XIO stop OTE run: ' }, function(entry)
    if entry and entry ~= '' then
      pen:edit({ op = 'network', network = line, place = side, entry = entry })
    end
  end)
end

--- Asks for a piece of a network.
function M.entry(pen)
  pen:place(function(target)
    vim.ui.input({ prompt = 'XIC a BST XIO b NXB XIC c BND: ' }, function(text)
      if text and text ~= '' then
        pen:edit(vim.tbl_extend('error', target, { text = text }))
      end
    end)
  end)
end

--- Changes the network under the cursor.
--- @param op string as it is offered
--- @param edit fun(line: integer, next: { above: integer|nil, below: integer|nil, after: integer|nil }): table
local function change(op, edit)
  return function(pen)
    pen:of_network(function(line, offer)
      if not pens.is_refused(offer, op) then
        pen:edit(edit(line, offer.neighbours))
      end
    end)
  end
end

M.join = change('merge', function(line, next)
  return { op = 'merge', networks = { line, next.below } }
end)

M.duplicate = change('duplicate', function(line)
  return { op = 'duplicate', network = line }
end)

M.delete = change('delete', function(line)
  return { op = 'delete', network = line }
end)

M.move_up = change('moveUp', function(line, next)
  return { op = 'moveNetwork', network = line, before = next.above }
end)

M.move_down = change('moveDown', function(line, next)
  return { op = 'moveNetwork', network = line, before = next.after }
end)

--- Makes two networks of one, before the block or at the wire under the cursor.
function M.split(pen)
  local wire = not here.block(pen.diagram) and here.wire(pen.diagram)
  if wire then
    return pen:edit({ op = 'split', at = wire.at })
  end
  pen:blocks(function(offer)
    if not pens.is_refused(offer, 'split') then
      pen:edit({ op = 'split', at = offer.points.before })
    end
  end)
end

return M
