--- The tags that the blocks of a line name, for the values at its end.
local M = {}

-- A letter of any script, or what begins a direct address.
local word = '[%a_%%\128-\255][%w_\128-\255]*'
-- The members worth a place at the end of a line, most telling first.
local shown_members = { 'et', 'cv', 'q', 'q1', 'qu', 'qd' }

--- The names in a block's operand list, in order, with indices and members: `a[3]`, `t.ET`, `%IX0.3`.
--- @param block string the block as it stands in the text
--- @return string[]
function M.names(block)
  local list = block:match('^[%[%(<].-[%]%)>]%s*%((.*)%)$')
  if not list then
    return {}
  end
  -- Strings first: they may hold a `#`; and before them the `$'` that does not end one. Then literals with a prefix
  -- (16#FF, T#5s), and comments last.
  list = list:gsub("%$[$']", ' '):gsub("'[^']*'", ' '):gsub('[%w_]+#[%w_%.:%-]*', ' '):gsub('#.-#', ' ')
  local names = {}
  local at = 1
  while true do
    local first, last = list:find(word, at)
    if not first then
      return names
    end
    local _, tail = list:find('^[%.%w_\128-\255%[%]]*', last + 1)
    local name = list:sub(first, math.max(last, tail))
    -- A digit before it makes it part of a number: 5s, 1.0e-3.
    if not list:sub(first - 1, first - 1):match('[%d%.]') then
      table.insert(names, name)
    end
    at = math.max(last, tail) + 1
  end
end

--- Names of tags, in lower case, to their places in the state's list.
--- @param tags ladder.Tag[]
--- @return table<string, integer>
function M.index(tags)
  local index = {}
  for place, tag in ipairs(tags) do
    index[vim.fn.tolower(tag.name)] = place
  end
  return index
end

--- @param index table<string, integer>
--- @param name string in lower case
--- @return integer[] places in the state's list; more than one for a timer or counter
local function places_of(index, name)
  if index[name] then
    return { index[name] }
  end
  local places = {}
  for _, member in ipairs(shown_members) do
    table.insert(places, index[name .. '.' .. member])
  end
  return places
end

--- The places in the state's list of every tag that these blocks name, each once.
--- @param blocks string[]
--- @param index table<string, integer>
--- @return integer[]
function M.places(blocks, index)
  local places, seen = {}, {}
  for _, block in ipairs(blocks) do
    for _, name in ipairs(M.names(block)) do
      name = vim.fn.tolower(name)
      local found = places_of(index, name)
      if #found == 0 then
        -- `word.3`, `a[i]`: the tag itself is what has a value.
        found = places_of(index, (name:match('^[^%.%[]+')))
      end
      for _, place in ipairs(found) do
        if not seen[place] then
          seen[place] = true
          table.insert(places, place)
        end
      end
    end
  end
  return places
end

return M
