// A stand-in's record: one line for each command that it was given, so that
// what would have happened outside can be read.
#pragma once

#include <filesystem>
#include <fstream>

#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/message.hpp"

namespace parlour::adapters {

class Record {
public:
  // Appends; makes the folder. An error of kind File names the file.
  Expected<void> open(const std::filesystem::path& file);

  // "2026-11-21T09:00:00<tab>Call<tab>64781001,Dr. Jeffery Ho": local time,
  // parameters as CSV, on the disk's way when this returns. False where it
  // could not be written.
  bool write(Timestamp time, const Message& message);

private:
  std::ofstream stream_;
};

} // namespace parlour::adapters
