local larger = larger -- the host's function, in C
return function()
  local most = 0
  for i = 1, 2000000 do most = larger(most, i) end
  return 2000000, most
end
