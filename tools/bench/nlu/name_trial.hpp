// Names as visitors say them: in another order, in part, misspelt; and names of
// people who are not there. The same ones every time.
#pragma once

#include <string>
#include <vector>

namespace parlour::tools {

struct NameTrial {
  std::string said;
  std::string meant; // "" for a stranger
};

// Three for each name, where what is said means nobody else: its words in
// another order, some of them, and all of them with one letter wrong.
std::vector<NameTrial> name_trials(const std::vector<std::string>& names);

// As many strangers as there are names: every second has a family name (a last
// word) of somebody's.
std::vector<NameTrial> stranger_trials(const std::vector<std::string>& names);

} // namespace parlour::tools
