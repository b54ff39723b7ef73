local count, yield = 10000, coroutine.yield
return function()
  local waiting = {}
  for i = 1, count do waiting[i] = false end
  collectgarbage() collectgarbage()
  local before = collectgarbage("count")
  for i = 1, count do
    local one = coroutine.create(function(given)
      local kept = given
      yield()
      return kept + given
    end)
    coroutine.resume(one, i)
    waiting[i] = one
  end
  collectgarbage() collectgarbage()
  return count, math.floor((collectgarbage("count") - before) * 1024 / count)
end
