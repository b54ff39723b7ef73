#include "adapters/audio/alsa/alsa_device.hpp"

#include <algorithm>
#include <cerrno>
#include <utility>

#include <alsa/asoundlib.h>
#include <fmt/format.h>

#include "adapters/audio/alsa/device_samples.hpp"

namespace parlour::adapters {

namespace {

constexpr unsigned period_time = 10'000;          // µs
constexpr unsigned capture_buffer_time = 500'000; // µs

struct Close {
  void operator()(snd_pcm_t* pcm) const {
    snd_pcm_close(pcm);
  }
};
using Pcm = std::unique_ptr<snd_pcm_t, Close>;

// alsa-lib prints its complaints on the screen of the conversation.
void say_nothing(const char*, int, const char*, int, const char*, ...) {}

snd_pcm_format_t alsa_format(DeviceSamples kind) {
  constexpr snd_pcm_format_t formats[] = {
      SND_PCM_FORMAT_S16_LE, SND_PCM_FORMAT_S32_LE, SND_PCM_FORMAT_S24_LE,
      SND_PCM_FORMAT_S24_3LE, SND_PCM_FORMAT_FLOAT_LE};
  return formats[static_cast<std::size_t>(kind)];
}

const char* way_out(SoundDirection direction) {
  return direction == SoundDirection::capture
             ? "parlour devices lists what there is; without a microphone, "
               "use the component FileMicrophone or --microphone FILE.wav"
             : "parlour devices lists what there is; without a speaker, use "
               "the component FileSpeaker or --speaker FILE.wav";
}

tl::unexpected<Error> cannot_open(const WantedDevice& wanted, int error) {
  const bool missing = error == ENOENT || error == ENODEV || error == ENXIO;
  const char* const reason =
      missing           ? "there is no such sound device"
      : error == EBUSY  ? "another program uses it"
      : error == EACCES ? "this user may not use it; the group \"audio\" may"
      : error == EINVAL
          ? "none of its formats can be used: 4,000 to 384,000 samples a "
            "second, of 16, 24 or 32 bit, in at most 32 channels"
          : snd_strerror(-error);
  return fail(missing ? ErrorKind::settings : ErrorKind::offline,
              fmt::format("the sound device \"{}\" cannot be used: {} ({})",
                          wanted.name, reason, way_out(wanted.direction)));
}

} // namespace

struct AlsaDevice::State {
  Pcm pcm;
  SoundDirection direction;
  PcmFormat format = {};
  DeviceSamples kind = DeviceSamples::s16;
  snd_pcm_uframes_t buffer = 0; // frames
  snd_pcm_uframes_t queue = 0;  // frames, of those
  std::vector<std::byte> bytes = {};

  int choose_hardware();
  int choose_buffer(snd_pcm_hw_params_t* params);
  int choose_software(Milliseconds queue_time);
  int fault() const;

