#include <gtest/gtest.h>

#include "script/source/by_name.hpp"

namespace parlour::script {

TEST(ByName, finds_names_whatever_the_case_of_their_first_letter) {
  const ByName<int> known{{"entrance", 1}, {"Plugin", 2}, {"noInput", 3}};
  EXPECT_EQ(known.find("Entrance")->second, 1);
  EXPECT_EQ(known.find("plugin")->second, 2);
  EXPECT_EQ(known.find("NoInput")->second, 3);
  for (const auto* unknown : {"noinput", "plug", "Plugins", ""})
    EXPECT_EQ(known.find(unknown), known.end()) << unknown;
}

} // namespace parlour::script
