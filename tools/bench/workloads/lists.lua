return function()
  local all, x, sum = {}, 12345, 0
  for i = 1, 500000 do
    x = x * 48271 % 2147483647
    all[#all + 1] = x
  end
  for i = 1, 500000 do sum = (sum + all[i]) % 1000003 end
  table.sort(all)
  return 500000, sum + all[1001]
end
