#include "adapters/audio/rate_converter.hpp"

#include <cassert>
#include <cmath>
#include <utility>

#include <samplerate.h>

namespace parlour::adapters {

namespace {

// Its look-ahead is 3 ms at 16,000 samples a second, and what it adds is 120 dB
// below the sound.
constexpr int quality = SRC_SINC_MEDIUM_QUALITY;

struct Delete {
  void operator()(SRC_STATE* converter) const {
    src_delete(converter);
  }
};

} // namespace

struct RateConverter::State {
  std::unique_ptr<SRC_STATE, Delete> converter;
  double ratio;
  int channels;

  void run(std::span<const float> samples, bool is_end,
           std::vector<float>& out) {
    SRC_DATA data{};
    data.data_in = samples.data();
    data.input_frames = static_cast<long>(samples.size()) / channels;
    data.src_ratio = ratio;
    data.end_of_input = is_end ? 1 : 0;
    while (step(data, out))
      continue;
  }

  // Converts some of the input. False once there is no more to be had from it.
  bool step(SRC_DATA& data, std::vector<float>& out) const {
    const auto room = static_cast<std::size_t>(
        std::ceil(static_cast<double>(data.input_frames) * ratio) + 64);
    const auto before = out.size();
    out.resize(before + room * static_cast<std::size_t>(channels));
    data.data_out = out.data() + before;
    data.output_frames = static_cast<long>(room);
    // It fails only for input that this class never gives it.
    [[maybe_unused]] const auto error = src_process(converter.get(), &data);
    assert(error == 0);
    out.resize(before + static_cast<std::size_t>(data.output_frames_gen) *
                            static_cast<std::size_t>(channels));
    data.data_in += data.input_frames_used * channels;
    data.input_frames -= data.input_frames_used;
    return data.output_frames_gen > 0 || data.input_frames_used > 0;
  }
};

Expected<RateConverter> RateConverter::create(int from, int to, int channels) {
  int error = 0;
  std::unique_ptr<SRC_STATE, Delete> converter(
      src_new(quality, channels, &error));
  const auto ratio = static_cast<double>(to) / from;
  if (!converter || !src_is_valid_ratio(ratio))
    return fail(ErrorKind::settings,
                "the rate " + std::to_string(from) + " cannot be changed to " +
                    std::to_string(to) +
                    (error ? std::string(": ") + src_strerror(error) : ""));
  return RateConverter(
      std::make_unique<State>(State{std::move(converter), ratio, channels}));
}

RateConverter::RateConverter(std::unique_ptr<State> state)
    : state_(std::move(state)) {}

RateConverter::RateConverter(RateConverter&&) noexcept = default;

RateConverter& RateConverter::operator=(RateConverter&&) noexcept = default;

RateConverter::~RateConverter() = default;

void RateConverter::process(std::span<const float> samples,
                            std::vector<float>& out) {
  state_->run(samples, false, out);
}

void RateConverter::finish(std::vector<float>& out) {
  // The library wants an address, even of no samples.
  const float none = 0;
  state_->run({&none, 0}, true, out);
  src_reset(state_->converter.get());
}

} // namespace parlour::adapters
