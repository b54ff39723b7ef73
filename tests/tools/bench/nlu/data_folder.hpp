// DataFolderTest: writes data sets into a folder of its own.
#pragma once

#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace parlour::tools {

class DataFolderTest : public testing::Test {
protected:
  void write(const std::string& name, const std::string& text) const {
    const auto path = std::filesystem::path(folder_.path()) / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
  std::filesystem::path folder() const {
    return folder_.path();
  }

private:
  test::TemporaryFolder folder_;
};

} // namespace parlour::tools
