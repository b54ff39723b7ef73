// Reads and checks the conversations that a test run is asked for.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/parlour/application/application.hpp"
#include "tools/parlour/console/places.hpp"
#include "tools/parlour/conversation_test/conversation_file.hpp"

namespace parlour::tools {

// Files and conversations have the same order.
struct TestSuite {
  std::vector<std::filesystem::path> files;
  std::vector<Conversation> conversations; // of each file
  std::vector<script::Finding> findings;   // errors in the files
};

// `names` are files, or names of conversations in dialogues/; none means all of
// dialogues/. The error names a file that does not exist.
Expected<TestSuite> read_suite(const Application& application,
                               const std::vector<std::string>& names,
                               const Places& places);

} // namespace parlour::tools
