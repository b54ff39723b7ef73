return function()
  local commands = {"BufferFull", "RecognitionResult", "FrameInfo", "NoResult",
                    "Speak", "Online", "Offline", "Timer"}
  local sum = 0
  for i = 1, 2000000 do
    local command = commands[i % 8 + 1]
    if command == "BufferFull" then sum = sum + 1
    elseif command == "RecognitionResult" then sum = sum + 2
    elseif command == "FrameInfo" then sum = sum + 3
    elseif command == "NoResult" then sum = sum + 4
    elseif command == "Speak" then sum = sum + 5
    elseif command == "Online" then sum = sum + 6
    elseif command == "Offline" then sum = sum + 7
    else sum = sum + 8 end
  end
  return 2000000, sum
end
