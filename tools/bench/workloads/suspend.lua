return function()
  local yield = coroutine.yield
  local resume = coroutine.wrap(function() while true do yield(1) end end)
  local sum = 0
  for i = 1, 1000000 do sum = sum + resume() end
  return 1000000, sum
end
