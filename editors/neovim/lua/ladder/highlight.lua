--- The highlight groups. All are defaults: a colour scheme or a user's own `:highlight` goes first.
local M = {}

--- Power is told by colour and by weight, so that it is seen without colours too. The colour is the scheme's own for
--- "all is well"; a link cannot add the weight.
local function power_on()
  local ok = vim.api.nvim_get_hl(0, { name = 'DiagnosticOk', link = false })
  return { fg = ok.fg, ctermfg = ok.ctermfg or 10, bold = true, default = true }
end

--- The scheme's grey. Neovim's own scheme has none for 16 colours, where a plain link would leave the syntax colours
--- standing: then it is "bright black".
local function grey()
  local dim = vim.api.nvim_get_hl(0, { name = 'NonText', link = false })
  return { fg = dim.fg, ctermfg = dim.ctermfg or 8, default = true }
end

local links = {
  LadderStale = 'LadderPowerOff',
  LadderValue = 'LadderPowerOff',
  LadderValueOn = 'LadderPowerOn',
  LadderForced = 'DiagnosticWarn',
  LadderBreakpoint = 'DiagnosticError',
  LadderNext = 'Visual',
  LadderTagName = 'Identifier',
  LadderTagType = 'Type',
}

function M.define()
  vim.api.nvim_set_hl(0, 'LadderPowerOn', power_on())
  vim.api.nvim_set_hl(0, 'LadderPowerOff', grey())
  for name, target in pairs(links) do
    vim.api.nvim_set_hl(0, name, { link = target, default = true })
  end
end

M.define()
vim.api.nvim_create_autocmd('ColorScheme', {
  group = vim.api.nvim_create_augroup('ladder_highlight', {}),
  callback = M.define,
})

return M
