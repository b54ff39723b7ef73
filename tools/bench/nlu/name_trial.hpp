// Names as visitors say them (in another order, in part, misspelt), and names
// of people who are not in the database. The result is the same every time.
//
//  meant     "Jeffery Ho Wei Ming"
//  said      "Ho Wei Ming Jeffery", "Jeffery Ho Ming", "Jefery Ho Wei Ming"
//  stranger  "Bartholomew Higginbotham", "Ingrid Ming"
#pragma once

#include <string>
#include <vector>

namespace parlour::tools {

struct NameTrial {
  std::string said;
  // Empty for somebody who is not in the database.
  std::string meant;
};

// Up to three for each name: its words in another order, some of its words, and
// all of them with one wrong letter. What could mean somebody else as well is
// left out.
std::vector<NameTrial> name_trials(const std::vector<std::string>& names);

// As many unknown names as there are names. Every second one shares its last
// word with a known name.
std::vector<NameTrial> stranger_trials(const std::vector<std::string>& names);

} // namespace parlour::tools
