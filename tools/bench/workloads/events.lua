-- events.xml written by hand: a table of states, each with a table of its
-- transitions by event.
local machine = {}
local function edge(from, to)
  machine[from] = {
    Next = {
      target = to,
      guard = function(context) return context.n < 1000000000 end,
      action = function(context) context.n = context.n + 1 end,
    },
  }
end
edge("Idle", "Greeting")
edge("Greeting", "Asking")
edge("Asking", "Confirm")
edge("Confirm", "Done")
edge("Done", "Idle")

local function send(session, event)
  local transition = machine[session.state][event]
  if transition and transition.guard(session.context) then
    transition.action(session.context)
    session.state = transition.target
  end
end

return function()
  local count = 1000002
  local session = { state = "Idle", context = { n = 0 } }
  for _ = 1, count do send(session, "Next") end
  return count, session.state
end
