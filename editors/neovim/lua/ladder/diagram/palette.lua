--- The blocks that can be drawn, to be searched.
local change = require('ladder.change')

local M = {}

--- Lets somebody look for a block, and draws it.
--- @param pen ladder.Pen
function M.draw(pen)
  pen:place(function(target, offer)
    vim.ui.input({ prompt = 'Block (timer, XIC, counter up): ' }, function(search)
      if not search then
        return
      end
      change.ask(pen.source, 'ladder.diagramPalette', { search = search }, function(found)
        if #found.rows == 0 then
          return change.refuse(('there is no block for "%s"'):format(search))
        end
        local function draw(row)
          if row then
            pen:write(row, target, offer)
          end
        end
        local first = found.rows[1]
        local name = first.block:match('^.%s*(.-)%s*.$')
        if #found.rows == 1 or (name ~= '' and name:lower() == vim.trim(search):lower()) then
          return draw(first)
        end
        vim.ui.select(found.rows, {
          prompt = 'Draw:',
          kind = 'ladder_palette',
          format_item = function(row)
            return ('%-8s %s'):format(row.block, row.title)
          end,
        }, draw)
      end)
    end)
  end)
end

return M
