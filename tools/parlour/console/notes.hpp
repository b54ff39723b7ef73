// Notes: lines about a conversation, for standard error or the log file.
#pragma once

#include <filesystem>
#include <fstream>
#include <mutex>
#include <string>
#include <utility>

#include "tools/parlour/console/printer.hpp"

namespace parlour::tools {

// Safe to call from any thread.
class Notes {
public:
  Notes(const Console& console, Printer& printer, std::filesystem::path log)
      : console_(console), printer_(printer), log_(std::move(log)) {}
  // Shows a line on standard error.
  void show(const std::string& text) {
    printer_.err(coloured(console_, grey, text));
  }
  // Appends a line to the log file, where showing it would disturb a
  // conversation on a terminal.
  void keep(const std::string& text) {
    std::lock_guard lock(mutex_);
    std::ofstream(log_, std::ios::app) << text << std::endl;
  }

private:
  std::mutex mutex_; // guards the log file
  const Console& console_;
  Printer& printer_;
  std::filesystem::path log_;
};

} // namespace parlour::tools
