// ApplicationTest: loads the applications beside this file, or small ones that
// a test writes.
#pragma once

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/application/application.hpp"

namespace parlour::tools {

class ApplicationTest : public testing::Test {
protected:
  Application load(const std::string& name) const {
    return load_application(
        test::source_path("tests/tools/parlour/applications/") + name,
        platform());
  }
  // Loads an application with these children of <settings> and <dialogue>.
  Application load(const std::string& settings,
                   const std::string& dialogue) const {
    folder_.write("settings.xml", "<settings name=\"own\">" + settings +
                                      "<Scripts><Script>own.xml</Script>"
                                      "</Scripts></settings>");
    folder_.write("own.xml", "<dialogue>" + dialogue + "</dialogue>");
    return load_application(std::filesystem::canonical(folder_.path()),
                            platform());
  }
  static std::filesystem::path platform() {
    return test::source_path("config/platform");
  }
  // The findings as text, without the folder of a test's own application.
  std::string findings(const Application& application) const {
    const auto folder = std::filesystem::canonical(folder_.path()).string();
    std::string all;
    for (auto finding : application.findings) {
      if (finding.place.file.rfind(folder, 0) == 0)
        finding.place.file.erase(0, folder.size() + 1);
      all += to_string(finding) + '\n';
    }
    return all;
  }

  test::TemporaryFolder folder_;
};

// Settings and files for a slot and a grammar that read a column.
inline constexpr const char* guest_settings =
    "<Plugins><Plugin>GrammarNLU</Plugin><Plugin>SQLiteDatabase</Plugin>"
    "</Plugins><component name=\"SQLiteDatabase\">"
    "<option name=\"file\" value=\"own.db\"/>"
    "<option name=\"schema\" value=\"schema.sql\"/></component>";
inline constexpr const char* guest_schema =
    "create table guest (name text);\n"
    "insert into guest values ('Ada Lovelace');\n";
inline constexpr const char* guest_topic =
    "<topic name=\"Visit\">"
    "<slot name=\"Guest\" type=\"Functional\" question=\"Who?\">"
    "<cardinality type=\"query\" source=\"db:guest.name\"/></slot>"
    "<examples><value>I am looking for [Ada](Guest)</value></examples>"
    "</topic>";

} // namespace parlour::tools
