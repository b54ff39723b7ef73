#include "tests/script/margin.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <sstream>

#include <gtest/gtest.h>

#include "adapters/files/data_files.hpp"
#include "tests/script/snippets.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::test {

namespace {

// The text behind `mark` up to the end of the comment.
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

std::string text_of(const std::filesystem::path& file) {
  std::ifstream input(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(input), {}};
}

bool said(const std::vector<Remark>& all, const Remark& wanted) {
  return std::any_of(all.begin(), all.end(), [&](const Remark& one) {
    return one.line == wanted.line &&
           one.text.find(wanted.text) != std::string::npos;
  });
}

std::string listed(const std::vector<Remark>& all) {
  std::string text;
  for (const auto& [line, said] : all)
    text += std::to_string(line) + ": " + said + '\n';
  return text;
}

void expect_said(const std::vector<Remark>& all,
                 const std::vector<Remark>& wanted, const char* what) {
  for (const auto& one : wanted)
    EXPECT_TRUE(said(all, one)) << "no " << what << " of line " << one.line
                                << ": " << one.text << "\nbut:\n"
                                << listed(all);
  EXPECT_EQ(all.size(), wanted.size()) << listed(all);
}

} // namespace

Expectation read_expectation(const std::string& script) {
  Expectation expected;
  expected.compiles = script.find("<!-- compiles -->") != std::string::npos;
  std::istringstream input(script);
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

void expect_as_in_margin(const std::filesystem::path& file, Runner runner) {
  const auto expected = read_expectation(text_of(file));
  ASSERT_FALSE(expected.empty()) << "the case expects nothing";
  const auto compiled = script::compile_file(file, platform());
  std::vector<Remark> findings;
  for (const auto& finding : compiled.findings.all())
    findings.push_back({finding.place.line, finding.message});
  expect_said(findings, expected.findings, "finding");
  EXPECT_TRUE(compiled.program || !expected.compiles);
  if (!compiled.program || expected.compiles)
    return;
  const TemporaryFolder folder;
  const auto result = runner(compiled.program, run_instructions,
                             adapters::data_files(folder.path() / "data"));
  EXPECT_EQ(result.printed, expected.printed);
  expect_said(result.errors, expected.errors, "error");
}

std::vector<std::filesystem::path> language_cases() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(
           source_path("tests/script/cases")))
    if (entry.path().extension() == ".xml")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string name_of_case(const std::filesystem::path& file) {
  auto name =
      file.parent_path().filename().string() + "_" + file.stem().string();
  std::replace_if(
      name.begin(), name.end(),
      [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

} // namespace parlour::test
