-- turns.xml written by hand: frames with slots, a stack of topics, the return.
local facility = {
  slots = {
    { name = "name", question = "Which facility do you want to know more?",
      set = { ["swimming pool"] = true, ["sky garden"] = true,
              ["auditorium"] = true, ["star home"] = true } },
    { name = "what",
      question = "What do you want to know, location or opening hours?",
      set = { ["location"] = true, ["opening hours"] = true } },
  },
  completed = function(values)
    return "The " .. values.name .. " " .. values.what ..
      " is on floor twenty three."
  end,
}
local taxi = {
  slots = { { name = "destination", question = "Where do you want to go?" } },
  completed = function(values)
    return "Your taxi to " .. values.destination .. " is booked."
  end,
}
local more = {
  slots = { { name = "wish", question = "Anything else?" } },
  completed = function() return "Good bye." end,
}
facility.next = more

local function missing(frame)
  for _, slot in ipairs(frame.topic.slots) do
    if frame.values[slot.name] == nil then return slot end
  end
end

local function begin(session, topic)
  session[#session + 1] = { topic = topic, values = {} }
end

local function fill(frame, said)
  for _, slot in ipairs(frame.topic.slots) do
    local value = said[slot.name]
    if value then
      value = value:lower()
      if not slot.set or slot.set[value] then
        frame.values[slot.name] = value
      end
    end
  end
end

-- One turn of the user: an act about a topic, or values for what was asked.
local function turn(session, act)
  local top = session[#session]
  if act.topic and not (top and top.topic == act.topic) then
    begin(session, act.topic)
    top = session[#session]
  end
  fill(top, act.slots)
  local reply = {}
  while top do
    local slot = missing(top)
    if slot then
      reply[#reply + 1] = slot.question
      break
    end
    reply[#reply + 1] = top.topic.completed(top.values)
    session[#session] = nil
    if top.topic.next then begin(session, top.topic.next) end
    top = session[#session]
  end
  return table.concat(reply, " ")
end

local acts = {
  { topic = facility, slots = {} },
  { slots = { name = "swimming pool" } },
  { topic = taxi, slots = {} },
  { slots = { destination = "airport" } },
  { slots = { what = "location" } },
  { slots = { wish = "no thanks" } },
}

return function()
  local rounds, said = 50000, 0
  for _ = 1, rounds do
    local session = {}
    for _, act in ipairs(acts) do said = said + #turn(session, act) end
  end
  return rounds * #acts, math.floor(said / rounds)
end
