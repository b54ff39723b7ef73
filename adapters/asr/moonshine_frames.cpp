#include "adapters/asr/moonshine_frames.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "runtime/text/json_text.hpp"

namespace parlour::adapters::moonshine {

namespace {

// In bytes; what the program takes.
constexpr std::size_t longest_payload = 1 << 20;
// Of alternatives and of words.
constexpr std::size_t most_entries = 256;

constexpr std::array<std::pair<std::string_view, AnswerKind>, 6> kinds = {{
    {"ready", AnswerKind::ready},
    {"partial", AnswerKind::partial},
    {"result", AnswerKind::result},
    {"rejected", AnswerKind::rejected},
    {"speech", AnswerKind::speech},
    {"failed", AnswerKind::failed},
}};

// {"type":"audio","turn":7,"bytes":640}, a line end, 640 bytes of samples.
std::string frame(Map head, std::string_view payload = {}) {
  if (!payload.empty())
    head.set("bytes", static_cast<std::int64_t>(payload.size()));
  auto bytes = json_text(Value(std::move(head)));
  bytes += '\n';
  bytes += payload;
  return bytes;
}

std::string turn_frame(const char* type, TurnNumber turn,
                       std::string_view payload = {}) {
  return frame({{"type", type}, {"turn", turn}}, payload);
}

// A turn is heard for 30 s, which is less, so that none is cut.
std::string_view payload_of(std::span<const Sample> samples) {
  const auto bytes = std::as_bytes(samples);
  return {reinterpret_cast<const char*>(bytes.data()),
          std::min(bytes.size(), longest_payload)};
}

// Those that fit.
// Names come first in the list, so that sentences are what is left out.
std::string lines_of(const Words& words) {
  std::string lines;
  for (const auto& phrase : words.phrases) {
    if (lines.size() + phrase.size() >= longest_payload)
      break;
    lines += phrase;
    lines += '\n';
  }
  return lines;
}

// Reads one answer of which nothing is known.
class AnswerFields {
public:
  explicit AnswerFields(const Value& fields) : fields_(fields) {}

  std::string text(std::string_view name) const {
    const auto* const text = fields_[name].if_string();
    return text ? *text : std::string();
  }
  double confidence() const {
    return std::clamp(fields_["confidence"].number_or(0), 0.0, 1.0);
  }
  // Each with `text` and `confidence`, whatever else there is.
  List entries(std::string_view name) const {
    List entries;
    if (const auto* const list = fields_[name].if_list())
      for (const auto& one : *list)
        if (entries.size() < most_entries && one.if_map())
          entries.push_back(entry(AnswerFields(one)));
    return entries;
  }
  std::vector<double> parts(std::string_view name) const {
    std::vector<double> parts;
    if (const auto* const list = fields_[name].if_list())
      for (const auto& one : *list)
        if (parts.size() < most_entries)
          parts.push_back(std::clamp(one.number_or(0), 0.0, 1.0));
    return parts;
  }

private:
  static Value entry(const AnswerFields& one) {
    return Map{{"text", one.text("text")}, {"confidence", one.confidence()}};
  }

  const Value& fields_;
};

tl::unexpected<Error> unreadable(std::string_view line) {
  return fail(ErrorKind::network, "it says what cannot be read: " +
                                      std::string(line.substr(0, 80)));
}

// A field of the wrong type counts as missing; an unknown kind ends the stream,
// as nobody knows what it asks for.
Expected<Answer> read_answer(std::string_view line) {
  const auto value = read_json(line);
  if (!value || !value->if_map())
    return unreadable(line);
  const AnswerFields fields(*value);
  const auto* const kind = std::ranges::find(
      kinds, fields.text("type"), [](const auto& one) { return one.first; });
  if (kind == kinds.end())
    return unreadable(line);
  return Answer{kind->second,
                (*value)["turn"].integer_or(0),
                fields.text(kind->second == AnswerKind::rejected ||
                                    kind->second == AnswerKind::failed
                                ? "reason"
                                : "text"),
                fields.confidence(),
                fields.entries("alternatives"),
                fields.entries("words"),
                fields.parts("likely")};
}

} // namespace

std::string audio_frame(TurnNumber turn, std::span<const Sample> samples) {
  return turn_frame("audio", turn, payload_of(samples));
}

std::string detect_frame(TurnNumber stream, std::span<const Sample> samples) {
  return turn_frame("detect", stream, payload_of(samples));
}

std::string finish_frame(TurnNumber turn) {
  return turn_frame("finish", turn);
}

std::string cancel_frame(TurnNumber turn) {
  return turn_frame("cancel", turn);
}

std::string words_frame(const Words& words) {
  return frame(
      {{"type", "words"}, {"names", static_cast<std::int64_t>(words.names)}},
      lines_of(words));
}

std::vector<std::string> language_frames(std::string_view model, bool rejects) {
  std::vector<std::string> frames;
  while (!model.empty()) {
    const auto part = model.substr(0, longest_payload);
    model.remove_prefix(part.size());
    frames.push_back(frame(
        {{"type", "language"}, {"more", !model.empty()}, {"rejects", rejects}},
        part));
  }
  return frames;
}

std::string narrow_frame(TurnNumber turn, const Words& words) {
  return frame({{"type", "narrow"},
                {"turn", turn},
                {"names", static_cast<std::int64_t>(words.names)}},
               lines_of(words));
}

// What was read is erased here, once for all lines that next() has returned.
void AnswerReader::add(std::string_view bytes) {
  held_.erase(0, std::exchange(at_, 0));
  held_ += bytes;
}

Expected<std::optional<Answer>> AnswerReader::next() {
  const auto end = held_.find('\n', at_);
  const auto length = std::min(end, held_.size()) - at_;
  if (length > longest_line)
    return fail(ErrorKind::network, "it says a line without an end");
  if (end == std::string::npos)
    return std::optional<Answer>();
  const auto line = std::string_view(held_).substr(at_, length);
  at_ = end + 1;
  auto answer = read_answer(line);
  if (!answer)
    return tl::make_unexpected(answer.error());
  return std::optional(std::move(*answer));
}

} // namespace parlour::adapters::moonshine
