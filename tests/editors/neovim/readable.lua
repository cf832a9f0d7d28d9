-- What the simulation shows can be read in colour schemes of either ground, also in those that do not name its colours.
return function(t)
  t.step('power, stops and breakpoints can be read in dark and light schemes', function()
    require('ladder.highlight')
    local contrast = require('ladder.contrast')
    local low = {}
    for scheme, ground in pairs({ default = 'dark', habamax = 'dark', slate = 'dark', morning = 'light', quiet = 'light', shine = 'light' }) do
      vim.o.background = ground
      vim.cmd.colorscheme(scheme)
      for _, name in ipairs({ 'PowerOn', 'PowerOff', 'Closed', 'ClosedOn', 'Blocks', 'Stops', 'Forced', 'Breakpoint' }) do
        local found = vim.api.nvim_get_hl(0, { name = 'Ladder' .. name, link = false }).fg
        if contrast.between(found, contrast.ground()) < contrast.READABLE then
          table.insert(low, ('%s in %s: #%06x'):format(name, scheme, found))
        end
      end
    end
    vim.o.background = 'dark'
    vim.cmd.colorscheme('default')
    t.equal('what cannot be read', {}, low)
  end)

  t.step('a scheme that names its colours keeps them', function()
    vim.api.nvim_set_hl(0, 'DiagnosticOk', { fg = 0x00ff00 })
    require('ladder.highlight').define()
    t.equal('power', 0x00ff00, vim.api.nvim_get_hl(0, { name = 'LadderPowerOn' }).fg)
    vim.cmd.colorscheme('default')
  end)
end
