--- Lists of tags, one for each program, remembered among the editor's own state: those of the trace, those that are watched.

--- So many programs are remembered, those that were shown last.
local most_programs = 200

--- What is remembered, the oldest first. A file that a user has broken counts as none.
--- @param file string
--- @return { program: string, tags: string[] }[]
local function read(file)
  local is_read, lines = pcall(vim.fn.readfile, file)
  local is_known, entries = pcall(vim.json.decode, is_read and table.concat(lines, '\n') or '[]')
  return vim.tbl_filter(function(entry)
    return type(entry) == 'table' and type(entry.program) == 'string' and vim.islist(entry.tags)
  end, is_known and vim.islist(entries) and entries or {})
end

--- The file of a program, or nil if it has none.
--- @param source integer
local function program_of(source)
  local name = vim.api.nvim_buf_get_name(source)
  return name ~= '' and vim.bo[source].buftype == '' and vim.fs.normalize(name) or nil
end

--- @class ladder.Remembered
--- @field of fun(source: integer): string[]|nil none if no tags were chosen
--- @field set fun(source: integer, tags: string[])

--- @param name string of the file in the folder of the editor's state, without `.json`
--- @return ladder.Remembered
return function(name)
  local function file()
    return vim.fs.joinpath(vim.fn.stdpath('state'), name .. '.json')
  end

  local M = {}

  --- Those of programs that are no file, and of this run of the editor.
  --- @type table<integer, string[]>
  local here = {}

  --- @param source integer
  --- @return string[]|nil none if no tags were chosen
  function M.of(source)
    source = source == 0 and vim.api.nvim_get_current_buf() or source
    if here[source] then
      return here[source]
    end
    local program = program_of(source)
    for _, entry in ipairs(program and read(file()) or {}) do
      if entry.program == program then
        return vim.tbl_filter(function(tag)
          return type(tag) == 'string'
        end, entry.tags)
      end
    end
  end

  --- @param source integer
  --- @param tags string[]
  function M.set(source, tags)
    if vim.deep_equal(M.of(source) or {}, tags) then
      return
    end
    here[source] = vim.deepcopy(tags)
    local program = program_of(source)
    if not program then
      return
    end
    local entries = vim.tbl_filter(function(entry)
      return entry.program ~= program
    end, read(file()))
    if #tags > 0 then
      table.insert(entries, { program = program, tags = tags })
    end
    entries = vim.list_slice(entries, math.max(#entries - most_programs + 1, 1))
    -- An empty list would be written as an object. Where nothing can be written, nothing is remembered.
    local text = #entries > 0 and vim.json.encode(entries) or '[]'
    pcall(vim.fn.mkdir, vim.fs.dirname(file()), 'p')
    local temporary = ('%s.%d'):format(file(), vim.fn.getpid())
    if pcall(vim.fn.writefile, { text }, temporary) then
      vim.uv.fs_rename(temporary, file())
    end
  end

  return M
end
