return function()
  local base = "the swimming pool is on floor "
  local count = 0
  for i = 1, 500000 do
    local text = base .. i % 100
    text = text:sub(5, 18)
    text = text:gsub("pool", "gym")
    count = count + #text
  end
  return 500000, count
end
