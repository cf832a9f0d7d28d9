--- Passes the messages of a debugger to the session that the buffer shows, and back. The debugger connects to a pipe that
--- is Neovim's own: no other program runs.
local M = {}

--- @class ladder.Bridge
--- @field client vim.lsp.Client
--- @field session string the server's name for it
--- @field socket uv.uv_pipe_t|nil there when the debugger is
--- @field waiting string[] what was said before it was

--- @type ladder.Bridge[]
local bridges = {}

--- Takes whole messages off the front of what has come, and calls back with each.
--- @param text string
--- @param take fun(message: table)
--- @return string rest
local function unpack_messages(text, take)
  while true do
    local header_end, body_start = text:find('\r\n\r\n', 1, true)
    local length = header_end and tonumber(text:sub(1, header_end):match('Content%-Length: *(%d+)'))
    if not length or #text < body_start + length then
      return text
    end
    take(vim.json.decode(text:sub(body_start + 1, body_start + length)))
    text = text:sub(body_start + length + 1)
  end
end

--- The name of a pipe that nobody has.
local function pipe_name()
  if vim.fn.has('win32') == 1 then
    return ([[\\.\pipe\ladder-%d-%d]]):format(vim.fn.getpid(), vim.uv.hrtime())
  end
  return vim.fn.tempname()
end

--- Waits for a debugger at a pipe.
--- @param client vim.lsp.Client
--- @param session string
--- @param gone fun() called when the debugger has left
--- @return string pipe
function M.open(client, session, gone)
  local bridge = { client = client, session = session, waiting = {} }
  table.insert(bridges, bridge)
  local pipe = pipe_name()
  local server = assert(vim.uv.new_pipe(false))
  assert(server:bind(pipe))
  server:listen(1, function(err)
    assert(not err, err)
    local socket = assert(vim.uv.new_pipe(false))
    server:accept(socket)
    server:close()
    bridge.socket = socket
    for _, frame in ipairs(bridge.waiting) do
      socket:write(frame)
    end
    local received = ''
    socket:read_start(vim.schedule_wrap(function(failed, data)
      if failed or not data then
        if not socket:is_closing() then
          socket:close()
        end
        bridges = vim.tbl_filter(function(it)
          return it ~= bridge
        end, bridges)
        return gone()
      end
      received = unpack_messages(received .. data, function(message)
        client:notify('ladder/toDebugger', { session = session, message = message })
      end)
    end))
  end)
  return pipe
end

--- A `ladder/fromDebugger` from the server.
--- @param said { session: string, message: table }
--- @param client_id integer
function M.receive(said, client_id)
  for _, bridge in ipairs(bridges) do
    if bridge.session == said.session and bridge.client.id == client_id then
      local body = vim.json.encode(said.message)
      local frame = ('Content-Length: %d\r\n\r\n%s'):format(#body, body)
      if not bridge.socket then
        table.insert(bridge.waiting, frame)
      elseif not bridge.socket:is_closing() then
        bridge.socket:write(frame)
      end
    end
  end
end

return M
