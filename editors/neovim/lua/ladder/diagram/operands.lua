--- Asks for what is in the parentheses of a block. Tags are completed; a name that is new is seen before it is taken.
require('ladder.highlight')

local change = require('ladder.change')

local M = {}

--- The tags that there are while somebody is asked, by their lower-case names; nothing until the server has told them.
--- @type table<string, table>|nil
local known
local wants_bool = false

--- In milliseconds. Who completes a tag waits so long for the tags of a long program.
local PATIENCE = 2000

--- What completes the question: the last word, by those that begin so first.
--- @param lead string
--- @return string[]
function M.complete(lead)
  local before, word = lead:match('^(.-)([%w_.$]*)$')
  word = word:lower()
  vim.wait(PATIENCE, function()
    return known ~= nil
  end, 5)
  local names = {}
  for name, tag in pairs(known or {}) do
    if name:find(word, 1, true) and (not wants_bool or tag.type == 'BOOL') then
      table.insert(names, tag.name)
    end
  end
  local function rank(name)
    return (vim.startswith(name:lower(), word) and '0' or '1') .. name:lower()
  end
  table.sort(names, function(one, two)
    return rank(one) < rank(two)
  end)
  return vim.tbl_map(function(name)
    return before .. name
  end, names)
end

--- The names in a text that are new, for `vim.ui.input`.
--- @param text string
--- @return any[][]
local function new_names(text)
  local marks = {}
  local declared = text:find(':', 1, true) or #text + 1
  for at, word in text:gmatch('()([%a_][^%s,()]*)') do
    local name = word:match('^[%w_]+')
    local is_name = word:match('^[%w_]+$') or word:match('^[%w_]+[.%[]')
    local is_literal = name:upper() == 'TRUE' or name:upper() == 'FALSE'
    if at < declared and is_name and not is_literal and known and not known[name:lower()] then
      table.insert(marks, { at - 1, at - 1 + #name, 'LadderNewTag' })
    end
  end
  return marks
end

--- What was typed as `name : SECTION TYPE`, in parts.
--- @param text string
--- @return string text, { section: string|nil, type: string }|nil
local function parts(text)
  local name, declaration = text:match('^%s*([%a_][%w_]*)%s*:%s*([^=].*)$')
  if not name then
    return vim.trim(text), nil
  end
  local section, type = declaration:match('^(VAR[%u_]*)%s+(.+)$')
  return name, { section = section, type = vim.trim(type or declaration) }
end

--- @param source integer
--- @param question { prompt: string, text: string, is_bool: boolean }
--- @param answer fun(text: string, declare: { section: string|nil, type: string }|nil)
function M.ask(source, question, answer)
  known, wants_bool = nil, question.is_bool
  change.ask(source, 'ladder.crossReference', {}, function(found)
    known = {}
    for _, tag in ipairs(found.tags) do
      known[tag.name:lower()] = tag
    end
  end)
  vim.ui.input({
    prompt = question.prompt .. ': ',
    default = question.text,
    completion = "customlist,v:lua.require'ladder.diagram.operands'.complete",
    highlight = new_names,
  }, function(text)
    if text then
      answer(parts(text))
    end
  end)
end

return M
