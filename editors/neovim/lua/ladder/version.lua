--- Whether a server and this plugin are made for each other. They are released together, under one number.
local M = {}

--- The plugin's own version.
M.plugin = '0.1.0'

--- @param version string
--- @return integer[]|nil
local function numbers(version)
  local major, minor, patch, rest = version:match('^(%d+)%.(%d+)%.(%d+)(.*)$')
  if not major or not (rest == '' or rest:match('^[-+]')) then
    return nil
  end
  return { tonumber(major), tonumber(minor), tonumber(patch) }
end

--- Compares versions as Cargo does: what is not to be broken is the first number that is not 0.
--- @param server string|nil such as `0.1.0`
--- @param plugin string|nil the plugin's own, if none is given
--- @return string|nil misfit what a person should know; nil if they fit
function M.misfit(server, plugin)
  plugin = plugin or M.plugin
  local theirs, ours = numbers(server or ''), assert(numbers(plugin))
  if not theirs then
    return ('This is not the language server: its version is "%s".'):format(server or '')
  end
  local kept = 3
  for index = 3, 1, -1 do
    kept = ours[index] > 0 and index or kept
  end
  for index = 1, 3 do
    local update = nil
    if theirs[index] < ours[index] then
      update = 'the server'
    elseif theirs[index] > ours[index] then
      if index > kept then
        return nil
      end
      update = 'the plugin'
    end
    if update then
      return ('The language server has version %s, this plugin %s. Some things will not work until %s is updated.'):format(
        server,
        plugin,
        update
      )
    end
  end
end

local said = false

--- Says once that a server does not fit.
--- @param client vim.lsp.Client
function M.check(client)
  local info = client.server_info or {}
  local misfit = M.misfit(info.version)
  if misfit and not said then
    said = true
    vim.notify('ladder: ' .. misfit .. ' :checkhealth ladder says more.', vim.log.levels.WARN)
  end
end

return M
