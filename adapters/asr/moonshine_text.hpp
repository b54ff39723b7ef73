// What the recogniser writes, as people type it: understanding is to get from a
// voice what it gets from a keyboard.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace parlour::adapters::moonshine {

// "My number is nine, one, two, three." becomes "My number is 9123."; "10.30
// a.m." becomes "10:30 am.". Punctuation that ends or divides sentences stays.
std::string typed_text(std::string_view spoken);

// Words without capitals as `written` has them, where that is the same word:
// "to sentosa" becomes "to Sentosa".
std::string
with_capitals(std::string_view text,
              const std::function<std::string(const std::string&)>& written);

} // namespace parlour::adapters::moonshine
