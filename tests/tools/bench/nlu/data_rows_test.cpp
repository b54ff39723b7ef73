#include <sstream>

#include <gmock/gmock.h>

#include "tests/tools/bench/nlu/data_folder.hpp"
#include "tools/bench/nlu/data_rows.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;
using DataRowsTest = DataFolderTest;

TEST_F(DataRowsTest, TellWhatTheNearestExampleReaches) {
  write("data_full.json",
        R"({"train": [["book a table", "eat"], ["sing a song", "play"]],
            "test": [["book a table", "eat"]], "oos_test": [["xyzzy", "oos"]],
            "val": [], "oos_val": []})");
  std::ostringstream out;
  EXPECT_TRUE(data_row("clinc", {folder(), DataPart::test, {}}, out));
  EXPECT_THAT(out.str(),
              HasSubstr("intent 100.0 % (bar 92.5: met), nearest "
                        "example 100.0 %, strangers rejected 100.0"));
}

TEST_F(DataRowsTest, SayWhatCouldNotBeMeasured) {
  for (const auto& name : data_row_names()) {
    std::ostringstream out;
    EXPECT_FALSE(data_row(name, {folder(), DataPart::test, {}}, out));
    EXPECT_THAT(out.str(), HasSubstr("there is no "));
    out.str("");
    EXPECT_TRUE(data_row(name, {}, out));
    EXPECT_THAT(out.str(), HasSubstr("not measured"));
  }
}

} // namespace
} // namespace parlour::tools
