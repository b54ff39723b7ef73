// Language cases: small scripts with the expectation in the margin. A folder
// is a section of the language; a file is run as `parlour exec` would, and
// what it prints is compared with its comments:
//
//   <!-- expect: text -->                   the next line printed
//   <!-- expect error at this line: text --> ends with an error of this line
//   <!-- expect finding at this line: text --> the compiler says so
//
// The text of an error or finding needs to be a part of what is said.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "script/compiler.hpp"
#include "script/exec_host.hpp"

namespace parlour::script {

namespace {

namespace fs = std::filesystem;

struct Remark {
  std::uint32_t line = 0;
  std::string text;

  bool operator==(const Remark&) const = default;
};

struct Expectation {
  std::string printed; // a line each
  std::vector<Remark> errors;
  std::vector<Remark> findings;
};

// What follows `mark` up to the end of the comment.
bool remark(const std::string& line, const std::string& mark,
            std::string& text) {
  const auto at = line.find("<!-- " + mark + ":");
  if (at == std::string::npos)
    return false;
  const auto start = at + mark.size() + 6;
  text = line.substr(start, line.find(" -->", start) - start);
  if (text.starts_with(' '))
    text.erase(0, 1);
  return true;
}

Expectation read_expectation(const fs::path& file) {
  Expectation expected;
  std::ifstream input(file);
  std::string line;
  for (std::uint32_t number = 1; std::getline(input, line); ++number) {
    std::string text;
    if (remark(line, "expect", text))
      expected.printed += text + '\n';
    if (remark(line, "expect error at this line", text))
      expected.errors.push_back({number, text});
    if (remark(line, "expect finding at this line", text))
      expected.findings.push_back({number, text});
  }
  return expected;
}

bool said(const std::vector<Remark>& all, const Remark& wanted) {
  return std::any_of(all.begin(), all.end(), [&](const Remark& remark) {
    return remark.line == wanted.line &&
           remark.text.find(wanted.text) != std::string::npos;
  });
}

// Virtual time from a fixed start.
struct Run {
  std::string printed;
  std::vector<Remark> errors;
};

Run run(const std::shared_ptr<const Program>& program) {
  Run run;
  Timestamp clock = 1'795'251'600'000; // 2026-11-21 09:00 UTC
  ExecOptions options;
  options.print = [&](std::string_view text) {
    run.printed.append(text) += '\n';
  };
  options.log = [](std::string_view) {};
  options.now = [&] { return clock; };
  options.wait_until = [&](Timestamp time) { clock = std::max(clock, time); };
  options.instructions = 1'000'000;
  if (const auto failure = run_main(program, options))
    run.errors.push_back(
        {failure->error.place.line, std::string(name_of(failure->error.kind)) +
                                        ": " + failure->error.message});
  return run;
}

std::vector<fs::path> cases() {
  std::vector<fs::path> files;
  const fs::path root = PARLOUR_SOURCE_DIR "/tests/script/cases";
  for (const auto& entry : fs::recursive_directory_iterator(root))
    if (entry.path().extension() == ".xml")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string name_of_case(const testing::TestParamInfo<fs::path>& info) {
  auto name = info.param.parent_path().filename().string() + "_" +
              info.param.stem().string();
  std::replace_if(
      name.begin(), name.end(),
      [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

class LanguageCase : public testing::TestWithParam<fs::path> {};

TEST_P(LanguageCase, DoesWhatItsMarginSays) {
  const auto expected = read_expectation(GetParam());
  ASSERT_FALSE(expected.printed.empty() && expected.errors.empty() &&
               expected.findings.empty())
      << "the case expects nothing";
  CompileOptions options;
  options.platform = PARLOUR_SOURCE_DIR "/config/platform";
  const auto compiled = compile_file(GetParam(), options);
  std::vector<Remark> findings;
  std::string all;
  for (const auto& finding : compiled.findings.all()) {
    findings.push_back({finding.place.line, finding.message});
    all += to_string(finding) + '\n';
  }
  for (const auto& wanted : expected.findings)
    EXPECT_TRUE(said(findings, wanted))
        << wanted.line << ": " << wanted.text << "\n"
        << all;
  EXPECT_EQ(findings.size(), expected.findings.size()) << all;
  if (!compiled.program)
    return;
  const auto result = run(compiled.program);
  EXPECT_EQ(result.printed, expected.printed);
  EXPECT_EQ(result.errors.size(), expected.errors.size())
      << (result.errors.empty() ? "" : result.errors[0].text);
  for (const auto& wanted : expected.errors)
    EXPECT_TRUE(said(result.errors, wanted))
        << (result.errors.empty() ? "no error" : result.errors[0].text);
}

INSTANTIATE_TEST_SUITE_P(Language, LanguageCase, testing::ValuesIn(cases()),
                         name_of_case);

} // namespace

} // namespace parlour::script
