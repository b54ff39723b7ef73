// Where the recogniser's program is, and what it runs on.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"

namespace parlour::adapters::moonshine {

struct Place {
  std::filesystem::path node;    // the program that runs it; absolute
  std::filesystem::path program; // moonshine.mjs; absolute
};

// What to look for. Relative paths start at the working folder. SileroVAD,
// which runs in the same program, asks with a name of its own.
struct PlaceOrder {
  // The program; empty: the first of `usual` that exists.
  std::filesystem::path program;
  std::vector<std::filesystem::path> usual;
  // A path, or a name that is looked for in the folders of `path`.
  std::string node;
  std::string path; // "/usr/local/bin:/usr/bin"
  // Who needs it, and who does the same without it.
  std::string plugin = "MoonshineASR";
  std::string otherwise = "SphinxASR";
  // What the program loads, beside it.
  std::vector<std::string> packages = {
      "onnxruntime-node", "@usefulsensors/moonshine-js", "llama-tokenizer-js"};
};

// The error, of kind Settings, names what is missing and how to get it.
Expected<Place> find_place(const PlaceOrder& order);

} // namespace parlour::adapters::moonshine
