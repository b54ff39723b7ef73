#include "tools/parlour/understand/marked_sentences.hpp"

#include <utility>

#include "runtime/text/json_text.hpp"
#include "tools/parlour/console/bounded_line.hpp"
#include "tools/parlour/console/line_reader.hpp"

namespace parlour::tools {

namespace {

// Empty for what is missing or null.
std::string text_of(const Value& value) {
  return value.is_unknown() ? std::string() : value.text();
}

Map map_of(const Value& value) {
  return value.if_map() ? *value.if_map() : Map();
}

std::string mistake_in(const Value& row) {
  if (!row.if_map() || !row["text"].if_string())
    return R"(a line is an object with a text: {"text": "…", "topic": "…"})";
  if (!row["acts"].is_unknown())
    return "'acts' are what --batch prints; a marked sentence has a 'topic' "
           "and "
           "'slots' of its own";
  for (const auto* key : {"slots", "context"})
    if (!row[key].is_unknown() && !row[key].if_map())
      return std::string("'") + key + "' is an object: {\"name\": …}";
  return "";
}

MarkedSentence sentence_of(const Value& row, std::uint32_t line) {
  auto topic = text_of(row["topic"]);
  if (topic.empty())
    topic = text_of(row["intent"]);
  return {line,
          row["text"].text(),
          std::move(topic),
          text_of(row["act"]),
          map_of(row["slots"]),
          map_of(row["context"])};
}

} // namespace

std::string intent_of(const MarkedSentence& sentence) {
  if (!sentence.topic.empty())
    return sentence.topic;
  return sentence.act.empty() ? "nothing" : sentence.act;
}

Expected<std::vector<MarkedSentence>>
read_marked_sentences(std::istream& in, const std::string& file) {
  std::vector<MarkedSentence> sentences;
  for (std::uint32_t line = 1;; ++line) {
    const auto read = read_bounded_line(in, longest_line);
    if (!read)
      return sentences;
    if (read->is_cut)
      return fail(ErrorKind::file, "this line is too long", {file, line, 1});
    if (is_blank(read->text))
      continue;
    const auto row = read_json(read->text);
    const auto mistake =
        row ? mistake_in(*row) : "this line is no JSON of its own";
    if (!mistake.empty())
      return fail(ErrorKind::file, mistake, {file, line, 1});
    sentences.push_back(sentence_of(*row, line));
  }
}

} // namespace parlour::tools
