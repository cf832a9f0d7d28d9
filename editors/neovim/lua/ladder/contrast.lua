--- Whether a colour can be read on another one.
local M = {}

--- What normal text needs, after the Web Content Accessibility Guidelines.
M.READABLE = 4.5

--- @param value integer a part of a colour, 0 to 255
local function linear(value)
  local part = value / 255
  return part <= 0.03928 and part / 12.92 or ((part + 0.055) / 1.055) ^ 2.4
end

--- @param colour integer 0xRRGGBB
local function luminance(colour)
  local red, green, blue = bit.rshift(colour, 16), bit.band(bit.rshift(colour, 8), 0xff), bit.band(colour, 0xff)
  return 0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue)
end

--- @param one integer 0xRRGGBB
--- @param other integer
--- @return number from 1, the same, to 21, black and white
function M.between(one, other)
  local light, dark = luminance(one), luminance(other)
  if light < dark then
    light, dark = dark, light
  end
  return (light + 0.05) / (dark + 0.05)
end

--- @return integer what the text is on; where a scheme leaves that to the terminal, what 'background' says
function M.ground()
  local ground = vim.api.nvim_get_hl(0, { name = 'Normal', link = false }).bg
  return ground or (vim.o.background == 'dark' and 0x000000 or 0xffffff)
end

return M
