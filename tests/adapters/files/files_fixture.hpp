// FilesTest: a data folder, and a secret file outside of it that scripts must
// not reach.
#pragma once

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/files/data_files.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {

class FilesTest : public testing::Test {
protected:
  FilesTest() {
    outside.write("secret.txt", "secret");
    std::filesystem::create_directory(data());
  }

  std::filesystem::path data() const {
    return outside.path() / "data";
  }
  void link(const std::string& to, const std::string& name) const {
    std::filesystem::create_symlink(to, data() / name);
  }

  // The outcome of a request as text, or the error.
  std::string ask(FileAction action, const std::string& name,
                  const std::string& text = "") {
    const auto outcome = files({action, name, text, max_bytes});
    if (!outcome && outcome.error().kind != ErrorKind::file)
      return "not of kind File: " + to_string(outcome.error());
    return outcome ? to_string(*outcome) : "error: " + outcome.error().message;
  }
  std::string read(const std::string& name) {
    return ask(FileAction::read, name);
  }
  std::string write(const std::string& name, const std::string& text) {
    return ask(FileAction::write, name, text);
  }
  std::string append(const std::string& name, const std::string& text) {
    return ask(FileAction::append, name, text);
  }
  std::string remove(const std::string& name) {
    return ask(FileAction::remove, name);
  }
  std::string list(const std::string& pattern) {
    return ask(FileAction::list, pattern);
  }

  test::TemporaryFolder outside;
  FileAccess files = data_files(data());
  std::size_t max_bytes = 1 << 20;
};

} // namespace parlour::adapters
