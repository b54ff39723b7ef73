#include "adapters/audio/sound_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sndfile.h>
#include <sys/file.h>
#include <unistd.h>

#include "runtime/base/outside/file_bytes.hpp"

namespace parlour::adapters {

namespace {

constexpr std::uint64_t largest = 2'000'000'000; // bytes
constexpr int most_writers = 100;

struct Close {
  void operator()(SNDFILE* file) const {
    sf_close(file);
  }
};
using File = std::unique_ptr<SNDFILE, Close>;

tl::unexpected<Error> file_error(const std::filesystem::path& path,
                                 const std::string& reason) {
  return fail(ErrorKind::file, reason, {path.string(), 0, 0});
}

Sample to_sample(float value) {
  return static_cast<Sample>(
      std::lround(std::clamp(value * 32'768, -32'768.0F, 32'767.0F)));
}

} // namespace

// -- reading
// -------------------------------------------------------------------

struct SoundFileReader::State {
  File file;
  PcmFormat format;
  std::vector<float> read = {}; // kept to be used again
};

// Opening a named pipe would wait for its writer, so the kind is looked at
// first.
Expected<SoundFileReader>
SoundFileReader::open(const std::filesystem::path& path) {
  if (auto is_file = check_is_file(path); !is_file)
    return tl::make_unexpected(is_file.error());
  SF_INFO info{};
  File file(sf_open(path.c_str(), SFM_READ, &info));
  if (!file)
    return file_error(path, std::string("this is no sound that can be read: ") +
                                sf_strerror(nullptr));
  const PcmFormat format{info.samplerate, info.channels};
  if (auto usable = parse_format(format_name(format)); !usable)
    return file_error(path, usable.error().message);
  return SoundFileReader(
      std::make_unique<State>(State{std::move(file), format}));
}

SoundFileReader::SoundFileReader(std::unique_ptr<State> state)
    : state_(std::move(state)) {}

SoundFileReader::SoundFileReader(SoundFileReader&&) noexcept = default;

SoundFileReader&
SoundFileReader::operator=(SoundFileReader&&) noexcept = default;

SoundFileReader::~SoundFileReader() = default;

const PcmFormat& SoundFileReader::format() const {
  return state_->format;
}

// Read as numbers from -1 to 1, because only so the library scales files of
// floating point; 16 bit come back as they are.
std::size_t SoundFileReader::read(std::span<Sample> samples) {
  auto& read = state_->read;
  const auto channels = static_cast<std::size_t>(state_->format.channels);
  read.resize(samples.size() / channels * channels);
  const auto count =
      sf_readf_float(state_->file.get(), read.data(),
                     static_cast<sf_count_t>(samples.size() / channels));
  read.resize(static_cast<std::size_t>(std::max<sf_count_t>(count, 0)) *
              channels);
  std::ranges::transform(read, samples.begin(), to_sample);
  return read.size();
}

void SoundFileReader::rewind() {
  sf_seek(state_->file.get(), 0, SEEK_SET);
}

// -- writing
// -------------------------------------------------------------------

namespace {

// "a-2.wav" for "a.wav".
std::filesystem::path numbered(const std::filesystem::path& path, int number) {
  if (number == 1)
    return path;
  auto name = path.stem();
  name += "-" + std::to_string(number);
  name += path.extension();
  return path.parent_path() / name;
}

// The descriptor of a file that is locked by its writer; -1 if another has it.
Expected<int> open_alone(const std::filesystem::path& path) {
  if (auto may = check_may_be_file(path); !may)
    return tl::make_unexpected(may.error());
  const int file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0)
    return file_error(path,
                      std::string("cannot be written: ") + strerror(errno));
  if (flock(file, LOCK_EX | LOCK_NB) == 0)
    return file;
  close(file);
  return -1;
}

int kind_of(const std::filesystem::path& path) {
  return (path.extension() == ".flac" ? SF_FORMAT_FLAC : SF_FORMAT_WAV) |
         SF_FORMAT_PCM_16;
}

} // namespace

struct SoundFileWriter::State {
  std::filesystem::path path;
  File file;
  std::uint64_t bytes = 0;
};

Expected<SoundFileWriter>
SoundFileWriter::create(const std::filesystem::path& path,
                        const PcmFormat& format) {
  for (int number = 1; number <= most_writers; ++number) {
    const auto name = numbered(path, number);
    const auto opened = open_alone(name);
    if (!opened)
      return tl::make_unexpected(opened.error());
    if (*opened < 0)
      continue;
    SF_INFO info{};
    info.samplerate = format.rate;
    info.channels = format.channels;
    info.format = kind_of(name);
    // It closes the descriptor, also if it fails.
    if (ftruncate(*opened, 0) != 0)
      return close(*opened), file_error(name, "cannot be written");
    File file(sf_open_fd(*opened, SFM_WRITE, &info, SF_TRUE));
    if (!file)
      return file_error(name, std::string("cannot be written: ") +
                                  sf_strerror(nullptr));
    sf_command(file.get(), SFC_SET_UPDATE_HEADER_AUTO, nullptr, SF_TRUE);
    return SoundFileWriter(
        std::make_unique<State>(State{name, std::move(file)}));
  }
  return file_error(path, "too many write to this file at once");
}

SoundFileWriter::SoundFileWriter(std::unique_ptr<State> state)
    : state_(std::move(state)) {}

SoundFileWriter::SoundFileWriter(SoundFileWriter&&) noexcept = default;

SoundFileWriter&
SoundFileWriter::operator=(SoundFileWriter&&) noexcept = default;

SoundFileWriter::~SoundFileWriter() = default;

const std::filesystem::path& SoundFileWriter::path() const {
  return state_->path;
}

Expected<void> SoundFileWriter::write(std::span<const Sample> samples) {
  auto& [path, file, bytes] = *state_;
  bytes += samples.size_bytes();
  if (bytes > largest)
    return file_error(path, "the file has reached 2 GB");
  const auto written = sf_write_short(file.get(), samples.data(),
                                      static_cast<sf_count_t>(samples.size()));
  if (written != static_cast<sf_count_t>(samples.size()))
    return file_error(path, std::string("cannot be written: ") +
                                sf_strerror(file.get()));
  return {};
}

} // namespace parlour::adapters
