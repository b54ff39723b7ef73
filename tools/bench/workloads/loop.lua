return function()
  local sum = 0
  for i = 1, 5000000 do sum = (sum + i * 3 - 1) % 1000003 end
  return 5000000, sum
end
