--- One line about a session, for status lines and the panel's title.
local value = require('ladder.value')

local M = {}

--- @param session ladder.Session|nil
--- @return string empty if there is none
function M.text(session)
  if not session then
    return ''
  end
  local state = session.state
  if not state then
    return 'starting'
  end
  local text = ('%s, scan %d, %s'):format(state.status, state.scan, value.duration(state.timeMs))
  if session.speed ~= 1 then
    text = text .. (session.speed == 'max' and ', full speed' or (', %gx speed'):format(session.speed))
  end
  if (state.forced or 0) > 0 then
    text = text .. (', %d forced'):format(state.forced)
  end
  if #state.faults > 0 then
    text = text .. (', %d fault%s'):format(#state.faults, #state.faults == 1 and '' or 's')
  end
  return state.stale and text .. ' (before the errors in the text)' or text
end

return M