  std::size_t channels() const {
    return static_cast<std::size_t>(format.channels);
  }
  std::size_t frame_bytes() const {
    return bytes_of(kind) * channels();
  }
};

// -- opening
// -------------------------------------------------------------------

Expected<AlsaDevice> AlsaDevice::open(const WantedDevice& wanted) {
  snd_lib_error_set_handler(say_nothing);
  snd_pcm_t* opened = nullptr;
  const auto stream = wanted.direction == SoundDirection::capture
                          ? SND_PCM_STREAM_CAPTURE
                          : SND_PCM_STREAM_PLAYBACK;
  int error =
      snd_pcm_open(&opened, wanted.name.c_str(), stream, SND_PCM_NONBLOCK);
  if (error < 0)
    return cannot_open(wanted, -error);
  auto state = std::make_unique<State>(State{Pcm(opened), wanted.direction});
  error = state->choose_hardware();
  if (error >= 0)
    error = state->choose_software(wanted.queue);
  if (error < 0)
    return cannot_open(wanted, -error);
  return AlsaDevice(std::move(state));
}

// The device's own rate nearest to that of speech: alsa-lib would convert, too,
// but less well.
int AlsaDevice::State::choose_hardware() {
  snd_pcm_hw_params_t* params = nullptr;
  snd_pcm_hw_params_alloca(&params);
  int error = snd_pcm_hw_params_any(pcm.get(), params);
  if (error < 0)
    return error;
  snd_pcm_hw_params_set_rate_resample(pcm.get(), params, 0);
  error = snd_pcm_hw_params_set_access(pcm.get(), params,
                                       SND_PCM_ACCESS_RW_INTERLEAVED);
  if (error < 0)
    return error;
  error = -EINVAL;
  for (const auto one :
       {DeviceSamples::s16, DeviceSamples::s32, DeviceSamples::s24,
        DeviceSamples::s24_3, DeviceSamples::float32})
    if (error < 0) {
      error = snd_pcm_hw_params_set_format(pcm.get(), params, alsa_format(one));
      kind = one;
    }
  if (error < 0)
    return error;
  unsigned channels = 1;
  unsigned rate = speech_rate;
  error = snd_pcm_hw_params_set_channels_near(pcm.get(), params, &channels);
  if (error >= 0)
    error = snd_pcm_hw_params_set_rate_near(pcm.get(), params, &rate, nullptr);
  format = {static_cast<int>(rate), static_cast<int>(channels)};
  return error < 0 ? error : choose_buffer(params);
}

int AlsaDevice::State::choose_buffer(snd_pcm_hw_params_t* params) {
  unsigned period = period_time;
  unsigned time = capture_buffer_time;
  int error = snd_pcm_hw_params_set_period_time_near(pcm.get(), params, &period,
                                                     nullptr);
  if (error >= 0)
    error = snd_pcm_hw_params_set_buffer_time_near(pcm.get(), params, &time,
                                                   nullptr);
  if (error >= 0)
    error = snd_pcm_hw_params(pcm.get(), params);
  if (error >= 0)
    error = snd_pcm_hw_params_get_buffer_size(params, &buffer);
  if (error >= 0 && !parse_format(format_name(format)))
    return -EINVAL;
  return error;
}

// However large the buffer is, a playing device is filled no further than the
// queue, so that it falls silent soon after it is told to.
int AlsaDevice::State::choose_software(Milliseconds queue_time) {
  const auto rate = static_cast<snd_pcm_uframes_t>(format.rate);
  const auto wanted =
      rate * static_cast<snd_pcm_uframes_t>(queue_time.count()) / 1'000;
  queue = std::clamp<snd_pcm_uframes_t>(wanted, 1, buffer);
  const auto period = std::min(queue / 2, rate * period_time / 1'000'000);
  const auto least = direction == SoundDirection::capture
                         ? rate * period_time / 1'000'000
                         : buffer - queue + period;
  snd_pcm_sw_params_t* params = nullptr;
  snd_pcm_sw_params_alloca(&params);
  int error = snd_pcm_sw_params_current(pcm.get(), params);
  if (error >= 0)
    error = snd_pcm_sw_params_set_avail_min(
        pcm.get(), params, std::max<snd_pcm_uframes_t>(least, 1));
  // write() starts it.
  if (error >= 0)
    error =
        snd_pcm_sw_params_set_start_threshold(pcm.get(), params, 2 * buffer);
  return error < 0 ? error : snd_pcm_sw_params(pcm.get(), params);
}

AlsaDevice::AlsaDevice(std::unique_ptr<State> state)
    : state_(std::move(state)) {}

AlsaDevice::AlsaDevice(AlsaDevice&&) noexcept = default;

AlsaDevice& AlsaDevice::operator=(AlsaDevice&&) noexcept = default;

AlsaDevice::~AlsaDevice() {
  if (state_)
    snd_pcm_drop(state_->pcm.get());
}

const PcmFormat& AlsaDevice::format() const {
  return state_->format;
}

// -- running
// -------------------------------------------------------------------

int AlsaDevice::prepare() {
  int error = snd_pcm_prepare(state_->pcm.get());
  if (error >= 0 && state_->direction == SoundDirection::capture)
    error = snd_pcm_start(state_->pcm.get());
  return error < 0 ? -error : 0;
}

void AlsaDevice::halt() {
  snd_pcm_drop(state_->pcm.get());
}

std::vector<pollfd> AlsaDevice::descriptors() const {
  const int count = snd_pcm_poll_descriptors_count(state_->pcm.get());
  std::vector<pollfd> all(static_cast<std::size_t>(std::max(count, 0)));
  const int filled = snd_pcm_poll_descriptors(
      state_->pcm.get(), all.data(), static_cast<unsigned>(all.size()));
  all.resize(static_cast<std::size_t>(std::max(filled, 0)));
  return all;
}

bool AlsaDevice::is_ready(std::span<pollfd> waited) const {
  unsigned short events = 0;
  const int error = snd_pcm_poll_descriptors_revents(
      state_->pcm.get(), waited.data(), static_cast<unsigned>(waited.size()),
      &events);
  return error < 0 || events != 0;
}

// Not all of alsa-lib's devices report by each call what has become of them.
int AlsaDevice::State::fault() const {
  switch (snd_pcm_state(pcm.get())) {
  case SND_PCM_STATE_XRUN:
    return EPIPE;
  case SND_PCM_STATE_SUSPENDED:
    return ESTRPIPE;
  case SND_PCM_STATE_DISCONNECTED:
    return ENODEV;
  default:
    return 0;
  }
}

AlsaDevice::Moved AlsaDevice::read(std::vector<Sample>& samples,
                                   std::size_t most) {
  auto& [pcm, direction, format, kind, buffer, queue, bytes] = *state_;
  const auto available = snd_pcm_avail_update(pcm.get());
  if (const int fault = state_->fault(); fault != 0)
    return {0, fault};
  if (available < 0)
    return {0, static_cast<int>(-available)};
  const auto frames =
      std::min(static_cast<std::size_t>(available), most / state_->channels());
  bytes.resize(frames * state_->frame_bytes());
  const auto read = snd_pcm_readi(pcm.get(), bytes.data(), frames);
  if (read < 0)
    return {0, read == -EAGAIN ? 0 : static_cast<int>(-read)};
  const auto count = static_cast<std::size_t>(read);
  append_samples(kind, std::span(bytes).first(count * state_->frame_bytes()),
                 samples);
  return {count * state_->channels(), 0};
}

AlsaDevice::Moved AlsaDevice::room() const {
  const auto available = snd_pcm_avail_update(state_->pcm.get());
  if (const int fault = state_->fault(); fault != 0)
    return {0, fault};
  if (available < 0)
    return {0, static_cast<int>(-available)};
  const auto kept = state_->buffer - state_->queue; // is never used
  const auto free = static_cast<snd_pcm_uframes_t>(available);
  return {(free > kept ? free - kept : 0) * state_->channels(), 0};
}

AlsaDevice::Moved AlsaDevice::write(std::span<const Sample> samples) {
  auto& [pcm, direction, format, kind, buffer, queue, bytes] = *state_;
  const auto taken = room();
  const auto frames =
      std::min(taken.samples, samples.size()) / state_->channels();
  if (frames == 0 || taken.error != 0)
    return {0, taken.error};
  bytes.clear();
  append_bytes(kind, samples.first(frames * state_->channels()), bytes);
  const auto written = snd_pcm_writei(pcm.get(), bytes.data(), frames);
  if (written < 0)
    return {0, written == -EAGAIN ? 0 : static_cast<int>(-written)};
  if (snd_pcm_state(pcm.get()) == SND_PCM_STATE_PREPARED)
    if (const int error = snd_pcm_start(pcm.get()); error < 0)
      return {0, -error};
  return {static_cast<std::size_t>(written) * state_->channels(), 0};
}

std::size_t AlsaDevice::queued() const {
  snd_pcm_sframes_t delay = 0;
  if (snd_pcm_delay(state_->pcm.get(), &delay) < 0 || delay < 0)
    return 0;
  return static_cast<std::size_t>(delay) * state_->channels();
}

} // namespace parlour::adapters
