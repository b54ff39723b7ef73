#include "tools/parlour/journal/session_lines.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/parlour/conversation_test/directive_reader.hpp"
#include "tools/parlour/talk/trace.hpp"

namespace parlour::tools {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* masked = "***";
// Shorter pauses are the machine's.
constexpr Timestamp shortest_wait = 500; // milliseconds

// `key` and `text`: one member more, such as "robot" and its words.
std::string object(const std::string& session, const LinePlace& place,
                   std::string_view kind, const char* key = nullptr,
                   const std::string& text = {}) {
  const auto second = format_timestamp(place.now, "%Y-%m-%dT%H:%M:%S");
  Json json{{"session", session},
            {"input", place.input},
            {"time", fmt::format("{}.{:03}", second, place.now % 1'000)},
            {"kind", kind}};
  if (key)
    json[key] = text;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// 'event Speaker Finished 4 "" true': what a conversation file has for it. A
// value that no such line can hold is told in a line before.
std::vector<std::string> event_lines(const Message& message) {
  std::vector<std::string> lines;
  auto line = "event " + message.source + " " + message.command;
  for (const auto& param : message.params) {
    const auto word = written(param);
    line += " " + word.value_or("unknown");
    if (!word)
      lines.push_back("# Of the next line, 'unknown' was " +
                      as_one_line(to_string(param)));
  }
  lines.push_back(as_one_line(line));
  return lines;
}

} // namespace

SessionLines::Lines
SessionLines::heading(const dialogue::SessionHistory& history,
                      Timestamp begins) {
  session_ = history.id;
  switch (form_) {
  case LineForm::transcript: {
    Lines lines{fmt::format("session {}, {} inputs", history.id,
                            history.inputs.size())};
    if (history.before > 0)
      lines.push_back(fmt::format(
          "    its first {} inputs are not kept any more", history.before));
    return lines;
  }
  case LineForm::test:
    return {"# Session " + history.id + ".",
            format_timestamp(begins, "clock %Y-%m-%d %H:%M:%S"),
            fmt::format("seed {}", history.opened.seed)};
  case LineForm::json:
    break;
  }
  return {};
}

// In a test time does not pass by itself: a pause becomes a `wait`.
SessionLines::Lines SessionLines::with_wait(const LinePlace& place,
                                            Lines of_input) {
  Lines lines;
  const auto pause = place.now - last_.value_or(place.now);
  if (form_ == LineForm::test && pause >= shortest_wait)
    lines.push_back(fmt::format("wait {}ms", pause));
  last_ = place.now;
  std::ranges::move(of_input, std::back_inserter(lines));
  return lines;
}

// The words come last, as hidden() may take their line's place.
SessionLines::Lines SessionLines::user(const LinePlace& place,
                                       const std::string& words) {
  if (form_ == LineForm::json)
    return {object(session_, place, "message", "user", words)};
  return with_wait(place, {"U: " + as_one_line(words)});
}

std::string SessionLines::hidden(const LinePlace& place) const {
  if (form_ == LineForm::json)
    return object(session_, place, "message", "user", masked);
  return std::string("U: ") + masked;
}

// A test's R line waits by itself.
SessionLines::Lines SessionLines::robot(const LinePlace& place,
                                        const std::string& words) {
  last_ = place.now;
  if (form_ == LineForm::json)
    return {object(session_, place, "output", "robot", words)};
  return {"R: " + as_one_line(words)};
}

// A transcript is what people say and hear: events are left out.
SessionLines::Lines SessionLines::event(const LinePlace& place,
                                        const Message& message) {
  switch (form_) {
  case LineForm::transcript:
    return {};
  case LineForm::test:
    return with_wait(place, event_lines(message));
  case LineForm::json:
    break;
  }
  return {object(session_, place, "message", "event", to_string(message))};
}

SessionLines::Lines SessionLines::other(const LinePlace& place,
                                        std::string_view name) {
  if (form_ != LineForm::json)
    return {};
  return {object(session_, place, name)};
}

} // namespace parlour::tools
