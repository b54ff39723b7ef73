#include "tools/parlour/journal/session_lines.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

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

// As conversation files write a value.
// With quotes where it has blanks or is empty, as the reader of tests wants it.
std::string written(const Value& value) {
  const auto text = to_string(value);
  return text.find_first_of(" \t\"") == std::string::npos && !text.empty()
             ? text
             : Json(text).dump();
}

// 'event Speaker Finished 4 "" true': what a conversation file has for it.
std::string event_line(const Message& message) {
  auto line = "event " + message.source + " " + message.command;
  for (const auto& param : message.params)
    line += " " + written(param);
  return line;
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
            format_timestamp(begins, "clock %Y-%m-%d %H:%M"),
            fmt::format("seed {}", history.opened.seed)};
  case LineForm::json:
    break;
  }
  return {};
}

// In a test time does not pass by itself: a pause becomes a `wait`.
SessionLines::Lines SessionLines::with_wait(const LinePlace& place,
                                            std::string line) {
  Lines lines;
  const auto pause = place.now - last_.value_or(place.now);
  if (form_ == LineForm::test && pause >= shortest_wait)
    lines.push_back(fmt::format("wait {}ms", pause));
  last_ = place.now;
  lines.push_back(std::move(line));
  return lines;
}

// The words come last, as hidden() may take their line's place.
SessionLines::Lines SessionLines::user(const LinePlace& place,
                                       const std::string& words) {
  if (form_ == LineForm::json)
    return {object(session_, place, "message", "user", words)};
  return with_wait(place, "U: " + as_one_line(words));
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
    return with_wait(place, as_one_line(event_line(message)));
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
