--- Asks for a value of a tag, and gives it: until the program writes another one, or for as long as it is forced.
local simulation = require('ladder.simulation')

--- @param source integer the buffer of the program
--- @param command 'set'|'force'
--- @param tag ladder.Tag
return function(source, command, tag)
  local prompt = ('%s %s (%s): '):format(command, tag.name, tag.type)
  vim.ui.input({ prompt = prompt, default = tag.text }, function(text)
    if text and text ~= '' then
      simulation.command(source, command, { tag = tag.name, text = text })
    end
  end)
end
