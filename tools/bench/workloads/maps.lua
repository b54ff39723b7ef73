return function()
  local entries, names, sum = {}, {}, 0
  for i = 1, 1000 do names[i] = "slot_" .. i - 1 end
  for i = 1, 2000000 do
    local key = names[i % 1000 + 1]
    entries[key] = (entries[key] or 0) + i % 7
  end
  for key, value in pairs(entries) do sum = sum + value end
  return 2000000, sum
end
