// The conversations of an application that are to be held.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/parlour/application/application.hpp"
#include "tools/parlour/console/places.hpp"
#include "tools/parlour/conversation_test/conversation_file.hpp"

namespace parlour::tools {

struct TestSuite {
  std::vector<std::filesystem::path> files;
  std::vector<Conversation> conversations; // of each file
  std::vector<script::Finding> findings;   // what is wrong with the files
};

// `names`: files, or names of conversations in dialogues/; none: all of them.
// The error says which one is not there.
Expected<TestSuite> read_suite(const Application& application,
                               const std::vector<std::string>& names,
                               const Places& places);

} // namespace parlour::tools
