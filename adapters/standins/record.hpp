// The record of a stand-in: a file with a line for each command, from which can
// be read what would have happened outside.
#pragma once

#include <filesystem>
#include <fstream>

#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"
#include "runtime/message/message.hpp"

namespace parlour::adapters {

// Not thread-safe.
class Record {
public:
  // Opens the file for appending and creates its folder. The error, of kind
  // File, names the file.
  Expected<void> open(const std::filesystem::path& file);

  // Appends a line and hands it to the system. False if that fails. The line
  // has local time, command and parameters as CSV:
  //
  //  2026-11-21T09:00:00<tab>Call<tab>64781001,Dr. Jeffery Ho
  bool write(Timestamp time, const Message& message);

private:
  std::ofstream stream_;
};

} // namespace parlour::adapters
