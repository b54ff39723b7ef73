// A folder with a program that speaks the protocol of the recogniser's and
// behaves or misbehaves.
#pragma once

#include <filesystem>
#include <string>

#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::test {

class FakeMoonshine {
public:
  // `mode`: see fake_moonshine.py.
  explicit FakeMoonshine(const std::string& mode) {
    folder_.write("mode", mode);
    std::filesystem::copy_file(
        source_path("tests/adapters/asr/fake_moonshine.py"), program());
    for (const auto* const package :
         {"onnxruntime-node", "@usefulsensors/moonshine-js",
          "llama-tokenizer-js", "@ricky0123/vad-web"})
      std::filesystem::create_directories(folder_.path() / "node_modules" /
                                          package);
  }
  std::filesystem::path program() const {
    return folder_.path() / "moonshine.mjs";
  }
  // What runs it.
  static std::string interpreter() {
    return "/usr/bin/python3";
  }

private:
  TemporaryFolder folder_;
};

} // namespace parlour::test
