// What takes the place of sound_file.cpp where libsndfile is missing.
#include "adapters/audio/sound_file.hpp"

namespace parlour::adapters {

namespace {

tl::unexpected<Error> missing() {
  return fail(ErrorKind::settings,
              "this program was built without libsndfile, so it can neither "
              "read nor write sound in files; install libsndfile1-dev and "
              "build it again");
}

} // namespace

struct SoundFileReader::State {
  PcmFormat format;
};

Expected<SoundFileReader> SoundFileReader::open(const std::filesystem::path&) {
  return missing();
}

SoundFileReader::SoundFileReader(SoundFileReader&&) noexcept = default;

SoundFileReader&
SoundFileReader::operator=(SoundFileReader&&) noexcept = default;

SoundFileReader::~SoundFileReader() = default;

const PcmFormat& SoundFileReader::format() const {
  return state_->format;
}

std::size_t SoundFileReader::read(std::span<Sample>) {
  return 0;
}

void SoundFileReader::rewind() {}

struct SoundFileWriter::State {
  std::filesystem::path path;
};

Expected<SoundFileWriter> SoundFileWriter::create(const std::filesystem::path&,
                                                  const PcmFormat&) {
  return missing();
}

SoundFileWriter::SoundFileWriter(SoundFileWriter&&) noexcept = default;

SoundFileWriter&
SoundFileWriter::operator=(SoundFileWriter&&) noexcept = default;

SoundFileWriter::~SoundFileWriter() = default;

const std::filesystem::path& SoundFileWriter::path() const {
  return state_->path;
}

Expected<void> SoundFileWriter::write(std::span<const Sample>) {
  return missing();
}

} // namespace parlour::adapters
