// Names as people say them, so that "Living-Room_Lamp" and "living room lamp"
// are the same.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace parlour::adapters::mqtt {

using Words = std::vector<std::string>;

// The runs of letters and digits in a UTF-8 text, in folded case.
Words words_of(std::string_view text);

// Whether `part` stands in `whole`, in a row. An empty part stands nowhere.
bool contains(const Words& whole, const Words& part);

} // namespace parlour::adapters::mqtt
