// Why a text is not well-formed XML, looked for only where the parser gave up:
// it knows one place, this finds all of them and what to write instead
// (language rule 1.3).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::script {

struct XmlSlip {
  std::size_t offset = 0;
  std::size_t length = 0; // bytes; 0: what stands there
  std::string message;
  // In the place of what was found; nothing where no correction is sure.
  std::optional<std::string> replacement{};
};

// In the order of the text; empty where nothing was found.
std::vector<XmlSlip> find_xml_slips(std::string_view text);

} // namespace parlour::script
