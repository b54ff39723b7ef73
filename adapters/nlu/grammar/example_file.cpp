#include "adapters/nlu/grammar/example_file.hpp"

#include <algorithm>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "adapters/nlu/grammar/examples.hpp"
#include "adapters/nlu/grammar/jsgf.hpp"
#include "adapters/nlu/grammar/marked_text.hpp"
#include "adapters/nlu/text/similarity.hpp"
#include "runtime/base/outside/file_bytes.hpp"
#include "runtime/base/text/names.hpp"
#include "runtime/base/text/utf8.hpp"

namespace parlour::adapters::nlu {

namespace {

constexpr std::size_t max_errors = 100;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

const std::string too_long =
    "an example has at most " + std::to_string(max_example_bytes) + " bytes";

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t") == std::string_view::npos;
}

using Constants = decltype(Wording::constants);

// `place_.line` is the current line, from 1. An example is a wording without
// constants.
class WordingReader {
public:
  // Without constants, a line that has some has no known topic.
  WordingReader(std::string file, const UnderstandingModel& model,
                bool takes_constants, std::vector<Wording>& read)
      : place_{std::move(file), 0, 0}, model_(model),
        takes_constants_(takes_constants), read_(read) {}

  std::vector<Error> run(std::istream& in) {
    for (std::string line;
         errors_.size() < max_errors && std::getline(in, line);) {
      ++place_.line;
      // Editors on Windows begin a file with a byte order mark and end lines
      // with "\r\n".
      if (place_.line == 1 && line.starts_with(byte_order_mark))
        line.erase(0, byte_order_mark.size());
      if (line.ends_with('\r'))
        line.pop_back();
      if (!is_blank(line) && !line.starts_with('#'))
        read(line);
    }
    return std::move(errors_);
  }

private:
  // Checks one line and adds its wording.
  void read(const std::string& line) {
    if (const auto invalid = find_invalid_utf8(line))
      return wrong(line, *invalid, "this is not UTF-8; save the file as UTF-8");
    const auto tab = line.find('\t');
    if (tab == std::string::npos || is_blank(line.substr(tab)))
      return wrong(line, 0, "a line is a topic, a tab, and the example's text");
    const auto end = takes_constants_ ? std::min(line.find(' '), tab) : tab;
    const auto name = line.substr(0, end);
    const auto topic =
        std::ranges::find(model_.topics, name, &TopicModel::name);
    if (topic == model_.topics.end())
      return wrong(line, 0,
                   "there is no topic '" + name + "'" +
                       did_you_mean(name, names_of(model_.topics)));
    // The checks report errors; whether there were any shows at the end.
    const auto before = errors_.size();
    auto constants = read_constants(line, end, tab, *topic);
    check_text(line, tab + 1, *topic);
    if (errors_.size() == before)
      read_.push_back({name, std::move(constants), line.substr(tab + 1)});
  }

  // Slot=value or Slot="some value", with blanks before each, in [at, end).
  Constants read_constants(const std::string& line, std::size_t at,
                           std::size_t end, const TopicModel& topic) {
    Constants constants;
    while ((at = std::min(line.find_first_not_of(' ', at), end)) < end) {
      const auto sign = line.find('=', at);
      const bool quoted = sign < end && line[sign + 1] == '"';
      const auto value = sign + (quoted ? 2 : 1);
      const auto value_end =
          sign < end ? line.find_first_of(quoted ? "\"\t" : " \t", value) : end;
      if (sign >= end || value_end == value ||
          (quoted && line[value_end] != '"')) {
        wrong(line, at,
              "a slot's value is written Slot=value or Slot=\"some "
              "value\"");
        return {};
      }
      const auto slot = line.substr(at, sign - at);
      check_slot(line, at, slot, topic);
      constants.emplace_back(
          slot, jsgf::literal(line.substr(value, value_end - value)));
      at = value_end + (quoted ? 1 : 0);
    }
    std::ranges::stable_sort(constants, {},
                             &std::pair<std::string, Value>::first);
    return constants;
  }

  void check_text(const std::string& line, std::size_t begin,
                  const TopicModel& topic) {
    const auto text = line.substr(begin);
    const auto marked = read_marks(text);
    if (text.size() > max_example_bytes)
      wrong(line, begin, too_long);
    else if (!marked)
      wrong(line, begin + text.find('['),
            "a slot's words are marked like this: [words](Slot)");
    else
      check_slots(line, begin, marked->marks, topic);
  }

  // `at` is the position in the line of the current mark's slot.
  void check_slots(const std::string& line, std::size_t at,
                   const std::vector<MarkedText::Mark>& marks,
                   const TopicModel& topic) {
    for (const auto& mark : marks) {
      at = line.find("](", line.find('[', at)) + 2;
      check_slot(line, at, mark.slot, topic);
    }
  }

  void check_slot(std::string_view line, std::size_t at,
                  const std::string& slot, const TopicModel& topic) {
    if (std::ranges::find(topic.slots, slot, &SlotModel::name) ==
        topic.slots.end())
      wrong(line, at,
            "the topic '" + topic.name + "' has no slot '" + slot + "'" +
                did_you_mean(slot, names_of(topic.slots)));
  }

  // Reports an error at a byte of the line. Columns count characters, so the
  // bytes that continue a character are subtracted.
  void wrong(std::string_view line, std::size_t byte, std::string message) {
    auto place = place_;
    place.column =
        1 + static_cast<std::uint32_t>(
                byte - static_cast<std::size_t>(std::ranges::count_if(
                           line.substr(0, byte), continues_code_point)));
    errors_.push_back({ErrorKind::compile, std::move(message), place});
  }

  SourceLocation place_;
  const UnderstandingModel& model_;
  const bool takes_constants_;
  std::vector<Wording>& read_;
  std::vector<Error> errors_;
};

std::vector<Error> read_lines(const std::filesystem::path& path,
                              const UnderstandingModel& model,
                              bool takes_constants,
                              std::vector<Wording>& wordings) {
  auto text = read_file(path, max_example_file_bytes);
  if (!text)
    return {std::move(text.error())};
  std::istringstream lines(std::move(*text));
  return WordingReader(path.string(), model, takes_constants, wordings)
      .run(lines);
}

} // namespace

std::vector<Error> add_example_file(const std::filesystem::path& path,
                                    UnderstandingModel& model) {
  std::vector<Wording> read;
  auto errors = read_lines(path, model, false, read);
  for (auto& example : read)
    std::ranges::find(model.topics, example.topic, &TopicModel::name)
        ->examples.push_back(std::move(example.text));
  return errors;
}

std::vector<Error> read_wording_file(const std::filesystem::path& path,
                                     const UnderstandingModel& model,
                                     std::vector<Wording>& wordings) {
  return read_lines(path, model, true, wordings);
}

} // namespace parlour::adapters::nlu
