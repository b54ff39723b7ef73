// Corrections never lead to more errors. Tested with every script with
// mistakes, and with the applications' scripts after random damage.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include <gtest/gtest.h>

#include "script/lint/lint.hpp"
#include "script/xml/source_reader.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/application/application.hpp"
#include "tools/parlour/application/fix.hpp"

namespace parlour::tools {
namespace {

namespace fs = std::filesystem;
using Findings = std::vector<script::Finding>;

std::vector<fs::path> scripts_below(const std::string& folder) {
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::recursive_directory_iterator(test::source_path(folder)))
    if (entry.path().extension() == ".xml")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string text_of(const fs::path& file) {
  return script::read_bytes(file).value();
}

Findings findings_of(const fs::path& file, const script::SourceTexts& texts) {
  auto compiled = load_file(file, process_places(), {.texts = &texts});
  script::lint::lint(compiled, {});
  return compiled.findings.all();
}

Corrected corrected(const fs::path& file) {
  const auto check = [&](const script::SourceTexts& texts) {
    return findings_of(file, texts);
  };
  return correct(check({}), check, file.parent_path());
}

bool is_well_formed(const std::string& text) {
  script::Findings findings;
  return script::read_source(text, findings.add_file(""), findings) &&
         !findings.has_errors();
}

void expect_no_worse(const fs::path& file) {
  const auto before = findings_of(file, {});
  const auto result = corrected(file);
  if (result.texts.empty())
    return;
  const auto& after = result.texts.begin()->second;
  const auto left = findings_of(file, result.texts);
  const auto text = text_of(file);
  EXPECT_FALSE(is_worse(left, before)) << file;
  EXPECT_TRUE(!is_well_formed(text) || is_well_formed(after)) << file;
}

std::size_t place(std::mt19937& random, std::size_t size) {
  return size == 0 ? 0 : random() % size;
}

std::string without(std::string text, char letter, std::mt19937& random) {
  const auto all =
      static_cast<std::size_t>(std::count(text.begin(), text.end(), letter));
  if (all == 0)
    return text;
  auto at = text.find(letter);
  for (auto i = place(random, all); i > 0; --i)
    at = text.find(letter, at + 1);
  return text.erase(at, 1);
}

std::string replaced(std::string text, const char* part, const char* by) {
  if (const auto at = text.find(part); at != std::string::npos)
    text.replace(at, std::string_view(part).size(), by);
  return text;
}

// Damage like that of somebody who edits the file.
std::string damaged(std::string text, unsigned seed) {
  std::mt19937 random(seed);
  const auto at = place(random, text.size());
  const auto letters = std::string_view("\"'<>&={}/;");
  switch (seed % 10) {
  case 0:
    return text.erase(at, 1);
  case 1:
    return text.insert(at, 1, letters[place(random, letters.size())]);
  case 2:
    return without(text, '"', random);
  case 3:
    return without(text, '\'', random);
  case 4:
    return without(text, '>', random);
  case 5:
    return without(text, '/', random);
  case 6:
    return replaced(text, " and ", " && ");
  case 7:
    return replaced(replaced(text, " == ", " = "), " eq ", " is ");
  case 8:
    return text.insert(std::min(text.find(' ', at), text.size()), "\"word\"");
  default:
    text[at] = static_cast<char>(text[at] ^ 0x20);
    return text;
  }
}

} // namespace

TEST(Correcting, mends_mistakes_of_newcomers) {
  for (const auto* folder : {"tests/script/mistakes", "tests/script/cases"})
    for (const auto& file : scripts_below(folder)) {
      expect_no_worse(file);
      for (const auto& left : corrected(file).findings)
        EXPECT_TRUE(left.fix.empty()) << file << ": " << left.message;
    }
}

TEST(Correcting, does_no_harm_to_damaged_scripts) {
  test::TemporaryFolder folder;
  unsigned seed = 1;
  for (const auto& file : scripts_below("config/apps"))
    for (int i = 0; i < 10; ++i) {
      folder.write("a.xml", damaged(text_of(file), seed++));
      expect_no_worse(folder.path() / "a.xml");
    }
}

} // namespace parlour::tools
