--- Values of tags, from what a person types and to what a person reads.
local M = {}

local bools = {
  ['1'] = true,
  ['true'] = true,
  ['on'] = true,
  ['high'] = true,
  ['0'] = false,
  ['false'] = false,
  ['off'] = false,
  ['low'] = false,
}

local floats = { REAL = true, LREAL = true }

--- What is sent to the server for a value that was typed. What is not understood here goes as it is: the server knows
--- the tag's type best and says what is wrong.
--- @param type string|nil the tag's type, nil if it is not known
--- @param text string
--- @return boolean|number|string
function M.parse(type, text)
  if type == 'BOOL' then
    local value = bools[text:lower()]
    if value ~= nil then
      return value
    end
  end
  if type and vim.startswith(type, 'STRING') then
    return text:match("^'(.*)'$") or text
  end
  -- Past 2^53 a number would lose its last digits on the way: it goes as text.
  local plain = text:gsub('_', '')
  -- `tonumber` alone would also take 0x10, which is no number of the language.
  local number = plain:match('^[-+]?%d[%d.]*[eE]?[-+]?%d*$') and tonumber(plain)
  if number and math.abs(number) < 2 ^ 53 then
    return number
  end
  return text
end

local units = { { 'd', 86400000 }, { 'h', 3600000 }, { 'm', 60000 } }

--- A time in milliseconds as it is written in a program: 90500 is `1m30.5s`.
--- @param ms number
--- @return string
function M.duration(ms)
  if ms < 0 then
    return '-' .. M.duration(-ms)
  end
  if ms < 1000 then
    return ('%gms'):format(ms)
  end
  local text = ''
  for _, unit in ipairs(units) do
    local count = math.floor(ms / unit[2])
    if count > 0 then
      text = text .. ('%d%s'):format(count, unit[1])
      ms = ms - count * unit[2]
    end
  end
  if ms > 0 then
    text = text .. ('%.10gs'):format(ms / 1000)
  end
  return text
end

--- @param tag ladder.Tag
--- @return string
function M.show(tag)
  local value = tag.value
  if type(value) == 'boolean' then
    return value and '1' or '0'
  end
  if type(value) == 'number' then
    if tag.type == 'TIME' then
      return M.duration(value)
    end
    if floats[tag.type] then
      return ('%.7g'):format(value)
    end
    return ('%.0f'):format(value)
  end
  if vim.startswith(tag.type, 'STRING') then
    return ("'%s'"):format(value)
  end
  return tostring(value)
end

return M
