--- What is picked up and put down in the diagram, and copied as ladder text.
local change = require('ladder.change')
local here = require('ladder.diagram.here')
local pens = require('ladder.diagram.pen')

local M = {}

--- Takes the text of what is selected into a register, or that of the network where nothing is.
--- @param taken fun(what: lsp.Range[])|nil what is done besides
function M.copy(pen, taken)
  local register = vim.v.register
  local function keep(text, kind)
    vim.fn.setreg(register, text, kind)
    pens.tell('Copied: ' .. vim.split(vim.trim(text), '\n')[1])
  end
  if #here.selected(pen.diagram) == 0 and not taken then
    return pen:of_network(function(_, offer)
      keep(offer.text, 'V')
    end)
  end
  pen:blocks(function(offer, what)
    if pens.is_refused(offer, 'move') then
      return
    end
    keep(offer.text, offer.text:find('\n') and 'V' or 'v')
    if taken then
      taken(what)
    end
  end)
end

--- Picks up what is selected, to be put down elsewhere.
function M.pick_up(pen)
  M.copy(pen, function(what)
    pen.held = { what = what, tick = pen:tick() }
    pens.tell('Picked up: go where it is to be, and put it down')
  end)
end

--- Puts down what was picked up, or draws what a register holds.
function M.put_down(pen)
  local held = pen.held
  pen.held = nil
  if held and held.tick ~= pen:tick() then
    return change.refuse('the text is another one than when that was picked up: pick it up again')
  end
  local text = vim.fn.getreg(vim.v.register)
  if not held and text:match('^%s*[+#]') then
    return pen:edit({ op = 'network', network = here.line(pen.diagram), place = 'below', text = text, copied = true })
  end
  pen:place(function(target)
    if held then
      return pen:edit({ op = 'move', what = held.what, to = { at = target.at } })
    end
    pen:edit(vim.tbl_extend('error', target, { text = text, copied = true }))
  end)
end

return M
