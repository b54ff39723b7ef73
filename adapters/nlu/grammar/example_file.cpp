#include "adapters/nlu/grammar/example_file.hpp"

#include <algorithm>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "adapters/nlu/grammar/examples.hpp"
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

// `place_.line` is the current line, from 1.
class ExampleReader {
public:
  ExampleReader(std::string file, UnderstandingModel& model)
      : place_{std::move(file), 0, 0}, model_(model) {}

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
  // Checks one line and adds its example.
  void read(const std::string& line) {
    if (const auto invalid = find_invalid_utf8(line))
      return wrong(line, *invalid, "this is not UTF-8; save the file as UTF-8");
    const auto tab = line.find('\t');
    if (tab == std::string::npos || is_blank(line.substr(tab)))
      return wrong(line, 0, "a line is a topic, a tab, and the example's text");
    const auto name = line.substr(0, tab);
    const auto topic =
        std::ranges::find(model_.topics, name, &TopicModel::name);
    if (topic == model_.topics.end())
      return wrong(line, 0,
                   "there is no topic '" + name + "'" +
                       did_you_mean(name, names_of(model_.topics)));
    if (fits(line, tab + 1, *topic))
      topic->examples.push_back(line.substr(tab + 1));
  }

  // Checks an example and reports what is wrong with it.
  bool fits(const std::string& line, std::size_t begin,
            const TopicModel& topic) {
    // The checks report errors; whether there were any shows at the end.
    const auto before = errors_.size();
    const auto text = line.substr(begin);
    const auto marked = read_marks(text);
    if (text.size() > max_example_bytes)
      wrong(line, begin, too_long);
    else if (!marked)
      wrong(line, begin + text.find('['),
            "a slot's words are marked like this: [words](Slot)");
    else
      check_slots(line, marked->marks, topic);
    return errors_.size() == before;
  }

  // `at` is the position in the line of the current mark's slot.
  void check_slots(const std::string& line,
                   const std::vector<MarkedText::Mark>& marks,
                   const TopicModel& topic) {
    std::size_t at = 0;
    for (const auto& mark : marks) {
      at = line.find("](", line.find('[', at)) + 2;
      if (std::ranges::find(topic.slots, mark.slot, &SlotModel::name) ==
          topic.slots.end())
        wrong(line, at,
              "the topic '" + topic.name + "' has no slot '" + mark.slot + "'" +
                  did_you_mean(mark.slot, names_of(topic.slots)));
    }
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
  UnderstandingModel& model_;
  std::vector<Error> errors_;
};

} // namespace

std::vector<Error> add_example_file(const std::filesystem::path& path,
                                    UnderstandingModel& model) {
  auto text = read_file(path, max_example_file_bytes);
  if (!text)
    return {std::move(text.error())};
  std::istringstream lines(std::move(*text));
  return ExampleReader(path.string(), model).run(lines);
}

} // namespace parlour::adapters::nlu
