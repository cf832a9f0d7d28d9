--- One line about a session, for status lines and the panel's title.
local M = {}

--- @param session ladder.Session|nil
--- @return string empty if there is none
function M.text(session)
  if not session then
    return ''
  end
  return session.state and session.state.text or 'starting'
end

return M
