--- Finds a program on the PATH, or where Cargo installs programs, by its whole path.
---
--- A bare name would be looked for by the system, and Windows looks in the current folder first: a folder that a user
--- opened must not bring a program of its own. Folders of the PATH that are not given whole, or lie in the current
--- folder, do not count for the same reason.
local M = {}

local NOWHERE = '/not-on-the-PATH/'

--- @class ladder.Surroundings
--- @field path string the variable PATH
--- @field windows boolean
--- @field here string the current folder
--- @field cargo string|nil the folder that Cargo installs programs into
--- @field is_program fun(path: string): boolean

--- @return ladder.Surroundings
local function surroundings()
  return {
    path = vim.env.PATH or '',
    windows = vim.fn.has('win32') == 1,
    here = vim.uv.cwd() or '',
    -- An editor that was started from a menu often does not have it on its PATH.
    cargo = vim.fs.joinpath(vim.env.CARGO_HOME or vim.fs.joinpath(vim.uv.os_homedir() or '', '.cargo'), 'bin'),
    is_program = function(path)
      return vim.fn.isdirectory(path) == 0 and vim.fn.executable(path) == 1
    end,
  }
end

--- Folders as they can be compared: with slashes, without one at the end, and on Windows in small letters.
--- @param folder string
--- @param it ladder.Surroundings
--- @return string
local function plain(folder, it)
  if it.windows then
    folder = vim.fn.tolower((folder:gsub('\\', '/')))
  end
  return (folder:gsub('/+$', ''))
end

--- @param folder string
--- @param it ladder.Surroundings
local function counts(folder, it)
  local way = plain(folder, it)
  local whole = vim.startswith(folder, '/')
  if it.windows then
    whole = way:match('^%a:/') ~= nil or way:match('^%a:$') ~= nil or vim.startswith(way, '//')
  end
  local here = plain(it.here, it)
  local climbs = ('/' .. way .. '/'):find('/../', 1, true) ~= nil
  return whole and not climbs and way ~= here and (here == '' or not vim.startswith(way, here .. '/'))
end

--- @param name string without an ending
--- @param given ladder.Surroundings|nil
--- @return string|nil path
function M.find(name, given)
  local it = given or surroundings()
  local folders = vim.split(it.path, it.windows and ';' or ':', { plain = true })
  table.insert(folders, it.cargo)
  for _, folder in ipairs(folders) do
    if counts(folder, it) then
      local path = folder:gsub('[/\\]+$', '') .. '/' .. name .. (it.windows and '.exe' or '')
      if it.is_program(path) then
        return path
      end
    end
  end
end

--- What starts a program: its path; where there is none, a path that leads nowhere and says why.
--- @param name string
--- @return string
function M.command(name)
  return M.find(name) or (NOWHERE .. name)
end

--- Whether that is what `M.command` returned because there is no such program.
--- @param command string|nil
function M.is_nowhere(command)
  return command ~= nil and vim.startswith(command, NOWHERE)
end

--- What a program prints when it is asked for its version.
--- @param program string
--- @return string|nil line the first one; nil if it does not start
function M.version(program)
  local started, job = pcall(vim.system, { program, '--version' }, { text = true, timeout = 3000 })
  if not started then
    return nil
  end
  local result = job:wait()
  return result.code == 0 and vim.trim(result.stdout):match('^[^\n]+') or nil
end

--- The program `ladder`: that of the language server, if it is set.
--- @return string
function M.ladder()
  local command = (vim.lsp.config.ladder or {}).cmd
  return type(command) == 'table' and command[1] or M.command('ladder')
end

return M
