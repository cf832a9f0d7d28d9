--- The simulation sessions that are open, one a buffer at most, and what is known of each.
---
--- A session follows the text of its buffer. `tick` is the buffer's change count at the last edit, which the server knows as
--- the text's version: until its states are of that version, what they say about places is about an older text.
local M = {}

--- @class ladder.Session
--- @field bufnr integer
--- @field client vim.lsp.Client
--- @field tick integer
--- @field id string|nil the server's name for it; nil until the server has answered
--- @field state ladder.State|nil the last one received
--- @field tags table<string, ladder.Tag> what is known of tags, by their names in lower case
--- @field power table<integer, table<integer, ladder.Power>> what is known of elements, by line and column
--- @field operands table<integer, ladder.Operand[]> those of the lines that are shown, by line
--- @field labels ladder.Label[] where values are shown
--- @field stale boolean the text is newer than what the server has answered about
--- @field waiting fun()[] commands that wait for the one under way
--- @field busy boolean a command is under way
--- @field asked integer how many commands had taken effect at the last answer
--- @field seen integer how many of them are in the picture that is shown
--- @field hits integer the number of the last hit that was reported
--- @field debugged boolean|nil its breakpoints are the debugger's

--- @class ladder.State
--- @field session string
--- @field uri string
--- @field version integer
--- @field stale boolean the text has errors; the last program without any runs on
--- @field change { number: integer, scan: integer, lost: { message: string }[]|nil }|nil
--- @field program integer|nil the number of the change that brought the program which runs
--- @field delta boolean|nil
--- @field status 'paused'|'running'|'ended'|'faulted'
--- @field text string how it is, in words
--- @field scan integer
--- @field timeMs number
--- @field behind integer
--- @field ahead integer
--- @field forced integer
--- @field commands integer
--- @field next lsp.Range|nil
--- @field hit { number: integer, message: string, range: lsp.Range|nil }|nil
--- @field tags ladder.Tag[]
--- @field power ladder.Power[]
--- @field operands ladder.Operand[]|nil
--- @field labels ladder.Label[]|nil all of them, whenever one is at another place
--- @field faults { message: string, range: lsp.Range, scan: integer }[]

--- @class ladder.Power
--- @field range lsp.Range
--- @field on boolean
--- @field unknown boolean? of a controller: that is not known
--- @field contact 'closed'|'open'|'blocks'|nil

--- @class ladder.Operand
--- @field range lsp.Range
--- @field block lsp.Range
--- @field tags string[]
--- @field drawn boolean|nil

--- @class ladder.Label where the value of an operand is shown
--- @field tag string whose text it is
--- @field at lsp.Position where the operand begins
--- @field side 'above'|'below'|'between'
--- @field column integer

--- @class ladder.Tag
--- @field name string
--- @field type string
--- @field value any
--- @field text string the value as people read it
--- @field role 'input'|'output'|'internal'
--- @field forced boolean
--- @field readOnly boolean|nil

--- @type table<integer, ladder.Session>
local sessions = {}

--- @param bufnr integer
--- @param client vim.lsp.Client
--- @return ladder.Session
function M.open(bufnr, client)
  local session = {
    bufnr = bufnr,
    client = client,
    tick = vim.api.nvim_buf_get_changedtick(bufnr),
    tags = {},
    power = {},
    operands = {},
    labels = {},
    stale = false,
    waiting = {},
    busy = false,
    asked = 0,
    seen = 0,
    hits = 0,
  }
  sessions[bufnr] = session
  return session
end

--- Takes in what a state tells of the drawing.
--- @param session ladder.Session
--- @param state ladder.State
function M.take(session, state)
  session.labels = state.labels or session.labels
  for _, tag in ipairs(state.tags) do
    session.tags[vim.fn.tolower(tag.name)] = tag
  end
  for _, element in ipairs(state.power) do
    local start = element.range.start
    session.power[start.line] = session.power[start.line] or {}
    session.power[start.line][start.character] = element
  end
  local fresh = {}
  for _, operand in ipairs(state.operands or {}) do
    local line = operand.block.start.line
    -- The operands of a line come together.
    session.operands[line] = fresh[line] and session.operands[line] or {}
    fresh[line] = true
    table.insert(session.operands[line], operand)
  end
end

--- Forgets all that is known of the drawing and the tags.
--- @param session ladder.Session
function M.reset(session)
  session.tags = {}
  session.power = {}
  session.operands = {}
  session.labels = {}
end

--- Forgets the lines that are not shown any more.
--- @param session ladder.Session
--- @param is_shown fun(line: integer): boolean
function M.forget(session, is_shown)
  for _, lines in ipairs({ session.power, session.operands }) do
    for line in pairs(lines) do
      if not is_shown(line) then
        lines[line] = nil
      end
    end
  end
end

--- @param bufnr integer
--- @return ladder.Session|nil
function M.of(bufnr)
  return sessions[bufnr]
end

--- The session that the server calls `id`; ids are unique for one server only.
--- @param id string
--- @param client_id integer
--- @return ladder.Session|nil
function M.find(id, client_id)
  for _, session in pairs(sessions) do
    if session.id == id and session.client.id == client_id then
      return session
    end
  end
end

--- @return ladder.Session[]
function M.all()
  return vim.tbl_values(sessions)
end

--- @param bufnr integer
function M.close(bufnr)
  sessions[bufnr] = nil
end

--- The tag of that name, whatever its case, if it is known.
--- @param session ladder.Session|nil
--- @param name string
--- @return ladder.Tag|nil
function M.tag(session, name)
  return session and session.tags[vim.fn.tolower(name)]
end

return M
