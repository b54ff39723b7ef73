#include "adapters/wyoming/audio_events.hpp"

#include <cstring>

namespace parlour::adapters::wyoming {

namespace {

// Each event for audio repeats the format, as the protocol wants it.
nlohmann::json format() {
  return {{"rate", speech_rate}, {"width", sizeof(Sample)}, {"channels", 1}};
}

} // namespace

Event audio_start() {
  return {"audio-start", format()};
}

Event audio_chunk(const std::string& samples, std::int64_t time) {
  auto data = format();
  data["timestamp"] = time;
  return {"audio-chunk", data, samples};
}

Event audio_stop(std::int64_t time) {
  return {"audio-stop", {{"timestamp", time}}};
}

std::string bytes_of(std::span<const Sample> samples) {
  const auto bytes = std::as_bytes(samples);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::vector<Sample> samples_of(const std::string& bytes) {
  std::vector<Sample> samples(bytes.size() / sizeof(Sample));
  if (!samples.empty())
    std::memcpy(samples.data(), bytes.data(), samples.size() * sizeof(Sample));
  return samples;
}

std::int64_t duration_of(const std::string& bytes) {
  return duration(bytes.size() / sizeof(Sample));
}

std::string trimmed(const std::string& text) {
  constexpr const char* blanks = " \t\r\n";
  const auto begin = text.find_first_not_of(blanks);
  if (begin == std::string::npos)
    return "";
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

} // namespace parlour::adapters::wyoming
