#include "adapters/audio/pcm.hpp"

#include <bit>
#include <charconv>
#include <cstring>

#include <fmt/format.h>

namespace parlour::adapters {

namespace {

static_assert(std::endian::native == std::endian::little,
              "samples are used as they lie in messages");

constexpr std::string_view encoding = "pcm_s16le";

tl::unexpected<Error> not_audio(std::string_view name,
                                std::string_view reason) {
  return fail(
      ErrorKind::type,
      fmt::format("\"{}\" is no audio that can be used: {}", name, reason));
}

// Takes the next field, up to a semicolon, from `rest`.
std::string_view next_field(std::string_view& rest) {
  const auto end = rest.find(';');
  const auto field = rest.substr(0, end);
  rest = end == std::string_view::npos ? "" : rest.substr(end + 1);
  return field;
}

// Reads "rate=16000" into `value` if `field` is one of that name.
bool read_field(std::string_view field, std::string_view name, int& value) {
  if (!field.starts_with(name) || field.size() <= name.size() ||
      field[name.size()] != '=')
    return false;
  const auto* const begin = field.data() + name.size() + 1;
  const auto* const end = field.data() + field.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  return error == std::errc{} && stop == end;
}

} // namespace

std::string format_name(const PcmFormat& format) {
  return fmt::format("{};rate={};channels={}", encoding, format.rate,
                     format.channels);
}

Expected<PcmFormat> parse_format(std::string_view name) {
  auto rest = name;
  if (next_field(rest) != encoding)
    return not_audio(name, "samples of 16 bit are expected (pcm_s16le)");
  PcmFormat format;
  while (!rest.empty()) {
    const auto field = next_field(rest);
    if (!read_field(field, "rate", format.rate) &&
        !read_field(field, "channels", format.channels))
      return not_audio(name, fmt::format("\"{}\" is unknown", field));
  }
  if (format.rate < 4'000 || format.rate > 384'000)
    return not_audio(name, "the rate must be from 4,000 to 384,000");
  if (format.channels < 1 || format.channels > 32)
    return not_audio(name, "it must have from 1 to 32 channels");
  return format;
}

Value pcm_value(std::span<const Sample> samples, const PcmFormat& format) {
  const auto bytes = std::as_bytes(samples);
  return Binary{format_name(format), {bytes.begin(), bytes.end()}};
}

Expected<std::span<const Sample>> speech_samples(const Value& audio) {
  const auto* const binary = audio.if_binary();
  if (!binary)
    return fail(ErrorKind::type, "this is no audio");
  return speech_samples(*binary);
}

Expected<std::span<const Sample>> speech_samples(const Binary& audio) {
  const auto format = parse_format(audio.format);
  if (!format)
    return tl::make_unexpected(format.error());
  if (*format != PcmFormat{})
    return not_audio(audio.format,
                     "16,000 samples a second of one channel are expected");
  if (audio.bytes.size() % sizeof(Sample))
    return not_audio(audio.format, "it ends within a sample");
  // The bytes come from an allocation of their own, which is aligned for any
  // type, and samples of int16_t may lie there.
  const void* const bytes = audio.bytes.data();
  return std::span(static_cast<const Sample*>(bytes),
                   audio.bytes.size() / sizeof(Sample));
}

} // namespace parlour::adapters
