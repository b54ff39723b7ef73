#include "tools/bench/script/load_bench.hpp"

#include <cstring>

#include <pugixml.hpp>

#include "script/compiler/compiler.hpp"
#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

namespace {

// Reads every name and value. The sum keeps the compiler from removing the
// work.
std::size_t walk(pugi::xml_node node) {
  std::size_t bytes = std::strlen(node.name()) + std::strlen(node.value());
  for (auto attribute : node.attributes())
    bytes += std::strlen(attribute.name()) + std::strlen(attribute.value());
  for (auto child : node.children())
    bytes += walk(child);
  return bytes;
}

} // namespace

std::string repeated_script(std::string_view pattern, std::size_t bytes) {
  std::string text = "<dialogue>\n";
  for (int number = 0; text.size() < bytes; ++number)
    for (const char letter : pattern)
      if (letter == '@')
        text += std::to_string(number);
      else
        text += letter;
  return text + "</dialogue>\n";
}

Expected<LoadTimes> load_once(const std::filesystem::path& file) {
  LoadTimes times;
  const auto start = cpu_nanoseconds();
  const auto compiled = script::compile_file(file, {});
  times.ours = cpu_nanoseconds() - start;
  if (!compiled.program)
    return fail(ErrorKind::compile,
                script::to_string(compiled.findings.all().front()));
  // The file is in the system's cache by now, as it was for our side after the
  // first run.
  const auto again = cpu_nanoseconds();
  pugi::xml_document document;
  const bool read = document.load_file(file.c_str());
  const auto seen = walk(document);
  times.parse_and_walk = cpu_nanoseconds() - again;
  if (!read || seen == 0)
    return fail(ErrorKind::file, file.string() + " cannot be read");
  return times;
}

} // namespace parlour::tools
