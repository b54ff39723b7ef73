#include "adapters/audio/file_options.hpp"

namespace parlour::adapters {

FileOptions read_file_options(OptionReader& read,
                              const std::filesystem::path& file,
                              const std::filesystem::path& folder) {
  constexpr Milliseconds longest{3'600'000};
  auto path = file.empty() ? read.file("file", folder) : file;
  const auto pace = Pace::read(read.text("pace"));
  if (!pace)
    read.wrong(pace.error());
  return {std::move(path), pace.value_or(Pace::of_clock()),
          read.duration("silence", Milliseconds(0), longest)};
}

} // namespace parlour::adapters
